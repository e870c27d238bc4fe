// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A refusal where everything is written already.
// EXPECT: an action returns nothing: what is refused is refused by a check, before the write
#include <rtuwire/server.hpp>

using namespace rtuwire;

inline constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .max = 600};
inline constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};
inline constexpr reg<celsius> bearing{.code = "TMP", .address = 12};

void act()
{
    bank<setpoint, actual> registers;
#ifdef REFUSED
    auto served = with_hooks(registers).on_write<setpoint>([](decihertz) { return errc::server_device_failure; });
#else
    auto served = with_hooks(registers).on_write<setpoint>([](decihertz) {});
#endif
    static_cast<void>(served);
}
