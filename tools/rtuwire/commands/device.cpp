// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Checks register files, and makes them of other programs': no line is needed.
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>

#include "commands/commands.hpp"
#include "device/drive_export.hpp"
#include "device/register_file.hpp"
#include "files/regular_file.hpp"
#include "files/whole_file.hpp"
#include "import/import.hpp"
#include "line/who_is_it.hpp"
#include "output/plain_text.hpp"
#include "words/named_value.hpp"

namespace tool {

namespace {

/// "setting, moves, no value at 0x7FFF".
std::string notes_of(named_place const& each)
{
    std::string notes;
    auto const add = [&notes](bool is_so, std::string const& what) {
        notes += is_so ? (notes.empty() ? "" : ", ") + what : std::string{};
    };
    add(each.is_setting, "setting");
    add(each.is_stored, "stored");
    add(each.moves, "moves");
    for (std::uint64_t const number : each.invalid) {
        std::array<char, 32> text{};
        auto const end = std::to_chars(text.data(), text.data() + text.size(), number, 16).ptr;
        add(true, "no value at 0x" + upper({text.data(), end}));
    }
    return notes;
}

record row_of(named_place const& each)
{
    place bare = each.where;
    bare.name.clear();
    auto const limit = [](std::optional<double> const& number) { return number ? cell{*number} : cell{}; };
    return {{"register", each.where.name},
            {"place", text_of(bare)},
            {"access", std::string{each.is_writable ? "read, write" : "read only"}},
            {"lowest", limit(each.lowest)},
            {"highest", limit(each.highest)},
            {"choices", list_of_choices(each)},
            {"group", each.group},
            {"note", notes_of(each)}};
}

exit_status check_files(choices const& chosen)
{
    output results{chosen.form, false};
    for (std::size_t i = 1; i < chosen.words.size(); ++i) {
        for (named_place const& each : register_file_at(chosen.words[i]).places) {
            results.put(row_of(each));
        }
    }
    results.finish();
    return exit_status::done;
}

/// To the file of --output, which is no file yet, or to the standard output.
void put_text(std::string const& text, std::string const& file)
{
    if (not file.empty()) {
        if (std::string const why = write_new_file(file, text); not why.empty()) {
            throw ended{exit_status::port, file + ": " + why};
        }
        return;
    }
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() or std::fflush(stdout) != 0) {
        throw ended{exit_status::port, "standard output: " + std::string{std::strerror(errno)}};
    }
}

/// Tells what was lost, and puts the rest.
exit_status put_file(choices const& chosen, register_file_writer const& written)
{
    for (std::string const& each : written.told()) {
        tell_error(each);
    }
    if (written.registers() == 0) {
        refuse_word(written.file() + ": it has no register that can be carried over");
    }
    std::string const text = written.text();
    static_cast<void>(read_register_file(written.file() + ", as it would be written", text));
    put_text(text, chosen.file);
    if (written.lost() == 0) {
        return exit_status::done;
    }
    tell_error(written.file() + ": " + std::to_string(written.registers()) + " registers; " +
               std::to_string(written.lost()) + " times something was not carried over");
    return exit_status::differs;
}

exit_status import_one(choices const& chosen)
{
    if (chosen.words.size() != 2) {
        refuse_word("one file is imported: device import FILE");
    }
    std::string const& file = chosen.words[1];
    file_text const found = text_of_file(file);
    if (not found.failure.empty()) {
        refuse_word(file + ": " + found.failure);
    }
    import_choices how{.base = chosen.base};
    if (chosen.line.is_unit_named) {
        how.unit = word_number(chosen.line.unit);
        if (not how.unit) {
            refuse_word("-u: one number, whose registers a file of several units is to have");
        }
    }
    return put_file(chosen, import_file(file, found.text, how));
}

exit_status export_one(choices const& chosen)
{
    if (chosen.words.size() != 2) {
        refuse_word("one drive is exported: device export atv320");
    }
    register_file_writer writer{chosen.words[1], std::nullopt};
    export_drive(catalog_chosen(chosen.words[1]), writer);
    return put_file(chosen, writer);
}

} // namespace

exit_status run_device(choices const& chosen)
{
    std::string const& what = chosen.words.front();
    if (what == "check" and chosen.words.size() > 1) {
        return check_files(chosen);
    }
    if (what == "import") {
        return import_one(chosen);
    }
    if (what == "export") {
        return export_one(chosen);
    }
    refuse_word("device knows register files: device check FILE, device import FILE, device export DRIVE");
}

} // namespace tool
