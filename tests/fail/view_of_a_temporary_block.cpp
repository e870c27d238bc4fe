// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request that would keep a view of words that are gone.
// EXPECT: register_view
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr write_multiple_registers<> kept{100, register_block{1, 2}};
#else
constexpr write_multiple_registers kept{100, register_block{1, 2}};
#endif
static_assert(kept.size() == 10);
