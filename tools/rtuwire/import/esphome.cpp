// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "import/forms.hpp"
#include "words/words.hpp"

namespace tool {

namespace {

struct esphome_type {
    std::string_view name;
    std::string_view type;
    std::string_view order;
};
constexpr esphome_type esphome_types[]{
    {"U_WORD", "", ""},           {"S_WORD", "i16", ""},        {"U_DWORD", "u32", ""}, {"S_DWORD", "i32", ""},
    {"U_DWORD_R", "u32", "cdab"}, {"S_DWORD_R", "i32", "cdab"}, {"U_QWORD", "u64", ""}, {"S_QWORD", "i64", ""},
    {"U_QWORD_R", "u64", "cdab"}, {"S_QWORD_R", "i64", "cdab"}, {"FP32", "f32", ""},    {"FP32_R", "f32", "cdab"}};

constexpr std::string_view entity_fields[]{
    "platform", "modbus_controller_id", "address", "register_type", "value_type", "bitmask", "unit_of_measurement",
    "filters", "lambda", "register_count", "response_size", "min_value", "max_value", "multiply", "optionsmap",
    // how something is shown, asked for and written
    "id", "name", "accuracy_decimals", "device_class", "state_class", "icon", "entity_category", "skip_updates",
    "force_new_range", "internal", "disabled_by_default", "step", "mode", "use_write_multiple", "optimistic",
    "restore_mode",
    // what makes another value of what is read and written
    "write_lambda", "custom_command", "inverted", "offset", "min_power", "max_power"};
constexpr std::string_view controller_fields[]{"id",
                                               "address",
                                               "modbus_id",
                                               "update_interval",
                                               "command_throttle",
                                               "setup_priority",
                                               "offline_skip_updates",
                                               "max_cmd_retries"};
/// Filters that change no value.
constexpr std::string_view harmless_filters[]{
    "throttle", "throttle_average", "delta",       "debounce",       "heartbeat", "skip_initial", "round", "timeout",
    "or",       "delayed_on",       "delayed_off", "delayed_on_off", "settle"};

/// An entry, or each of a list of them.
template <typename Read> void each_entry(source_value const& from, Read read)
{
    if (from.kind == source_kind::table) {
        read(from);
        return;
    }
    for (auto const& [key, each] : from.fields) {
        if (each.kind == source_kind::table) {
            read(each);
        }
    }
}

bool is_of_controller(source_value const& entry) { return entry.text_of("platform") == "modbus_controller"; }

class esphome_reader {
public:
    explicit esphome_reader(register_file_writer& into) : into_{into} {}

    void read_controller(source_value const& from)
    {
        static_cast<void>(has_names_twice(into_, from));
        lose_other_fields(into_, from, "the controller", controller_fields);
        controllers_[from.text_of("id")] = {whole_field(into_, from, "address"), from.text_of("modbus_id")};
        if (source_value const* const throttle = from.find("command_throttle")) {
            source_value number = *throttle;
            bool const is_ms = number.text.ends_with("ms");
            number.text.resize(number.text.size() - (is_ms ? 2U : number.text.ends_with('s') ? 1U : 0U));
            auto const amount = number.number();
            if (amount) {
                into_.pause(throttle->place, *amount * (is_ms ? 1 : 1000));
            } else {
                into_.lose(throttle->place, "command_throttle " + throttle->text + " is no time");
            }
        }
    }

    void read(std::string_view kind, source_value const& from)
    {
        written_register one;
        one.place = from.place;
        one.name = from.text_of("name").empty() ? from.text_of("id") : from.text_of("name");
        if (has_names_twice(into_, from)) {
            into_.lose(from.place, one.name + " is left out");
            return;
        }
        lose_other_fields(into_, from, one.name, entity_fields);
        auto const address = whole_field(into_, from, "address");
        if (not address) {
            into_.lose(from.place, one.name + " is left out: it has no address");
            return;
        }
        one.address = *address;
        if (not read_unit(from, one)) {
            into_.lose(from.place, one.name + " is left out: nobody says of which unit it is");
            return;
        }
        one.is_writable =
            kind == "number" or kind == "select" or kind == "switch" or kind == "output" or kind == "light";
        if (not read_space(kind, from, one) or not read_type(kind, from, one)) {
            return;
        }
        one.unit = from.text_of("unit_of_measurement");
        read_scale(from, one);
        read_limits(kind, from, one);
        into_.add(std::move(one));
    }

private:
    struct controller {
        std::optional<std::int64_t> unit{};
        std::string line{};
    };

