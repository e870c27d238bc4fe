// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// For a block that says all it needs.
#include <rtuwire/rtuwire.hpp>

#include <rtuwire/port.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;

void snippet()
{
    // BLOCK
}
