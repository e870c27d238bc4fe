// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The messages of Modbus TCP (Messaging on TCP/IP 1.0b, 3.1.3): a header of number, protocol and length in front of unit,
// function and data, no CRC behind them. Written, and cut out of the bytes of a connection, which come in pieces of any size.
// Knows no socket and no clock.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// A message: its number, and its unit, function and data, as an RTU frame has them before its CRC.
struct mbap_message {
    std::uint16_t number;
    byte_view body; ///< 2 to 254 bytes
};

/// What is wrong with bytes that should be messages. Behind them no other message is found: the connection is of no more use.
enum class mbap_fault : std::uint8_t {
    none,
    protocol, ///< the bytes behind the number are not 0
    length,   ///< the length is not that of a unit, a function and at most 252 bytes
};

namespace detail {

/// The number, the protocol and the length, which counts what follows it.
inline constexpr std::size_t mbap_header_size = 6;
inline constexpr std::size_t least_mbap_body = 2;
inline constexpr std::size_t crc_size = 2;

} // namespace detail

/// The size of the longest message: 260.
inline constexpr std::size_t max_mbap_size = detail::mbap_header_size + max_adu_size - detail::crc_size;

/// Writes a message. Errors: `frame_too_short`, `frame_too_long` (its body), `buffer_too_small`.
[[nodiscard]] constexpr result<byte_view> write_mbap(byte_span place, mbap_message const& message) noexcept
{
    if (message.body.size() < detail::least_mbap_body) {
        return errc::frame_too_short;
    }
    if (message.body.size() > max_adu_size - detail::crc_size) {
        return errc::frame_too_long;
    }
    byte_writer out{place};
    out.u16(message.number);
    out.u16(0);
    out.u16(static_cast<std::uint32_t>(message.body.size()));
    out.bytes(message.body);
    if (out.written().size() != detail::mbap_header_size + message.body.size()) {
        return errc::buffer_too_small;
    }
    return byte_view{out.written()};
}

/// The message as an RTU frame, whose CRC is made here: for what takes frames, a client or a server. `place` has 256 bytes.
[[nodiscard]] constexpr byte_view rtu_frame_of(mbap_message const& message, byte_span place) noexcept
{
    byte_writer out{place};
    out.bytes(message.body);
    std::uint16_t const crc = crc16(message.body);
    out.u8(crc & 0xFFU); // the low byte first
    out.u8(static_cast<std::uint32_t>(crc) >> 8U);
    return out.written();
}

/// Cuts the bytes of a connection into messages, in place:
///
///     cutter.add(what came into cutter.room());
///     while (auto const message = cutter.first()) { ...; cutter.drop_first(); }
class mbap_cutter {
public:
    /// Where the next bytes go. Never empty once `first` has none and there is no fault.
    [[nodiscard]] constexpr byte_span room() noexcept { return byte_span{bytes_}.subspan(size_); }
    /// So many bytes have come there.
    constexpr void add(std::size_t count) noexcept { size_ += count; }

    /// The first message that is whole. Valid until `drop_first` or `clear`.
    [[nodiscard]] constexpr std::optional<mbap_message> first() const noexcept
    {
        if (fault() != mbap_fault::none or size_ < detail::mbap_header_size or size_ < first_size()) {
            return std::nullopt;
        }
        return mbap_message{detail::to_u16(bytes_[0], bytes_[1]),
                            byte_view{bytes_}.first(first_size()).subspan(detail::mbap_header_size)};
    }

    constexpr void drop_first() noexcept
    {
        std::size_t const gone = first() ? first_size() : 0;
        std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(gone),
                  bytes_.begin() + static_cast<std::ptrdiff_t>(size_), bytes_.begin());
        size_ -= gone;
    }

    constexpr void clear() noexcept { size_ = 0; }

    /// Found as soon as the bytes tell it: what is none of Modbus TCP may never get longer.
    [[nodiscard]] constexpr mbap_fault fault() const noexcept
    {
        if ((size_ > 2 and bytes_[2] != std::byte{0}) or (size_ > 3 and bytes_[3] != std::byte{0})) {
            return mbap_fault::protocol;
        }
        if (size_ < detail::mbap_header_size) {
            return mbap_fault::none;
        }
        std::size_t const body = first_size() - detail::mbap_header_size;
        bool const is_in_range = body >= detail::least_mbap_body and body <= max_adu_size - detail::crc_size;
        return is_in_range ? mbap_fault::none : mbap_fault::length;
    }

    /// The bytes that came and were not dropped: of a message that is not whole, or of none.
    [[nodiscard]] constexpr byte_view bytes() const noexcept { return byte_view{bytes_}.first(size_); }

private:
    constexpr std::size_t first_size() const noexcept
    {
        return detail::mbap_header_size + detail::to_u16(bytes_[4], bytes_[5]);
    }

    std::array<std::byte, 2 * max_mbap_size> bytes_{};
    std::size_t size_{0};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
