// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The largest frame that there is: 256 bytes, which their own byte count tells.
#include <rtuwire/rtu/framer.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/core/crc16.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};

/// A frame of function 20, "read file record", whose byte count tells its size.
template <std::size_t Size> constexpr std::array<std::byte, Size> file_record()
{
    std::array<std::byte, Size> frame{};
    byte_writer out{frame};
    out.u8(2);
    out.u8(20);
    out.u8(Size - 5);
    while (out.size() < Size - 2) {
        out.u8(0x5A);
    }
    std::uint16_t const crc = crc16(out.written());
    out.u8(crc & 0xFFU);
    out.u8(crc >> 8U);
    return frame;
}

/// Whether a frame of so many bytes ends with its last one, without a silence behind it.
template <direction Way, std::size_t Size> constexpr bool ends_with_its_last_byte()
{
    constexpr auto frame = file_record<Size>();
    instant now{0xFFFF'0000U};
    framer<Way> receiver{line};
    receiver.advance(now);
    now = now + milliseconds(100);
    receiver.advance(now);
    now = now + line.characters(Size - 1);
    static_cast<void>(receiver.receive(byte_view{frame}.first(Size - 1), now));
    bool const is_early = receiver.poll_frame().has_value();
    now = now + line.characters(1);
    static_cast<void>(receiver.receive(byte_view{frame}.last(1), now));
    auto const heard = receiver.poll_frame();
    return not is_early and heard and *heard and same_bytes((*heard)->bytes(), frame);
}
constexpr bool both_ways()
{
    return ends_with_its_last_byte<direction::request, 255>() and
           ends_with_its_last_byte<direction::response, 255>() and
           ends_with_its_last_byte<direction::request, 256>() and ends_with_its_last_byte<direction::response, 256>();
}
PROOF("a frame of 256 bytes ends with its last one, like any other", both_ways)

} // namespace
