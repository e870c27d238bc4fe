// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One register read by address, over the client. Twin of one_typed.cpp.
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

result<std::uint16_t> read_one(unit_id unit, client& link, instant now)
{
    single_request conversation{unit, read_holding_registers{3204, 1}};
    link.converse(conversation, now);
    link.converse(conversation, now);
    if (not conversation.outcome()) {
        return conversation.outcome().error();
    }
    auto const response = conversation.outcome()->to<read_holding_registers>();
    if (not response) {
        return response.error();
    }
    return response->registers[0];
}
