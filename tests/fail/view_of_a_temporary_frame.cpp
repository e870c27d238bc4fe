// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A view of a frame that is gone with the result that held it.
// EXPECT: a frame that ends with its expression gives no view: give it a name first
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

std::size_t kept_size()
{
#ifdef REFUSED
    byte_view const kept = *encode(unit_id{1}, read_holding_registers{3201, 1});
#else
    auto const frame = *encode(unit_id{1}, read_holding_registers{3201, 1});
    byte_view const kept = frame;
#endif
    return kept.size();
}
