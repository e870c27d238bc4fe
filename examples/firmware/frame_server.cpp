// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The pump of server.cpp behind DMA and an idle-line interrupt: a frame in, a frame out, in one place. There
// is no engine: the receiver tells where a frame ends.
#include "board.hpp"
#include "frames.hpp"

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

using dma = board::dma_stand_in<board::line_uart>;

/// Shared by the interrupts and the loop.
constinit board::frame_line<dma, board::driver_enable> line;

} // namespace

void on_line_interrupt() { dma::on_interrupt(line); }
void on_tick() { dma::on_tick(line); }

int main()
{
    bank<setpoint, actual, bearing> registers;
    loopback_only diagnostics;
    registers.set<bearing>(celsius{-5});
    line.begin();
    board::start_interrupts();
    board::print("ready\n");
    for (;;) {
        if (auto const [place, size] = line.poll_frame(); size > 0) {
            byte_span const response = response_frame(place, size, address, registers, profile, diagnostics);
            if (response.empty()) {
                line.release();
            } else {
                line.send(response);
            }
        }
        if (registers.take_written<setpoint>()) {
            registers.set<actual>(registers.get<setpoint>());
        }
        board::sleep(line);
    }
}
