// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The file: "19200 8E1 7" for a silent address; behind it a tabulator and name=value, separated by tabulators, for one
// that responded.
#include "line/scan_log.hpp"

#include <charconv>
#include <iterator>
#include <optional>
#include <string_view>

#include <rtuwire/port.hpp>

#include "catalog/catalog.hpp"
#include "exit_status.hpp"
#include "line/line_words.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

constexpr char const* heading = "# rtuwire scan";

std::string key_of(line_setting const& how, std::uint8_t unit)
{
    return std::to_string(how.baud) + ' ' + name_of_format(how.format) + ' ' + std::to_string(unit);
}

/// What a line of the file says of one address.
struct noted_address {
    line_setting how;
    std::uint8_t unit;
    record found{}; ///< empty for a silent one
};

std::optional<unsigned> plain_number(std::string_view word)
{
    unsigned number = 0;
    auto const [end, wrong] = std::from_chars(word.data(), word.data() + word.size(), number);
    bool const is_plain = wrong == std::errc{} and end == word.data() + word.size() and std::to_string(number) == word;
    return is_plain ? std::optional{number} : std::nullopt;
}

std::vector<std::string> pieces_of(std::string const& line, char between)
{
    std::vector<std::string> parts(1);
    for (char const each : line) {
        if (each == between) {
            parts.emplace_back();
        } else {
            parts.back() += each;
        }
    }
    return parts;
}

/// "19200 8E1 7"; nothing where it is anything else.
std::optional<noted_address> asked_address(std::string const& key)
{
    auto const parts = pieces_of(key, ' ');
    auto const baud = parts.size() == 3 ? plain_number(parts[0]) : std::nullopt;
    auto const unit = parts.size() == 3 ? plain_number(parts[2]) : std::nullopt;
    if (not baud or not rtuwire::is_bit_rate(*baud) or not unit or not rtuwire::unit_id::checked(*unit)) {
        return std::nullopt;
    }
    for (named_format const& each : all_formats) {
        if (each.name == parts[1]) {
            return noted_address{{*baud, each.format}, static_cast<std::uint8_t>(*unit)};
        }
    }
    return std::nullopt;
}

/// The whole line; nothing where it is not just as `note_found` and `note_silent` write it.
std::optional<noted_address> noted_in(std::string const& line)
{
    auto parts = pieces_of(line, '\t');
    auto found = asked_address(parts.front());
    parts.erase(parts.begin());
    if (not found or parts.empty()) {
        return found;
    }
    constexpr std::string_view names[]{"unit", "baud", "format", "vendor", "product", "revision", "drive", "note"};
    if (parts.size() != std::size(names)) {
        return std::nullopt;
    }
    std::string const told[]{std::to_string(found->unit), std::to_string(found->how.baud),
                             name_of_format(found->how.format)};
    for (std::size_t i = 0; i < std::size(names); ++i) {
        std::string const name{names[i]};
        if (not parts[i].starts_with(name + '=')) {
            return std::nullopt;
        }
        std::string const value = parts[i].substr(name.size() + 1);
        bool const is_wrong = (i < std::size(told) and value != told[i]) or
                              (name == "drive" and not value.empty() and catalog_named(value) == nullptr);
        if (is_wrong) {
            return std::nullopt;
        }
        found->found.add(name, name == "unit"   ? cell{std::int64_t{found->unit}}
                               : name == "baud" ? cell{std::int64_t{found->how.baud}}
                                                : cell{value});
    }
    return found;
}

} // namespace

scan_log::scan_log(std::string const& file) : file_{file}
{
    if (file.empty()) {
        return;
    }
    std::string const kept = text_to_resume(file);
    read(kept);
    out_ = appended_file{file};
    if (kept.empty()) {
        write(heading);
    } else if (not out_.failure().empty()) {
        throw ended{exit_status::port, file + ": " + out_.failure()};
    }
}

/// Believes the file as a whole or not at all: a line that was cut short would make a unit that is there an absent one.
void scan_log::read(std::string const& text)
{
    std::vector<std::string> lines = pieces_of(text, '\n');
    std::string const rest = lines.back();
    lines.pop_back();
    if (lines.empty() ? not rest.empty() : lines.front() != heading) {
        refuse_word("--resume " + file_ + ": this is no file of a scan; it is left as it is");
    }
    auto const refuse = [&](std::size_t index, std::string const& line, std::string const& why) {
        refuse_word("--resume " + file_ + ":" + std::to_string(index + 1) + ": '" + line + "' " + why +
                    "; the file is left as it is: mend or remove the line");
    };
    for (std::size_t i = 1; i < lines.size(); ++i) {
        auto const read = noted_in(lines[i]);
        if (not read) {
            refuse(i, lines[i], "is no line of a scan, or contradicts itself");
        }
        if (not done_.insert(key_of(read->how, read->unit)).second) {
            refuse(i, lines[i], "is of an address that an earlier line is of");
        }
        if (not read->found.fields().empty()) {
            found_.push_back(read->found);
        }
    }
    if (not rest.empty()) {
        refuse(lines.size(), rest, "is not whole: its end is missing");
    }
}

bool scan_log::is_done(line_setting const& how, std::uint8_t unit) const { return done_.contains(key_of(how, unit)); }

void scan_log::note_silent(line_setting const& how, std::uint8_t unit)
{
    done_.insert(key_of(how, unit));
    write(key_of(how, unit));
}

void scan_log::note_found(line_setting const& how, std::uint8_t unit, record const& line)
{
    std::string text = key_of(how, unit);
    for (field const& each : line.fields()) {
        text += '\t' + each.name + '=' + plain_text(text_of_cell(each.value));
    }
    done_.insert(key_of(how, unit));
    write(text);
}

void scan_log::write(std::string const& line)
{
    if (file_.empty()) {
        return;
    }
    out_.write(line + '\n');
    if (not out_.failure().empty()) {
        throw ended{exit_status::port, file_ + ": " + out_.failure()};
    }
}

} // namespace tool
