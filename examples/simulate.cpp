// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Simulated drives for a PLC, a SCADA system or a script of one's own, on a pseudo-terminal or a real
// port: simulate --drive atv320:1 --drive atv28:2 [--port P] [--baud B] [--format F] [--vendor NAME]
#include <chrono>
#include <set>
#include <string>
#include <vector>

#include <rtuwire/frames.hpp>
#include <rtuwire/port.hpp>

#include "../tools/rtuwire/simulated_line.hpp"
#include "support/command_line.hpp"
#include "support/line_reader.hpp"
#include "support/say.hpp"
#include "support/signals.hpp"
#include "support/standard_descriptors.hpp"

using namespace rtuwire;
using namespace examples;
using tool::drive_events;
using tool::simulated_line;

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

/// "atv320:7", or "atv320" for unit 1.
drive_choice drive_in(std::string const& word)
{
    auto const colon = word.find(':');
    auto const unit = number_in(colon == std::string::npos ? "1" : word.substr(colon + 1));
    if (not unit) {
        throw usage_error{"--drive " + word + ": no number of a unit behind the colon"};
    }
    return {word.substr(0, colon), *unit};
}

std::string vendor_in(std::string const& name)
{
    if (name.size() >= 64) {
        throw usage_error{"--vendor " + name + ": longer than 63 characters"};
    }
    return name;
}

/// Refuses what no line can have, before one is opened.
void check(std::vector<drive_choice> const& drives)
{
    std::set<std::uint32_t> units;
    for (auto const& each : drives) {
        with_drive(each.name, [&](auto device) {
            static_cast<void>(station_at<typename decltype(device)::type>(each.unit, each.name));
        });
        if (not units.insert(each.unit).second) {
            throw usage_error{"unit " + std::to_string(each.unit) + " is given twice"};
        }
    }
}

options parse(arguments words)
{
    options chosen;
    while (words.next()) {
        if (words.flag() == "--drive") {
            chosen.drives.push_back(drive_in(words.value()));
        } else if (words.flag() == "--vendor") {
            chosen.vendor = vendor_in(words.value());
        } else if (not chosen.line.take(words)) {
            words.refuse();
        }
    }
    if (chosen.drives.empty()) {
        chosen.drives.push_back({"atv320", 1});
    }
    check(chosen.drives);
    return chosen;
}

/// "1 fault": what happens to unit 1. "1 show": what it does.
template <typename Line> void apply(Line& line, std::string const& order)
{
    auto const space = order.find(' ');
    auto const unit = number_in(order.substr(0, space));
    auto* const drive = unit ? line.find(*unit) : nullptr;
    std::string const what = space == std::string::npos ? "" : order.substr(space + 1);
    if (drive != nullptr and what == "show") {
        say("unit %u: %s\n", *unit, drive->shown().c_str());
    } else if (drive == nullptr or not drive->suffer(what, line.now())) {
        complain("simulate understands: UNIT show|%s\n", drive_events);
    }
}

template <typename Port>
int serve(Port& port, std::string const& path, line_timing const& timing, options const& chosen)
{
    simulated_line<Port> line{port, timing, chosen.vendor};
    for (auto const& drive : chosen.drives) {
        line.add(drive.name, drive.unit);
    }
    // Nothing is heard before the line was silent once.
    instant const listening = port.now() + timing.frame_end() + timing.frame_end();
    result<void> failed{};
    while (failed and not reached(port.now(), listening)) {
        failed = line.pass(timing.frame_end());
    }
    complain("simulate: what answers here is simulated, whoever it says has made it\n");
    for (auto const& drive : chosen.drives) {
        say("%s unit %u on %s\n", drive.name.c_str(), drive.unit, path.c_str());
    }
    standard_output.finish(std::chrono::milliseconds{200});
    if (standard_output.failure() != 0) {
        return 1; // nobody knows where the drives are
    }
    line_reader input{STDIN_FILENO};
    while (failed and noted.end == 0) {
        failed = line.pass(milliseconds(20));
        while (auto const order = input.next()) {
            apply(line, *order);
        }
        if (noted.suspend != 0) {
            suspend(); // the drives fall silent, as without power
        }
    }
    return failed ? 0 : 1;
}

int run(options const& chosen)
{
    auto const& set = chosen.line.settings;
    if (not chosen.line.port.empty()) {
        posix_serial port;
        int const status =
            port.open(chosen.line.port, set)
                ? serve(port, chosen.line.port, line_timing::host(set.bits_per_second, set.format), chosen)
                : 1;
        if (not port.failure().empty()) {
            complain("%s\n", port.failure().c_str());
        }
        return status;
    }
    pseudo_terminal port;
    if (not port.open()) {
        complain("simulate: no pseudo-terminal to be had\n");
        return 1;
    }
    // Nothing delays the bytes of a pseudo-terminal inside a frame.
    // A pseudo-terminal is no wire: nothing has to be silent before a response.
    auto const timing = line_timing::host(set.bits_per_second, set.format, milliseconds(5)).with_silence(duration{});
    return serve(port, port.path(), timing, chosen);
}

} // namespace

/// The motors are simulated and stop with this program; a client hears no more of them and must know why.
void rtuwire::on_missing_value(rtuwire::errc why) noexcept
{
    complain("simulate: read a value that is not there (%s); all drives end here\n", std::string{name(why)}.c_str());
    error_output.finish(std::chrono::milliseconds{500});
}

int main(int argc, char** argv)
{
    keep_standard_descriptors();
    std::string const usage = std::string{"[--drive "} + drive_names() +
                              "[:UNIT]]... [--port DEVICE] [--baud RATE] "
                              "[--format 8E1|8O1|8N1|8N2] [--vendor NAME]";
    return with_usage("simulate", usage, argc, argv, [&] {
        options const chosen = parse({argc, argv});
        take_signals();
        return end_of_output("simulate", run(chosen));
    });
}
