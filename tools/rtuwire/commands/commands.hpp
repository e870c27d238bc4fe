// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the tool can do: a function a command, each in a file of its own. They throw `ended` where they end early.
#pragma once

#include <cstdint>
#include <string_view>

#include "choices.hpp"
#include "exit_status.hpp"

namespace tool {

exit_status run_scan(choices const& chosen);
exit_status run_identify(choices const& chosen);
exit_status run_map(choices const& chosen);
exit_status run_ask(choices const& chosen);
exit_status run_read(choices const& chosen);
exit_status run_watch(choices const& chosen);
exit_status run_monitor(choices const& chosen);
exit_status run_list(choices const& chosen);
exit_status run_explain(choices const& chosen);
exit_status run_faults(choices const& chosen);
exit_status run_backup(choices const& chosen);
exit_status run_compare(choices const& chosen);
exit_status run_restore(choices const& chosen);
exit_status run_write(choices const& chosen);
exit_status run_decode(choices const& chosen);
exit_status run_simulate(choices const& chosen);
exit_status run_start(choices const& chosen);
exit_status run_stop(choices const& chosen);
exit_status run_reset(choices const& chosen);
exit_status run_sniff(choices const& chosen);
exit_status run_capture(choices const& chosen);
exit_status run_replay(choices const& chosen);
exit_status run_timing(choices const& chosen);
exit_status run_ports(choices const& chosen);
exit_status run_check(choices const& chosen);
exit_status run_chaos(choices const& chosen);
exit_status run_serve(choices const& chosen);
exit_status run_device(choices const& chosen);
exit_status run_gateway(choices const& chosen);

/// What a command makes of the register file of a unit, of --device or --name.
enum class file_use : std::uint8_t {
    none,   ///< it refuses --device
    names,  ///< it knows the registers by their names, and what the file says of them
    served, ///< the file is the device
};

/// Nothing of it has a default: what a new command makes of register files is said, or it does not compile.
struct command {
    std::string_view name;
    exit_status (*run)(choices const&);
    file_use files;
};

inline constexpr command commands[]{
    {"ports", run_ports, file_use::none},       {"scan", run_scan, file_use::none},
    {"identify", run_identify, file_use::none}, {"map", run_map, file_use::names},
    {"read", run_read, file_use::names},        {"watch", run_watch, file_use::names},
    {"monitor", run_monitor, file_use::names},  {"list", run_list, file_use::none},
    {"explain", run_explain, file_use::none},   {"faults", run_faults, file_use::none},
    {"write", run_write, file_use::names},      {"ask", run_ask, file_use::names},
    {"start", run_start, file_use::none},       {"stop", run_stop, file_use::none},
    {"reset", run_reset, file_use::none},       {"backup", run_backup, file_use::names},
    {"compare", run_compare, file_use::names},  {"restore", run_restore, file_use::names},
    {"sniff", run_sniff, file_use::names},      {"capture", run_capture, file_use::none},
    {"replay", run_replay, file_use::names},    {"timing", run_timing, file_use::none},
    {"decode", run_decode, file_use::names},    {"simulate", run_simulate, file_use::served},
    {"device", run_device, file_use::none},     {"check", run_check, file_use::none},
    {"chaos", run_chaos, file_use::none},       {"serve", run_serve, file_use::none},
    {"gateway", run_gateway, file_use::none},
};

/// Null where there is none of that name: `completion` and `man` are of the command line itself.
constexpr command const* command_named(std::string_view name)
{
    for (command const& each : commands) {
        if (each.name == name) {
            return &each;
        }
    }
    return nullptr;
}

} // namespace tool
