// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 14: what comes before the first order: the channels are set, the drive is checked, a setting goes to all
// drives, and somebody else's drive is watched. An ATV28's link is released. The drives are simulated. Builds on lesson
// 12.
#include <iostream>

#include <rtuwire/print.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};

void show(char const* what, reason const& how) { std::cout << what << ": " << how << '\n'; }

bool prepare_an_atv320()
{
    constexpr station<atv320::device> drive{unit_id{7}};
    sim::bench bench{timing, drive};

    set_channel by_line{drive, channel_settings<atv320::device>::by_modbus()};
    show("channels", bench.run(by_line));

    static_cast<void>(bench.run(broadcast_setting<atv320::device, atv320::tto>(3_s)));

    // Thirty drives, 25 ms for each exchange, 400 ms for one that is off.
    duration const gap = longest_gap_of(30, milliseconds(25), milliseconds(400));
    check_supervision safe{drive, {.longest_gap = gap}};
    show("to be ordered", bench.run(safe));
    supervision_report const& found = safe.report();
    std::cout << "  register " << found.address << "; time-out " << found.period.timeout.microseconds / 1'000
              << " ms, needed " << found.period.shortest_timeout().microseconds / 1'000 << " ms\n";

    static_cast<void>(bench.run(broadcast_setting<atv320::device, atv320::tto>(5_s)));
    check_supervision again{drive, {.longest_gap = gap}};
    show("to be ordered", bench.run(again));

    watch eye{drive};
    bench.run_until([&] { return eye.rounds() >= 2; }, milliseconds(1'000), eye);
    std::cout << "seen: " << eye.state() << '\n'; // a fault that a program before this one left would be seen here
    std::cout << "left: it trips when nobody has asked it for 5 s (SLF1)\n";
    return by_line.succeeded() and safe.reason().kind == outcome_kind::timeout_too_short and again.ready();
}

bool release_an_atv28()
{
    constexpr station<atv28::device> old{unit_id{7}};
    sim::bench bench{timing, old};

    atv28::activate_link take{old};
    show("ATV28 by its link", bench.run(take));
    atv28::direct_start go{old, -20_Hz};
    show("run directly", bench.run(go));
    bool const has_run = go.running();
    atv28::direct_stop rest{old, atv28::direct_stop_by::fast_stop};
    show("stopped directly", bench.run(rest));
    recall_from_eeprom recall{old};
    show("recalled", bench.run(recall));

    bench.drive().set_input(1, true); // somebody asks to run at the terminals
    atv28::release_link give{old};
    show("released", bench.run(give));
    bench.drive().set_input(1, false);
    atv28::release_link once_more{old};
    show("released", bench.run(once_more)); // its terminals command: a run input that closes now runs the motor
    std::cout << "left: released or not, it trips when nobody has asked it for 7 s (SLF)\n";
    return take.succeeded() and has_run and not go.running() and rest.succeeded() and recall.succeeded() and
           give.reason().kind == outcome_kind::run_input_closed and once_more.succeeded();
}

} // namespace

int main() { return prepare_an_atv320() and release_an_atv28() ? 0 : 1; }
