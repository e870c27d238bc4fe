// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 2: a client asks a server: both ends in one program, without hardware. The bench gives them the bytes and the
// time; on a board the same client and server get them from a UART and a timer. Builds on lesson 1.
#include <cstdio>

#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

int main()
{
    word_bank<16> registers;
    static_cast<void>(registers.set(3, 1500));
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{unit_id{7}, registers}};

    single_request ask_speed{unit_id{7}, read_holding_registers{.start = 3, .count = 1}};
    auto const outcome = bench.run(ask_speed);
    if (not outcome) {
        return 1;
    }
    auto const response = outcome->to<read_holding_registers>();
    std::printf("register 3 of unit 7: %u, after %u us\n", response ? response->registers[0] : 0U,
                bench.now().microseconds);
    return response and response->registers[0] == 1500 ? 0 : 1;
}
