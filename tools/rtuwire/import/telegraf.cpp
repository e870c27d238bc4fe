// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include "import/forms.hpp"

namespace tool {

namespace {

struct telegraf_type {
    std::string_view name;
    std::string_view type;
    std::string_view bits;
};
constexpr telegraf_type telegraf_types[]{
    {"INT16", "i16", ""},        {"UINT16", "", ""},         {"INT32", "i32", ""},  {"UINT32", "u32", ""},
    {"INT64", "i64", ""},        {"UINT64", "u64", ""},      {"UINT8L", "", "0-7"}, {"UINT8H", "", "8-15"},
    {"FLOAT32-IEEE", "f32", ""}, {"FLOAT64-IEEE", "f64", ""}};

constexpr std::string_view plugin_fields[]{"name", "slave_id", "configuration_type", "discrete_inputs", "coils",
                                           "holding_registers", "input_registers", "request", "metric", "workarounds",
                                           // the line, and how often something is asked for
                                           "timeout", "busy_retries", "busy_retries_wait", "controller", "baud_rate",
                                           "data_bits", "parity", "stop_bits", "rs485", "transmission_mode",
                                           "debug_connection", "interval", "tags", "name_override", "alias"};
constexpr std::string_view request_fields[]{"slave_id", "byte_order", "register",     "measurement",
                                            "fields",   "tags",       "optimization", "optimization_max_register_fill"};
constexpr std::string_view field_names[]{"name", "address", "byte_order", "data_type", "type",        "scale",
                                         "bit",  "length",  "register",   "omit",      "measurement", "output"};

/// Its registers are a number without a sign, or with one.
std::string_view fixed_type(std::size_t registers, bool has_sign)
{
    constexpr std::string_view with_sign[]{"i16", "i32", "i64"};
    constexpr std::string_view without[]{"", "u32", "u64"};
    std::size_t const index = registers == 1 ? 0 : registers == 2 ? 1 : 2;
    return has_sign ? with_sign[index] : without[index];
}

class telegraf_reader {
public:
    explicit telegraf_reader(register_file_writer& into) : into_{into} {}

    void read(source_value const& plugin)
    {
        lose_other_fields(into_, plugin, "the plugin", plugin_fields);
        read_pause(plugin);
        std::string const style = plugin.text_of("configuration_type");
        line_ = plugin.text_of("controller");
        unit_ = whole_field(into_, plugin, "slave_id");
        if (style.empty() or style == "register") {
            for (auto const& [key, space] : {std::pair{"discrete_inputs", "discrete"},
                                             {"coils", "coil"},
                                             {"holding_registers", "holding"},
                                             {"input_registers", "input"}}) {
                read_list(plugin, key, [this, space = space](source_value const& field) { read_old(field, space); });
            }
            return;
        }
        for (std::string_view const key : {"request", "metric"}) {
            read_list(plugin, key, [this](source_value const& request) { read_request(request); });
        }
    }

private:
    template <typename Read> void read_list(source_value const& from, std::string_view key, Read read)
    {
        source_value const* const list = from.find(key);
        for (std::size_t i = 0; list != nullptr and i < list->fields.size(); ++i) {
            source_value const& each = list->fields[i].second;
            if (each.kind == source_kind::table) {
                read(each);
            } else {
                into_.lose(each.place, std::string{key} + " has tables only");
            }
        }
    }

    void read_pause(source_value const& plugin)
    {
        source_value const* const around = plugin.find("workarounds");
        source_value const* const pause = around == nullptr ? nullptr : around->find("pause_between_requests");
        if (pause == nullptr) {
            return;
        }
        source_value number = *pause;
        bool const is_ms = number.text.ends_with("ms");
        number.text.resize(number.text.size() - (is_ms ? 2U : number.text.ends_with('s') ? 1U : 0U));
        if (auto const amount = number.number()) {
            into_.pause(pause->place, *amount * (is_ms ? 1 : 1000));
        } else {
            into_.lose(pause->place, "pause_between_requests " + pause->text + " is no time");
        }
    }

    written_register begin(source_value const& field) const
    {
        written_register one;
        one.place = field.place;
        one.name = field.text_of("name");
        one.unit_id = unit_;
        one.line = line_;
        return one;
    }

