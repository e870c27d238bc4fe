// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A check that takes something else than its register holds: another unit, a plain number, nothing, two values.
// EXPECT: a check is called with the value of its register
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
    static_cast<void>(with_hooks(registers).check<setpoint>([](decihertz) { return errc::none; }));
#elif REFUSED == 1
    static_cast<void>(with_hooks(registers).check<setpoint>([](celsius) { return errc::none; }));
#elif REFUSED == 2
    static_cast<void>(with_hooks(registers).check<setpoint>([](int) { return errc::none; }));
#elif REFUSED == 3
    static_cast<void>(with_hooks(registers).check<setpoint>([] { return errc::none; }));
#else
    static_cast<void>(with_hooks(registers).check<setpoint>([](decihertz, decihertz) { return errc::none; }));
#endif
}
