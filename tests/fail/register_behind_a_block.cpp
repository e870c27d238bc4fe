// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register behind the last one of a block.
// EXPECT: there_is_no_such_register
#include <rtuwire/wire/views.hpp>

using namespace rtuwire;

constexpr register_block two{1, 2};

#ifdef REFUSED
constexpr std::uint16_t word = two[2];
#else
constexpr std::uint16_t word = two[1];
#endif
static_assert(word == 2);