    /// Of one controller, its unit may be unknown; of several, an entity says whose it is.
    bool read_unit(source_value const& from, written_register& one) const
    {
        std::string const id = from.text_of("modbus_controller_id");
        auto const found = id.empty() and controllers_.size() == 1 ? controllers_.begin() : controllers_.find(id);
        if (found != controllers_.end()) {
            one.unit_id = found->second.unit;
            one.line = found->second.line;
            return one.unit_id or controllers_.size() == 1;
        }
        one.line = id; // of a part of a configuration, whose controllers stand elsewhere
        return controllers_.empty();
    }

    bool read_space(std::string_view kind, source_value const& from, written_register& one)
    {
        std::string said = from.text_of("register_type");
        if (said.empty()) {
            said = kind == "switch" ? "coil" : "holding";
            if (kind == "switch" or kind == "sensor" or kind == "binary_sensor") {
                into_.note(from.place, one.name + " has no register_type: it is taken for a " + said);
            }
        }
        one.space = said == "read" ? "input" : said == "discrete_input" ? "discrete" : said;
        bool const is_known =
            one.space == "holding" or one.space == "input" or one.space == "coil" or one.space == "discrete";
        if (not is_known) {
            into_.lose(from.place, one.name + " is left out: register_type '" + said + "' is none of a register file");
        }
        return is_known;
    }

    bool read_type(std::string_view kind, source_value const& from, written_register& one)
    {
        if (one.space == "coil" or one.space == "discrete") {
            return true;
        }
        if (kind == "text_sensor") {
            auto const count = whole_field(into_, from, "register_count");
            auto const size = from.find("response_size") != nullptr ? whole_field(into_, from, "response_size") : count;
            std::int64_t const characters = size.value_or(0) * (from.find("response_size") != nullptr ? 1 : 2);
            one.type = "text" + std::to_string(characters);
            if (not from.text_of("raw_encode").empty()) {
                one.type = from.text_of("raw_encode") == "ANSI" or from.text_of("raw_encode") == "NONE" ? one.type : "";
            }
            return true;
        }
        std::string const said = from.text_of("value_type").empty() ? "U_WORD" : from.text_of("value_type");
        auto const found = std::ranges::find(esphome_types, said, &esphome_type::name);
        if (found == std::end(esphome_types)) {
            into_.lose(from.place, one.name + " is left out: value_type '" + said + "' is none of a register file");
            return false;
        }
        one.type = found->type;
        one.order = found->order;
        read_mask(kind, from, one);
        return true;
    }

