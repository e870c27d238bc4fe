// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 13: three drives on one line, each with conversations of its own, in the slots of a bus. They take turns
// request by request; a drive that is off costs the others little of the line's time. Builds on lessons 3 and 11.
#include <iostream>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

/// Frequency and current of any drive that has both.
template <typename Device, auto const& Frequency, auto const& Current>
using panel_of = poller<read_plan<Device, Frequency, Current>>;

int main()
{
    constexpr line_timing times{19'200, character_format::even_8_1};
    constexpr station<atv320::device> press{unit_id{1}}, fan{unit_id{3}};
    constexpr station<atv12::device> pump{unit_id{2}};
    // One slot for each conversation below. What is off may take a tenth of the line's time.
    sim::bench bench{bus<3>{times, {}, {.silent_share = 10}}, press, pump, fan};
    bench.cut<2>(); // the fan is off

    panel_of<atv320::device, atv320::rfr, atv320::lcr> of_press{press};
    panel_of<atv12::device, atv12::rfr, atv12::lcr> of_pump{pump};
    panel_of<atv320::device, atv320::rfr, atv320::lcr> of_fan{fan};
    int rounds[3]{}, failures[3]{};
    auto const again = [&](auto& panel, int which) { // counts a round, and begins the next
        if (panel.settled()) {
            ++(panel.outcome() ? rounds : failures)[which];
            panel.again();
        }
    };
    // The slots are numbered as the conversations stand here. In a firmware: link.converse(0, of_press, now)...
    bench.run_until(
        [&] {
            again(of_press, 0);
            again(of_pump, 1);
            again(of_fan, 2);
            return false;
        },
        milliseconds(10'000), of_press, of_pump, of_fan);
    std::cout << "press: " << of_press.latest().get<atv320::rfr>() << ", pump: " << of_pump.latest().get<atv12::rfr>()
              << '\n';
    char const* const names[] = {"press", "pump", "fan"};
    for (int i = 0; i < 3; ++i) {
        std::cout << names[i] << ": " << rounds[i] << " rounds, " << failures[i] << " without a response\n";
    }
    std::cout << "left: press and pump trip when nobody has asked them for 10 s (SLF1)\n";
    bench.run_for(milliseconds(11'000)); // a request was under way
    bool const have_tripped = bench.drive<0>().fault() != 0 and bench.drive<1>().fault() != 0;
    // Nobody waits for the one that is off.
    bool const is_fair =
        rounds[0] > 100 and rounds[1] > 100 and rounds[0] - rounds[1] < 50 and rounds[1] - rounds[0] < 50;
    return is_fair and have_tripped and rounds[2] == 0 and failures[2] > 0 ? 0 : 1;
}
