// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A hex literal that ends within an octet.
// EXPECT: a hex literal holds two digits for each octet
#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr auto octets = "02 0"_hex;
#else
constexpr auto octets = "02 00"_hex;
#endif
static_assert(octets.size() == 2);
