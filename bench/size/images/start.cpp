// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The reset vector of every image.
#include <cstdint>

int main();
#pragma GCC diagnostic ignored "-Wpedantic"

void reset();
void reset()
{
    main();
    for (;;) {
    }
}

[[gnu::section(".vectors"), gnu::used]] void (*const vectors[])() = {reinterpret_cast<void (*)()>(0x2001'0000), reset};
