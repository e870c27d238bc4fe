// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Prints the menu numbers of the ATV310, a line each: manual, number, and the address of the parameter that the map has
// for its mnemonic. For compare_menu.py.
#include <iostream>
#include <string_view>

#include <rtuwire/altivar/atv310_parameters.hpp>

namespace {

using namespace rtuwire::altivar;

void print(std::string_view manual, menu_numbers const& menu)
{
    for (menu_number const& each : menu.rows()) {
        parameter const* const row = atv310::parameters.by_code(each.code);
        std::cout << manual << '\t' << std::string_view{each.number} << '\t' << (row == nullptr ? 0 : row->address)
                  << '\n';
    }
}

} // namespace

int main()
{
    print("2014", atv310::menu_2014);
    print("2026", atv310::menu_2026);
    return std::cout.flush() ? 0 : 1;
}
