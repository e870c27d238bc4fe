// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of the ATV28 shows, run against a simulated one: connect, look, start, stop, cycle, reset, leave, begin.
//! [head]
#include <iostream>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
//! [head]

int main()
{
    //! [connect]
    constexpr station<atv28::device> drive{unit_id{7}};
    constexpr line_timing timing{19'200, character_format::none_8_1};
    sim::bench line{timing, drive}; // a simulated one; on a host a blocking_client takes its place
    auto const volts = line.run(read<atv28::uln>(drive));
    if (not volts) {
        std::cout << "no line voltage: " << volts.error() << '\n';
        return 1;
    }
    std::cout << "line voltage " << *volts << '\n'; // the keypad has to show the same
    //! [connect]

    //! [limits]
    // One plan, as many requests as this drive needs for it.
    using monitor = read_plan<atv28::device, atv28::eta, atv28::rfr, atv28::lcr, atv28::hsp>;
    poller<monitor> panel{drive};
    if (auto const round = line.run(panel); not round) {
        std::cout << "no values: " << round.error() << '\n';
        return 1;
    }
    std::cout << panel.latest().get<atv28::rfr>() << " by " << monitor::request_count << " requests\n";
    //! [limits]

    //! [start]
    start go{drive, 30_Hz}; // checks the drive first
    std::cout << "start: " << line.run(go) << '\n';
    change_reference faster{drive, 40_Hz};
    std::cout << "faster: " << line.run(faster) << '\n';
    stop rest{drive, stop_by::ramp};
    std::cout << "stop: " << line.run(rest) << '\n';
    //! [start]

    line.drive().inject_fault(9);
    //! [fault]
    go = start{drive, 30_Hz};
    std::cout << "start in a fault: " << line.run(go) << '\n';
    std::cout << name_of(static_cast<atv28::fault_code>(go.reason().fault)) << '\n';
    //! [fault]
    line.drive().clear_cause();
    //! [reset]
    reset_fault clear{drive};
    std::cout << "reset: " << line.run(clear) << '\n';
    //! [reset]

    //! [cycle]
    cyclic loop{drive, {.period = milliseconds(100)}};
    auto const runs = [&] {
        static_cast<void>(loop.run(30_Hz)); // no effect until the drive was checked, nor while it stands so
        return loop.control().is_ordered() and loop.speed() > 600;
    };
    bool const has_run = line.run_until(runs, milliseconds(20'000), loop);
    loop.stop();
    bool const has_stopped =
        line.run_until([&] { return line.drive().motor().is_at_rest(); }, milliseconds(20'000), loop);
    std::cout << (has_run and has_stopped ? "cycle: it ran and stopped\n" : "cycle: it did not run, or not stop\n");
    //! [cycle]

    //! [leave]
    stop end{drive, stop_by::ramp};
    std::cout << "leave: " << line.run(end) << '\n'; // at rest, in "switch on disabled"; nobody asks it any more
    //! [leave]
    line.run_for(milliseconds(7'000));
    line.link() = host_client{timing}; // of another program

    //! [begin]
    constexpr bool is_reset_asked = true; // by whoever starts this program: a word of the command line, a key
    auto const status = line.run(read<atv28::eta>(drive));
    auto const fault = line.run(read<atv28::lft>(drive));
    bool const is_in_fault = status and fault and status->has(atv28::status_bit::fault);
    if (is_in_fault) {
        std::cout << "found in fault: " << *fault << '\n';
    }
    if (is_in_fault and *fault == atv28::fault_code::slf and is_reset_asked) { // any other has a cause to look for
        reset_fault left_over{drive};
        std::cout << "reset: " << line.run(left_over) << '\n';
    }
    start anew{drive, 30_Hz}; // a drive that is still in fault refuses it
    std::cout << "begin: " << line.run(anew) << '\n';
    //! [begin]
    rest = stop{drive, stop_by::ramp};
    static_cast<void>(line.run(rest));

    bool const is_right = faster.succeeded() and rest.succeeded() and has_run and has_stopped and
                          go.reason().kind == outcome_kind::in_fault and clear.succeeded();
    bool const is_left = end.succeeded() and end.reason().state == cia402::state::switch_on_disabled and is_in_fault and
                         anew.succeeded() and rest.succeeded();
    return is_right and is_left and monitor::request_count == 3 ? 0 : 1;
}
