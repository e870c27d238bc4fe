// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include "import/forms.hpp"

namespace tool {

namespace {

constexpr std::pair<std::string_view, std::string_view> types_of_home_assistant[]{
    {"int16", "i16"}, {"uint16", ""},    {"int32", "i32"},   {"uint32", "u32"},
    {"int64", "i64"}, {"uint64", "u64"}, {"float32", "f32"}, {"float64", "f64"}};

/// What its entities have, and what only says how one is shown or how often asked for.
constexpr std::string_view shown_fields[]{
    "name", "unique_id",       "device_class", "state_class",    "scan_interval", "precision",  "lazy_error_count",
    "icon", "entity_category", "slave",        "device_address", "address",       "input_type", "zero_suppress"};
constexpr std::string_view hub_fields[]{"name",
                                        "type",
                                        "host",
                                        "port",
                                        "baudrate",
                                        "bytesize",
                                        "method",
                                        "parity",
                                        "stopbits",
                                        "delay",
                                        "timeout",
                                        "message_wait_milliseconds",
                                        "close_comm_on_error",
                                        "retries",
                                        "retry_on_empty",
                                        "sensors",
                                        "binary_sensors",
                                        "switches",
                                        "lights",
                                        "fans",
                                        "climates"};

std::vector<std::string_view> with_shown(std::initializer_list<std::string_view> more)
{
    std::vector<std::string_view> all{std::begin(shown_fields), std::end(shown_fields)};
    all.insert(all.end(), more);
    return all;
}

class home_assistant_reader {
public:
    explicit home_assistant_reader(register_file_writer& into) : into_{into} {}

    void read_hub(source_value const& hub)
    {
        static_cast<void>(has_names_twice(into_, hub));
        lose_other_fields(into_, hub, "the hub", hub_fields);
        line_ = "the hub " + hub.text_of("name") + " in line " + std::to_string(hub.place.line);
        if (auto const pause = number_field(into_, hub, "message_wait_milliseconds")) {
            into_.pause(hub.find("message_wait_milliseconds")->place, *pause);
        }
        each_of(hub, "sensors", [this](source_value const& from) { read_sensor(from); });
        each_of(hub, "binary_sensors", [this](source_value const& from) { read_binary_sensor(from); });
        for (std::string_view const kind : {"switches", "lights", "fans"}) {
            each_of(hub, kind, [this](source_value const& from) { read_switch(from); });
        }
        each_of(hub, "climates", [this](source_value const& from) { read_climate(from); });
    }

private:
    template <typename Read> void each_of(source_value const& hub, std::string_view kind, Read read)
    {
        source_value const* const list = hub.find(kind);
        if (list == nullptr) {
            return;
        }
        if (list->kind != source_kind::list) {
            into_.lose(list->place,
                       std::string{kind} + " is no list here" + (list->tag.empty() ? "" : " (" + list->tag + ')'));
            return;
        }
        for (auto const& [key, each] : list->fields) {
            if (each.kind != source_kind::table) {
                into_.lose(each.place, "an entity is a table");
            } else if (has_names_twice(into_, each)) {
                into_.lose(each.place, each.text_of("name") + " is left out");
            } else {
                read(each);
            }
        }
    }

    /// Nothing where it has no address.
    std::optional<written_register> begin(source_value const& from, std::string_view key = "address")
    {
        written_register one;
        one.place = from.place;
        one.name = from.text_of("name");
        auto const address = whole_field(into_, from, key);
        one.address = address.value_or(0);
        one.line = line_;
        std::string_view const unit = from.find("device_address") != nullptr ? "device_address" : "slave";
        one.unit_id = whole_field(into_, from, unit);
        bool const has_unit = one.unit_id or from.find(unit) == nullptr;
        if (not address or not has_unit) {
            into_.lose(from.place, one.name + " is left out: " +
                                       (has_unit ? "it has no address" : "nobody says of which unit it is"));
        }
        return address and has_unit ? std::optional{one} : std::nullopt;
    }

    bool read_space(source_value const& from, std::string_view key, std::string_view otherwise, written_register& one)
    {
        std::string kind = from.text_of(key);
        kind = kind.empty() ? std::string{otherwise} : kind;
        kind = kind == "coils" ? "coil" : kind == "holdings" ? "holding" : kind;
        one.space = kind == "discrete_input" ? "discrete" : kind;
        bool const is_known =
            one.space == "holding" or one.space == "input" or one.space == "coil" or one.space == "discrete";
        if (not is_known) {
            into_.lose(from.place, one.name + " is left out: " + std::string{key} + " '" + kind + "' is none");
        }
        return is_known;
    }

