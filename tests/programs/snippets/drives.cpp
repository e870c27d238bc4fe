// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: README.md
// BEGINS: using namespace rtuwire::altivar;
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

using namespace rtuwire;

void snippet(int ramp)
{
    static_cast<void>(ramp);
    constexpr rtuwire::line_timing timing{19'200, rtuwire::character_format::even_8_1};
    // BLOCK
}
