// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/registers.md
// BEGINS: namespace meter::rows {
// REST FROM: auto ask = read<meter::row<"ENERGY">>
// FOR: // name, functions, limits, units and readable as below => FACTS
// FOR: { ... } => { static_cast<void>(each.address); }
#include <array>

#include <rtuwire/client.hpp>
#include <rtuwire/rows.hpp>
#include <rtuwire/server.hpp>

using namespace rtuwire;

#define FACTS                                                                                                          \
    static constexpr literal name{"meter"};                                                                            \
    static constexpr function_set functions = all_functions;                                                           \
    static constexpr device_limits limits{.read = 16};                                                                 \
    static constexpr unit_range units{};                                                                               \
    static constexpr std::array<address_range, 0> readable{};

// BLOCK

void snippet()
{
    constexpr station<meter::device> unit{unit_id{3}};
    // REST
}
