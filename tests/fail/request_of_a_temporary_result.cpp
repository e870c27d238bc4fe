// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request for the octets of a frame that is gone with the result that held it.
// EXPECT: deleted
// EXPECT: request
#include <rtuwire/client/conversation.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>

using namespace rtuwire;

std::size_t asked()
{
#ifdef REFUSED
    request const question{*encode(unit_id{1}, read_holding_registers{3201, 1})};
#else
    auto const frame = *encode(unit_id{1}, read_holding_registers{3201, 1});
    request const question{frame};
#endif
    return question.frame().size();
}
