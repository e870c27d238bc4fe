// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A simulated ATV320 on a board, as unit 1: something to try a controller against.
#include "board.hpp"
#include "line.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;

namespace {

constexpr unit_id address{1};
// An emulated UART delivers in lumps, as a host's does; a real board takes line_timing{...}.
constexpr auto timing = line_timing::host(19'200, character_format::even_8_1);

/// Shared by the interrupts and the loop.
constinit board::half_duplex_line<board::line_uart, board::driver_enable> line;

} // namespace

void on_line_interrupt() { line.on_interrupt(board::now()); }
void on_tick() { line.on_tick(board::now()); }

int main()
{
    sim::unit<altivar::atv320::device> drive{address, timing, board::now()};
    board::start_interrupts();
    board::print("ready\n");
    for (;;) {
        line.serve(drive, board::now());
        board::sleep(line);
    }
}
