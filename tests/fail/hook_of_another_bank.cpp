// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A hook of a register that the bank does not have.
// EXPECT: this bank has no such register
#include <rtuwire/server.hpp>

using namespace rtuwire;

inline constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .max = 600};
inline constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};
inline constexpr reg<celsius> bearing{.code = "TMP", .address = 12};

void act()
{
#ifdef REFUSED
    bank<setpoint, actual> registers;
#else
    bank<setpoint, actual, bearing> registers;
#endif
    static_cast<void>(with_hooks(registers).on_write<bearing>([](celsius) {}));
}
