// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A hex literal that ends within a byte.
// EXPECT: a hex literal holds two digits for each byte
#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr auto bytes = "02 0"_hex;
#else
constexpr auto bytes = "02 00"_hex;
#endif
static_assert(bytes.size() == 2);
