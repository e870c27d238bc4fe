// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The server with its framer and its times, functions 03, 06, 08, 16, 23 and 43/14.
#include "board.hpp"

#include <rtuwire/server/server.hpp>

using namespace rtuwire;

namespace {

constexpr device_object objects[] = {{vendor_name, "A"}, {product_code, "B"}, {2, "1"}};
constexpr server_profile profile{.identity = identity_of<objects>};
constexpr unit_id address{1};
word_bank<16> bank;

} // namespace

int main()
{
    server node{address, line_timing{19'200, character_format::even_8_1}, profile};
    for (;;) {
        board::pass(node);
        node.serve(bank, board::now());
    }
}
