// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Two registers of a bank share an address, and nobody ever names one of them.
// EXPECT: these_registers_overlap<total, load>
#include <rtuwire/server.hpp>

using namespace rtuwire;

inline constexpr reg<unsigned32<>> total{.code = "E", .address = 7};
inline constexpr reg<count16> load{.code = "P", .address = 8};

void act()
{
#ifdef REFUSED
    static_cast<void>(bank<total, load>{});
#else
    static_cast<void>(bank<total>{});
#endif
}
