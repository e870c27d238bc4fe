// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What differs between two sets of settings: of a file, of a drive, of the factory.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <rtuwire/maintenance.hpp>

#include "backup/drive_settings.hpp"
#include "catalog/entry_words.hpp"
#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
#include "commands/device_commands.hpp"
#include "line/who_is_it.hpp"

namespace tool {

namespace {

using rtuwire::altivar::comparison;

/// One side, with a name for its column.
struct compared_side {
    std::string name;
    saved_settings settings;
};

bool is_unit_word(std::string const& word, line_choices const& line)
{
    bool const is_number = not word.empty() and std::ranges::all_of(word, is_digit);
    std::vector<named_unit> const names = names_in(line);
    return is_number or std::ranges::count(names, word, &named_unit::name) > 0;
}

/// The drive of the line; `word` is "7", "fan" or "7@/dev/ttyUSB1".
compared_side drive_side(line_choices line, std::string const& word, std::string const& name)
{
    std::size_t const at = word.find('@');
    line.unit = word.substr(0, at);
    line.port = at == word.npos ? line.port : word.substr(at + 1);
    named_unit const unit = unit_in(line);
    open_line open{line};
    return {name, settings_of(open, unit, line.port)};
}

compared_side side_of(choices const& chosen, std::string const& word)
{
    if (word.find('@') != word.npos or is_unit_word(word, chosen.line)) {
        return drive_side(chosen.line, word, "unit " + word);
    }
    return {word, settings_of_file(word, chosen.line.drive)};
}

class settings_comparison {
public:
    settings_comparison(output_form form, compared_side const& left, compared_side const& right)
        : form_{form}, left_{left}, right_{right}
    {}

    exit_status run()
    {
        output results{form_, false};
        for (saved_parameter const* const each : in_order()) {
            compare(*each, results);
        }
        results.finish();
        if (form_ == output_form::table) {
            std::fprintf(stderr, "%zu of %zu settings differ%s\n", different_, compared_, left_out_text().c_str());
        }
        return different_ > 0 ? exit_status::differs : exit_status::done;
    }

private:
    std::vector<saved_parameter const*> in_order() const
    {
        std::vector<saved_parameter const*> all;
        for (saved_parameter const& each : left_.settings.parameters) {
            all.push_back(&each);
        }
        std::ranges::sort(all, {}, [](auto const* each) {
            return std::tuple{each->entry->group, each->entry->address};
        });
        return all;
    }

    /// Of two types of drives, a register is the same where it counts the same.
    static bool is_same(register_entry const& left, register_entry const& right)
    {
        return left.kind == right.kind and left.unit == right.unit and left.steps_set_by == right.steps_set_by and
               left.step.numerator == right.step.numerator and left.step.denominator == right.step.denominator;
    }

    void compare(saved_parameter const& left, output& results)
    {
        saved_parameter const* const right = right_.settings.find(left.entry->code);
        if (right == nullptr or not is_same(*left.entry, *right->entry)) {
            unmatched_ += is_restorable(role_of(*left.entry->row)) ? 1U : 0U;
            return;
        }
        switch (rtuwire::altivar::compared(*left.entry->row, left.word, right->word)) {
        case comparison::not_compared: return;
        case comparison::equal: ++compared_; return;
        case comparison::not_wanted:
            if (not right->word) {
                ++unmatched_;
                return;
            }
            break;
        case comparison::differs:
        case comparison::unknown: break;
        }
        ++compared_;
        ++different_;
        show(left, *right, results);
    }

    static std::string text_in(saved_parameter const& of, saved_settings const& in)
    {
        if (not of.word) {
            return of.error;
        }
        return full_text_in(*of.entry, *of.word, *in.drive, in.word_of(of.entry->steps_set_by));
    }

    static cell raw_of(saved_parameter const& of) { return of.word ? cell{std::int64_t{*of.word}} : cell{}; }

    void show(saved_parameter const& left, saved_parameter const& right, output& results) const
    {
        bool const is_table = form_ == output_form::table;
        record row{{"group", std::string{left.entry->group}},
                   {"register", is_table ? code_and_menu(*left.entry) : std::string{left.entry->code}}};
        if (not is_table) {
            row.add("address", std::int64_t{left.entry->address})
                .add("left raw", raw_of(left))
                .add("right raw", raw_of(right));
        }
        results.put(row.add(is_table ? left_.name : "left", text_in(left, left_.settings))
                        .add(is_table ? right_.name : "right", text_in(right, right_.settings))
                        .add("name", std::string{left.entry->name}));
    }

    std::string left_out_text() const
    {
        return unmatched_ == 0 ? std::string{} : "; " + std::to_string(unmatched_) + " are not in both";
    }

    output_form form_;
    compared_side const& left_;
    compared_side const& right_;
    std::size_t compared_{0};
    std::size_t different_{0};
    std::size_t unmatched_{0};
};

/// The factory's side of a type of drive.
compared_side factory_side(drive_catalog const& drive) { return {"factory", factory_settings_of(drive)}; }

} // namespace

exit_status run_compare(choices const& chosen)
{
    std::vector<std::string> const& words = chosen.words;
    if (words.size() > 2 or (words.size() == 2 and chosen.is_factory)) {
        refuse_word("two sides are compared: FILE, UNIT or UNIT@PORT, and one of them or --factory");
    }
    if (words.empty() and not chosen.is_factory) {
        refuse_word("with what is it compared? say a FILE, UNIT or UNIT@PORT, or --factory");
    }
    if (unit_in(chosen.line).names != nullptr) {
        return compare_device(chosen);
    }
    // Files first: what is wrong in one is told before a line is opened.
    std::vector<std::optional<compared_side>> sides(words.size());
    for (bool const is_file : {true, false}) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            bool const is_drive = words[i].find('@') != words[i].npos or is_unit_word(words[i], chosen.line);
            if (is_file != is_drive) {
                sides[i] = side_of(chosen, words[i]);
            }
        }
    }
    compared_side const left =
        not words.empty() ? *sides[0] : drive_side(chosen.line, chosen.line.unit, "unit " + chosen.line.unit);
    compared_side const right = chosen.is_factory ? factory_side(*left.settings.drive)
                                : words.size() == 2
                                    ? *sides[1]
                                    : drive_side(chosen.line, chosen.line.unit, "unit " + chosen.line.unit);
    return settings_comparison{chosen.form, left, right}.run();
}

} // namespace tool
