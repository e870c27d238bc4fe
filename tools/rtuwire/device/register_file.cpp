// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "device/register_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <rtuwire/frames.hpp>

#include "device/device_folders.hpp"
#include "exit_status.hpp"
#include "files/regular_file.hpp"
#include "files/toml_values.hpp"
#include "words/named_value.hpp"
#include "words/suggestion.hpp"
#include "words/time_words.hpp"

namespace tool {

namespace {

constexpr std::size_t longest_identity = 63;

class file_reader : toml_values {
public:
    explicit file_reader(std::string const& file) : toml_values{file} { found_.file = file; }

    named_places run(std::string const& text)
    {
        toml::table const all = plain_toml_in(file(), text);
        check_keys(file(), all, {"device", "groups", "register"});
        read_device(all);
        read_groups(all);
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
    /// What a unit says of itself; empty where nobody said.
    std::string identity_in(toml::table const& from, std::string_view key) const
    {
        auto const text = text_in(from, key);
        if (text and (text->empty() or text->size() > longest_identity)) {
            refuse(from.get(key)->source(),
                   std::string{key} + " is a text of 1 to " + std::to_string(longest_identity) + " characters");
        }
        return text.value_or("");
    }

    void read_device(toml::table const& all)
    {
        if (toml::table const* const device = table_in(all, "device")) {
            check_keys(file(), *device, {"vendor", "product", "max_registers", "pause"});
            found_.vendor = identity_in(*device, "vendor");
            found_.product = identity_in(*device, "product");
            if (found_.vendor.empty() != found_.product.empty()) {
                refuse(device->source(), "vendor and product go together: what the unit says of itself by function 43");
            }
            auto const most = whole_in(*device, "max_registers", 1, rtuwire::max_read_quantity);
            found_.max_registers = most ? std::optional{static_cast<std::uint16_t>(*most)} : std::nullopt;
            found_.pause = whole_in(*device, "pause", 0, 3'000);
        }
    }

    void read_groups(toml::table const& all)
    {
        toml::table const* const groups = table_in(all, "groups");
        if (groups == nullptr) {
            return;
        }
        for (auto const& [key, value] : *groups) {
            std::string const name{key.str()};
            if (std::string const why = why_no_word(name); not why.empty()) {
                refuse(key.source(), "'" + name + "': " + why);
            }
            if (found_.group_named(name) != nullptr) {
                refuse(key.source(), "the group '" + name + "' stands in two lines");
            }
            auto const period = value.is_string() ? time_limit_typed(value.as_string()->get()) : std::nullopt;
            if (not period) {
                refuse(value.source(),
                       "a group has the period in which it is read: " + name + " = \"200ms\", \"1s\" or \"5min\"");
            }
            found_.groups.push_back({name, *period});
        }
    }

    static std::string decimal(double number)
    {
        std::array<char, 400> text{};
        auto const end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed).ptr;
        return {text.data(), end};
    }

    /// The place as a person would type it, part by part: what is wrong with one is said in the same words, at its key.
    place place_in(toml::table const& from, std::string const& name) const
    {
        toml::node const* const address = from.get("address");
        if (address == nullptr or not address->is_integer()) {
            refuse((address != nullptr ? *address : static_cast<toml::node const&>(from)).source(),
                   "address is missing, or no whole number");
        }
        std::string const space = text_in(from, "space").value_or("holding");
        bool const is_list = is_same_word(space, "list");
        check_part(from, "space", name, space + (is_list ? ":40001" : ":0"));
        std::string text = space + ':' + std::to_string(address->as_integer()->get());
        place found = check_part(from, "address", name, text);
        for (auto const& [key, mark] : {std::pair{"bits", '.'}, {"type", ':'}, {"order", ':'}}) {
            auto const part = text_in(from, key);
            if (not part) {
                continue;
            }
            if (part->find_first_of(":.") != part->npos) {
                refuse(from.get(key)->source(), std::string{key} + ": '" + *part + "' is none");
            }
            text += mark + *part;
            found = check_part(from, key, name, text);
            bool const is_of_key = mark == '.' or (std::string_view{key} == "type" ? found.form.type != value_type::none
                                                                                   : not found.form.order.empty());
            if (not is_of_key) { // each of them is told by its form, and one was meant for another
                refuse(from.get(key)->source(), std::string{key} + ": '" + *part + "' is none");
            }
        }
        return scaled_place(from, name, text, std::move(found));
    }

    place scaled_place(toml::table const& from, std::string const& name, std::string const& text, place found) const
    {
        auto const scale = number_in(from, "scale");
        auto const unit = text_in(from, "unit");
        auto const offset = number_in(from, "offset");
        bool const may_be_unit =
            not unit or (unit->find_first_of(":+-") == unit->npos and unit->find_first_of(".0123456789") != 0);
        if (not may_be_unit) {
            refuse(from.get("unit")->source(),
                   "'" + *unit + "' is no unit, which has at most 16 letters, digits and % / ^ _ .");
        }
        std::string how = text + ':' + decimal(scale.value_or(1));
        if (scale) {
            found = check_part(from, "scale", name, how);
        }
        how += unit.value_or("");
        if (unit) {
            found = check_part(from, "unit", name, how);
        }
        if (offset) {
            std::string const added = (std::signbit(*offset) ? "" : "+") + decimal(*offset);
            // A bare digit behind a unit may mean a power.
            bool const has_point = added.find('.') != added.npos;
            found = check_part(from, "offset", name, how + added + (has_point ? "" : ".0"));
        }
        return found;
    }

    place check_part(toml::table const& from, std::string_view key, std::string const& name,
                     std::string const& text) const
    {
        places_typed typed = read_places(text);
        if (typed.refused or typed.places.size() != 1) {
            toml::node const* const value = from.get(key);
            refuse((value != nullptr ? *value : static_cast<toml::node const&>(from)).source(),
                   name + " is " + (typed.refused ? typed.refused->sentence : text + ", which are several"));
        }
        return std::move(typed.places[0]);
    }

    void add(toml::table const& from)
    {
        check_keys(file(), from,
                   {"name", "space", "address", "bits", "type", "order", "scale", "unit", "offset", "access", "min",
                    "max", "choices", "invalid", "setting", "stored", "moves", "group", "simulated"});
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
        named_place one{.where = place_in(from, *name), .line = at.begin.line};
        one.where.name = *name;
        check_size(from, one);
        read_access(from, one);
        read_limits(from, one);
        read_choices(from, one);
        read_invalid(from, one);
        read_marks(from, one);
        read_group(from, one);
        read_simulated(from, one);
        check_overlap(from, one);
        found_.places.push_back(std::move(one));
    }

    /// A value comes by one response.
    void check_size(toml::table const& from, named_place const& one) const
    {
        if (one.where.size() > found_.max_registers.value_or(one.where.size())) {
            refuse(from.get("type")->source(), one.where.name + " has " + std::to_string(one.where.size()) +
                                                   " registers, and max_registers is " +
                                                   std::to_string(*found_.max_registers));
        }
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

    /// What its numbers mean: all that it may be.
    void read_choices(toml::table const& from, named_place& one) const
    {
        toml::table const* const choices = table_in(from, "choices");
        if (choices == nullptr) {
            return;
        }
        toml::source_region const at = from.get("choices")->source();
        value_form const& form = one.where.form;
        bool const has_scale =
            form.factor != short_decimal{1, 0} or form.offset != short_decimal{} or not form.unit.empty();
        bool const is_whole = form.type != value_type::f32 and form.type != value_type::f64 and
                              form.type != value_type::text and form.type != value_type::bits;
        if (has_scale or not is_whole or one.lowest or one.highest) {
            refuse(at, "choices are names of whole numbers without scale, unit, min and max");
        }
        if (choices->empty()) {
            refuse(at, "choices are none: { off = 0, heat = 1 }");
        }
        for (auto const& [key, value] : *choices) {
            named_choice choice{std::string{key.str()}, 0};
            if (std::string const why = why_no_word(choice.name); not why.empty()) {
                refuse(key.source(), "'" + choice.name + "': " + why);
            }
            if (not value.is_integer()) {
                refuse(value.source(), choice.name + " is no whole number");
            }
            choice.number = value.as_integer()->get();
            if (not holds(one.where, choice.number)) {
                refuse(value.source(), "no number of " + one.where.name + " is " + std::to_string(choice.number));
            }
            for (named_choice const& before : one.choices) {
                if (before.number == choice.number or is_same_word(before.name, choice.name)) {
                    refuse(key.source(), before.name + " and " + choice.name + " are one choice twice");
                }
            }
            one.choices.push_back(std::move(choice));
        }
        std::ranges::sort(one.choices, {}, &named_choice::number);
    }

    /// How many bits a place has, of numbers only.
    static unsigned width_of(place const& where)
    {
        return where.is_single_bit() ? 1U
               : where.bit < 0       ? 16U * where.form.registers()
                                     : static_cast<unsigned>(std::max(where.last_bit, where.bit) - where.bit + 1);
    }

    static bool holds(place const& where, std::int64_t number)
    {
        if (where.is_single_bit() or where.bit >= 0) {
            return number >= 0 and number < std::int64_t{1} << width_of(where);
        }
        return words_for(where, std::to_string(number)).wrong.empty();
    }

    /// The bits by which the device says that it has no value.
    void read_invalid(toml::table const& from, named_place& one) const
    {
        toml::node const* const value = from.get("invalid");
        if (value == nullptr) {
            return;
        }
        if (one.where.form.type == value_type::text) {
            refuse(value->source(), "a text has no invalid number");
        }
        toml::array const* const list = value->as_array();
        for (std::size_t i = 0; i < (list == nullptr ? 1 : list->size()); ++i) {
            toml::node const& each = list == nullptr ? *value : *list->get(i);
            unsigned const width = width_of(one.where);
            std::int64_t const number = each.is_integer() ? each.as_integer()->get() : 0;
            bool const fits =
                width == 64 or (number < std::int64_t{1} << width and number >= -(std::int64_t{1} << (width - 1)));
            if (not each.is_integer() or not fits) {
                refuse(each.source(), "invalid is a number of " + std::to_string(width) +
                                          " bits as the registers have it, or a list of such: 0x7FFF");
            }
            std::uint64_t const mask = width == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
            one.invalid.push_back(static_cast<std::uint64_t>(number) & mask);
        }
    }

    /// What a write of it does.
    void read_marks(toml::table const& from, named_place& one) const
    {
        one.moves = flag_in(from, "moves");
        one.is_setting = flag_in(from, "setting");
        one.is_stored = flag_in(from, "stored");
        for (char const* const key : {"setting", "stored"}) {
            if (flag_in(from, key) and not one.is_writable) {
                refuse(from.get(key)->source(),
                       std::string{key} + " is of what is written, and this has no access = \"write\"");
            }
        }
        if (one.is_setting and one.where.bit >= 0) {
            refuse(from.get("setting")->source(),
                   "some bits of a register are no setting: a restore writes whole registers");
        }
        if (one.moves and one.is_setting) {
            refuse(from.get("setting")->source(), "what moves something is no setting: it is never restored");
        }
    }

    void read_group(toml::table const& from, named_place& one) const
    {
        auto const name = text_in(from, "group");
        if (not name) {
            return;
        }
        named_group const* const group = found_.group_named(*name);
        if (group == nullptr) {
            std::vector<std::string_view> known;
            for (named_group const& each : found_.groups) {
                known.push_back(each.name);
            }
            refuse(from.get("group")->source(), "the group '" + *name + "' has no period: say " + *name +
                                                    " = \"1s\" behind [groups]" + suggestion(*name, known));
        }
        one.group = group->name;
    }

    /// With what a simulated device begins: a value in the unit, the name of a choice, a text, true or false.
    void read_simulated(toml::table const& from, named_place& one) const
    {
        toml::node const* const value = from.get("simulated");
        if (value == nullptr) {
            return;
        }
        bool const is_float = one.where.form.type == value_type::f32 or one.where.form.type == value_type::f64;
        std::string const text = value->is_string()    ? value->as_string()->get()
                                 : value->is_boolean() ? std::string{value->as_boolean()->get() ? "1" : "0"}
                                 : value->is_integer() ? std::to_string(value->as_integer()->get())
                                 : value->is_floating_point()
                                     ? (is_float ? text_of_cell(value->as_floating_point()->get())
                                                 : decimal(value->as_floating_point()->get()))
                                     : std::string{};
        words_typed typed = words_to_hold(one, text);
        if (not typed.wrong.empty()) {
            refuse(value->source(), "simulated: " + typed.wrong);
        }
        one.simulated = std::move(typed.words);
    }

    /// Two names for one register contradict each other, or one of them is wrong.
    void check_overlap(toml::table const& from, named_place const& one)
    {
        for (unsigned each = one.where.address; each < one.where.address + unsigned{one.where.size()}; ++each) {
            std::vector<std::size_t>& here = taken_[{one.where.space, each}];
            for (std::size_t const other : here) {
                named_place const& before = found_.places[other];
                if (overlap(before.where, one.where)) {
                    refuse(from.get("address")->source(), one.where.name + " has register " + std::to_string(each) +
                                                              ", which is of " + before.where.name + " in line " +
                                                              std::to_string(before.line));
                }
            }
            here.push_back(found_.places.size());
        }
    }

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
    static std::mutex guard; // lines may be simulated, each in a thread of its own
    std::scoped_lock const held{guard};
    static std::map<std::string, named_places> known;
    auto const before = known.find(file);
    if (before != known.end()) {
        return before->second;
    }
    std::string const path = path_of_device(file);
    file_text const found = text_of_file(path);
    if (not found.failure.empty()) {
        refuse_word(path + ": " + found.failure);
    }
    return known.emplace(file, read_register_file(path, found.text)).first->second;
}

} // namespace tool
