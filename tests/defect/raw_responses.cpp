// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A raw request of function 20 or 24 is held against as much of its response as one with a type; and a unit without an
// identifier does not fail at telling it: it has no function 17.
#include <rtuwire/ask/single_request.hpp>

#include <array>

#include "support/proof.hpp"
#include "support/whole_bank.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/raw.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// What a conversation makes of a response with the right CRC and byte count.
template <std::size_t Asked, std::size_t Told>
constexpr errc taken(std::array<std::byte, Asked> const& asked, std::array<std::byte, Told> const& told)
{
    single_request ask{unit_id{1}, raw_pdu{function_code{to_u8(asked[0])}, byte_view{asked}.subspan(1)}};
    ask.accept(response{told});
    return ask.outcome().error();
}

// File 4, record 1, 2 registers, and file 3, record 9, 2 registers: the example of AP 6.14.
constexpr auto two_runs = "14 0E 06 00 04 00 01 00 02 06 00 03 00 09 00 02"_hex;

constexpr bool holds_runs()
{
    return taken(two_runs, "14 0C 05 06 0D FE 00 20 05 06 33 CD 00 40"_hex) == errc::none and
           // One run, three of them, runs of another size, another reference, and the request itself.
           taken(two_runs, "14 06 05 06 0D FE 00 20"_hex) == errc::response_mismatch and
           taken(two_runs, "14 10 05 06 0D FE 00 20 05 06 33 CD 00 40 03 06 00 00"_hex) == errc::wrong_length and
           taken(two_runs, "14 0C 03 06 0D FE 07 06 33 CD 00 40 00 20"_hex) == errc::response_mismatch and
           taken(two_runs, "14 0C 05 07 0D FE 00 20 05 06 33 CD 00 40"_hex) == errc::response_mismatch and
           taken(two_runs, two_runs) == errc::response_mismatch;
}
PROOF("defect: D42 a raw request of function 20 takes the runs it asked for, and no others", holds_runs)

constexpr auto queue = "18 04 DE"_hex;

constexpr bool holds_count()
{
    return taken(queue, "18 00 06 00 02 01 B8 12 84"_hex) == errc::none and
           taken(queue, "18 00 02 00 00"_hex) == errc::none and
           taken(queue, "18 00 06 00 01 01 B8 12 84"_hex) == errc::wrong_length and
           taken(queue, "18 00 06 00 03 01 B8 12 84"_hex) == errc::wrong_length and
           taken(queue, "18 00 05 00 01 01 B8 12"_hex) == errc::wrong_length;
}
PROOF("defect: D42 a raw request of function 24 takes as many registers as are counted", holds_count)

/// 32 registers, one more than the function has (AP 6.18).
constexpr bool holds_most()
{
    std::array<std::byte, 5 + 64> told{std::byte{0x18}, std::byte{0}, std::byte{66}, std::byte{0}, std::byte{32}};
    return taken(queue, told) == errc::wrong_length;
}
PROOF("defect: D42 a raw request of function 24 takes no more than the function has", holds_most)

// Of the other functions, and of one's own, nothing more is compared than before.
constexpr bool leaves_others()
{
    return taken("41 01"_hex, "41"_hex) == errc::none and taken("0B"_hex, "0B FF FF 01 08"_hex) == errc::none;
}
PROOF("a raw request of another function takes what its client takes", leaves_others)

constexpr auto identify = "11"_hex;

constexpr bool has_no_function_17()
{
    test::whole_bank bank;
    std::array<std::byte, max_pdu_size> place{};
    serial_diagnostics line;
    bank.id_size = 0;
    byte_view const told = respond<public_functions>(identify, bank, server_profile{}, place, line);
    return told.size() == 2 and told[0] == std::byte{0x91} and told[1] == std::byte{1};
}
PROOF("defect: D42 a unit with an empty identifier has no function 17", has_no_function_17)

} // namespace
