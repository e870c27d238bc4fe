// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A user's program: one golden frame, checked when compiling and when run.
#include <rtuwire/rtuwire.hpp>

int main()
{
    using namespace rtuwire;
    constexpr auto expected = "02 03 0C 1E 00 04 27 6C"_hex;
    constexpr read_holding_registers request{.start = 3102, .count = 4};
    static_assert(encode(unit_id{2}, request) == expected);
    return encode(unit_id{2}, request) == expected ? 0 : 1;
}
