// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/registers.md
// BEGINS: bank<pump::setpoint, pump::actual> registers;
#include <rtuwire/server.hpp>

using namespace rtuwire;

namespace pump {
inline constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .max = 600};
inline constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};
} // namespace pump

struct water_tank {
    bool is_empty() const;
};
struct motor_driver {
    void go(decihertz speed);
};
inline water_tank tank;
inline motor_driver inverter;

void snippet(server& node, instant now)
{
    // BLOCK
}
