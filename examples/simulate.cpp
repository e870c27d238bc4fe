// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Simulated drives for a PLC, a SCADA system or a script of one's own, on a pseudo-terminal or a real
// port: simulate --drive atv320:1 --drive atv28:2 [--port P] [--baud B] [--format F] [--vendor NAME]
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/port/pseudo_terminal.hpp>
#include <rtuwire/wire/errc_name.hpp>

#include "support/orders.hpp"
#include "support/simulated_line.hpp"

using namespace rtuwire;
using namespace examples;

namespace {

struct drive_choice {
    std::string name;
    std::uint32_t unit;
};

struct options {
    line_choice line{};
    std::vector<drive_choice> drives{};
    std::string vendor{}; ///< who made them; empty for what their manuals print
};

std::optional<drive_choice> drive_in(std::string const& word)
{
    auto const colon = word.find(':');
    auto const unit = number_in(colon == std::string::npos ? "1" : word.substr(colon + 1));
    if (not unit) {
        return std::nullopt;
    }
    return drive_choice{word.substr(0, colon), *unit};
}

std::optional<options> parse(int argc, char** argv)
{
    options chosen;
    for (int i = 1; i + 1 < argc; i += 2) {
        std::string const flag = argv[i];
        if (flag == "--drive") {
            auto const drive = drive_in(argv[i + 1]);
            if (not drive) {
                return std::nullopt;
            }
            chosen.drives.push_back(*drive);
        } else if (flag == "--vendor" and std::string{argv[i + 1]}.size() < 64) {
            chosen.vendor = argv[i + 1];
        } else if (not chosen.line.take(flag, argv[i + 1])) {
            return std::nullopt;
        }
    }
    if (chosen.drives.empty()) {
        chosen.drives.push_back({"atv320", 1});
    }
    return argc % 2 == 1 ? std::optional{chosen} : std::nullopt;
}

volatile std::sig_atomic_t is_ended = 0;
extern "C" void end_it(int) { is_ended = 1; }

/// "1 fault": what happens to unit 1.
template <typename Line> void obey(Line& line, std::string const& order)
{
    auto const space = order.find(' ');
    auto const unit = number_in(order.substr(0, space));
    auto* const drive = unit ? line.find(*unit) : nullptr;
    bool const is_known = drive != nullptr and space != std::string::npos and
                          drive->suffer(order.substr(space + 1), line.now());
    if (not is_known) {
        std::fprintf(stderr, "simulate understands: UNIT %s\n", drive_events);
    }
}

template <typename Port>
int serve(Port& port, std::string const& path, line_timing const& timing, options const& chosen)
{
    simulated_line<Port> line{port, timing, chosen.vendor};
    for (auto const& drive : chosen.drives) {
        if (not line.add(drive.name, drive.unit)) {
            std::fprintf(stderr, "simulate: no drive %s at unit %u (the drives are %s)\n",
                         drive.name.c_str(), drive.unit, drive_names);
            return 2;
        }
    }
    // Nothing is heard before the line was silent once.
    instant const listening = port.now() + timing.frame_end() + timing.frame_end();
    result<void> failed{};
    while (failed and not reached(port.now(), listening)) {
        failed = line.pass(timing.frame_end());
    }
    std::fputs("simulate: what answers here is simulated, whoever it says has made it\n", stderr);
    for (auto const& drive : chosen.drives) {
        std::printf("%s unit %u on %s\n", drive.name.c_str(), drive.unit, path.c_str());
    }
    std::fflush(stdout);
    orders input{STDIN_FILENO};
    while (failed and is_ended == 0) {
        failed = line.pass(milliseconds(20));
        while (auto const order = input.next()) {
            obey(line, *order);
        }
    }
    return failed ? 0 : 1;
}

} // namespace

/// The motors are simulated and stop with this program; a client hears no more of them and must know why.
void rtuwire::on_missing_value(rtuwire::errc why) noexcept
{
    std::fprintf(stderr, "simulate: read a value that is not there (%s); all drives end here\n",
                 std::string{name(why)}.c_str());
}

int main(int argc, char** argv)
{
    auto const chosen = parse(argc, argv);
    if (not chosen) {
        std::fprintf(stderr,
                     "usage: simulate [--drive %s[:UNIT]]... [--port DEVICE] [--baud RATE] "
                     "[--format 8E1|8O1|8N1|8N2] [--vendor NAME]\n",
                     drive_names);
        return 2;
    }
    std::signal(SIGINT, end_it);
    std::signal(SIGTERM, end_it);
    auto const& set = chosen->line.settings;
    if (not chosen->line.port.empty()) {
        posix_serial port;
        int const status = port.open(chosen->line.port, set)
                               ? serve(port, chosen->line.port,
                                       line_timing::host(set.bits_per_second, set.format), *chosen)
                               : 1;
        if (not port.failure().empty()) {
            std::fprintf(stderr, "%s\n", port.failure().c_str());
        }
        return status;
    }
    pseudo_terminal port;
    if (not port.open()) {
        std::fputs("simulate: no pseudo-terminal to be had\n", stderr);
        return 1;
    }
    // Nothing delays the octets of a pseudo-terminal inside a frame.
    auto const timing = line_timing::host(set.bits_per_second, set.format, milliseconds(5));
    return serve(port, port.path(), timing, *chosen);
}
