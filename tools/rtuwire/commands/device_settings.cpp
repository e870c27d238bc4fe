// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Backs up, compares and restores the settings of what is no drive, by its register file.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "backup/device_settings.hpp"
#include "backup/drive_settings.hpp"
#include "commands/device_commands.hpp"
#include "line/end_wish.hpp"
#include "line/line_words.hpp"
#include "line/write_log.hpp"
#include "output/output.hpp"
#include "words/named_value.hpp"
#include "words/place_value.hpp"

namespace tool {

namespace {

/// One side, with a name for its column.
struct device_side {
    std::string name;
    device_settings settings;
};

device_side unit_side(line_choices line, std::string const& word)
{
    std::size_t const at = word.find('@');
    line.unit = word.substr(0, at);
    line.port = at == word.npos ? line.port : word.substr(at + 1);
    named_unit const unit = unit_in(line);
    open_line open{line};
    return {"unit " + word, device_settings_of(open, unit, line.port)};
}

cell raw_of(device_value const& of)
{
    return of.words.empty()       ? cell{}
           : of.words.size() == 1 ? cell{std::int64_t{of.words[0]}}
                                  : cell{hex_words(of.words)};
}

exit_status compare(choices const& chosen, device_side const& left, device_side const& right)
{
    bool const is_table = chosen.form == output_form::table;
    output results{chosen.form, false};
    std::size_t compared = 0, different = 0, unmatched = 0;
    for (device_value const& each : left.settings.values) {
        device_value const* const other = right.settings.find(each.named);
        unmatched += other == nullptr ? 1U : 0U;
        if (other == nullptr or (each.words.empty() and other->words.empty())) {
            continue;
        }
        ++compared;
        if (each.words == other->words) {
            continue;
        }
        ++different;
        record row{{"group", each.named->group}, {"register", each.named->where.name}};
        if (not is_table) {
            row.add("address", std::int64_t{each.named->where.address})
                .add("left raw", raw_of(each))
                .add("right raw", raw_of(*other));
        }
        results.put(row.add(is_table ? left.name : "left", text_of(each))
                        .add(is_table ? right.name : "right", text_of(*other)));
    }
    results.finish();
    for (device_value const& each : right.settings.values) {
        unmatched += left.settings.find(each.named) == nullptr ? 1U : 0U;
    }
    if (is_table) {
        std::string const rest = unmatched == 0 ? "" : "; " + std::to_string(unmatched) + " are not in both";
        std::fprintf(stderr, "%zu of %zu settings differ%s\n", different, compared, rest.c_str());
    }
    return different > 0 ? exit_status::differs : exit_status::done;
}

/// Before the line is opened: what would be written has to be a value of its register.
void refuse_what_is_not_written(std::string const& file, device_settings const& wanted)
{
    for (device_value const& each : wanted.values) {
        std::string const why = each.words.empty() ? std::string{} : why_not_written(*each.named, each.words);
        if (not why.empty()) {
            refuse_word(place_text(file, each.place) + why);
        }
    }
    if (std::ranges::all_of(wanted.values, [](device_value const& each) { return each.words.empty(); })) {
        refuse_word(file + ": there is no value in it that could be restored");
    }
}

void refuse_options_of_drives(restore_choices const& with)
{
    bool const has_any = with.with_channels or with.with_link or with.with_inferred or with.with_supervision or
                         with.with_autorestart or with.has_open_inputs or with.save;
    if (has_any) {
        refuse_word("--with-..., --inputs-open and --save are of drives: the settings of a device are those that its "
                    "register file names");
    }
}

void show_plan(choices const& chosen, named_unit const& unit, std::vector<value_to_write> const& values,
               std::vector<device_value> const& held)
{
    output results{chosen.form, false};
    for (value_to_write const& each : values) {
        auto const now = std::ranges::find(held, each.named, &device_value::named);
        results.put({{"unit", std::int64_t{unit.unit.byte()}},
                     {"register", each.named->where.name},
                     {"held", text_of(*now)},
                     {"wanted", each.text},
                     {"outcome", std::string{"to be written"}}});
    }
    results.finish();
}

} // namespace

backup_summary back_up_device(open_line& line, named_unit const& unit, std::string const& port, bool is_csv)
{
    device_settings const settings = device_settings_of(line, unit, port);
    auto const refused =
        std::ranges::count_if(settings.values, [](device_value const& each) { return each.words.empty(); });
    return {is_csv ? csv_text_of(settings) : json_text_of(settings), settings.said("device"), settings.values.size(),
            static_cast<std::size_t>(refused)};
}

exit_status compare_device(choices const& chosen)
{
    if (chosen.is_factory) {
        refuse_word("--factory: a register file says nothing of the factory");
    }
    named_places const& names = *unit_in(chosen.line).names;
    std::vector<named_unit> const named = names_in(chosen.line);
    auto const is_unit = [&named](std::string const& word) {
        return word.find('@') != word.npos or std::ranges::all_of(word, is_digit) or
               std::ranges::count(named, word, &named_unit::name) > 0;
    };
    std::vector<device_side> sides(chosen.words.size());
    for (bool const is_file : {true, false}) { // what is wrong in a file is told before a line is opened
        for (std::size_t i = 0; i < sides.size(); ++i) {
            std::string const& word = chosen.words[i];
            if (is_file != is_unit(word)) {
                sides[i] =
                    is_file ? device_side{word, device_settings_of_file(word, names)} : unit_side(chosen.line, word);
            }
        }
    }
    if (sides.size() == 1) {
        sides.push_back(unit_side(chosen.line, chosen.line.unit));
    }
    return compare(chosen, sides[0], sides[1]);
}

exit_status restore_device(choices const& chosen)
{
    refuse_options_of_drives(chosen.restore);
    named_unit const unit = unit_to_change(chosen);
    device_settings const wanted = device_settings_of_file(chosen.file, *unit.names);
    refuse_what_is_not_written(chosen.file, wanted);
    if (not chosen.restore.dry_run) {
        refuse_wrong_log();
    }
    open_line line{chosen.line};
    static_cast<void>(refuse_another_device(line, unit.unit, unit.names->vendor, unit.names->product));
    static_cast<void>(refuse_another_device(line, unit.unit, wanted.said("vendor"), wanted.said("product")));
    std::vector<named_place const*> registers;
    for (device_value const& each : wanted.values) {
        if (not each.words.empty()) {
            registers.push_back(each.named);
        }
    }
    std::vector<device_value> const held = read_settings(line, unit, registers);
    std::vector<value_to_write> values;
    for (device_value const& each : held) {
        if (each.words.empty()) {
            throw ended{exit_status::differs,
                        each.named->where.name + " cannot be read: " + each.error + "; nothing was written"};
        }
        device_value const& want = *wanted.find(each.named);
        if (want.words != each.words) {
            value_to_write value{.where = each.named->where, .named = each.named, .words = want.words};
            value.text = value.text_of_words(value.words);
            values.push_back(std::move(value));
        }
    }
    std::string const rest = std::to_string(held.size() - values.size()) + " held, " +
                             std::to_string(wanted.values.size() - held.size()) + " without a value";
    if (chosen.restore.dry_run or values.empty()) {
        show_plan(chosen, unit, values, held);
        std::fprintf(stderr, "rtuwire: %s; %zu to be written, %s\n",
                     values.empty() ? "the unit holds all of it" : "nothing is written in a dry run", values.size(),
                     rest.c_str());
        return exit_status::done;
    }
    exit_status const status = write_values(chosen, line, std::move(values));
    std::fprintf(stderr, "rtuwire: %s; %s\n",
                 status == exit_status::done      ? "all that differed is written and read back"
                 : status == exit_status::refused ? "nothing was written"
                 : noted_signal() != 0            ? "ended by a signal: the rows say what was written"
                                                  : "not all of it is written: the rows say what is",
                 rest.c_str());
    return status;
}

} // namespace tool
