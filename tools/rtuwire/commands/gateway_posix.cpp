// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The gateway to MQTT is a program of its own, which alone needs a library of that.
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

#include <unistd.h>

#include "commands/commands.hpp"

namespace tool {

namespace {

constexpr char const* gateway_program = "rtuwire-gateway";

/// Where it may be: beside this program, also where both were just built; else in PATH.
std::array<std::string, 3> gateway_places()
{
    std::error_code ignored;
    std::filesystem::path const here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    return {(here / gateway_program).string(), (here.parent_path() / "gateway" / gateway_program).string(),
            gateway_program};
}

} // namespace

exit_status run_gateway(choices const& chosen)
{
    if (chosen.form == output_form::csv) {
        refuse_word("gateway: --csv: it says what it does as JSON, by --json");
    }
    std::vector<std::string> words{gateway_program};
    words.insert(words.end(), chosen.words.begin(), chosen.words.end());
    auto const pass_on = [&words](bool is_chosen, char const* word) {
        if (is_chosen) {
            words.emplace_back(word);
        }
    };
    pass_on(chosen.only_checks, "--check");
    pass_on(chosen.allowed.may_write, "--write");
    pass_on(chosen.form == output_form::json, "--json");
    std::vector<char*> pointers;
    for (std::string& each : words) {
        pointers.push_back(each.data());
    }
    pointers.push_back(nullptr);
    for (std::string const& each : gateway_places()) {
        ::execvp(each.c_str(), pointers.data());
        if (errno != ENOENT) {
            throw ended{exit_status::port, each + ": " + std::strerror(errno)};
        }
    }
    refuse_word("rtuwire-gateway is not installed: it stands neither beside this program nor in PATH; Debian's package "
                "of that name has it");
}

} // namespace tool
