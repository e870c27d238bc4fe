// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One client with constant times and two conversations: a poll of eight registers, then a start.
#include "board.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/client/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

using panel = read_plan<atv320::device, atv320::eta, atv320::rfr, atv320::frh, atv320::lcr, atv320::otr, atv320::eti,
                        atv320::uln, atv320::uop>;
constexpr station<atv320::device> drive{unit_id{1}};
constexpr line_timing timing{19'200, character_format::even_8_1};
#ifdef OF_FOUR_FUNCTIONS
constexpr client_needs<function_list<read_holding_registers, write_single_register, write_multiple_registers<>,
                                     read_write_multiple_registers<>>>
    needs{.timing = timing, .longest_frame = 64, .motors = 1};
constinit basic_client<needs> link;
#else
constinit static_drive_client<timing> link;
#endif

} // namespace

int main()
{
    poller<panel> conversation{drive};
    altivar::start go{drive, 50_Hz};
    for (;;) {
        board::pass(link);
        if (not go.settled()) {
            link.converse(go, board::now());
        } else {
            link.converse(conversation, board::now());
        }
        if (conversation.settled()) {
            board::put(static_cast<std::byte>(conversation.latest().get<atv320::lcr>().count()));
            conversation.again();
        }
    }
}
