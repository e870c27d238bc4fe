// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any bytes as a frame: nothing reads outside, and whatever decodes encodes to the same bytes, or, where bits fill
// their last byte, to a frame that decodes to the same value.
#include <array>
#include <concepts>
#include <cstdint>
#include <cstdlib>

#include <rtuwire/rtuwire.hpp>

#include "../tests/support/pdus.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

void require(bool holds)
{
    if (not holds) {
        std::abort();
    }
}

/// What a frame's last byte of bits holds behind the last bit is not encoded again.
template <typename P> constexpr bool has_padding = std::same_as<P, write_multiple_coils<>>;

/// Whether the frame that a value encodes to is the one it was decoded from, but for the padding.
template <typename P> bool is_same_frame(P const& value, byte_view again, byte_view frame)
{
    if constexpr (has_padding<P>) {
        auto const heard = decode_adu(again);
        auto const other = heard ? P::decode(heard->pdu()) : heard.error();
        std::size_t const same = frame.size() - 3; // all but the last byte of bits and the CRC
        return other and *other == value and again.size() == frame.size() and
               same_bytes(again.first(same), frame.first(same));
    } else {
        return same_bytes(again, frame);
    }
}

template <typename P> void decode(adu heard, byte_view frame)
{
    auto const value = P::decode(heard.pdu());
    if (not value) {
        return;
    }
    std::array<std::byte, max_adu_size> place{};
    auto const again = encode_adu(place, heard.unit(), *value);
    // A response may lie past the last register, which a request may not.
    if (not again) {
        return require(again == errc::invalid_address_range);
    }
    require(is_same_frame(*value, *again, frame));
}

void decode_all(byte_view frame)
{
    for (direction const way : {direction::request, direction::response}) {
        auto const known = frame_length(way, frame);
        require(known.size() <= max_adu_size or not known.is_final());
    }
    auto const heard = decode_adu(frame);
    if (not heard) {
        return;
    }
    test::all_pdus::for_each([&]<typename Pdu>() { decode<Pdu>(*heard, frame); });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    std::array<std::byte, 300> bytes{};
    size = size < bytes.size() - 2 ? size : bytes.size() - 2;
    for (std::size_t i = 0; i < size; ++i) {
        bytes[i] = static_cast<std::byte>(data[i]);
    }
    decode_all(byte_view{bytes}.first(size));
    std::uint16_t const crc = crc16(byte_view{bytes}.first(size));
    bytes[size] = to_byte(crc);
    bytes[size + 1] = to_byte(std::uint32_t{crc} >> 8U);
    decode_all(byte_view{bytes}.first(size + 2));
    return 0;
}
