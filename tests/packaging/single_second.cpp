// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The other of two files that include the single header: without the parts for a host.
#include <rtuwire.hpp>

bool frame_is_right();

bool frame_is_right()
{
    using namespace rtuwire;
    constexpr auto expected = "02 03 0C 1E 00 04 27 6C"_hex;
    return encode(unit_id{2}, read_holding_registers{.start = 3102, .count = 4}) == expected;
}
