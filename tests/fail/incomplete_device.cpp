// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A device of one's own that does not say all that a device says.
// EXPECT: a device has limits: `static constexpr device_limits limits`
#include <rtuwire/ask/access.hpp>
#include <rtuwire/table/device.hpp>

using namespace rtuwire;

inline constexpr reg<decihertz> speed{.code = "SPD", .address = 100};

struct pump {
    static constexpr literal name{"pump"};
    static constexpr function_set functions{function_code::read_holding_registers};
#ifndef REFUSED
    static constexpr device_limits limits{125, 123, 0, 0};
#endif
    static constexpr unit_range units{1, 247};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<speed>;
};

void act()
{
    station<pump> const drive{unit_id{7}};
    static_cast<void>(read<speed>(drive));
}
