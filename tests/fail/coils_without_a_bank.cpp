// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server of coils whose bank has none.
// EXPECT: a server of function 01 needs a bank with coils()
#include <rtuwire/server.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

struct registers_and_coils : word_bank<4> {
#ifndef REFUSED
    bit_bank<8> switched{};
    constexpr auto& coils() { return switched; }
#endif
};

void act()
{
    basic_server<loopback_only, function_list<read_holding_registers, read_coils>> node{
        unit_id{1}, line_timing{19'200, character_format::even_8_1}};
    registers_and_coils bank;
    node.serve(bank, instant{0});
}
