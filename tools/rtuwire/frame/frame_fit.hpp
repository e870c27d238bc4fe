// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whether bytes are a request or a response, by the checks of the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rtuwire/frames.hpp>
#include <rtuwire/trace.hpp>

namespace tool {

/// The two bytes from there on as a word; there have to be two.
[[nodiscard]] inline std::uint16_t word_at(rtuwire::byte_view bytes, std::size_t at)
{
    return rtuwire::register_view{bytes.subspan(at, 2)}[0];
}

/// The frame that brings a PDU to a unit, or back.
[[nodiscard]] std::vector<std::byte> frame_of(std::byte unit, rtuwire::byte_view pdu);

/// What is wrong with a PDU as a request or a response; none where it may be one. Of a function that is not public
/// nothing is known, so that any bytes may be either.
[[nodiscard]] rtuwire::errc flaw_of(rtuwire::byte_view pdu, rtuwire::frame_role role);

/// What is wrong with a response to a request, beside what a client compares: its own form, and with 43/14 whether it is of the
/// access that was asked for.
[[nodiscard]] rtuwire::errc flaw_of_response(rtuwire::byte_view request, rtuwire::byte_view response);

/// Whether this PDU is a request or a response of a public function, or an exception.
[[nodiscard]] bool is_known_pdu(rtuwire::byte_view pdu);

/// The size of the frame that bytes begin with, by its CRC and the form of its function; 0 where none is whole.
[[nodiscard]] std::size_t frame_at_begin(rtuwire::byte_view bytes, rtuwire::frame_role role);

/// Whether its function is one whose fields are known, exception or not.
[[nodiscard]] bool has_known_fields(rtuwire::byte_view pdu);

} // namespace tool
