// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/write_log.hpp"

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

#include <pwd.h>
#include <unistd.h>

namespace tool {

namespace {

std::string variable(char const* name)
{
    char const* const value = std::getenv(name);
    return value == nullptr ? std::string{} : std::string{value};
}

std::string user_name()
{
    passwd const* const entry = ::getpwuid(::getuid());
    return entry == nullptr ? std::to_string(::getuid()) : std::string{entry->pw_name};
}

std::string time_now()
{
    std::time_t const now = std::time(nullptr);
    char text[32] = "";
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S%z", std::localtime(&now));
    return text;
}

std::string place_of(std::string const& port, unsigned unit)
{
    return '\t' + port + '\t' + std::to_string(unit) + '\t';
}

} // namespace

std::string write_log_file()
{
    std::string const state = variable("XDG_STATE_HOME");
    std::string const home = variable("HOME");
    if (not state.empty()) {
        return state + "/rtuwire/writes.log";
    }
    return home.empty() ? std::string{} : home + "/.local/state/rtuwire/writes.log";
}

bool log_write(written_value const& what)
{
    std::filesystem::path const file = write_log_file();
    if (file.empty()) {
        return false;
    }
    std::error_code ignored; // the file itself tells
    std::filesystem::create_directories(file.parent_path(), ignored);
    std::ofstream out{file, std::ios::app};
    out << time_now() << '\t' << user_name() << place_of(what.port, what.unit) << what.label << '\t' << what.before
        << '\t' << what.after << std::endl;
    return out.good();
}

unsigned count_saves(std::string const& port, unsigned unit)
{
    std::ifstream in{write_log_file()};
    unsigned count = 0;
    for (std::string line; std::getline(in, line);) {
        count += line.find(place_of(port, unit) + "CMI\t") != std::string::npos ? 1U : 0U;
    }
    return count;
}

} // namespace tool
