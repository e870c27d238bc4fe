// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Sixteen registers, served by functions 03, 06, 16 and 23; with ALL_OF_REGISTERS by 08 and 43/14, too.
#include "../images/board.hpp"

#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/server.hpp>

using namespace rtuwire;

namespace {

constexpr unit_id address{1};
constexpr line_timing timing{19'200, character_format::even_8_1};
word_bank<16> bank;

#ifdef ALL_OF_REGISTERS
using engine = server;
constexpr device_object objects[] = {{vendor_name, "A"}, {product_code, "B"}, {2, "1"}};
constexpr server_profile profile{.identity = identity_of<objects>};
#else
using engine = server::with<function_list<read_holding_registers, write_single_register, write_multiple_registers<>,
                                          read_write_multiple_registers<>>>;
constexpr server_profile profile{};
#endif

} // namespace

char size_of_object[sizeof(engine)];

int main()
{
    engine node{address, timing, profile};
    for (;;) {
        board::pass(node);
        node.serve(bank, board::now());
    }
}
