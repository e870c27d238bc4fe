// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "backup/saved_settings.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "catalog/value_text.hpp"
#include "words/register_words.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

constexpr std::string_view format_name = "rtuwire backup 1";

/// A raw count: a whole number in digits, or hexadecimal; below zero where the register is signed.
std::optional<std::uint16_t> raw_count(std::string_view text, std::int32_t least = 0)
{
    if (text.starts_with("0x") or text.starts_with("0X")) {
        return word_number(text);
    }
    std::int32_t number = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    bool const is_whole = error == std::errc{} and end == text.data() + text.size();
    return is_whole and number >= least and number <= 65'535 ? std::optional{static_cast<std::uint16_t>(number)}
                                                             : std::nullopt;
}

class rows_reader {
public:
    rows_reader(saved_text const& text, std::string_view drive) : text_{text}, chosen_{drive} {}

    settings_reading run()
    {
        found_.fault = why_no_whole_backup(text_);
        bool const is_right = not found_.fault and find_drive() and take_rows(false) and take_rows(true);
        if (is_right and found_.settings.parameters.empty()) {
            refuse({}, "it has no parameters");
        }
        std::ranges::sort(found_.settings.parameters, {},
                          [](saved_parameter const& each) { return each.entry->address; });
        return std::move(found_);
    }

private:
    bool refuse(text_place place, std::string sentence)
    {
        found_.fault = file_fault{place, std::move(sentence)};
        return false;
    }

    bool find_drive()
    {
        for (auto const& [name, value] : text_.head) {
            if (name != "rows") {
                found_.settings.head.emplace_back(name, value.text);
            }
        }
        auto const drive = text_.head.find("drive");
        if (drive == text_.head.end() and chosen_.empty()) {
            return refuse({}, "it does not say of which drive it is; say --drive");
        }
        std::string_view const name = drive == text_.head.end() ? chosen_ : std::string_view{drive->second.text};
        text_place const place = drive == text_.head.end() ? text_place{} : drive->second.place;
        found_.settings.drive = catalog_named(name);
        return found_.settings.drive != nullptr or
               refuse(place, "'" + std::string{name} + "' is no drive of this program");
    }

    /// Those whose steps another register sets come second, when that one is known.
    bool take_rows(bool is_stepped)
    {
        for (saved_row const& row : text_.rows) {
            if (auto unknown = unknown_register(row)) {
                if (not is_stepped) {
                    found_.left_out.push_back(*std::move(unknown));
                }
                continue;
            }
            register_entry const* const entry = entry_of(row);
            if (entry == nullptr) {
                return false;
            }
            if (entry->steps_set_by.empty() != is_stepped and not take_row(row, *entry)) {
                return false;
            }
        }
        return true;
    }

    /// Where a row has a name and an address that are both unknown: a wrong name of a known register is refused.
    std::optional<file_fault> unknown_register(saved_row const& row) const
    {
        drive_catalog const& drive = *found_.settings.drive;
        placed_text const* const code = row.find("register");
        placed_text const* const address = row.find("address");
        std::optional<std::uint16_t> const number = address != nullptr ? raw_count(address->text) : std::nullopt;
        if (code == nullptr or not number or drive.at(*number) != nullptr or drive.by_code(code->text) != nullptr or
            drive.by_menu(code->text) != nullptr) {
            return std::nullopt;
        }
        return file_fault{code->place, code->text + ", register " + std::to_string(*number) +
                                           ", is none that is known of an " + std::string{drive.name} +
                                           ": it is left out"};
    }

    register_entry const* entry_of(saved_row const& row)
    {
        drive_catalog const& drive = *found_.settings.drive;
        placed_text const* const code = row.find("register");
        if (code == nullptr) {
            refuse(row.place, "this parameter has no 'register'");
            return nullptr;
        }
        register_entry const* const by_code = drive.by_code(code->text);
        register_entry const* const entry = by_code != nullptr ? by_code : drive.by_menu(code->text);
        if (entry == nullptr) {
            std::vector<std::string_view> codes;
            for (register_entry const& each : drive.registers) {
                codes.push_back(each.code);
            }
            refuse(code->place, "'" + code->text + "' is no register that is known of an " + std::string{drive.name} +
                                    suggestion(code->text, codes));
            return nullptr;
        }
        placed_text const* const address = row.find("address");
        if (address != nullptr and raw_count(address->text) != entry->address) {
            refuse(address->place, std::string{entry->code} + " is register " + std::to_string(entry->address) +
                                       ", not " + address->text);
            return nullptr;
        }
        return entry;
    }

