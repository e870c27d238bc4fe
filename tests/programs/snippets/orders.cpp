// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/driving.md
// BEGINS: drive_client<> link{timing};
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

template <typename Text> void show(Text const& text);

void snippet()
{
    constexpr line_timing timing{19'200, character_format::even_8_1};
    constexpr station<atv320::device> press{unit_id{1}}, mixer{unit_id{2}}, fan{unit_id{3}};
    // BLOCK
}
