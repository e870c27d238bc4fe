// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "device/register_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include "exit_status.hpp"
#include "files/regular_file.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

constexpr std::size_t longest_file = 1U << 20U;
constexpr std::size_t most_registers = 2'000;

class file_reader {
public:
    explicit file_reader(std::string const& file) : file_{file} { found_.file = file; }

    named_places run(std::string const& text)
    {
        if (text.size() > longest_file) {
            refuse_word(file_ + ": " + std::to_string(text.size()) + " bytes; a register file has at most " +
                        std::to_string(longest_file));
        }
        if (text.find('\0') != text.npos) {
            refuse_word(file_ + ": a byte is zero: it is no text");
        }
        toml::parse_result const parsed = toml::parse(std::string_view{text}, std::string_view{file_});
        if (not parsed) {
            refuse(parsed.error().source(), std::string{parsed.error().description()});
        }
        toml::table const& all = parsed.table();
        check_keys(all, {"register"});
        toml::node const* const list = all.get("register");
        if (list == nullptr or list->as_array() == nullptr or not list->as_array()->is_homogeneous<toml::table>() or
            list->as_array()->empty()) {
            refuse(list == nullptr ? all.source() : list->source(),
                   "it has no registers: each is a table that begins with [[register]]");
        }
        if (list->as_array()->size() > most_registers) {
            refuse(list->source(), std::to_string(list->as_array()->size()) +
                                       " registers; a register file has at most " + std::to_string(most_registers));
        }
        for (toml::node const& each : *list->as_array()) {
            add(*each.as_table());
        }
        return std::move(found_);
    }

private:
    [[noreturn]] void refuse(toml::source_region const& where, std::string const& why) const
    {
        refuse_word(file_ + ":" + std::to_string(where.begin.line) + ":" + std::to_string(where.begin.column) + ": " +
                    why);
    }

    void check_keys(toml::table const& from, std::vector<std::string_view> const& known) const
    {
        for (auto const& [key, value] : from) {
            if (std::ranges::count(known, key.str()) == 0) {
                refuse(key.source(), "'" + std::string{key.str()} + "' is no key here" + suggestion(key.str(), known));
            }
        }
    }

    /// A text of one table; nothing where it has none.
    std::optional<std::string> text_in(toml::table const& from, std::string_view key) const
    {
        toml::node const* const value = from.get(key);
        if (value == nullptr) {
            return std::nullopt;
        }
        if (not value->is_string()) {
            refuse(value->source(), std::string{key} + " is a text: write it in quotation marks");
        }
        return value->as_string()->get();
    }

    /// A number of one table, as it may be typed; nothing where it has none.
    std::optional<double> number_in(toml::table const& from, std::string_view key) const
    {
        toml::node const* const value = from.get(key);
        if (value == nullptr) {
            return std::nullopt;
        }
        auto const number = value->is_number() ? value->value<double>() : std::nullopt;
        if (not number or not std::isfinite(*number)) {
            refuse(value->source(), std::string{key} + " is a number");
        }
        return number;
    }

