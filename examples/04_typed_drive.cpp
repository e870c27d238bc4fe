// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive with types: one read, one write, and a plan that is polled into a snapshot. The drive is a
// bank of its registers; wire and clock are variables.
#include <cstdio>

#include <rtuwire/rtuwire.hpp>

#include "support/figures.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using examples::figures;

namespace {

using monitor = read_plan<atv12::device, atv12::eta, atv12::rfr, atv12::lcr, atv12::acc>;

/// Both ends of a line, and the registers of the far one.
struct line_of_two {
    line_timing timing{19'200, character_format::even_8_1};
    client link{timing};
    server node{unit_id{7}, timing};
    bank<atv12::eta, atv12::rfr, atv12::frh, atv12::lcr, atv12::acc> registers{};
    instant now{0};

    template <conversation Conversation> void run(Conversation& conversation)
    {
        while (not conversation.settled()) {
            link.advance(now);
            link.converse(conversation, now);
            if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
                now = now + timing.characters(frame.size());
                link.sent(now);
                node.receive(frame, now);
            }
            node.advance(now);
            node.serve(registers, now);
            if (byte_view const frame = node.poll_transmit(); not frame.empty()) {
                now = now + timing.characters(frame.size());
                node.sent(now);
                link.receive(frame, now);
            }
            now = now + microseconds(100);
        }
    }
};

} // namespace

int main()
{
    constexpr station<atv12::device> drive{unit_id{7}};
    line_of_two line;
    line.registers.set<atv12::eta>(status_word{0x0237});
    line.registers.set<atv12::rfr>(signed_decihertz{487});

    auto tell = write<atv12::acc>(drive, 1.3_s);
    line.run(tell);
    auto ask = read<atv12::rfr>(drive);
    line.run(ask);
    poller<monitor> panel{drive};
    line.run(panel);

    auto const& seen = panel.latest();
    bool const runs = seen.get<atv12::eta>().has(status_bit::operation_enabled);
    std::printf("%zu requests: %s at %s Hz, ramp %s s\n", monitor::request_count, runs ? "running" : "stopped",
                figures(seen.get<atv12::rfr>()).c_str(), figures(seen.get<atv12::acc>()).c_str());
    bool const is_read = ask.outcome() == signed_decihertz{487};
    bool const is_written = tell.outcome().has_value() and seen.get<atv12::acc>() == deciseconds{13};
    return is_read and is_written and runs and panel.outcome().has_value() ? 0 : 1;
}
