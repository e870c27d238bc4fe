// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A hook of something else than a holding register.
// EXPECT: a hook is of a holding register: coils and inputs have none
#include <rtuwire/server.hpp>

using namespace rtuwire;

inline constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .max = 600};
inline constexpr coil lamp{.code = "K1", .address = 10};

void act()
{
    bank<setpoint, lamp> registers;
#ifdef REFUSED
    static_cast<void>(with_hooks(registers).on_write<lamp>([](bool) {}));
#else
    static_cast<void>(with_hooks(registers).on_write<setpoint>([](decihertz) {}));
#endif
}
