// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: README.md
// BEGINS: client link{
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/client.hpp>

#include "board_of_a_page.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;

constinit interrupt_queue<> line;
template <typename Value> void show(Value const& value);

void snippet()
{
    constexpr station<atv12::device> drive{unit_id{7}};
    // BLOCK
}
