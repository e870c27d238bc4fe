// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An action that takes something else than its register holds: another unit, a plain number, nothing, two values.
// EXPECT: an action is called with the value of its register
// CASES: 4
#include <rtuwire/server.hpp>

using namespace rtuwire;

inline constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .max = 600};
inline constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};
inline constexpr reg<celsius> bearing{.code = "TMP", .address = 12};

void act()
{
    bank<setpoint, actual> registers;
#ifndef REFUSED
    static_cast<void>(with_hooks(registers).on_write<setpoint>([](decihertz) {}));
#elif REFUSED == 1
    static_cast<void>(with_hooks(registers).on_write<setpoint>([](celsius) {}));
#elif REFUSED == 2
    static_cast<void>(with_hooks(registers).on_write<setpoint>([](int) {}));
#elif REFUSED == 3
    static_cast<void>(with_hooks(registers).on_write<setpoint>([] {}));
#else
    static_cast<void>(with_hooks(registers).on_write<setpoint>([](decihertz, decihertz) {}));
#endif
}
