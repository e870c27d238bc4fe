// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A check of a plain word that wants an amount.
// EXPECT: a check of an address is called with its word, [&](std::uint16_t asked) { ... }
#include <rtuwire/server.hpp>

using namespace rtuwire;

void act()
{
    word_bank<4> registers{100};
#ifdef REFUSED
    static_cast<void>(with_hooks(registers).check(100, [](decihertz) { return errc::none; }));
#else
    static_cast<void>(with_hooks(registers).check(100, [](std::uint16_t) { return errc::none; }));
#endif
}
