// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/microcontroller.md
// BEGINS: pseudo_terminal both;
#include <thread>

#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/server.hpp>

using namespace rtuwire;

int snippet()
{
    server node{unit_id{7}, line_timing::without_wire()};
    word_bank<8> bank;
    // BLOCK
    device.join();
    return 0;
}
