// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "device/register_file_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <tuple>

#include "device/register_file.hpp"
#include "exit_status.hpp"
#include "output/plain_text.hpp"
#include "words/words.hpp"

namespace tool {

namespace {

constexpr std::size_t longest_written_name = 40;
constexpr std::size_t most_text = 1'000'000;

bool is_ascii_letter(char c) noexcept { return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z'); }

/// What a shell, a topic, a template or a spreadsheet takes for an order, and what a terminal acts upon.
bool is_hostile(std::string_view text)
{
    bool const has_order = text.find_first_of("/+#") != text.npos or text.find("{{") != text.npos or
                           (not text.empty() and std::string_view{"=+-@"}.find(text[0]) != text.npos);
    return has_order or plain_text(text) != text;
}

/// Letters, digits and _, a letter first; empty where nothing of a text may stand there.
std::string word_of(std::string_view text, std::string_view first)
{
    std::string word;
    for (char const c : text) {
        bool const stays = is_ascii_letter(c) or is_digit(c);
        if (stays) {
            word += c;
        } else if (not word.empty() and word.back() != '_') {
            word += '_';
        }
    }
    while (word.ends_with('_')) {
        word.pop_back();
    }
    word = word.empty() or is_ascii_letter(word[0]) ? word : std::string{first} + word;
    word.resize(std::min(word.size(), longest_written_name));
    return word;
}

std::string toml_number(double number)
{
    std::array<char, 400> text{};
    auto const end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed).ptr;
    return {text.data(), end};
}

std::string toml_text(std::string_view text)
{
    std::string quoted{'"'};
    for (char const c : text) {
        quoted += c == '"' or c == '\\' ? "\\" : "";
        quoted += c;
    }
    return quoted + '"';
}

/// As TOML has it, whose whole numbers have a sign.
std::string number_of_bits(std::uint64_t bits)
{
    std::array<char, 24> text{};
    auto const number = static_cast<std::int64_t>(bits);
    auto const end = number < 0 ? std::to_chars(text.data(), text.data() + text.size(), number).ptr
                                : std::to_chars(text.data(), text.data() + text.size(), number, 16).ptr;
    return (number < 0 ? "" : "0x") + upper({text.data(), static_cast<std::size_t>(end - text.data())});
}

/// The table of one register.
std::string table_of(written_register const& one, std::string const& name)
{
    std::string text = "[[register]]\nname = " + toml_text(name) + '\n';
    auto const add = [&text](std::string_view key, std::string const& value) {
        text += std::string{key} + " = " + value + '\n';
    };
    auto const add_text = [&add](std::string_view key, std::string const& value) {
        if (not value.empty()) {
            add(key, toml_text(value));
        }
    };
    add_text("space", one.space == "holding" ? "" : one.space);
    add("address", std::to_string(one.address));
    add_text("bits", one.bits);
    add_text("type", one.type);
    add_text("order", one.order);
    if (one.scale != 1) {
        add("scale", toml_number(one.scale));
    }
    add_text("unit", one.unit);
    if (one.offset != 0) {
        add("offset", toml_number(one.offset));
    }
    add_text("access", one.is_writable ? "write" : "");
    for (auto const& [key, limit] : {std::pair{"min", one.lowest}, {"max", one.highest}}) {
        if (limit) {
            add(key, toml_number(*limit));
        }
    }
    std::string choices;
    for (auto const& [word, number] : one.choices) {
        choices += (choices.empty() ? "{ " : ", ") + word + " = " + std::to_string(number);
    }
    if (not choices.empty()) {
        add("choices", choices + " }");
    }
    std::string invalid;
    for (std::uint64_t const number : one.invalid) {
        invalid += (invalid.empty() ? "" : ", ") + number_of_bits(number);
    }
    if (not invalid.empty()) {
        add("invalid", one.invalid.size() == 1 ? invalid : '[' + invalid + ']');
    }
    for (auto const& [key, is_so] :
         {std::pair{"setting", one.is_setting}, {"stored", one.is_stored}, {"moves", one.moves}}) {
        if (is_so) {
            add(key, "true");
        }
    }
    return text;
}

/// The one register of a table, as the tool itself takes it; or why it does not.
struct checked_table {
    named_places read{};
    std::string wrong{};
};
checked_table check_table(std::string const& text)
{
    try {
        return {.read = read_register_file({}, text)};
    } catch (ended const& why) {
        std::string_view said = why.what(); // ":3:8: address ..."
        std::size_t const colon = said.find(": ");
        said.remove_prefix(said.starts_with(':') and colon != said.npos ? colon + 2 : 0);
        return {.wrong = std::string{said}};
    }
}

} // namespace

void register_file_writer::lose(text_place place, std::string const& what)
{
    ++lost_;
    note(place, what);
}

void register_file_writer::note(text_place place, std::string const& what)
{
    told_.push_back(told_place(file_, place) + what);
}

void register_file_writer::add_comment(std::string_view text)
{
    comments_ += text.empty() or is_hostile(text) ? std::string{} : "# " + std::string{text} + '\n';
}

void register_file_writer::limit_requests(text_place place, std::int64_t registers)
{
    if (registers < 1 or registers > 125) {
        lose(place, "at most " + std::to_string(registers) + " registers a request, which are 1 to 125");
        return;
    }
    max_registers_ = registers;
}

void register_file_writer::pause(text_place place, double milliseconds)
{
    double const whole = std::ceil(milliseconds);
    if (not(whole >= 0 and whole <= 3'000)) {
        lose(place, "a pause of " + toml_number(milliseconds) + " ms, which is 0 to 3000");
        return;
    }
    pause_ = static_cast<std::int64_t>(whole);
}

/// In the shape of a name, and not another's.
std::string register_file_writer::own_name(std::string name, text_place place)
{
    std::string const wished = name;
    if (not why_no_name(name).empty()) {
        name = name.substr(0, longest_written_name - 6) + "_value";
    }
    for (unsigned& last = last_of_name_[lower(wished)]; known_.by_name(name) != nullptr;) {
        last = std::max(last + 1, 2U);
        std::string const mark = '_' + std::to_string(last);
        name = wished.substr(0, longest_written_name - mark.size()) + mark;
    }
    if (name != wished) {
        note(place, wished + " is called " + name + " here");
    }
    return name;
}

std::string register_file_writer::name_of(written_register& one)
{
    std::string name = word_of(one.name, "r_");
    if (name.empty()) {
        name = one.space + '_' + std::to_string(one.address);
    }
    if (not one.not_the_value.empty()) {
        name = name.substr(0, longest_written_name - 4) + "_raw";
    }
    if (is_hostile(one.name)) {
        note(one.place, '\'' + plain_text(one.name) + "' is called " + name + " here");
    }
    return own_name(std::move(name), one.place);
}

/// Of numbers only, and nothing that somebody takes for an order; what else is no unit, its check says.
void register_file_writer::mend_unit(written_register& one)
{
    std::erase(one.unit, ' ');
    bool const is_number = one.bits.empty() and not one.type.starts_with("text") and one.type != "bits" and
                           one.type != "hex" and one.space != "coil" and one.space != "discrete";
    bool const is_of_powers = std::ranges::none_of(one.unit, [](char c) { return c == '+' or c == '#'; }) and
                              plain_text(one.unit) == one.unit;
    if (not one.unit.empty() and not(is_number and is_of_powers)) {
        lose(one.place, one.name + ": its unit '" + one.unit + "' is " +
                            (is_number ? "none of a register file" : "said of what is no number"));
        one.unit.clear();
    }
}

/// Names of numbers are words, and none stands twice.
void register_file_writer::mend_choices(written_register& one)
{
    auto const choices = std::exchange(one.choices, {});
    for (std::pair<std::string, std::int64_t> const& each : choices) {
        std::string const& said = each.first;
        std::int64_t const number = each.second;
        auto const amount = static_cast<double>(number);
        if (amount < one.lowest.value_or(amount) or amount > one.highest.value_or(amount)) {
            lose(one.place, one.name + ": '" + said + "' is beyond its limits");
            continue;
        }
        std::string digits = std::to_string(number);
        std::erase(digits, '-');
        std::string word = word_of(said, "n_");
        word = word.empty() ? "n_" + digits : word;
        auto const has = [&one](std::string const& text) {
            return std::ranges::any_of(one.choices,
                                       [&text](auto const& other) { return is_same_word(other.first, text); });
        };
        if (has(word)) {
            std::string const mark = '_' + digits;
            word = word.substr(0, longest_written_name - mark.size()) + mark;
        }
        bool const is_twice = has(word) or std::ranges::any_of(one.choices, [number](auto const& other) {
                                  return other.second == number;
                              });
        if (is_twice) {
            lose(one.place, one.name + ": '" + said + "' is a second name of " + std::to_string(number));
            continue;
        }
        one.choices.emplace_back(word, number);
    }
}

/// A unit is the device of one line: the same number on another line is another device.
bool register_file_writer::is_of_unit(written_register const& one)
{
    if (one.unit_id and *one.unit_id != wanted_.value_or(*one.unit_id)) {
        lose(one.place, one.name + " is of unit " + std::to_string(*one.unit_id) + ", and this file is of unit " +
                            std::to_string(*wanted_) + ": import it with -u " + std::to_string(*one.unit_id));
        return false;
    }
    if (not one.line.empty() and not line_.empty() and one.line != line_) {
        lose(one.place, one.name + " is left out: it is of another device, behind " + plain_text(one.line) +
                            ", and this file is of that behind " + plain_text(line_));
        return false;
    }
    wanted_ = one.unit_id ? one.unit_id : wanted_;
    line_ = one.line.empty() ? line_ : one.line;
    return true;
}

/// A scale that no register file has leaves the count.
void register_file_writer::check_scale(written_register& one) const
{
    written_register bare;
    bare.scale = one.scale;
    bare.offset = one.offset;
    if (std::string const why = check_table(table_of(bare, "a1")).wrong; not why.empty()) {
        one.not_the_value = "it is to be multiplied by " + toml_number(one.scale) +
                            (one.offset == 0 ? "" : ", and " + toml_number(one.offset) + " is to be added") +
                            ", which no register file does";
    }
}

/// Leaves out what is said besides of a value, one by one, until it is right. Why it is not.
std::string register_file_writer::drop_what_is_wrong(written_register& one, std::string const& name)
{
    auto const limits = std::pair{one.lowest, one.highest};
    if (not one.choices.empty()) { // which are all that may be written
        one.lowest = one.highest = std::nullopt;
    }
    std::string wrong = check_table(device_part() + table_of(one, name)).wrong;
    std::string const first = wrong;
    std::vector<std::string> dropped;
    auto const drop = [&](auto written_register::*part, std::string_view what) {
        if (wrong.empty() or one.*part == std::remove_reference_t<decltype(one.*part)>{}) {
            return;
        }
        dropped.push_back(one.name + ": its " + std::string{what} + " left out: " + wrong);
        one.*part = {};
        wrong = check_table(device_part() + table_of(one, name)).wrong;
    };
    drop(&written_register::choices, "choices are");
    if (one.choices.empty()) {
        std::tie(one.lowest, one.highest) = limits;
        wrong = check_table(device_part() + table_of(one, name)).wrong;
    }
    drop(&written_register::unit, "unit is");
    drop(&written_register::invalid, "invalid numbers are");
    drop(&written_register::lowest, "lower limit is");
    drop(&written_register::highest, "upper limit is");
    if (not wrong.empty()) {
        return first;
    }
    for (std::string const& each : dropped) {
        lose(one.place, each);
    }
    return {};
}

void register_file_writer::add(written_register one)
{
    if (not is_of_unit(one)) {
        return;
    }
    check_scale(one);
    if (not one.not_the_value.empty()) {
        one.unit.clear();
        one.scale = 1;
        one.offset = 0;
        one.is_writable = one.is_setting = one.is_stored = false;
        one.choices.clear();
    }
    if (not one.is_writable) {
        one.lowest = one.highest = std::nullopt;
        one.is_setting = one.is_stored = false;
    }
    mend_unit(one);
    mend_choices(one);
    std::string const name = name_of(one);
    if (std::string const wrong = drop_what_is_wrong(one, name); not wrong.empty()) {
        lose(one.place, one.name + " is left out: " + wrong);
        return;
    }
    std::string const table = table_of(one, name);
    named_place const read = check_table(device_part() + table).read.places.at(0);
    if (known_.places.size() >= most_registers or tables_.size() > most_text) {
        lose(one.place, one.name + " is left out: a register file has at most " + std::to_string(most_registers) +
                            " registers, and 1 MiB");
        return;
    }
    if (named_place const* const other = known_.overlapping(read.where)) {
        lose(one.place, one.name + " is left out: its registers are those of " + other->where.name);
        return;
    }
    if (not one.not_the_value.empty()) {
        lose(one.place,
             one.name + " is carried over as " + name + ", its registers as they come: " + one.not_the_value);
    }
    std::string const comment = one.comment.empty() and one.name != name ? one.name : one.comment;
    tables_ += '\n' + (comment.empty() or is_hostile(comment) ? std::string{} : "# " + comment + '\n') + table;
    known_.places.push_back(read);
}

std::string register_file_writer::device_part() const
{
    std::string text = max_registers_ ? "max_registers = " + std::to_string(*max_registers_) + '\n' : std::string{};
    text += pause_ ? "pause = " + std::to_string(*pause_) + '\n' : std::string{};
    return text.empty() ? text : "[device]\n" + text;
}

std::string register_file_writer::text() const
{
    return comments_ + (wanted_ ? "# Unit " + std::to_string(*wanted_) + ".\n" : "") + device_part() + tables_;
}

} // namespace tool
