// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Simulated drives for a PLC, a SCADA system or a script of one's own, on a pseudo-terminal or a real port. Its output
// may block, and its standard descriptors may be closed: the drives answer all the same.
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rtuwire/frames.hpp>
#include <rtuwire/port.hpp>

#include "../support/line_reader.hpp"
#include "../support/say.hpp"
#include "../support/signals.hpp"
#include "commands/commands.hpp"
#include "line/open_line.hpp"
#include "output/plain_text.hpp"
#include "port/own_terminal.hpp"
#include "port/port_word.hpp"
#include "port/simulated_device.hpp"
#include "port/simulated_line.hpp"
#include "port/simulated_words.hpp"

namespace tool {

namespace {

using rtuwire::line_timing;

constexpr std::size_t longest_vendor = 63;

std::vector<simulated_drive_choice> drives_in(std::vector<std::string> const& words)
{
    std::string all;
    for (std::string const& each : words) {
        all += (all.empty() ? "" : ",") + each;
    }
    if (all.empty()) {
        refuse_word("simulate: what? say atv320:1, meter.toml:61 or --device meter.toml");
    }
    simulated_words const found = read_simulated_drives(all);
    if (not found.why.empty()) {
        refuse_word(found.why + (found.nearest.empty() ? "" : "; did you mean " + found.nearest + "?"));
    }
    return found.drives;
}

/// A serial device to serve on, or an address to listen at; nothing else is one.
port_description place_in(std::string const& word)
{
    port_choice which = read_port_word(word);
    if (which.refused) {
        refuse_word(which.refused->sentence);
    }
    if (not std::holds_alternative<serial_device>(which.port) and
        not std::holds_alternative<mbap_address>(which.port)) {
        refuse_word("--port " + word + ": drives are simulated on a serial device, such as " + example_port +
                    ", behind " + "mbap://127.0.0.1:1502, or on a pseudo-terminal where no port is given");
    }
    return std::move(which.port);
}

/// "1 fault": what happens to unit 1. "1 show": what it does.
template <typename Line> void apply(Line& line, std::string const& order)
{
    auto const space = order.find(' ');
    auto const unit = number_in(order.substr(0, space));
    auto* const drive = unit ? line.find(*unit) : nullptr;
    std::string const what = space == std::string::npos ? "" : order.substr(space + 1);
    if (drive != nullptr and what == "show") {
        standard_output.put("unit " + std::to_string(*unit) + ": " + plain_text(drive->shown()) + '\n');
    } else if (drive == nullptr or not drive->suffer(what, line.now())) {
        std::string const known = drive == nullptr ? std::string{"UNIT show|"} + drive_events : drive->understood();
        error_output.put("simulate understands: " + plain_text(known) + '\n');
    }
}

/// Nothing is heard before the line was silent once.
template <typename Line> rtuwire::result<void> listen(Line& line, rtuwire::instant until, rtuwire::duration step)
{
    rtuwire::result<void> passed{};
    while (passed and not reached(line.now(), until)) {
        passed = line.pass(step);
    }
    return passed;
}

/// Until a signal ends it, or the port fails.
template <typename Line> rtuwire::result<void> follow_orders(Line& line)
{
    line_reader input{STDIN_FILENO};
    rtuwire::result<void> passed{};
    while (passed and noted.end == 0) {
        passed = line.pass(rtuwire::milliseconds(20));
        while (auto const order = input.next()) {
            apply(line, *order);
        }
        if (noted.suspend != 0) {
            suspend(); // the drives fall silent, as without power
        }
    }
    return passed;
}

template <typename Port>
exit_status serve(Port& port, std::string const& path, line_timing const& timing,
                  std::vector<simulated_drive_choice> const& drives, std::string const& vendor)
{
    simulated_line<Port> line{port, timing, vendor};
    for (auto const& each : drives) {
        add_to(line, each, timing);
    }
    if (not listen(line, port.now() + timing.frame_end() + timing.frame_end(), timing.frame_end())) {
        return exit_status::port;
    }
    complain("simulate: these drives are simulated, whatever maker they name\n");
    for (auto const& each : drives) {
        say("%s unit %u on %s\n", each.drive.c_str(), unsigned{each.unit}, path.c_str());
    }
    standard_output.finish(std::chrono::milliseconds{200});
    if (standard_output.failure() != 0) {
        return exit_status::port; // nobody knows where the drives are
    }
    return follow_orders(line) ? exit_status::done : exit_status::port;
}

exit_status with_failure(exit_status status, std::string const& failure)
{
    if (not failure.empty()) {
        complain("rtuwire: %s\n", plain_text(failure).c_str());
    }
    return status;
}

exit_status serve_on(serial_device const& place, choices const& chosen,
                     std::vector<simulated_drive_choice> const& drives)
{
    auto const set = setting_in(chosen.line);
    rtuwire::host_serial port;
    exit_status const status =
        port.open(place.path, serial_settings_in(chosen.line, set))
            ? serve(port, place.path, line_timing::host(set.baud, set.format), drives, chosen.vendor)
            : exit_status::port;
    return with_failure(status, port.failure());
}

/// As behind a gateway.
exit_status serve_on(mbap_address const& place, choices const& chosen,
                     std::vector<simulated_drive_choice> const& drives)
{
    std::vector<std::uint8_t> units;
    for (simulated_drive_choice const& each : drives) {
        units.push_back(each.unit);
    }
    rtuwire::mbap_listener port;
    exit_status const status =
        port.open(place.host, place.port, units)
            ? serve(port, port.device(), line_timing::without_wire(rtuwire::milliseconds(5)), drives, chosen.vendor)
            : exit_status::port;
    return with_failure(status, port.failure());
}

exit_status serve_on_port(choices const& chosen, std::vector<simulated_drive_choice> const& drives)
{
    port_description const place = place_in(chosen.line.port);
    auto const* const address = std::get_if<mbap_address>(&place);
    return address != nullptr ? serve_on(*address, chosen, drives)
                              : serve_on(std::get<serial_device>(place), chosen, drives);
}

exit_status serve_on_pseudo_terminal(choices const& chosen, std::vector<simulated_drive_choice> const& drives)
{
    auto const set = setting_in(chosen.line);
    own_terminal port;
    if (not port.open()) {
        throw ended{exit_status::port, no_terminal_text("-p COM3, or -p mbap://127.0.0.1:1502 to listen there")};
    }
    // A pseudo-terminal is no wire: nothing delays its bytes inside a frame, and nothing has to be silent before a
    // response.
    auto const timing =
        line_timing::host(set.baud, set.format, rtuwire::milliseconds(5)).with_silence(rtuwire::duration{});
    return serve(port, port.path(), timing, drives, chosen.vendor);
}

} // namespace

exit_status run_simulate(choices const& chosen)
{
    auto const drives = drives_in(chosen.words);
    if (chosen.vendor.size() > longest_vendor) {
        refuse_word("--vendor " + chosen.vendor + ": longer than " + std::to_string(longest_vendor) + " characters");
    }
    take_signals();
    exit_status const status =
        chosen.line.port.empty() ? serve_on_pseudo_terminal(chosen, drives) : serve_on_port(chosen, drives);
    // 1: the drives ended well, but what they said was not taken.
    int const said = end_of_output("rtuwire", static_cast<int>(status));
    return status == exit_status::done and said != 0 ? exit_status::port : status;
}

} // namespace tool

/// Whoever hears no more of the drives, or of the line, must know why.
void rtuwire::on_missing_value(rtuwire::errc why) noexcept
{
    tool::complain("rtuwire: read a value that is not there (%s), a fault of this program; it ends here\n",
                   std::string{name(why)}.c_str());
    tool::error_output.finish(std::chrono::milliseconds{500});
}
