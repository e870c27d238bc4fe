// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 12: a motor is started and stopped, and each order says how it ended: done, refused, in fault, local, no
// response. A start that is done says that the drive runs by this reference, as was read back; its ramp has only begun,
// and it may stand at 0.0 Hz yet: the speed is read. The drive is simulated, so it can be disturbed. The end shows what
// a program leaves behind, and how the next one begins. Builds on lesson 3.
#include <iostream>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

int surprises = 0;

/// Prints how an order ended, and notes where it is not what this program is written to show.
void show(char const* what, reason const& how, outcome_kind expected)
{
    std::cout << what << ": " << how << '\n';
    surprises += how.kind == expected ? 0 : 1;
}

} // namespace

int main()
{
    constexpr station<atv320::device> drive{unit_id{7}};
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, drive};
    // The drive has to stop by itself soon enough when the line goes silent, or it is not started.
    static_cast<void>(bench.run(broadcast_setting<atv320::device, atv320::tto>(3_s)));

    start go{drive, 50_Hz}; // run again it is a new order; another reference is another one: `go = start{...}`
    show("start at 50 Hz", bench.run(go), outcome_kind::succeeded);
    stop rest{drive, stop_by::ramp};
    show("stop on the ramp", bench.run(rest), outcome_kind::succeeded);

    go = start{drive, -30_Hz};
    show("start at -30 Hz: reverse", bench.run(go), outcome_kind::succeeded);
    bench.drive().inject_fault(9); // something blocks the motor
    go = start{drive, 30_Hz};
    show("start in a fault", bench.run(go), outcome_kind::in_fault);
    bench.drive().clear_cause();
    reset_fault clear{drive};
    show("reset", bench.run(clear), outcome_kind::succeeded);

    go = start{drive, 30_Hz, run_direction::reverse};
    show("start at 30 Hz in reverse", bench.run(go), outcome_kind::succeeded);
    go = start{drive, -30_Hz, run_direction::reverse};
    show("two signs for one direction", bench.run(go), outcome_kind::contradictory);

    rest = stop{drive, stop_by::freewheel};
    show("let the motor coast", bench.run(rest), outcome_kind::succeeded);
    bench.drive().set_local(true); // somebody at the drive takes it over
    go = start{drive, 30_Hz};
    show("start in local control", bench.run(go), outcome_kind::local_control);
    bench.drive().set_local(false);

    bench.cut(); // the cable is cut
    go = start{drive, 30_Hz};
    show("start without a line", bench.run(go), outcome_kind::silent);
    rest = stop{drive, stop_by::ramp};
    show("stop without a line", bench.run(rest), outcome_kind::silent);
    std::cout << "the motor " << (bench.drive().motor().is_at_rest() ? "stands" : "turns") << '\n';

    bench.run_for(milliseconds(5'000)); // nobody asks: as behind a program that has ended
    bench.cut(false);
    go = start{drive, 30_Hz}; // what the next one finds
    show("start after a silence", bench.run(go), outcome_kind::in_fault);
    bool const is_link_fault = go.reason().fault == static_cast<std::uint16_t>(atv320::fault_code::slf1);
    show("reset", bench.run(clear), outcome_kind::succeeded);
    show("start", bench.run(go), outcome_kind::succeeded);
    rest = stop{drive, stop_by::ramp};
    show("stop on the ramp", bench.run(rest), outcome_kind::succeeded);
    std::cout << "left at rest: in 3 s without a request the drive is in fault again (SLF1)\n";
    return surprises == 0 and is_link_fault and bench.drive().motor().is_at_rest() ? 0 : 1;
}
