// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A hook that would never be called.
// EXPECT: this register is read-only: no client writes it, so no hook would ever be called
#include <rtuwire/server.hpp>

using namespace rtuwire;

inline constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .max = 600};
inline constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};
inline constexpr reg<celsius> bearing{.code = "TMP", .address = 12};

void act()
{
    bank<setpoint, actual> registers;
#ifdef REFUSED
    static_cast<void>(with_hooks(registers).check<actual>([](decihertz) { return errc::none; }));
#else
    static_cast<void>(with_hooks(registers).check<setpoint>([](decihertz) { return errc::none; }));
#endif
}