    /// Type, order, scale and unit of a sensor or a climate.
    bool read_form(source_value const& from, written_register& one)
    {
        std::string const said = from.text_of("data_type").empty() ? "int16" : from.text_of("data_type");
        auto const type = std::ranges::find(types_of_home_assistant, said, [](auto const& each) { return each.first; });
        auto const count = whole_field(into_, from, "count");
        bool const is_text = said == "string" and count and *count > 0;
        if (type == std::end(types_of_home_assistant) and not is_text) {
            into_.lose(from.place, one.name + " is left out: its data_type '" + said + "' is none of a register file" +
                                       (said == "string" ? ", or has no count" : ""));
            return false;
        }
        one.type = is_text ? "text" + std::to_string(2 * *count) : std::string{type->second};
        bool const is_wide = one.type.ends_with("32") or one.type.ends_with("64");
        std::string const swap = from.text_of("swap");
        if (swap == "byte" or swap == "word" or swap == "word_byte") {
            one.order = swap == "byte" or not is_wide ? "badc" : swap == "word" ? "cdab" : "dcba";
            one.order = swap == "word" and not is_wide ? "" : one.order;
        } else if (not swap.empty() and swap != "none") {
            one.not_the_value = "swap '" + swap + "' is none";
        }
        one.scale = number_or_raw(from, "scale", 1, one);
        one.offset = number_or_raw(from, "offset", 0, one);
        one.unit = from.text_of("unit_of_measurement");
        read_invalid(into_, from, "nan_value", one);
        return true;
    }

    void read_sensor(source_value const& from)
    {
        auto one = begin(from);
        if (not one) {
            return;
        }
        lose_other_fields(
            into_, from, one->name,
            with_shown({"data_type", "count", "swap", "scale", "offset", "unit_of_measurement", "nan_value"}));
        if (read_space(from, "input_type", "holding", *one) and read_form(from, *one)) {
            into_.add(std::move(*one));
        }
    }

    void read_binary_sensor(source_value const& from)
    {
        auto one = begin(from);
        if (not one) {
            return;
        }
        lose_other_fields(into_, from, one->name, with_shown({}));
        if (read_space(from, "input_type", "coil", *one)) {
            one->bits = one->space == "holding" or one->space == "input" ? "0" : "";
            into_.add(std::move(*one));
        }
    }

    void read_switch(source_value const& from)
    {
        auto one = begin(from);
        if (not one) {
            return;
        }
        lose_other_fields(into_, from, one->name, with_shown({"write_type", "command_on", "command_off"}));
        if (not read_space(from, "write_type", "holding", *one)) {
            return;
        }
        one->is_writable = true;
        std::int64_t const off = whole_or_raw(from, "command_off", 0, *one);
        std::int64_t const on = whole_or_raw(from, "command_on", 1, *one);
        if (one->space == "holding") {
            one->choices = {{"off", off}, {"on", on}};
        } else if (off != 0 or on == 0) {
            one->not_the_value = "it is on where the coil is off, or on and off are the same";
        }
        into_.add(std::move(*one));
    }

    void read_climate(source_value const& from)
    {
        auto one = begin(from);
        if (not one) {
            return;
        }
        lose_other_fields(into_, from, one->name,
                          with_shown({"data_type", "count", "swap", "scale", "offset", "temperature_unit", "min_temp",
                                      "max_temp", "temp_step", "target_temp_register"}));
        std::string const name = one->name;
        if (not read_space(from, "input_type", "holding", *one) or not read_form(from, *one)) {
            return;
        }
        one->unit = "deg" + (from.text_of("temperature_unit").empty() ? "C" : from.text_of("temperature_unit"));
        written_register target = *one;
        one->name = name + " current";
        into_.add(std::move(*one));
        auto const address = whole_field(into_, from, "target_temp_register");
        if (not address) {
            into_.lose(from.place, name + ": it has no target_temp_register of one address");
            return;
        }
        target.name = name + " target";
        target.space = "holding";
        target.address = *address;
        target.is_writable = true;
        target.lowest = number_field(into_, from, "min_temp");
        target.highest = number_field(into_, from, "max_temp");
        into_.add(std::move(target));
    }

    register_file_writer& into_;
    std::string line_{};
};

bool is_hub(source_value const& value)
{
    constexpr std::string_view kinds[]{"sensors", "binary_sensors", "switches", "lights", "fans", "covers", "climates"};
    return value.kind == source_kind::table and
           std::ranges::any_of(kinds, [&value](std::string_view kind) { return value.find(kind) != nullptr; });
}

/// The hubs of a file; null where it has none.
source_value const* hubs_of(source_value const& file)
{
    source_value const* const hubs = file.kind == source_kind::list ? &file : file.find("modbus");
    bool const has_hub =
        hubs != nullptr and
        (is_hub(*hubs) or std::ranges::any_of(hubs->fields, [](auto const& each) { return is_hub(each.second); }));
    return has_hub ? hubs : nullptr;
}

} // namespace

bool is_home_assistant(source_value const& file) { return hubs_of(file) != nullptr; }

void import_home_assistant(source_value const& file, register_file_writer& into)
{
    into.add_comment("Imported from a configuration of Home Assistant.");
    home_assistant_reader reader{into};
    source_value const& hubs = *hubs_of(file);
    if (hubs.kind == source_kind::table) {
        reader.read_hub(hubs);
        return;
    }
    for (auto const& [key, each] : hubs.fields) {
        if (is_hub(each)) {
            reader.read_hub(each);
        } else {
            into.lose(each.place, "a hub without entities");
        }
    }
}

} // namespace tool
