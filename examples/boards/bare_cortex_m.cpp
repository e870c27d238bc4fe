// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A Cortex-M without an operating system or a maker's library: a client that polls a register. board.hpp and line.hpp of
// examples/firmware have clock, sleep and start; what is your chip's is a header like those in examples/firmware/boards.
#include "board.hpp"
#include "line.hpp"

#include <cstdint>

#include <rtuwire/client.hpp>

using namespace rtuwire;

std::uint16_t value = 0;   // of the register: show it where trouble is errc::none
errc trouble = errc::busy; // why there is no value, in words name(trouble); busy until the first answer or time-out

namespace {

/// Enables the driver before the first start bit and disables it after the last stop bit.
constinit board::half_duplex_line<board::line_uart, board::driver_enable> line;

using number = quantity<dimensionless, std::uint16_t>;

void say(single_request<read_holding_registers> const& ask)
{
    auto const response = ask.outcome();
    trouble = response.error();
    if (response) {
        value = response->to<read_holding_registers>()->registers[0];
        board::print("value ");
        board::print(number{value});
    } else {
        board::print(trouble);
    }
    board::print("\n");
}

} // namespace

void on_line_interrupt() { line.on_interrupt(board::now()); }
void on_tick() { line.on_tick(board::now()); }

int main()
{
    board::start_interrupts();
    // An emulated UART delivers in lumps, as a host's does; a real board takes line_timing{...}.
    client link{line_timing::host(19'200, character_format::even_8_1)};
    single_request ask{unit_id{7}, read_holding_registers{.start = 3201, .count = 1}};
    for (;;) {
        line.serve(link, board::now()); // receives, advances, sends
        link.converse(ask, board::now());
        if (ask.settled()) {
            say(ask);
            ask.again();
        }
        board::sleep(line);
    }
}
