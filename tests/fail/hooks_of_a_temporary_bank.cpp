// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Hooks of a bank that is gone when they are served.
// EXPECT: a bank that ends with its expression cannot be served: give it a name, and the hooks refer to it
#include <rtuwire/server.hpp>

using namespace rtuwire;

void act()
{
#ifdef REFUSED
    static_cast<void>(with_hooks(word_bank<4>{100}));
#else
    word_bank<4> registers{100};
    static_cast<void>(with_hooks(registers));
#endif
}
