// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/simulated-drive.md
// BEGINS: #include <rtuwire/altivar/atv320.hpp>
// REST FROM: constexpr station
// BLOCK
using namespace rtuwire;
using namespace rtuwire::altivar;

void snippet()
{
    // REST
}
