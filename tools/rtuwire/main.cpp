// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// rtuwire: what a person does with a line of Modbus RTU, from a terminal. docs/tool.md is its page.
#include <csignal>
#include <exception>
#include <string>
#include <string_view>

#include "../support/standard_descriptors.hpp"
#include "command_line.hpp"
#include "commands/commands.hpp"
#include "output/passing_text.hpp"
#include "output/plain_text.hpp"

namespace {

using namespace tool;

struct command {
    std::string_view name;
    exit_status (*run)(choices const&);
};

constexpr command commands[] = {
    {"scan", run_scan},         {"identify", run_identify}, {"read", run_read},     {"watch", run_watch},
    {"list", run_list},         {"explain", run_explain},   {"faults", run_faults}, {"write", run_write},
    {"sniff", run_sniff},       {"capture", run_capture},   {"replay", run_replay}, {"timing", run_timing},
    {"simulate", run_simulate}, {"monitor", run_monitor},   {"decode", run_decode}, {"start", run_start},
    {"stop", run_stop},         {"reset", run_reset},       {"backup", run_backup}, {"compare", run_compare},
    {"restore", run_restore},   {"device", run_device},     {"ports", run_ports},   {"ask", run_ask},
    {"map", run_map},
};

/// Behind the last frame, however the command ends.
struct last_note {
    ~last_note() { tell_dropped(); }
};

exit_status run(choices const& chosen)
{
    last_note const at_the_end;
    for (command const& each : commands) {
        if (each.name == chosen.command) {
            return each.run(chosen);
        }
    }
    refuse_word("'" + chosen.command + "' is no command");
}

} // namespace

int main(int argc, char** argv)
{
    keep_standard_descriptors();
    std::signal(SIGPIPE, SIG_IGN); // a reader that went away is told by the write
    std::signal(SIGXFSZ, SIG_IGN); // and so is a file that may not grow
    try {
        parsed const words = parse(argc, argv);
        return static_cast<int>(words.chosen ? run(*words.chosen) : words.status);
    } catch (ended const& why) {
        tell_error(why.what());
        return static_cast<int>(why.status);
    } catch (std::exception const& why) {
        tell_error(why.what());
        return static_cast<int>(exit_status::port);
    }
}
