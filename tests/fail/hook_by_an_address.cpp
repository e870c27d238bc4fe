// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An address where the bank's registers have types.
// EXPECT: the registers of this bank have types: name one, .on_write<R>(call), instead of an address
#include <rtuwire/server.hpp>

using namespace rtuwire;

inline constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .max = 600};
inline constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};
inline constexpr reg<celsius> bearing{.code = "TMP", .address = 12};

void act()
{
    bank<setpoint, actual> registers;
#ifdef REFUSED
    static_cast<void>(with_hooks(registers).on_write(10, [](std::uint16_t) {}));
#else
    static_cast<void>(with_hooks(registers).on_write<setpoint>([](decihertz) {}));
#endif
}
