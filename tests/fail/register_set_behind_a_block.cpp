// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register set behind the last one of a block; also where nothing is checked when the program runs.
// EXPECT: there_is_no_such_register
#define RTUWIRE_CHECKED 0
#include <rtuwire/wire/views.hpp>

using namespace rtuwire;

constexpr register_block<2> with(std::size_t index)
{
    register_block two{1, 2};
    two.set(index, 7);
    return two;
}

#ifdef REFUSED
constexpr register_block words = with(2);
#else
constexpr register_block words = with(1);
#endif
static_assert(words[1] == 7);
