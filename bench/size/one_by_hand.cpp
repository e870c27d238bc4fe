// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One register read by address, over the client. Twin of one_typed.cpp.
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/single_question.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>

using namespace rtuwire;

result<std::uint16_t> read_one(unit_id unit, client& link, instant now)
{
    single_question talk{unit, read_holding_registers{3204, 1}};
    link.converse(talk, now);
    link.converse(talk, now);
    if (not talk.outcome()) {
        return talk.outcome().error();
    }
    auto const answer = talk.outcome()->to<read_holding_registers>();
    if (not answer) {
        return answer.error();
    }
    return answer->registers[0];
}
