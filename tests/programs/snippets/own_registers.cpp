// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/registers.md
// BEGINS: namespace meter {
// REST FROM: auto ask = read<meter::energy>
#include <array>
#include <iostream>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;

// BLOCK

void snippet(int n)
{
    // REST
}
