// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What comes before the first order: the channels are set, the drive is checked, a setting goes to all drives, and
// somebody else's drive is watched. An ATV28's link is released. The drives are simulated.
#include <cstdio>

#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};

void show(char const* what, literal how) { std::printf("%s: %.*s\n", what, static_cast<int>(how.size()), how.begin()); }

bool prepare_an_atv320()
{
    constexpr station<atv320::device> drive{unit_id{7}};
    sim::bench bench{timing, drive};

    set_channel by_line{drive, channel_settings<atv320::device>::by_modbus()};
    show("channels", name_of(bench.run(by_line).kind));

    static_cast<void>(bench.run(broadcast_setting<atv320::device, atv320::tto>(3_s)));

    // Thirty drives, 25 ms for each exchange, 400 ms for one that is off.
    duration const gap = longest_gap_of(30, milliseconds(25), milliseconds(400));
    check_supervision safe{drive, {.longest_gap = gap}};
    show("to be ordered", name_of(bench.run(safe).kind));
    supervision_report const& found = safe.report();
    std::printf("  register %u; time-out %u ms, needed %u ms\n", unsigned{found.address},
                static_cast<unsigned>(found.period.timeout.microseconds / 1'000),
                static_cast<unsigned>(found.period.shortest_timeout().microseconds / 1'000));

    static_cast<void>(bench.run(broadcast_setting<atv320::device, atv320::tto>(5_s)));
    check_supervision again{drive, {.longest_gap = gap}};
    show("to be ordered", name_of(bench.run(again).kind));

    watch eye{drive};
    bench.run_until([&] { return eye.rounds() >= 2; }, milliseconds(1'000), eye);
    show("seen", cia402::name_of(eye.state()));
    return by_line.succeeded() and safe.reason().kind == outcome_kind::timeout_too_short and again.ready();
}

bool release_an_atv28()
{
    constexpr station<atv28::device> old{unit_id{7}};
    sim::bench bench{timing, old};

    atv28::activate_link take{old};
    show("ATV28 by its link", name_of(bench.run(take).kind));
    atv28::direct_start go{old, -20_Hz};
    show("run directly", name_of(bench.run(go).kind));
    atv28::direct_stop rest{old, atv28::direct_stop_by::fast_stop};
    show("stopped directly", name_of(bench.run(rest).kind));
    recall_from_eeprom recall{old};
    show("recalled", name_of(bench.run(recall).kind));

    bench.drive().set_input(1, true); // somebody asks to run at the terminals
    atv28::release_link give{old};
    show("released", name_of(bench.run(give).kind));
    bench.drive().set_input(1, false);
    atv28::release_link once_more{old};
    show("released", name_of(bench.run(once_more).kind));
    return take.succeeded() and go.running() and rest.succeeded() and recall.succeeded() and
           give.reason().kind == outcome_kind::run_input_closed and once_more.succeeded();
}

} // namespace

int main() { return prepare_an_atv320() and release_an_atv28() ? 0 : 1; }
