// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/write_log.hpp"

#include <filesystem>
#include <sstream>

#include "../support/platform.hpp"
#include "exit_status.hpp"
#include "files/regular_file.hpp"
#include "line/time_text.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

std::string place_of(std::string const& port, unsigned unit)
{
    return '\t' + plain_text(port) + '\t' + std::to_string(unit) + '\t';
}

/// More than one row has, and than one of many has as a rule.
constexpr std::size_t row_size = 4096, usual_size = 256;

/// Does that with the file, which is made where it is missing. Why it could not; empty where it could.
template <typename Action> std::string with_log(Action action)
{
    std::filesystem::path const file = write_log_file();
    if (file.empty()) {
        return "there is no home for writes.log: set " TOOL_HOME;
    }
    std::error_code ignored; // the file itself tells
    std::filesystem::create_directories(file.parent_path(), ignored);
    appended_file log{file.string()};
    action(log);
    return log.failure().empty() ? std::string{} : file.string() + ": " + log.failure();
}

} // namespace

std::string write_log_file()
{
    std::string const state = folder_of_user(user_folder::state);
    return state.empty() ? state : state + "/rtuwire/writes.log";
}

std::string log_write(written_value const& what)
{
    std::string const row = second_text(unix_now()) + '\t' + name_of_user() + place_of(what.port, what.unit) +
                            plain_text(what.label) + '\t' + plain_text(what.before) + '\t' + plain_text(what.after) +
                            '\n';
    return with_log([&row](appended_file& log) { log.write((log.ends_with_line() ? "" : "\n") + row); });
}

std::string why_nothing_can_be_noted(std::size_t rows)
{
    return with_log([rows](appended_file& log) { log.reserve(row_size + rows * usual_size); });
}

void refuse_wrong_log(std::size_t rows)
{
    if (std::string const why = why_nothing_can_be_noted(rows); not why.empty()) {
        throw ended{exit_status::port, "nothing is written, because nothing could be noted: " + why};
    }
}

unsigned count_saves(std::string const& port, unsigned unit)
{
    std::istringstream in{text_of_file(write_log_file()).text};
    unsigned count = 0;
    for (std::string line; std::getline(in, line);) {
        count += line.find(place_of(port, unit) + "CMI\t") != std::string::npos ? 1U : 0U;
    }
    return count;
}

} // namespace tool
