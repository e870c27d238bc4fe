// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The board alone, for images that cut frames by themselves and never sleep.
#include "board.hpp"

namespace {

/// What arrives goes back; a function of its own, as a pass is.
[[gnu::noinline]] void pass_back()
{
    rtuwire::instant const now = board::now();
    if (board::has_byte()) {
        std::byte const byte = board::byte();
        board::put({&byte, 1});
    }
    static_cast<void>(now);
}

} // namespace

int main()
{
    for (;;) {
        pass_back();
    }
}
