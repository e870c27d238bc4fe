// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a request of any function may do to a unit, by its bytes alone: to be refused as a write of the same is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rtuwire/frames.hpp>

#include "choices.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"
#include "line/who_is_it.hpp"
#include "words/value_words.hpp"

namespace tool {

/// Whether a request is of a function, and of a part of it, by which a unit of whatever maker is only read.
[[nodiscard]] bool has_reading_function(rtuwire::byte_view pdu);

/// Whether a request only reads, on a unit of whatever maker, and is as the specification has it.
[[nodiscard]] bool only_reads(rtuwire::byte_view pdu);

/// Which frames are looked for within another: of a function that is not public nobody knows the length, so that each piece
/// of a long text may be one, by its CRC alone.
enum class functions_within : std::uint8_t { public_ones, any };

/// The first frame in these bytes that does more than read, from a byte on; empty where there is none.
[[nodiscard]] rtuwire::byte_view changing_frame_in(rtuwire::byte_view bytes, functions_within which, std::size_t from);

/// Refuses a frame, as it is sent, in whose bytes stands another one that does more than read, to whatever unit: who ends a
/// frame by its length takes the rest for that. A loopback (08/00), whose data are anybody's, may hold none at all.
void refuse_frame_within(rtuwire::byte_view frame, functions_within which);

/// "function 06, write single register"; of one that is not public, and that a decimal number may have meant, with that.
[[nodiscard]] std::string words_of_function(rtuwire::byte_view pdu);

/// Refuses a request that writes registers or coils, and is not as the specification has it: what a unit makes of it, nobody
/// knows. And a mask that changes nothing.
void refuse_unreadable(rtuwire::byte_view pdu);

/// Ends the command where this unit may not be sent this request by these rules. The values that it writes, checked as
/// `write` checks them; none where they are no registers and no coils, or a mask.
std::vector<value_to_write> checked_request(rtuwire::byte_view pdu, open_line& line, named_unit const& unit,
                                            write_rules const& rules, choices const& chosen);

/// Whether a request writes 0000 (disable voltage), and nothing else, to the command of some drive but an ATV28.
[[nodiscard]] bool is_word_that_stops(rtuwire::byte_view pdu);

/// Ends the command where this unit may not be sent this request, which is as the specification has it, for a client that sends
/// what it likes. 0000 may always go to the command of a drive that is known, other than an ATV28; no other word that stops in one
/// profile and may run in another: which it is, a late response could say wrongly. Other registers, and coils, are judged by the
/// rules of `write`, all else by those of `ask`. What is not known to be another device gets none of the addresses by which a drive is run, or is told who runs it. Asks the unit where that depends on it, so this is
/// asked before each. The values that it writes, where these are registers or coils.
std::vector<value_to_write> refuse_for_client(rtuwire::byte_view pdu, open_line& line, named_unit const& unit,
                                              write_rules const& rules, choices const& chosen);

/// The same of a request to all units, of which nobody knows who they are.
void refuse_broadcast(rtuwire::byte_view pdu, choices const& chosen);

} // namespace tool
