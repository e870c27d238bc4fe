// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request to everyone, which nobody would answer.
// EXPECT: a broadcast has no response, so only a write can be broadcast
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr auto frame = encode(broadcast, read_holding_registers{3201, 1});
#else
constexpr auto frame = encode(unit_id{1}, read_holding_registers{3201, 1});
#endif
static_assert(frame.has_value());