    bool take_row(saved_row const& row, register_entry const& entry)
    {
        if (not seen_.insert(entry.address).second) {
            return refuse(row.find("register")->place, std::string{entry.code} + " stands here a second time");
        }
        saved_parameter made{&entry, {}, {}, row.place};
        placed_text const* const raw = row.find("raw");
        placed_text const* const value = row.find("value");
        if (placed_text const* const error = row.find("error"); error != nullptr) {
            if (raw != nullptr or value != nullptr) {
                return refuse(error->place, std::string{entry.code} + " has both a value and an error");
            }
            made.error = error->text;
        } else if (not read_word(made, row, raw, value)) {
            return false;
        }
        found_.settings.parameters.push_back(std::move(made));
        return true;
    }

    bool read_word(saved_parameter& made, saved_row const& row, placed_text const* raw, placed_text const* value)
    {
        register_entry const& entry = *made.entry;
        if (raw == nullptr and value == nullptr) {
            return refuse(row.place, std::string{entry.code} + " has no value");
        }
        if (raw != nullptr) {
            made.place = raw->place;
            std::int32_t const least = entry.kind == register_kind::signed_number ? -32'768 : 0;
            made.word = raw_count(raw->text, least);
            if (not made.word) {
                return refuse(raw->place, std::string{entry.code} + ": '" + raw->text +
                                              "' is no raw count: a whole number in digits, from " +
                                              std::to_string(least) + " to 65535");
            }
        }
        return value == nullptr or read_value(made, row, *value);
    }

    bool read_value(saved_parameter& made, saved_row const& row, placed_text const& value)
    {
        register_entry const& entry = *made.entry;
        auto const set_by = found_.settings.word_of(entry.steps_set_by);
        if (made.word and not entry.steps_set_by.empty() and not set_by) {
            return true; // a value of which nobody knows what it counts; the raw count is what is meant
        }
        placed_text const* const unit = row.find("unit");
        value_reading const read = read_saved_value(entry, *found_.settings.drive, value.text,
                                                    unit == nullptr ? std::string{} : unit->text, set_by);
        if (not read.word) {
            return refuse(value.place, read.sentence);
        }
        if (made.word and *made.word != *read.word) {
            auto const step = step_of(entry, *found_.settings.drive, set_by);
            return refuse(value.place, std::string{entry.code} + ": the raw count " + std::to_string(*made.word) +
                                           " is " + text_of(entry, *made.word, *step) + ", not '" + value.text +
                                           "'; empty the one of them that is old");
        }
        made.place = made.word ? made.place : value.place;
        made.word = read.word;
        return true;
    }

    saved_text const& text_;
    std::string_view chosen_;
    settings_reading found_{};
    std::set<std::uint16_t> seen_{};
};

} // namespace

std::optional<file_fault> why_no_whole_backup(saved_text const& text)
{
    auto const format = text.head.find("format");
    if (format != text.head.end() and format->second.text != format_name) {
        return file_fault{format->second.place, "'" + format->second.text + "' is no format that this program reads: " +
                                                    std::string{format_name}};
    }
    auto const rows = text.head.find("rows");
    if (rows == text.head.end() or rows->second.text == std::to_string(text.rows.size())) {
        return std::nullopt;
    }
    return file_fault{rows->second.place, "it says that it has " + rows->second.text + " rows, and has " +
                                              std::to_string(text.rows.size()) +
                                              "; where that is meant, take out 'rows'"};
}

saved_parameter const* saved_settings::find(std::string_view code) const noexcept
{
    auto const found = std::ranges::find_if(parameters, [code](auto const& each) { return each.entry->code == code; });
    return found != parameters.end() ? &*found : nullptr;
}

std::optional<std::uint16_t> saved_settings::word_of(std::string_view code) const noexcept
{
    saved_parameter const* const found = code.empty() ? nullptr : find(code);
    return found != nullptr ? found->word : std::nullopt;
}

settings_reading settings_in(saved_text const& text, std::string_view drive)
{
    return text.fault ? settings_reading{.fault = text.fault} : rows_reader{text, drive}.run();
}

} // namespace tool
