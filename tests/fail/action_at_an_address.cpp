// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An action at a plain word that wants nothing.
// EXPECT: an action at an address is called with its word, [&](std::uint16_t now) { ... }
#include <rtuwire/server.hpp>

using namespace rtuwire;

void act()
{
    word_bank<4> registers{100};
#ifdef REFUSED
    static_cast<void>(with_hooks(registers).on_write(100, [] {}));
#else
    static_cast<void>(with_hooks(registers).on_write(100, [](std::uint16_t) {}));
#endif
}
