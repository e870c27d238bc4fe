// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "command_words.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include <CLI/CLI.hpp>

#include "chaos/line_fault.hpp"
#include "help/tool_texts.hpp"
#include "words/time_words.hpp"

namespace tool {

namespace {

constexpr char const* ends_with = "Exit status: 0 done, 1 differs or refused by the device, 2 usage, 3 no answer,\n"
                                  "4 port, 5 refused for safety.";

/// A range takes "nan", which is neither below nor above anything.
std::string why_no_number(std::string const& word)
{
    return std::isnan(std::strtod(word.c_str(), nullptr)) ? "'" + word + "' is no number" : std::string{};
}

/// An empty word is what a variable without a value leaves, and never all that there is.
std::string why_no_list(std::string const& word)
{
    return word.empty() ? "nothing stands in the list: name what is meant, or leave the option out" : std::string{};
}

void add_line_options(CLI::App& app, line_choices& line)
{
    app.add_option("-p,--port", line.port,
                   "/dev/ttyUSB0, tcp://host:4001, mbap://host, sim:atv320:7,atv12:3, sim:sdm630:1, sim:meter.toml:61 "
                   "or a capture file");
    // A list as it is typed: CLI11 would drop what is empty between its commas.
    app.add_option_function<std::vector<std::string>>(
           "-u,--unit",
           [&line](std::vector<std::string> const& typed) {
               line.unit = typed.front();
               for (std::size_t i = 1; i < typed.size(); ++i) {
                   line.unit += ',' + typed[i];
               }
           },
           "the unit's address, or a name given by --name; for read, watch and monitor a list, 2,5,10-14, or "
           "-u 2 -u 5")
        ->allow_extra_args(false)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->default_str(line.unit);
    app.add_option("-b,--baud", line.baud, "bits a second")->capture_default_str();
    app.add_option("-f,--format", line.format, "8E1, 8N1, 8O1, 8N2, 8E2 or 8O2")->capture_default_str();
    app.add_option("-d,--drive", line.drive, "the drive's type, instead of asking it; none: it is no drive");
    app.add_option("--device", line.device,
                   "a register file of what is no drive: names of its registers, for all that reads, writes or shows "
                   "them;\nsimulate serves it");
    app.add_option("--name", line.names,
                   "a unit's name, and its type or register file: fan=7:atv320, meter=61:meter.toml")
        ->allow_extra_args(false);
    app.add_option("--timeout", line.response_timeout, "seconds to wait for a response")
        ->check(why_no_number)
        ->check(CLI::Range(0.001, 30.0));
    app.add_option("--retries", line.retries, "how often a request is repeated")
        ->check(CLI::Range(0, 10))
        ->capture_default_str();
    app.add_option("--pause", line.pause, "milliseconds of silence before each request but those of stop")
        ->check(CLI::Range(0, 3'000))
        ->capture_default_str();
    app.add_flag("--echo", line.has_echo, "the line gives back what is sent");
    app.add_flag("--rs485", line.must_switch_rs485,
                 "the driver of the port switches the transceiver's direction: of a UART, not of a USB adapter");
    app.add_option("--noise", line.noise, "so many bytes in front of a response are skipped")
        ->check(CLI::Range(0, 8))
        ->capture_default_str();
    app.add_flag(
        "--any-unit", line.may_be_any_unit,
        "take 0, or an address from 248 to 255, for --unit of read, watch and identify: whatever hangs on the line may "
        "answer to it");
    app.add_flag("-v,--verbose", line.is_verbose, "show each frame that is sent or comes, on the standard error");
    app.add_option("--trace", line.trace_file, "keep them in a file for Wireshark, as capture does");
    app.add_option("--listen", line.listen, "seconds to listen before the first frame")
        ->check(why_no_number)
        ->check(CLI::Range(0.0, 3'600.0))
        ->capture_default_str();
    app.add_flag("--no-listen", line.must_not_listen, "speak at once, on a line in use, too");
}

void add_form_options(CLI::App& app, output_form& form)
{
    auto* const as_json = app.add_flag_callback(
        "--json", [&form] { form = output_form::json; }, "one JSON object a line");
    app.add_flag_callback(
           "--csv", [&form] { form = output_form::csv; }, "comma-separated values")
        ->excludes(as_json);
}

void add_permissions(CLI::App& app, permissions& allowed)
{
    app.add_flag("--write", allowed.may_write, "allow writes");
    app.add_flag("--allow-run", allowed.may_run, "allow what moves a motor");
    app.add_flag("-y,--yes", allowed.is_confirmed, "ask nothing back");
}

/// In front of the last lines of its help.
void add_to_footer(CLI::App& command, std::string const& text) { command.footer(text + '\n' + command.get_footer()); }

CLI::App& add_command(CLI::App& app, choices& chosen, char const* name, char const* what)
{
    CLI::App* const command = app.add_subcommand(name, what);
    command->fallthrough();
    command->footer("Example: " + example_of(name) + "\nOptions of every command: rtuwire --help\n" + ends_with);
    command->callback([&chosen, name] { chosen.command = name; });
    return *command;
}

/// A length of time, taken as seconds. `read` says which lengths are allowed, `rule` the same in words.
void add_time(CLI::App& command, char const* name, std::optional<double>& seconds, char const* what,
              std::optional<double> (*read)(std::string_view), char const* rule)
{
    auto const take = [&seconds, name, read, rule](std::string const& text) {
        seconds = read(text);
        if (not seconds) {
            throw CLI::ValidationError{name, "'" + text + "' is no length of time such as " + rule};
        }
    };
    command.add_option_function<std::string>(name, take, what)->type_name("TIME");
}

void add_period(CLI::App& command, choices& chosen)
{
    add_time(command, "--every", chosen.every, "the period: 200ms, 1s", seconds_typed, "200ms, 1s or 5min");
}

void add_time_limit(CLI::App& command, choices& chosen)
{
    add_time(command, "--for", chosen.last, "how long: 10s, 5min, 8h", time_limit_typed,
             "500ms, 10s, 5min or 8h: more than 0, at most 366 days");
}

void add_operands(CLI::App& command, choices& chosen, char const* name, std::string const& what,
                  bool is_required = false)
{
    auto* const words = command.add_option(name, chosen.words, what);
    if (is_required) {
        words->required();
    }
}

constexpr char const* register_words =
    "mnemonics (RFR), globs ('DP*'), groups (@monitor, group:monitor), bits (ETA.fault, 3201.3), "
    "addresses (3202, 0x0C82), ranges (3201-3205), numbers of an ATV310's menu "
    "(611, 705.0)";

/// Of a unit that is asked: one number, one meaning, whatever stands beside it.
std::string register_words_of_a_unit()
{
    return std::string{register_words} +
           ". A number that this menu has means it on an ATV310, elsewhere an address or "
           "a bit: without --drive the unit "
           "is asked who it is. 0x0263 is an address everywhere. And places of any "
           "device, as below, which ask nobody who it is. Of several units RFR@fan or RFR@7 is asked of that one "
           "only";
}

/// Registers of a drive, and places of any device.
void add_places(CLI::App& command, choices& chosen, bool is_required)
{
    add_operands(command, chosen, "REG", register_words_of_a_unit(), is_required);
    add_to_footer(command, "A place of any device:\n" + places_text());
}

void add_reading(CLI::App& app, choices& chosen)
{
    add_command(app, chosen, "ports", "the serial ports of this system, and what their adapters say of themselves");
    CLI::App& scan = add_command(app, chosen, "scan", "find the units of a line, and its bit rate and format");
    auto* const find = scan.add_flag("--find", chosen.finds_setting,
                                     "try the usual bit rates and formats, one after another, until somebody answers;\n"
                                     "so it does without a word of them (-b, -f, --bauds, --formats)");
    scan.add_option("PORT", chosen.line.port, "the same as --port")->excludes(app.get_option("--port"));
    scan.add_option("--units", chosen.scan.units, "1-247 or 1,3,7-9")->capture_default_str();
    scan.add_option("--bauds", chosen.scan.bauds, "bit rates to try all of, such as 9600,19200")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->excludes(find);
    scan.add_option("--formats", chosen.scan.formats, "formats to try all of, such as 8E1,8N1")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->excludes(find);
    scan.add_option("--resume", chosen.scan.resume_file, "keeps what was found here, and goes on from there");
    add_command(app, chosen, "identify", "who is it?");
    CLI::App& map = add_command(app, chosen, "map", "which addresses does a unit have?");
    add_operands(map, chosen, "RANGE",
                 "input:1000-1999, list:40001-40100, coil, 0x0C80-0x0CFF; without one holding:0-9999 input:0-9999; "
                 "with --device the names of what is there, and of what is not");
    map.add_option("--resume", chosen.scan.resume_file, "keeps what was found here, and goes on from there");
    map.add_option("-o,--output", chosen.file, "a new register file of what was found, to be given names and types");
    CLI::App& read = add_command(app, chosen, "read", "read registers");
    add_places(read, chosen, true);
    read.add_option("--sunspec", chosen.sunspec,
                    "a folder of SunSpec models: @sunspec reads all points of a unit by them");
    CLI::App& watch = add_command(app, chosen, "watch", "read registers again and again, a line each time");
    add_places(watch, chosen, true);
    add_period(watch, chosen);
    add_time_limit(watch, chosen);
    CLI::App& monitor = add_command(app, chosen, "monitor", "several units on a full screen");
    add_places(monitor, chosen, false);
    add_period(monitor, chosen);
    monitor
        .add_option("--plot", chosen.monitor.plots, "registers whose curves are shown large: RFR, RFR@fan,power@meter")
        ->allow_extra_args(false);
    monitor
        .add_option("--alarm", chosen.monitor.alarms,
                    "limits of a value, which is an alarm outside of them: LCR@fan=..8.5A, power=10..2000")
        ->allow_extra_args(false);
    monitor.add_flag("--bell", chosen.monitor.has_bell, "ring the terminal's bell at each new alarm");
    CLI::App& list = add_command(app, chosen, "list", "the registers of a drive, or the drives");
    add_operands(list, chosen, "PATTERN", "mnemonics, globs, groups, addresses, numbers of an ATV310's menu");
    list.add_option("--search", chosen.search, "a word in the registers' names, values or bits, or a menu number");
    list.add_option("--group", chosen.group, "those of a group, such as motor_control");
    add_operands(add_command(app, chosen, "explain", "all that is known of a register, of one drive or of each"),
                 chosen, "REG", register_words, true);
    add_command(app, chosen, "faults", "the last fault and those before, with the drive's state at each");
}

void add_writing(CLI::App& app, choices& chosen)
{
    CLI::App& write = add_command(app, chosen, "write", "write registers, and read them back (--write)");
    add_operands(
        write, chosen, "REG=VALUE",
        "ACC=1.3s, SLL=YES, 3104=60Hz; of what is no drive, with --drive none, holding:40:0.1V=230.1V, coil:3=on, "
        "40:f32:cdab=21.5, 40.3=on, 40-43=1,2,3,4 by one request",
        true);
    write.add_flag("--read-modify-write", chosen.may_rewrite,
                   "bits of a unit without function 22: read their register, and write all of it back");
    write.add_option("--then-read", chosen.then_read, "registers to read in the same request, by function 23: 100-103")
        ->type_name("REG")
        ->allow_extra_args(false);
    add_to_footer(
        write,
        "A place of any device, written by function 05, 06, 16, or 22 for bits; #2301 is a count without its scale.\n"
        "Neighbours take a value each, by one request of function 16 or 15: 40-42=1,2,3, coil:0-1=on,off,\n"
        "setpoint,mode=21.5,heat by the names of a register file.\n" +
            places_text());
    CLI::App& ask = add_command(app, chosen, "ask", "send any function, and show both frames");
    add_operands(ask, chosen, "FC HEX",
                 "the function and its data, in hexadecimal, without unit and CRC: 03 0C820001, 2B 0E 01 00, 11", true);
    add_to_footer(
        ask, "Free are 01 to 04, 07, 08 with sub-function 0, 0B, 0C, 11, 14, 18, 2B 0E. All others need --write, and\n"
             "are checked as a write of the same is; a unit that does not say by 2B 0E that it is no drive takes\n"
             "them with --allow-run besides. -u 0 sends to all units what writes; nobody answers.");
    CLI::App& start = add_command(app, chosen, "start", "run a motor until somebody ends this program (--allow-run)");
    auto* const speed =
        start.add_option("--speed", chosen.motion.speed,
                         "such as 1200rpm; on a terminal a line such as 900rpm changes it while it runs");
    start
        .add_option("--frequency", chosen.motion.frequency,
                    "such as 40Hz; on a terminal a line such as 30Hz changes it while it runs")
        ->excludes(speed);
    start.add_flag("--reverse", chosen.motion.is_reverse, "the other direction");
    add_time_limit(start, chosen);
    add_to_footer(start, "Ctrl-C stops the motor by its ramp. Ctrl-C again, a second later or more, takes its power "
                         "away: it coasts.");
    CLI::App& stop = add_command(app, chosen, "stop", "stop a motor");
    auto* const ramp = stop.add_flag_callback(
        "--ramp", [&chosen] { chosen.motion.stop_by = "ramp"; },
        "by its ramp (as without a word), once CHCF was read to be the drive profile: else 0000 goes, and it coasts");
    auto* const freewheel = stop.add_flag_callback(
        "--freewheel", [&chosen] { chosen.motion.stop_by = "freewheel"; }, "without power");
    stop.add_flag_callback(
            "--quick", [&chosen] { chosen.motion.stop_by = "quick"; },
            "by its quick stop, once CHCF was read so: else 0000 goes, and it coasts")
        ->excludes(ramp)
        ->excludes(freewheel);
    ramp->excludes(freewheel);
    add_command(app, chosen, "reset", "reset a fault (--write)");
}

void add_settings(CLI::App& app, choices& chosen)
{
    CLI::App& backup =
        add_command(app, chosen, "backup", "read all parameters of a drive into a file, or the settings of a --device");
    backup
        .add_option("-o,--output", chosen.file, "the file: JSON, or CSV where its name ends so; - for standard output")
        ->required();
    CLI::App& compare =
        add_command(app, chosen, "compare", "what differs between settings of files, drives, the factory");
    add_operands(compare, chosen, "FILE",
                 "one or two: a FILE, a UNIT, or UNIT@PORT; the unit of --unit stands for the second");
    compare.add_flag("--factory", chosen.is_factory, "with the factory values, instead of a second one");
    CLI::App& restore = add_command(app, chosen, "restore",
                                    "write a file's settings into a drive that stands, or a --device (--write)");
    restore.add_option("FILE", chosen.file, "a backup, JSON or CSV")->required();
    restore_choices& with = chosen.restore;
    restore.add_flag("--dry-run", with.dry_run, "show what would be written, and write nothing");
    restore.add_flag("--with-channels", with.with_channels,
                     "also who commands it, run inputs, and the macro that sets both");
    restore.add_flag("--with-link", with.with_link, "also its address, bit rate, format and time-out");
    restore.add_flag("--with-inferred", with.with_inferred, "also what is known only from a sister drive");
    restore.add_flag("--with-supervision", with.with_supervision, "also what can switch off whatever stops the motor");
    restore.add_flag("--with-autorestart", with.with_autorestart, "also what lets the drive start by itself");
    restore.add_flag("--inputs-open", with.has_open_inputs,
                     "no run input is closed: for a drive that cannot tell (ATV310)");
    restore.add_flag("--save", with.save, "save to the EEPROM at the end, where all of it is held");
}

void add_line_tools(CLI::App& app, choices& chosen)
{
    CLI::App& sniff = add_command(app, chosen, "sniff", "show what others say on the line");
    sniff.add_flag("--find", chosen.finds_setting,
                   "find the bit rate and the format of a line on which somebody talks, without a word to it");
    sniff.add_option("-o,--output", chosen.file, "a file that keeps what is shown, as capture writes it");
    add_time_limit(sniff, chosen);
    CLI::App& capture = add_command(app, chosen, "capture", "write what passes to a file for Wireshark");
    capture.add_option("-o,--output", chosen.file, "the file, - for standard output")->required();
    capture.add_option("--as", chosen.capture_form, "udp, user0, rtac or upper-pdu")
        ->check(CLI::IsMember({"udp", "user0", "rtac", "upper-pdu"}))
        ->capture_default_str();
    add_time_limit(capture, chosen);
    add_command(app, chosen, "replay", "show a capture as sniff showed its line")
        .add_option("FILE", chosen.file, "a capture; without one, --port names it");
    CLI::App& timing = add_command(app, chosen, "timing", "silences, response times, load and errors of a line");
    timing.add_option("FILE", chosen.file,
                      "a capture; without one, the port is listened to, or the capture that it names");
    add_time_limit(timing, chosen);
    add_operands(add_command(app, chosen, "decode", "explain bytes"), chosen, "HEX",
                 "bytes, or - to read them from standard input; none with a capture as --port");
    CLI::App& simulate = add_command(app, chosen, "simulate",
                                     "simulated drives, and devices of register files, on a pseudo-terminal or a port");
    add_operands(simulate, chosen, "DRIVE:UNIT", "such as atv320:1, or meter.toml:61; also --device meter.toml:61");
    simulate.add_option("--vendor", chosen.vendor, "who made them, instead of what their manuals print");
}

void add_device(CLI::App& app, choices& chosen)
{
    CLI::App& device = add_command(app, chosen, "device",
                                   "register files: device check FILE; device import FILE; device export DRIVE");
    add_operands(device, chosen, "FILE",
                 "check, then one or more files; import, then a file of another program; export, then a drive", true);
    device.add_option("-o,--output", chosen.file, "import, export: a new file; without it standard output");
    device.add_option("--base", chosen.base,
                      "import: the address where the registers of a SunSpec model begin (identify shows it), or those "
                      "of a module behind a coupler");
    add_to_footer(device, register_file_text());
}

CLI::Range any_seed() { return {0U, std::numeric_limits<std::uint32_t>::max()}; }

void add_check(CLI::App& app, choices& chosen)
{
    CLI::App& check =
        add_command(app, chosen, "check",
                    "does a server, or a client, keep to the protocol? Anybody's device or library, clause by clause");
    check.add_option("--only", chosen.check.only, "clauses, functions or groups: L07, F03, I");
    check.add_flag("--list", chosen.check.lists, "the clauses, and what fails without them");
    check.add_option("--explain", chosen.check.explained, "what a clause sends, and what may come");
    check.add_option("--readable", chosen.check.readable,
                     "a holding or input register that can be read, where none of the usual is there");
    check.add_option("--scratch", chosen.check.scratch,
                     "8 to 100 registers that may be changed, such as 100-107; they are put back (--write)");
    check.add_option("--scratch-coils", chosen.check.scratch_coils,
                     "16 coils that may be changed, such as 0-15 (--write)");
    check.add_flag("--alone", chosen.check.is_alone,
                   "no other unit is on the line: writes may go to addresses that nobody has");
    check.add_flag("--disruptive", chosen.check.may_disrupt,
                   "clear its counters, silence and restart it, write where nothing should be (--write)");
    check.add_option("--hostile", chosen.check.hostile, "seconds of random frames and noise, none of which writes")
        ->check(CLI::Range(1, 86'400));
    check.add_option("--seed", chosen.check.seed, "the same number sends the same random frames")
        ->check(any_seed())
        ->capture_default_str();
    check.add_option("--profile", chosen.check.profile,
                     "a file: functions that the device is said to have, deviations that are known");
    check.add_option("--junit", chosen.check.junit, "a file with the verdicts, for programs that collect test results");
    check.add_flag("--client", chosen.check.is_client,
                   "check a client: servers are played to it, on a pseudo-terminal, or on the --port");
    check.add_option("--client-port", chosen.check.client_port,
                     "what the client opens, where --port is a serial device: its other end, such as /dev/ttyUSB1");
    add_operands(
        check, chosen, "COMMAND",
        "behind --client --: the program of the client and its words; without it a client that asks by itself is "
        "judged by its requests alone");
    add_to_footer(
        check,
        "Exit status: 0 all musts hold, 1 not. It only reads, and sends frames that are damaged or for nobody.\n"
        "With --client the COMMAND is run for each clause, with more words: PORT TIMEOUT and, for each request,\n"
        "  read UNIT ADDRESS COUNT    read holding registers (03), print their values in decimal, on one line\n"
        "  write UNIT ADDRESS VALUE   write one register (06 or 16), print ok\n"
        "such as /dev/pts/4 500 read 1 100 2 read 1 300 2. It opens PORT once (8E1, 19200 bit/s on a real line; RTU "
        "over\n"
        "TCP where it is host:port), waits TIMEOUT milliseconds for a response, sends the requests in order, and "
        "prints a\n"
        "line for each: values, ok, or error where it failed. Other lines are left out.");
}

void add_chaos(CLI::App& app, choices& chosen)
{
    CLI::App& chaos = add_command(app, chosen, "chaos", "a line that misbehaves, between a client and a server");
    chaos.add_option("--from", chosen.chaos.from, "the client's port: pty makes one, whose name it says");
    chaos.add_option("--to", chosen.chaos.to, "the server's port, as --port takes it, or pty");
    chaos
        .add_option_function<std::vector<std::string>>(
            "--faults",
            [&chosen](std::vector<std::string> const& typed) {
                for (std::string const& each : typed) {
                    chosen.chaos.faults += (chosen.chaos.faults.empty() ? "" : ",") + each;
                }
            },
            "what is played, and how often or at which frame: late=1%,lost@250x5,delay=5%:30ms")
        ->allow_extra_args(false);
    chaos.add_option("--seed", chosen.chaos.seed, "the same number and the same bytes make the same decisions")
        ->check(any_seed())
        ->capture_default_str();
    chaos.add_flag("--dry", chosen.chaos.is_dry, "show what each fault would meet, and open nothing");
    chaos
        .add_option("-o,--output", chosen.file, "a new file for Wireshark that says of each frame what was done to it")
        ->check([](std::string const& typed) { return typed.empty() ? "a file has a name" : std::string{}; });
    add_time_limit(chaos, chosen);
    add_to_footer(chaos, "--timeout is the client's, 1 s where it is not said. Each of these may happen to an answer, "
                         "the echo to its request:\n" +
                             faults_text() +
                             "and to a request, as request-lost and so on: delay, lost, damaged, lumps, split, cut.\n"
                             "=1% of the frames, @250 the frame with this number, @250x5 five from it on, :30ms the "
                             "time.\n"
                             "For benches: who asks again gives a command again, and a late stop stops late.\n"
                             "Exit status: 0 where requests came, also by Ctrl-C; 3 where none did.");
}

void add_serve(CLI::App& app, choices& chosen)
{
    CLI::App& serve = add_command(app, chosen, "serve", "let many clients ask the units of one line, by Modbus TCP");
    serve_choices& with = chosen.serve;
    serve
        .add_option("--listen", with.listen,
                    "where: mbap://127.0.0.1:1502 (as without one) is Modbus TCP, tcp://127.0.0.1:4001 RTU frames over "
                    "TCP; port 0 is any that is free")
        ->allow_extra_args(false);
    serve
        .add_option("--units", with.units,
                    "the units that are served, 1-4,7; drives as well. Without it all but drives")
        ->check(why_no_list);
    serve.add_option("--functions", with.functions, "the functions that are served, 3,4,16 or 0x10")
        ->check(why_no_list);
    serve
        .add_option("--from", with.from,
                    "the clients that are served, 192.168.1.0/24 or fd00::/8; all others are hung up on")
        ->allow_extra_args(false);
    serve.add_flag("--allow-broadcast", with.may_broadcast, "send to all units what clients send to unit 0 (--write)");
    serve.add_option("--metrics", with.metrics, "where GET /metrics tells figures to Prometheus: 127.0.0.1:9502")
        ->check(why_no_list);
    add_time(serve, "--idle", with.idle, "how long a client may ask nothing before it is hung up on: 10min without it",
             time_limit_typed, "10s, 10min or 8h: more than 0, at most 366 days");
    add_time_limit(serve, chosen);
    add_to_footer(
        serve,
        "It reads. With --write it passes on what the command write would, to drives as well; nothing by which a\n"
        "motor of a known drive may turn, nor --allow-run; 0000 passes. --write beyond this machine\n"
        "needs --from.\n"
        "Exceptions of its own: 01 refused here; 03 not as the specification has it; 06 too many requests wait, "
        "or this\none waited 5 s; 0A no such unit here; 0B the unit did not answer, or the line is away.");
}

void add_gateway(CLI::App& app, choices& chosen)
{
    CLI::App& gateway = add_command(app, chosen, "gateway", "devices on lines to an MQTT broker, as a file says");
    gateway.add_option("FILE", chosen.words, "its lines, devices and broker; without one /etc/rtuwire/gateway.toml")
        ->expected(0, 1);
    gateway.add_flag("--check", chosen.only_checks, "check the file and all that it names, and show what it publishes");
    add_to_footer(gateway, "It runs rtuwire-gateway, until somebody ends it; HUP reads the file again. --write allows "
                           "the settings that the\nfile names. Ports, rates and units stand in the file.");
}

/// What the program says of itself.
void add_own_texts(CLI::App& app, choices& chosen)
{
    add_operands(add_command(app, chosen, "completion", "print a completion script: put it where your shell finds it"),
                 chosen, "SHELL", "bash or zsh", true);
    add_command(app, chosen, "man", "print a page for man(1)");
}

} // namespace

void add_words(CLI::App& app, choices& chosen)
{
    app.footer(first_steps_text() + ends_with);
    app.require_subcommand(1);
    add_line_options(app, chosen.line);
    add_form_options(app, chosen.form);
    add_permissions(app, chosen.allowed);
    add_reading(app, chosen);
    add_writing(app, chosen);
    add_settings(app, chosen);
    add_line_tools(app, chosen);
    add_device(app, chosen);
    add_check(app, chosen);
    add_chaos(app, chosen);
    add_serve(app, chosen);
    add_gateway(app, chosen);
    add_own_texts(app, chosen);
}

} // namespace tool
