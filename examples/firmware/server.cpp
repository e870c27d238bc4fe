// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server with typed registers: a pump whose setpoint any Modbus master writes, as unit 1.
#include "board.hpp"
#include "line.hpp"

#include <rtuwire/client.hpp>
#include <rtuwire/server.hpp>

using namespace rtuwire;

namespace {

constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .min = 0, .max = 600};
constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};
constexpr reg<celsius> bearing{.code = "TMP", .address = 12, .mode = access::read_only};

constexpr device_object objects[] = {{vendor_name, "rtuwire"}, {product_code, "pump"}, {major_minor_revision, "1.0"}};
constexpr server_profile profile{.identity = identity_of<objects>};
constexpr unit_id address{1};

/// Shared by the interrupts and the loop.
constinit board::half_duplex_line<board::line_uart, board::driver_enable> line;

} // namespace

void on_line_interrupt() { line.on_interrupt(board::now()); }
void on_tick() { line.on_tick(board::now()); }

int main()
{
    // An emulated UART delivers in lumps, as a host's does; a real board takes line_timing{...}.
    server node{address, line_timing::host(19'200, character_format::even_8_1), profile};
    bank<setpoint, actual, bearing> registers;
    registers.set<bearing>(celsius{-5});
    board::start_interrupts();
    board::print("ready\n");
    for (;;) {
        instant const now = board::now();
        line.serve(node, now);
        node.serve(registers, now);
        if (registers.take_written<setpoint>()) {
            registers.set<actual>(registers.get<setpoint>());
        }
        board::sleep(line);
    }
}