    /// A field with a list of addresses: those of its value, in a row.
    void read_old(source_value const& field, std::string const& space)
    {
        written_register one = begin(field);
        one.space = space;
        lose_other_fields(into_, field, one.name, field_names);
        source_value const* const list = field.find("address");
        std::size_t const count = list == nullptr ? 0 : list->fields.size();
        for (std::size_t i = 0; i < count; ++i) {
            auto const number = list->fields[i].second.whole_number();
            one.address = i == 0 ? number.value_or(-1) : one.address;
            if (not number or *number != one.address + static_cast<std::int64_t>(i)) {
                into_.lose(list->place, one.name + " is left out: its addresses are not in a row");
                return;
            }
        }
        if (count == 0) {
            into_.lose(field.place, one.name + " is left out: it has no address");
            return;
        }
        finish(field, std::move(one), field.text_of("data_type"), field.text_of("byte_order"), count);
    }

    void read_request(source_value const& request)
    {
        lose_other_fields(into_, request, "the request", request_fields);
        unit_ = whole_field(into_, request, "slave_id");
        read_list(request, "fields", [this, &request](source_value const& field) {
            written_register one = begin(field);
            lose_other_fields(into_, field, one.name, field_names);
            if (field.is_true("omit")) {
                return;
            }
            std::string const space =
                field.text_of("register").empty() ? request.text_of("register") : field.text_of("register");
            one.space = space.empty() ? "holding" : space;
            auto const address = whole_field(into_, field, "address");
            if (not address) {
                into_.lose(field.place, one.name + " is left out: it has no address");
                return;
            }
            one.address = *address;
            auto const length = whole_field(into_, field, "length");
            std::string type = field.text_of("type");
            type = type == "FLOAT32" ? "FLOAT32-IEEE" : type == "FLOAT64" ? "FLOAT64-IEEE" : type;
            std::string const order = request.text_of("byte_order");
            finish(field, std::move(one), type, order,
                   static_cast<std::size_t>(std::clamp<std::int64_t>(length.value_or(1), 0, 125)));
        });
    }

    void finish(source_value const& field, written_register one, std::string type, std::string const& order,
                std::size_t count)
    {
        if (one.space == "coil" or one.space == "discrete") {
            into_.add(std::move(one));
            return;
        }
        bool const is_fixed = type == "FIXED" or type == "UFIXED" or type == "FLOAT32";
        bool const is_in_sizes = count == 1 or count == 2 or count == 4;
        auto const found = std::ranges::find(telegraf_types, type, &telegraf_type::name);
        if (type == "STRING") {
            one.type = "text" + std::to_string(2 * count);
        } else if (type == "BIT") {
            one.bits = std::to_string(whole_or_raw(field, "bit", 0, one));
        } else if (is_fixed and is_in_sizes) {
            one.type = fixed_type(count, type == "FIXED");
        } else if (found != std::end(telegraf_types)) {
            one.type = found->type;
            one.bits = found->bits;
        } else {
            into_.lose(field.place, one.name + " is left out: its type '" + type + "' is none of a register file");
            return;
        }
        read_order(order, one);
        double const scale = number_or_raw(field, "scale", 1, one);
        if (one.bits.empty()) {
            one.scale = scale;
        } else if (scale != 1) {
            one.not_the_value = "bits have no scale here";
        }
        into_.add(std::move(one));
    }

    static void read_order(std::string const& said, written_register& one)
    {
        bool const is_wide = one.type.ends_with("32") or one.type.ends_with("64");
        std::string order;
        for (char const c : said) {
            order += c >= 'A' and c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
        bool const is_swapped =
            order == "ba" or order == "dcba" or order == "badc" or order == "hgfedcba" or order == "badcfehg";
        if (order.empty() or order == "ab" or order == "abcd" or order == "abcdefgh") {
            return;
        }
        if (is_wide) {
            one.order = order == "ba" ? "dcba" : order;
        } else if (not one.bits.empty()) {
            one.not_the_value = is_swapped ? "its bytes are swapped, and bits have no order here" : one.not_the_value;
        } else {
            one.order = is_swapped ? "badc" : "";
        }
    }

    register_file_writer& into_;
    std::optional<std::int64_t> unit_{};
    std::string line_{};
};

/// The plugins; null where a file has none.
source_value const* plugins_of(source_value const& file)
{
    source_value const* const inputs = file.find("inputs");
    return inputs == nullptr ? nullptr : inputs->find("modbus");
}

} // namespace

bool is_telegraf(source_value const& file) { return plugins_of(file) != nullptr; }

void import_telegraf(source_value const& file, register_file_writer& into)
{
    into.add_comment("Imported from a configuration of Telegraf.");
    source_value const& plugins = *plugins_of(file);
    if (plugins.kind == source_kind::table) {
        telegraf_reader{into}.read(plugins);
        return;
    }
    for (auto const& [key, each] : plugins.fields) {
        if (each.kind == source_kind::table) {
            telegraf_reader{into}.read(each);
        }
    }
}

} // namespace tool
