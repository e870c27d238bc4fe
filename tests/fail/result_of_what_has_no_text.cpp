// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A result of registers on a stream: which of them, in which form, only the program knows.
// EXPECT: include_rtuwire_print_hpp_or_show_its_value_or_its_error
// ALONE
#include <iostream>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;

void act(result<read_holding_registers::response> const& found)
{
#ifdef REFUSED
    std::cout << found;
#else
    std::cout << found.has_value() << found.error();
#endif
}
