// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register behind the last one of a view, though bytes follow it; also where nothing is checked when the program runs.
// EXPECT: there_is_no_such_register
#define RTUWIRE_CHECKED 0
#include <rtuwire/wire/views.hpp>

using namespace rtuwire;

constexpr std::array<std::byte, 6> bytes{std::byte{0}, std::byte{1}, std::byte{0},
                                         std::byte{2}, std::byte{0}, std::byte{3}};
constexpr register_view two{byte_view{bytes}.first(4)};

#ifdef REFUSED
constexpr std::uint16_t word = two[2];
#else
constexpr std::uint16_t word = two[1];
#endif
static_assert(word == 2);