    void read_mask(std::string_view kind, source_value const& from, written_register& one)
    {
        std::int64_t const said = whole_or_raw(from, "bitmask", 0xFFFF'FFFF, one);
        bool const is_truth = kind == "binary_sensor" or kind == "switch";
        auto const mask = static_cast<std::uint64_t>(said);
        if (mask == 0xFFFF'FFFFU or (mask == 0xFFFF and one.type.empty())) {
            return;
        }
        int const low = std::countr_zero(mask);
        bool const is_run = mask != 0 and mask <= 0xFFFF and std::has_single_bit((mask >> low) + 1);
        if (not is_run or not one.type.empty() or (is_truth and not std::has_single_bit(mask))) {
            one.not_the_value = "its bitmask is not that of neighbouring bits of one register";
            return;
        }
        int const last = static_cast<int>(std::bit_width(mask)) - 1;
        one.bits = std::to_string(low) + (last == low ? "" : '-' + std::to_string(last));
        if (one.is_writable) {
            into_.lose(
                from.place,
                one.name +
                    " is read only here: it is some bits of a register, which the other program writes as a whole");
            one.is_writable = false;
        }
    }

    void read_scale(source_value const& from, written_register& one)
    {
        if (source_value const* const code = from.find("lambda")) {
            one.not_the_value = "its value is made by a lambda in line " + std::to_string(code->place.line);
        }
        read_what_is_written(from, one);
        one.scale = 1 / number_or_raw(from, "multiply", 1, one); // what is written is multiplied
        if (not std::isfinite(one.scale)) {
            one.scale = 1;
            one.not_the_value = "it is to be multiplied by 0";
        }
        source_value const* const filters = from.find("filters");
        for (std::size_t i = 0; filters != nullptr and i < filters->fields.size(); ++i) {
            source_value const& filter = filters->fields[i].second;
            for (auto const& [name, value] : filter.fields) {
                read_filter(name, value, one);
            }
            if (filter.is_plain() and std::ranges::count(harmless_filters, filter.text) == 0) {
                one.not_the_value = "of the filter " + filter.text;
            }
        }
    }

    /// Words of ESPHome that make another value, or another place, of what is read and written.
    static void read_what_is_written(source_value const& from, written_register& one)
    {
        for (std::string_view const key :
             {"write_lambda", "custom_command", "inverted", "offset", "min_power", "max_power"}) {
            source_value const* const said = from.find(key);
            bool const is_without_effect =
                said != nullptr and
                ((key == "offset" and said->whole_number() == 0) or
                 (key == "inverted" and (lower(said->text) == "false" or lower(said->text) == "no")));
            if (said != nullptr and not is_without_effect) {
                one.not_the_value = "of its " + std::string{key} + " in line " + std::to_string(said->place.line);
            }
        }
    }

    static void read_filter(std::string const& name, source_value const& value, written_register& one)
    {
        auto const number = value.number();
        if (name == "multiply" and number) {
            one.scale *= *number;
            one.offset *= *number;
        } else if (name == "offset" and number) {
            one.offset += *number;
        } else if (std::ranges::count(harmless_filters, name) == 0) {
            one.not_the_value = "of the filter " + name + " in line " + std::to_string(value.place.line);
        }
    }

    void read_limits(std::string_view kind, source_value const& from, written_register& one)
    {
        if (kind == "number") {
            one.lowest = number_field(into_, from, "min_value");
            one.highest = number_field(into_, from, "max_value");
        }
        source_value const* const options = from.find("optionsmap");
        for (std::size_t i = 0; options != nullptr and i < options->fields.size(); ++i) {
            auto const& [name, value] = options->fields[i];
            if (auto const number = value.whole_number()) {
                one.choices.emplace_back(name, *number);
            } else {
                one.not_the_value = "its choice " + name + " is no whole number";
            }
        }
    }

    register_file_writer& into_;
    std::map<std::string, controller> controllers_{};
};

constexpr std::string_view kinds_of_entities[]{"sensor", "binary_sensor", "text_sensor", "number",
                                               "select", "switch",        "output",      "light"};

} // namespace

bool is_esphome(source_value const& file)
{
    bool is_one = file.find("modbus_controller") != nullptr;
    for (std::string_view const kind : kinds_of_entities) {
        if (source_value const* const entries = file.find(kind)) {
            each_entry(*entries, [&is_one](source_value const& each) { is_one = is_one or is_of_controller(each); });
        }
    }
    return is_one;
}

void import_esphome(source_value const& file, register_file_writer& into)
{
    into.add_comment("Imported from a configuration of ESPHome.");
    esphome_reader reader{into};
    if (source_value const* const controllers = file.find("modbus_controller")) {
        each_entry(*controllers, [&reader](source_value const& each) { reader.read_controller(each); });
    }
    for (std::string_view const kind : kinds_of_entities) {
        source_value const* const entries = file.find(kind);
        if (entries == nullptr) {
            continue;
        }
        each_entry(*entries, [&](source_value const& each) {
            if (is_of_controller(each)) {
                reader.read(kind, each);
            }
        });
    }
}

} // namespace tool
