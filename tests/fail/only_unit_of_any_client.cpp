// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request at address 0 that is to be answered, by a client that sends broadcasts there.
// EXPECT: give its client_needs has_only_unit
#include <rtuwire/client.hpp>

using namespace rtuwire;

inline constexpr client_needs<> alone{.has_only_unit = true};

void act()
{
#ifdef REFUSED
    client link{line_timing{19'200, character_format::even_8_1}};
#else
    basic_client<alone> link{line_timing{19'200, character_format::even_8_1}};
#endif
    single_request ask{only_unit, read_holding_registers{.start = 100, .count = 1}};
    link.converse(ask, instant{0});
}
