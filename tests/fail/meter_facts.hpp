// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a device of one's own says of itself beside its rows, for the refused acts.
#pragma once

#include <rtuwire/client.hpp>
#include <rtuwire/rows.hpp>

using namespace rtuwire;

struct meter_facts {
    static constexpr literal name{"meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
};
