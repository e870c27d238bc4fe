// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A hex literal with something else in it.
// EXPECT: a_hex_literal_holds_only_hexadecimal_digits_and_spaces
#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr auto octets = "02 0G"_hex;
#else
constexpr auto octets = "02 0F"_hex;
#endif
static_assert(octets.size() == 2);
