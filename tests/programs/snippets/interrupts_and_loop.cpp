// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/microcontroller.md
// BEGINS: constinit interrupt_queue<> line;
// REST FROM: client link{
#include <rtuwire/client.hpp>

#include "board_of_a_page.hpp"

using namespace rtuwire;

// BLOCK

void snippet()
{
    // REST
}
