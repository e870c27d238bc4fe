// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client with a plan of eight monitoring registers.
#include "board.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/client/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

using panel = read_plan<atv320::device, atv320::eta, atv320::rfr, atv320::frh, atv320::lcr, atv320::otr, atv320::eti,
                        atv320::uln, atv320::uop>;
constexpr station<atv320::device> drive{unit_id{1}};

} // namespace

int main()
{
    client link{line_timing{19'200, character_format::even_8_1}};
    poller<panel> conversation{drive};
    for (;;) {
        conversation.again();
        while (not conversation.settled()) {
            board::pass(link);
            link.converse(conversation, board::now());
        }
        board::put(static_cast<std::byte>(conversation.latest().get<atv320::lcr>().count()));
    }
}
