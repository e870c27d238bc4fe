// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/tap.hpp"

#include <array>
#include <chrono>

#include "exit_status.hpp"
#include "line/end_wish.hpp"
#include "line/open_line.hpp"
#include "line/usual_settings.hpp"

namespace tool {

using rtuwire::instant;
using std::chrono::steady_clock;

any_port open_to_listen(choices const& chosen)
{
    if (is_modbus_tcp(chosen.line)) {
        refuse_word(
            chosen.line.port +
            ": a server of Modbus TCP answers whoever asks, and nobody else hears it: there is nothing to listen to "
            "(--trace keeps what a command itself says and hears)");
    }
    if (chosen.line.port.starts_with("sim:")) {
        refuse_word(
            chosen.line.port +
            ": nobody else talks on a simulated line, so that there is nothing to listen to (--trace keeps what "
            "a command itself says and hears)");
    }
    return open_port(chosen.line, setting_in(chosen.line));
}

void listen(any_port& port, choices const& chosen, line_calendar const& calendar, take_frame const& take,
            std::function<bool()> const& goes_on)
{
    line_setting const how = setting_in(chosen.line);
    rtuwire::line_timing const wire{how.baud, how.format};
    rtuwire::line_listener tap{port.timing()};
    auto const began = steady_clock::now();
    auto const is_over = [&] {
        return chosen.last and steady_clock::now() - began >= std::chrono::duration<double>{*chosen.last};
    };
    std::array<std::byte, 512> place;
    while (noted_signal() == 0 and goes_on() and not is_over()) {
        auto const bytes = port.read(place, port.now() + rtuwire::milliseconds(20));
        if (not bytes) {
            throw ended{exit_status::port, port.failure()};
        }
        instant const now = port.now();
        auto const hand_on = [&](rtuwire::heard_frame const& it) { take({it, calendar.of(it.frame.at), wire}); };
        tap.receive(*bytes, now, hand_on);
        if (port.take_receive_error()) {
            tap.receive_error(now, hand_on);
        }
        tap.advance(now, hand_on);
    }
}

} // namespace tool
