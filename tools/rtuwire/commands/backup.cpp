// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads all parameters of a drive into a file.
#include <string>

#include "backup/backup_text.hpp"
#include "backup/drive_settings.hpp"
#include "commands/commands.hpp"
#include "files/regular_file.hpp"
#include "files/whole_file.hpp"
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

} // namespace

exit_status run_backup(choices const& chosen)
{
    bool const is_output = chosen.file == "-";
    if (std::string const why = is_output ? std::string{} : why_no_regular_file(chosen.file); not why.empty()) {
        refuse_word(chosen.file + ": " + why);
    }
    named_unit const unit = unit_in(chosen.line);
    open_line line{chosen.line};
    saved_settings const settings = settings_of(line, unit, chosen.line.port);
    std::string const text = is_csv(chosen) ? csv_text_of(settings) : json_text_of(settings);
    if (is_output) {
        print(text);
        return exit_status::done;
    }
    if (std::string const why = write_whole_file(chosen.file, text); not why.empty()) {
        throw ended{exit_status::port, chosen.file + ": " + why + "; the backup is not kept"};
    }
    std::int64_t refused = 0;
    for (saved_parameter const& each : settings.parameters) {
        refused += each.word ? 0 : 1;
    }
    output results{chosen.form, false};
    results.put({{"unit", std::int64_t{unit.unit.byte()}},
                 {"drive", std::string{settings.drive->name}},
                 {"file", chosen.file},
                 {"read", static_cast<std::int64_t>(settings.parameters.size()) - refused},
                 {"refused by the drive", refused}});
    results.finish();
    return exit_status::done;
}

} // namespace tool
