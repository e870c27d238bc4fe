// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/registers.md
// BEGINS: namespace meter {
// REST FROM: auto ask = read<meter::energy>
// FOR: /* name, functions, limits, units, readable */ => static constexpr literal name{"meter"}; static constexpr function_set functions = all_functions; static constexpr device_limits limits{}; static constexpr unit_range units{}; static constexpr std::array<address_range, 0> readable{};
#include <iostream>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;

// BLOCK

constexpr station<meter::device> unit{unit_id{3}};

void act(int n)
{
    // REST
}
