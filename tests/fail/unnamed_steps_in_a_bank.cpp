// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A ramp time in a bank, whose steps another register sets.
// EXPECT: another register sets this register's steps: name them with restepped
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/server/typed_bank.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

void act()
{
#ifdef REFUSED
    static_cast<void>(bank<atv320::acc, atv320::inr>{});
#else
    static_cast<void>(bank<restepped<deciseconds, atv320::acc>, atv320::inr>{});
#endif
}
