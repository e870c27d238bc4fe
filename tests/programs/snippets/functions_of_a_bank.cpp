// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/registers.md
// BEGINS: using meter_functions = function_list<
#include <rtuwire/server.hpp>

using namespace rtuwire;

inline constexpr reg<count16> total{.code = "SUM", .address = 1};
inline constexpr input_reg<decivolts> mains{.code = "U", .address = 1};
inline constexpr coil relay{.code = "K1", .address = 1};

void snippet(line_timing const& timing)
{
    bank<total, mains, relay> registers;
    // BLOCK
}
