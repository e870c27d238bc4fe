// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register whose second word has no address.
// EXPECT: a register ends at address 65535 or before
#include "meter.hpp"

inline constexpr reg<float32<kilowatt_hours>> last{.code = "E1", .address = 65534};
inline constexpr reg<float32<kilowatt_hours>> late{.code = "E2", .address = 65535};

void act()
{
#ifdef REFUSED
    static_cast<void>(table<late>::size);
#else
    static_cast<void>(table<last>::size);
#endif
}
