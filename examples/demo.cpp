// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client drives a drive: a simulated one in a process of its own, or with --port a real one, which is
// only read unless --allow-run is given. Whatever ends or suspends this program stops the motor first: Ctrl-C,
// Ctrl-Z, any other signal but KILL and STOP, an output that takes no more, an error of this program.
#include <chrono>
#include <string>

#include "../tools/support/platform.hpp"
#include "support/command_line.hpp"
#include "support/demonstration.hpp"
#include "support/simulated_process.hpp"

using namespace rtuwire;
using namespace examples;
using altivar::run_direction;

namespace {

struct options {
    std::string drive{"atv320"};
    std::uint32_t unit{1};
    line_choice line{};
    std::string svg{"demo.svg"};
    bool may_run{false};
};

options parse(arguments words)
{
    options chosen;
    while (words.next()) {
        if (words.flag() == "--allow-run") {
            chosen.may_run = true;
        } else if (words.flag() == "--drive") {
            chosen.drive = words.value();
        } else if (words.flag() == "--unit") {
            chosen.unit = words.number();
        } else if (words.flag() == "--svg") {
            chosen.svg = words.value();
        } else if (not chosen.line.take(words)) {
            words.refuse();
        }
    }
    return chosen;
}

/// What only a simulated drive lets be done to it.
template <typename Demo> bool disturb(Demo& demo, simulated_process const& drive, duration timeout)
{
    demo.step("Something blocks the motor: the drive trips");
    if (not drive.suffer("fault") or not demo.see_fault()) {
        return false;
    }
    demo.step("The cause is gone: reset, and start again");
    if (not drive.suffer("clear") or not demo.reset() or not demo.start(run_direction::forward) or
        not demo.reach_reference()) {
        return false;
    }
    demo.step("The cable is cut for longer than the drive's time-out");
    if (not drive.suffer("cut") or not demo.lose_link() or not demo.watch(timeout + milliseconds(1'000))) {
        return false;
    }
    demo.step("The cable is mended: nothing moves until somebody says so");
    return drive.suffer("join") and demo.regain_link() and demo.see_fault() and demo.reset() and
           demo.watch(milliseconds(500)) and demo.start(run_direction::forward) and demo.reach_reference();
}

/// Runs the motor; a simulated drive is disturbed too.
template <typename Demo> bool drive_motor(Demo& demo, simulated_process const* simulated, duration timeout)
{
    demo.step("Start, and ramp up to 50 Hz");
    bool ok = demo.take_command() and demo.start(run_direction::forward) and demo.reach_reference();
    if (ok) {
        demo.step("Read the monitor plan");
        ok = demo.read_panel();
    }
    if (ok) {
        demo.step("Reverse");
        ok = demo.start(run_direction::reverse) and demo.reach_reference();
    }
    if (ok and simulated != nullptr) {
        ok = disturb(demo, *simulated, timeout);
    }
    if (simulated != nullptr) {
        simulated->suffer("join"); // a signal may have come while the cable was cut
    }
    demo.step("Stop");
    bool const is_stopped = demo.stop();
    say("\n%s\n", is_stopped ? "The motor stands." : "THE MOTOR WAS NOT SEEN TO STOP.");
    return is_stopped and ok;
}

template <device_type Device>
int demonstrate(options const& chosen, station<Device> const& drive, posix_serial& port, line_timing const& timing,
                simulated_process const* simulated)
{
    bool const is_short = simulated != nullptr and Device::scanner.words > 0;
    duration const timeout = is_short ? milliseconds(3'000) : Device::silence.factory;
    demonstration<Device> demo{port, timing, drive};
    say("%s, unit %u on %s\n", chosen.drive.c_str(), chosen.unit, port.device().c_str());
    demo.step("Who is it?");
    bool ok = demo.identify() and demo.read_panel();
    bool const may_run = simulated != nullptr or chosen.may_run;
    ok = ok and not(demo.is_in_fault() and may_run); // nobody asked this program for a reset
    if (ok and simulated != nullptr) {
        say("   (a simulated drive: ramps are set to 1 s, TTO to 3 s where there is one)\n");
        ok = demo.shorten_times();
    }
    if (ok and may_run) {
        ok = drive_motor(demo, simulated, timeout);
    } else if (ok) {
        demo.step("Only read: --allow-run would run the motor");
        ok = demo.watch(milliseconds(3'000));
    }
    if (noted.suspend != 0) {
        standard_output.finish(std::chrono::milliseconds{500});
        suspend(); // nothing is asked of the drive any more
    }
    print_plot(demo.seen());
    bool const is_drawn = svg_plot{demo.seen()}.write(chosen.svg);
    say("\n%s %s\n", is_drawn ? "The same as a drawing:" : "NO drawing could be written to", chosen.svg.c_str());
    ok = ok and is_drawn;
    demo.print_counts();
    if (simulated == nullptr) {
        demo.tell_what_is_left();
    }
    say("%s\n", ok ? "All went as it should." : "Not all went as it should.");
    return status_of_end(ok ? 0 : 1);
}

/// On the line that was chosen, or on a simulated one.
template <device_type Device> int run_on_line(options const& chosen, station<Device> const& drive)
{
    auto const& set = chosen.line.settings;
    posix_serial port;
    simulated_process simulated;
    bool const is_real = not chosen.line.port.empty();
    // Nothing delays the bytes of a pseudo-terminal inside a frame.
    auto const no_delay = line_timing::host(set.bits_per_second, set.format, milliseconds(5));
    if (not is_real and not simulated.start(chosen.drive, chosen.unit, no_delay)) {
        complain("demo: no simulated drive to be had\n");
        return 1;
    }
    if (not port.open(is_real ? chosen.line.port : simulated.path(), set)) {
        complain("%s\n", port.failure().c_str());
        return 1;
    }
    return demonstrate(chosen, drive, port, is_real ? port.timing() : no_delay, is_real ? nullptr : &simulated);
}

} // namespace

/// An error of this program must not leave the motor running.
void rtuwire::on_missing_value(rtuwire::errc why) noexcept
{
    emergency.stop_motor();
    complain("demo: read a value that is not there (%s); the motor was stopped\n", std::string{name(why)}.c_str());
    error_output.finish(std::chrono::milliseconds{500});
}

int main(int argc, char** argv)
{
    keep_standard_descriptors();
    std::string const usage = std::string{"[--drive "} + drive_names() +
                              "] [--port DEVICE [--allow-run]] [--unit 1..247] [--baud RATE] "
                              "[--format 8E1|8O1|8N1|8N2] [--svg FILE]";
    return with_usage("demo", usage, argc, argv, [&] {
        options const chosen = parse({argc, argv});
        take_signals();
        stop_motor_before_dying();
        int status = 0;
        with_drive(chosen.drive, [&](auto device) {
            using type = typename decltype(device)::type;
            status = run_on_line(chosen, station_at<type>(chosen.unit, chosen.drive));
        });
        return end_of_output("demo", status);
    });
}
