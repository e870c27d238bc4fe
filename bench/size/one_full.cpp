// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One register of the full map, read by name over the client. Twin of one_typed.cpp: a larger map costs no flash.
#include <rtuwire/altivar/atv320_parameters.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/client/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

result<std::uint16_t> read_one(station<atv320::full_device> const& drive, client& link, instant now)
{
    auto conversation = read<atv320::parameter<"SP2">>(drive);
    link.converse(conversation, now);
    link.converse(conversation, now);
    if (not conversation.outcome()) {
        return conversation.outcome().error();
    }
    return conversation.outcome()->count();
}
