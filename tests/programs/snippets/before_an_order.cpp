// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/driving.md
// BEGINS: set_channel by_line
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/drives.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

template <typename... Values> void show(Values const&... values);

void snippet()
{
    constexpr station<atv320::device> drive{unit_id{7}};
    constexpr station<atv28::device> old{unit_id{3}};
    // BLOCK
}
