// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The board alone: what every image has besides rtuwire.
#include "board.hpp"

namespace {

struct nothing {
    static void receive(std::byte byte, rtuwire::instant) { board::put(byte); }
    static void receive_error(rtuwire::instant) {}
    static void advance(rtuwire::instant) {}
    static void sent(rtuwire::instant) {}
    static std::span<std::byte const> poll_transmit() { return {}; }
    static rtuwire::deadline poll_deadline() { return {}; }
};

} // namespace

int main()
{
    nothing none;
    for (;;) {
        board::pass(none);
    }
}
