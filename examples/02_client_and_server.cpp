// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Both ends in one program and no operating system between them: how firmware drives the engines. Here
// the wire is an assignment and the clock a variable.
#include <cstdio>

#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

int main()
{
    line_timing const line{19'200, character_format::even_8_1};
    client link{line};
    server node{unit_id{7}, line};
    word_bank<16> registers;
    static_cast<void>(registers.set(3, 1500));

    single_request ask_speed{unit_id{7}, read_holding_registers{.start = 3, .count = 1}};
    instant now{0};
    while (not ask_speed.settled()) {
        link.advance(now);
        link.converse(ask_speed, now);
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            now = now + line.characters(frame.size());
            link.sent(now);
            node.receive(frame, now);
        }
        node.advance(now);
        node.serve(registers, now);
        if (byte_view const frame = node.poll_transmit(); not frame.empty()) {
            now = now + line.characters(frame.size());
            node.sent(now);
            link.receive(frame, now);
        }
        now = now + microseconds(100);
    }
    auto const outcome = ask_speed.outcome();
    if (not outcome) {
        return 1;
    }
    auto const response = outcome->to<read_holding_registers>();
    std::printf("register 3 of unit 7: %u, after %u us\n", response ? response->registers[0] : 0U, now.microseconds);
    return response and response->registers[0] == 1500 ? 0 : 1;
}
