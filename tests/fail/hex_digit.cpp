// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A hex literal with something else in it: the neighbours of each kind of digit.
// EXPECT: a_hex_literal_holds_only_hexadecimal_digits_and_spaces
// CASES: 6
#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
constexpr auto bytes = "02 0F"_hex;
#elif REFUSED == 1
constexpr auto bytes = "02 0G"_hex;
#elif REFUSED == 2
constexpr auto bytes = "02 0g"_hex;
#elif REFUSED == 3
constexpr auto bytes = "02 0@"_hex;
#elif REFUSED == 4
constexpr auto bytes = "02 0`"_hex;
#elif REFUSED == 5
constexpr auto bytes = "02 0:"_hex;
#else
constexpr auto bytes = "02 0/"_hex;
#endif
static_assert(bytes.size() == 2);
