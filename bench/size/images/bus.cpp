// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A bus of four slots with three conversations: a cycle, a poll of eight registers, a start.
#include "board.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

using panel = read_plan<atv320::device, atv320::eta, atv320::rfr, atv320::frh, atv320::lcr, atv320::otr, atv320::eti,
                        atv320::uln, atv320::uop>;
constexpr station<atv320::device> first{unit_id{1}};
constexpr station<atv320::device> second{unit_id{2}};
constexpr station<atv320::device> third{unit_id{3}};

} // namespace

int main()
{
    bus<4> line{line_timing{19'200, character_format::even_8_1}};
    cyclic<atv320::device> cycle{first};
    poller<panel> conversation{second};
    altivar::start go{third, 50_Hz};
    for (;;) {
        board::pass(line);
        auto const now = board::now();
        line.converse(0, cycle, now);
        line.converse(1, conversation, now);
        line.converse(2, go, now);
        static_cast<void>(cycle.run(1'500_rpm));
        if (conversation.settled()) {
            board::put(static_cast<std::byte>(conversation.latest().get<atv320::lcr>().count()));
            conversation.again();
        }
    }
}
