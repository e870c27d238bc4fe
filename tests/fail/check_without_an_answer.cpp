// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A check that does not say what to answer: it returns a bool, or nothing.
// EXPECT: a check returns an errc: none, illegal_data_value (exception 03: not this value) or server_device_failure
// CASES: 2
#include <rtuwire/server.hpp>

using namespace rtuwire;

inline constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .max = 600};
inline constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};
inline constexpr reg<celsius> bearing{.code = "TMP", .address = 12};

void act()
{
    bank<setpoint, actual> registers;
#ifndef REFUSED
    auto served = with_hooks(registers).check<setpoint>([](decihertz) { return errc::none; });
#elif REFUSED == 1
    auto served = with_hooks(registers).check<setpoint>([](decihertz) { return true; });
#else
    auto served = with_hooks(registers).check<setpoint>([](decihertz) {});
#endif
    static_cast<void>(served);
}
