// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads all parameters of a drive into a file, or the settings that a register file names.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>

#include "backup/backup_text.hpp"
#include "backup/drive_settings.hpp"
#include "commands/commands.hpp"
#include "commands/device_commands.hpp"
#include "files/regular_file.hpp"
#include "files/whole_file.hpp"
#include "output/plain_text.hpp"
#include "words/words.hpp"

namespace tool {

namespace {

bool is_csv(choices const& chosen) { return chosen.form == output_form::csv or lower(chosen.file).ends_with(".csv"); }

void print(std::string const& text)
{
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() or std::fflush(stdout) != 0) {
        throw ended{exit_status::port, "standard output: it could not be written"};
    }
}

backup_summary back_up_drive(open_line& line, named_unit const& unit, std::string const& port, bool is_csv)
{
    saved_settings const settings = settings_of(line, unit, port);
    auto const refused =
        std::ranges::count_if(settings.parameters, [](saved_parameter const& each) { return not each.word; });
    backup_rows const rows = rows_of(settings);
    return {is_csv ? csv_text_of(rows) : json_text_of(rows), std::string{settings.drive->name}, rows.rows.size(),
            static_cast<std::size_t>(refused)};
}

} // namespace

exit_status run_backup(choices const& chosen)
{
    bool const is_output = chosen.file == "-";
    if (std::string const why = is_output ? std::string{} : why_no_regular_file(chosen.file); not why.empty()) {
        refuse_word(chosen.file + ": " + why);
    }
    named_unit const unit = unit_in(chosen.line);
    open_line line{chosen.line};
    backup_summary const made = unit.names != nullptr ? back_up_device(line, unit, chosen.line.port, is_csv(chosen))
                                                      : back_up_drive(line, unit, chosen.line.port, is_csv(chosen));
    if (is_output) {
        print(made.text);
        return exit_status::done;
    }
    std::error_code ignored;
    bool const is_there = std::filesystem::exists(chosen.file, ignored);
    if (std::string const why = write_whole_file(chosen.file, made.text); not why.empty()) {
        throw ended{exit_status::port, chosen.file + ": " + why + "; the backup is not kept"};
    }
    if (is_there) {
        std::fprintf(stderr, "note: %s was there already, and is replaced\n", plain_text(chosen.file).c_str());
    }
    output results{chosen.form, false};
    results.put({{"unit", std::int64_t{unit.unit.byte()}},
                 {unit.names != nullptr ? "device" : "drive", made.of},
                 {"file", chosen.file},
                 {"read", static_cast<std::int64_t>(made.rows - made.refused)},
                 {unit.names != nullptr ? "without a value" : "refused by the drive",
                  static_cast<std::int64_t>(made.refused)}});
    results.finish();
    return exit_status::done;
}

} // namespace tool
