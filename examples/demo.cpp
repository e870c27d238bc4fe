// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client drives a drive: a simulated one in a process of its own, or with --port a real one, which is
// only read unless --allow-run is given. Ctrl-C stops the motor first, and so does an error of this program.
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>

#include "support/demonstration.hpp"
#include "support/simulated_process.hpp"

using namespace rtuwire;
using namespace examples;
using altivar::heading;

namespace {

struct options {
    std::string drive{"atv320"};
    std::uint32_t unit{1};
    line_choice line{};
    std::string svg{"demo.svg"};
    bool may_run{false};
};

std::optional<options> parse(int argc, char** argv)
{
    options chosen;
    for (int i = 1; i < argc; ++i) {
        std::string const flag = argv[i];
        if (flag == "--allow-run") {
            chosen.may_run = true;
            continue;
        }
        if (++i == argc) {
            return std::nullopt;
        }
        std::string const value = argv[i];
        auto const number = number_in(value);
        if (flag == "--drive") {
            chosen.drive = value;
        } else if (flag == "--unit" and number) {
            chosen.unit = *number;
        } else if (flag == "--svg") {
            chosen.svg = value;
        } else if (not chosen.line.take(flag, value)) {
            return std::nullopt;
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
    if (not drive.suffer("clear") or not demo.reset() or not demo.start(heading::forward) or
        not demo.reach_reference()) {
        return false;
    }
    demo.step("The cable is cut for longer than the drive's time-out");
    if (not drive.suffer("cut") or not demo.lose_link() or
        not demo.watch(timeout + milliseconds(1'000))) {
        return false;
    }
    demo.step("The cable is mended: nothing moves until somebody says so");
    return drive.suffer("join") and demo.regain_link() and demo.see_fault() and demo.reset() and
           demo.watch(milliseconds(500)) and demo.start(heading::forward) and
           demo.reach_reference();
}

/// Runs the motor; a simulated drive is disturbed too.
template <typename Demo>
bool drive_motor(Demo& demo, simulated_process const* simulated, duration timeout)
{
    demo.step("Start, and ramp up to 50 Hz");
    bool ok = demo.take_command() and demo.start(heading::forward) and demo.reach_reference();
    if (ok) {
        demo.step("Read the monitor plan");
        ok = demo.read_panel();
    }
    if (ok) {
        demo.step("Reverse");
        ok = demo.start(heading::reverse) and demo.reach_reference();
    }
    if (ok and simulated != nullptr) {
        ok = disturb(demo, *simulated, timeout);
    }
    demo.step("Stop");
    bool const is_stopped = demo.stop();
    std::printf("\n%s\n", is_stopped ? "The motor stands." : "THE MOTOR WAS NOT SEEN TO STOP.");
    return is_stopped and ok;
}

template <device_type Device>
int demonstrate(options const& chosen, station<Device> const& drive, posix_serial& port,
                line_timing const& timing, simulated_process const* simulated)
{
    bool const is_short = simulated != nullptr and Device::profile.scanner_words > 0;
    duration const timeout = is_short ? milliseconds(2'000) : Device::silence.factory;
    demonstration<Device> demo{port, timing, drive, timeout};
    std::printf("%s, unit %u on %s\n", chosen.drive.c_str(), chosen.unit, port.device().c_str());
    demo.step("Who is it?");
    bool ok = demo.identify() and demo.read_panel();
    if (ok and simulated != nullptr) {
        std::puts("   (a simulated drive: ramps are set to 1 s, TTO to 2 s where there is one)");
        ok = demo.shorten_times();
    }
    if (ok and (simulated != nullptr or chosen.may_run)) {
        ok = drive_motor(demo, simulated, timeout);
    } else if (ok) {
        demo.step("Only read: --allow-run would run the motor");
        ok = demo.watch(milliseconds(3'000));
    }
    print_plot(demo.seen());
    if (svg_plot{demo.seen()}.write(chosen.svg)) {
        std::printf("\nThe same as a drawing: %s\n", chosen.svg.c_str());
    }
    demo.print_counts();
    std::puts(ok ? "All went as it should." : "Not all went as it should.");
    return ok ? 0 : interruptions > 0 ? 130 : 1;
}

/// On the line that was chosen, or on a simulated one.
template <device_type Device> int run_on_line(options const& chosen, station<Device> const& drive)
{
    auto const& set = chosen.line.settings;
    posix_serial port;
    simulated_process simulated;
    bool const is_real = not chosen.line.port.empty();
    // Nothing delays the octets of a pseudo-terminal inside a frame.
    auto const timing = is_real
                            ? line_timing::host(set.bits_per_second, set.format)
                            : line_timing::host(set.bits_per_second, set.format, milliseconds(5));
    if (not is_real and not simulated.start(chosen.drive, chosen.unit, timing)) {
        std::fputs("demo: no simulated drive to be had\n", stderr);
        return 1;
    }
    if (not port.open(is_real ? chosen.line.port : simulated.path(), set)) {
        std::fprintf(stderr, "%s\n", port.failure().c_str());
        return 1;
    }
    return demonstrate(chosen, drive, port, timing, is_real ? nullptr : &simulated);
}

extern "C" void interrupt(int) { interruptions = interruptions + 1; }

} // namespace

/// An error of this program must not leave the motor running.
void rtuwire::on_missing_value(rtuwire::errc why) noexcept
{
    std::fprintf(stderr, "demo: read a value that is not there (%s); stopping the motor\n",
                 std::string{name(why)}.c_str());
    emergency.stop_motor();
}

int main(int argc, char** argv)
{
    auto const chosen = parse(argc, argv);
    std::optional<int> status;
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    if (chosen) {
        with_drive(chosen->drive, [&](auto device) {
            using type = typename decltype(device)::type;
            if (auto const drive = station<type>::checked(chosen->unit)) {
                status = run_on_line(*chosen, *drive);
            }
        });
    }
    if (not status) {
        std::fprintf(stderr,
                     "usage: demo [--drive %s] [--port DEVICE [--allow-run]] [--unit 1..247] "
                     "[--baud RATE] [--format 8E1|8O1|8N1|8N2] [--svg FILE]\n",
                     drive_names);
        return 2;
    }
    return *status;
}