    static std::string decimal(double number)
    {
        std::array<char, 400> text{};
        auto const end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed).ptr;
        return {text.data(), end};
    }

    /// The place as a person would type it: what is wrong with it is said in the same words.
    std::string place_text(toml::table const& from) const
    {
        toml::node const* const address = from.get("address");
        if (address == nullptr or not address->is_integer()) {
            refuse((address != nullptr ? *address : static_cast<toml::node const&>(from)).source(),
                   "address is missing, or no whole number");
        }
        std::string text =
            text_in(from, "space").value_or("holding") + ':' + std::to_string(address->as_integer()->get());
        for (auto const& [key, mark] : {std::pair{"bits", '.'}, {"type", ':'}, {"order", ':'}}) {
            if (auto const part = text_in(from, key)) {
                if (part->find_first_of(":.") != part->npos) {
                    refuse(from.get(key)->source(), std::string{key} + ": '" + *part + "' is none");
                }
                text += mark + *part;
            }
        }
        auto const scale = number_in(from, "scale");
        auto const unit = text_in(from, "unit");
        auto const offset = number_in(from, "offset");
        bool const may_be_unit =
            not unit or (unit->find_first_of(":+-") == unit->npos and unit->find_first_of(".0123456789") != 0);
        if (not may_be_unit) {
            refuse(from.get("unit")->source(),
                   "'" + *unit + "' is no unit, which has at most 16 letters, digits and % / ^ _ .");
        }
        if (not scale and not unit and not offset) {
            return text;
        }
        std::string const added = offset ? (std::signbit(*offset) ? "" : "+") + decimal(*offset) : std::string{};
        // A bare digit behind a unit may mean a power.
        bool const has_point = added.find('.') != added.npos;
        return text + ':' + decimal(scale.value_or(1)) + unit.value_or("") + added +
               (added.empty() or has_point ? "" : ".0");
    }

    void add(toml::table const& from)
    {
        check_keys(from, {"name", "space", "address", "bits", "type", "order", "scale", "unit", "offset", "access",
                          "min", "max"});
        auto const name = text_in(from, "name");
        if (not name) {
            refuse(from.source(), "a register without a name");
        }
        toml::source_region const at = from.get("name")->source();
        if (std::string const why = why_no_name(*name); not why.empty()) {
            refuse(at, "'" + *name + "': " + why);
        }
        if (named_place const* const before = found_.by_name(*name)) {
            refuse(at, "the name '" + *name + "' stands in line " + std::to_string(before->line) + ", too");
        }
        std::string const text = place_text(from);
        places_typed typed = read_places(text);
        if (typed.refused or typed.places.size() != 1) {
            refuse(from.source(),
                   *name + " is " + (typed.refused ? typed.refused->sentence : text + ", which are several"));
        }
        value_form const& form = typed.places[0].form;
        bool const is_as_said = (from.get("type") == nullptr or form.type != value_type::none) and
                                (from.get("order") == nullptr or not form.order.empty());
        if (not is_as_said) { // each of them is told by its form, and one was meant for another
            refuse(from.source(), *name + ": its type is no type, or its order no order");
        }
        named_place one{.where = typed.places[0], .line = at.begin.line};
        one.where.name = *name;
        read_access(from, one);
        read_limits(from, one);
        check_overlap(from, one);
        found_.places.push_back(std::move(one));
    }

    void read_access(toml::table const& from, named_place& one) const
    {
        auto const access = text_in(from, "access");
        if (not access or *access == "read") {
            return;
        }
        toml::source_region const at = from.get("access")->source();
        if (*access != "write") {
            refuse(at, "access is \"read\" or \"write\"");
        }
        if (one.where.space == register_space::input or one.where.space == register_space::discrete) {
            refuse(at, "input registers and discrete inputs are read only");
        }
        if (one.where.bit >= 0) {
            refuse(at, "a register is written as a whole, not its bits");
        }
        one.is_writable = true;
    }

    void read_limits(toml::table const& from, named_place& one) const
    {
        one.lowest = number_in(from, "min");
        one.highest = number_in(from, "max");
        if (not one.lowest and not one.highest) {
            return;
        }
        toml::source_region const at = from.get(one.lowest ? "min" : "max")->source();
        bool const is_number = not one.where.is_single_bit() and one.where.form.type != value_type::text;
        if (not one.is_writable or not is_number) {
            refuse(at, "min and max limit what is written, and this is " +
                           std::string{one.is_writable ? "no number" : "not written: it has no access = \"write\""});
        }
        if (one.lowest and one.highest and *one.lowest > *one.highest) {
            refuse(at, "min is above max");
        }
    }

    /// Two names for one register contradict each other, or one of them is wrong.
    void check_overlap(toml::table const& from, named_place const& one)
    {
        bool const is_bit = one.where.is_single_bit() or one.where.bit >= 0;
        unsigned const count = is_bit ? 1U : one.where.form.registers();
        for (unsigned each = one.where.address; each < one.where.address + count; ++each) {
            std::vector<std::size_t>& here = taken_[{one.where.space, each}];
            for (std::size_t const other : here) {
                named_place const& before = found_.places[other];
                if (overlap(before.where, one.where)) {
                    refuse(from.source(), one.where.name + " has register " + std::to_string(each) + ", which is of " +
                                              before.where.name + " in line " + std::to_string(before.line));
                }
            }
            here.push_back(found_.places.size());
        }
    }

    std::string const& file_;
    named_places found_{};
    std::map<std::pair<register_space, unsigned>, std::vector<std::size_t>> taken_{};
};

} // namespace

named_places read_register_file(std::string const& file, std::string const& text)
{
    return file_reader{file}.run(text);
}

named_places const& register_file_at(std::string const& file)
{
    static std::map<std::string, named_places> known;
    auto const before = known.find(file);
    if (before != known.end()) {
        return before->second;
    }
    file_text const found = text_of_file(file);
    if (not found.failure.empty()) {
        refuse_word(file + ": " + found.failure);
    }
    return known.emplace(file, read_register_file(file, found.text)).first->second;
}

} // namespace tool
