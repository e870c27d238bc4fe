// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The request of a conversation that is gone, and its bytes with it.
// EXPECT: deleted
// EXPECT: next
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

std::size_t asked()
{
#ifdef REFUSED
    auto const request = single_request{unit_id{7}, read_holding_registers{.start = 3201, .count = 1}}.next();
#else
    single_request const ask{unit_id{7}, read_holding_registers{.start = 3201, .count = 1}};
    auto const request = ask.next();
#endif
    return request->frame().size();
}
