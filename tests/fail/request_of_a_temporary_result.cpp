// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request for the bytes of a frame that is gone with the result that held it.
// EXPECT: deleted
// EXPECT: request
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

std::size_t asked()
{
#ifdef REFUSED
    request_frame const request{*encode(unit_id{1}, read_holding_registers{3201, 1})};
#else
    auto const frame = *encode(unit_id{1}, read_holding_registers{3201, 1});
    request_frame const request{frame};
#endif
    return request.frame().size();
}
