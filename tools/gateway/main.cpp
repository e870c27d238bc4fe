// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// rtuwire-gateway: the values of devices on Modbus lines, to an MQTT broker. docs/tool.md is its page.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>

#include <CLI/CLI.hpp>
#include <rtuwire/frames.hpp>

#include "../support/platform.hpp"
#include "mqtt/mqtt_gateway.hpp"
#include "output/plain_text.hpp"

namespace {

using namespace tool;
using namespace tool::gateway;

void tell_failure(char const* why) { std::fprintf(stderr, "rtuwire-gateway: %s\n", plain_text(why).c_str()); }

exit_status run(gateway_choices const& chosen, bool only_checks)
{
    gateway_plan plan = checked_plan(chosen.file);
    if (only_checks) {
        show_plan(plan, chosen.has_json ? output_form::json : output_form::table);
        for (std::string const& each : plan.notes) {
            std::fprintf(stderr, "note: %s\n", plain_text(each).c_str());
        }
        return exit_status::done;
    }
    mqtt_gateway{chosen, std::move(plan)}.run();
    return exit_status::done;
}

int status_of_run(gateway_choices const& chosen, bool only_checks)
{
    try {
        return static_cast<int>(run(chosen, only_checks));
    } catch (ended const& why) {
        tell_failure(why.what());
        return static_cast<int>(why.status);
    } catch (std::exception const& why) {
        tell_failure(why.what());
        return static_cast<int>(exit_status::port);
    }
}

std::string version_text()
{
    constexpr unsigned number = RTUWIRE_VERSION;
    return std::to_string(number / 10'000) + '.' + std::to_string(number / 100 % 100) + '.' +
           std::to_string(number % 100);
}

} // namespace

int main(int argc, char** argv)
{
    keep_standard_descriptors();
    std::signal(SIGPIPE, SIG_IGN); // a reader that went away is told by the write
    std::signal(SIGXFSZ, SIG_IGN); // and so is a file that may not grow
    gateway_choices chosen;
    bool only_checks = false;
    CLI::App app{"Devices on Modbus lines to an MQTT broker, as a file says. It reads unless --write says otherwise.",
                 "rtuwire-gateway"};
    app.set_version_flag("--version", version_text());
    app.add_option("FILE", chosen.file, "lines, devices and the broker")->capture_default_str();
    app.add_flag("--check", only_checks, "check the file and all that it names, and show what would be published");
    app.add_flag("--write", chosen.may_write, "allow the settings that the file names");
    app.add_flag("--json", chosen.has_json, "one JSON object a line: of --check a value each, else each change");
    try {
        app.parse(argc, argv);
    } catch (CLI::ParseError const& why) {
        return app.exit(why) == 0 ? 0 : static_cast<int>(exit_status::usage);
    }
    int const status = status_of_run(chosen, only_checks);
    if (is_a_connection_left()) {
        std::fflush(nullptr);
        std::_Exit(status);
    }
    return status;
}
