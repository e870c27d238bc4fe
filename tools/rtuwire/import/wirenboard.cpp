// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>

#include "exit_status.hpp"
#include "import/forms.hpp"

namespace tool {

namespace {

/// What a format of a template is here, and how many registers it has.
struct wirenboard_format {
    std::string_view name;
    std::string_view type;
    unsigned registers;
};
constexpr wirenboard_format wirenboard_formats[]{
    {"u16", "u16", 1}, {"s16", "i16", 1},   {"u32", "u32", 2},    {"s32", "i32", 2},     {"u64", "u64", 4},
    {"s64", "i64", 4}, {"float", "f32", 2}, {"double", "f64", 4}, {"bcd16", "bcd16", 1}, {"bcd32", "bcd32", 2},
};

/// The units of kinds of channels that say none.
constexpr std::pair<std::string_view, std::string_view> units_of_kinds[]{
    {"temperature", "degC"}, {"rel_humidity", "%"}, {"voltage", "V"},
    {"current", "A"},        {"power", "W"},        {"power_consumption", "kWh"}};

constexpr std::string_view channel_fields[]{
    "name", "title", "id", "address", "reg_type", "format", "word_order", "byte_order", "scale", "offset", "readonly",
    "units", "min", "max", "enum", "enum_titles", "error_value", "unsupported_value", "string_data_size", "on_value",
    "off_value", "write_address",
    // how something is shown and asked for, there
    "type", "group", "order", "sporadic", "semi-sporadic", "enabled", "round_to", "precision", "original_name",
    "description", "read_period_ms", "read_rate_limit_ms", "poll_interval", "hidden", "required"};

constexpr std::string_view device_fields[]{
    "name",   "id",           "protocol",           "channels",         "parameters",
    "groups", "translations", "max_read_registers", "guard_interval_us"};

class wirenboard_reader {
public:
    wirenboard_reader(std::optional<std::int64_t> base, register_file_writer& into)
        : base_{base.value_or(0)}, into_{into}
    {}

    void read_list(source_value const& list, bool is_settings)
    {
        for (auto const& [key, each] : list.fields) {
            if (each.kind != source_kind::table) {
                into_.lose(each.place, "a channel is a table");
                continue;
            }
            read(each, key, is_settings);
        }
    }

private:
    void read(source_value const& from, std::string const& key, bool is_setting)
    {
        written_register one;
        one.place = from.place;
        one.name = is_setting ? (key.empty() ? from.text_of("id") : key) : from.text_of("name");
        one.name = one.name.empty() ? from.text_of("title") : one.name;
        if (has_names_twice(into_, from)) {
            into_.lose(from.place, one.name + " is left out");
            return;
        }
        lose_other_fields(into_, from, one.name, channel_fields);
        if (not read_space(from, one) or not read_address(from, one) or not read_format(from, one)) {
            return;
        }
        one.is_writable =
            (one.space == "holding" or one.space == "coil") and not from.is_true("readonly") and one.is_writable;
        if (one.is_writable and not one.bits.empty()) {
            into_.lose(
                from.place,
                one.name +
                    " is read only here: it is some bits of a register, which the other program writes as a whole");
            one.is_writable = false;
        }
        one.is_setting = is_setting and one.space == "holding";
        read_scale(from, one);
        read_meaning(from, one);
        into_.add(std::move(one));
    }

    bool read_space(source_value const& from, written_register& one)
    {
        std::string const kind = from.text_of("reg_type");
        if (source_value const* const parts = from.find("consists_of")) {
            into_.lose(parts->place, one.name + " is left out: it is made of several registers");
            return false;
        }
        if (kind.empty() or kind == "holding" or kind == "holding_single" or kind == "holding_multi") {
            one.space = "holding";
        } else if (kind == "input" or kind == "press_counter") {
            one.space = "input";
        } else if (kind == "coil" or kind == "discrete") {
            one.space = kind;
        } else {
            into_.lose(from.place, one.name + " is left out: reg_type '" + kind + "' is no space of Modbus");
            return false;
        }
        one.is_writable = true;
        return true;
    }

    /// 16, "0x10", "0x10:4:2": the bits from 4, two of them.
    bool read_address(source_value const& from, written_register& one)
    {
        source_value const* const value = from.find("address");
        if (value == nullptr or not value->is_plain()) {
            into_.lose(from.place, one.name + " is left out: it is written only, or has no address");
            return false;
        }
        std::array<std::int64_t, 3> numbers{0, 0, 0};
        std::size_t count = 0;
        std::string_view rest = value->text;
        bool is_right = true;
        do {
            std::size_t const colon = rest.find(':');
            source_value part;
            part.kind = source_kind::text;
            part.text = std::string{rest.substr(0, colon)};
            auto const number = part.whole_number();
            is_right = number.has_value() and count < numbers.size();
            if (is_right) {
                numbers[count++] = *number;
            }
            rest.remove_prefix(colon == rest.npos ? rest.size() : colon + 1);
        } while (is_right and not rest.empty());
        bool const has_bits = count == 3 and numbers[1] >= 0 and numbers[2] > 0 and numbers[1] + numbers[2] <= 16;
        if (not is_right or (count != 1 and not has_bits)) {
            into_.lose(value->place,
                       one.name + " is left out: '" + value->text + "' is no address, nor some bits of one register");
            return false;
        }
        one.address = numbers[0] + base_;
        if (has_bits and numbers[2] < 16) {
            std::string const last = std::to_string(numbers[1] + numbers[2] - 1);
            one.bits = std::to_string(numbers[1]) + (numbers[2] == 1 ? "" : '-' + last);
        }
        if (source_value const* const other = from.find("write_address")) {
            into_.lose(other->place, one.name + " is read only here: it is written at another address, " + other->text);
            one.is_writable = false;
        }
        return true;
    }

    bool read_format(source_value const& from, written_register& one)
    {
        std::string const format = from.text_of("format").empty() ? "u16" : from.text_of("format");
        if (one.space == "coil" or one.space == "discrete") {
            return true;
        }
        auto const refuse = [&](std::string const& why) {
            into_.lose(from.place, one.name + " is left out: its format '" + format + "' " + why);
            return false;
        };
        bool const has_low_byte_first = from.text_of("byte_order") == "little_endian";
        bool const has_low_word_first = from.text_of("word_order") == "little_endian";
        if (format == "string8") {
            auto const size = whole_field(into_, from, "string_data_size");
            one.type = size ? "text" + std::to_string(2 * *size) : "";
            one.order = has_low_byte_first ? "badc" : "";
            return size or refuse("has no size");
        }
        if (not one.bits.empty()) { // a number of some bits, whose sign would be lost
            bool const is_plain = not has_low_byte_first and (format == "u16" or format == "u8");
            return is_plain or refuse("is of some bits");
        }
        if (format == "u8") { // the low byte of a register
            one.bits = has_low_byte_first ? "8-15" : "0-7";
            return true;
        }
        auto const found = std::ranges::find(wirenboard_formats, format, &wirenboard_format::name);
        if (found == std::end(wirenboard_formats)) {
            return refuse("is none of a register file");
        }
        one.type = found->type == "u16" ? "" : std::string{found->type};
        if (has_low_byte_first) {
            one.order = found->registers > 1 and has_low_word_first ? "dcba" : "badc";
        } else if (has_low_word_first and found->registers > 1) {
            one.order = "cdab";
        }
        return true;
    }

    void read_scale(source_value const& from, written_register& one)
    {
        one.scale = number_or_raw(from, "scale", 1, one);
        one.offset = number_or_raw(from, "offset", 0, one);
        bool const has_scale = one.scale != 1 or one.offset != 0;
        if (has_scale and not one.bits.empty()) {
            one.not_the_value = "bits have no scale here, " + from.text_of("scale");
        }
        auto const kind =
            std::ranges::find(units_of_kinds, from.text_of("type"), [](auto const& each) { return each.first; });
        one.unit = from.text_of("units");
        if (one.unit == "%, RH") {
            one.unit = "%";
        } else if (one.unit.empty() and kind != std::end(units_of_kinds) and one.bits.empty()) {
            one.unit = kind->second;
        }
    }

    void read_meaning(source_value const& from, written_register& one)
    {
        bool const is_whole = one.type.empty() or one.type.starts_with('i') or one.type.starts_with('u');
        if (is_whole and one.bits.empty() and one.space != "coil" and one.space != "discrete") {
            one.lowest = number_field(into_, from, "min");
            one.highest = number_field(into_, from, "max");
        }
        read_choices(from, one);
        for (std::string_view const key : {"error_value", "unsupported_value"}) {
            read_invalid(into_, from, key, one);
        }
    }

    void read_choices(source_value const& from, written_register& one)
    {
        source_value const* const numbers = from.find("enum");
        source_value const* const titles = from.find("enum_titles");
        if (numbers != nullptr) {
            bool const is_whole = titles != nullptr and titles->fields.size() == numbers->fields.size();
            for (std::size_t i = 0; i < (is_whole ? titles->fields.size() : 0); ++i) {
                if (auto const number = numbers->fields[i].second.whole_number()) {
                    one.choices.emplace_back(titles->fields[i].second.text, *number);
                }
            }
            if (one.choices.size() != numbers->fields.size()) {
                into_.lose(numbers->place, one.name + ": an enum without a title for each whole number");
                one.choices.clear();
            }
        }
        if (from.find("on_value") == nullptr) {
            return;
        }
        std::int64_t const on = whole_or_raw(from, "on_value", 1, one);
        std::int64_t const off = whole_or_raw(from, "off_value", 0, one);
        if (one.space == "holding" or one.space == "input") {
            one.choices = {{"off", off}, {"on", on}};
        } else if (off != 0 or on == 0) {
            one.not_the_value = "it is on where the coil is off, or on and off are the same";
        }
    }

    std::int64_t base_;
    register_file_writer& into_;
};

} // namespace

bool is_wirenboard(source_value const& file)
{
    source_value const* const device = file.find("device");
    return device != nullptr and device->kind == source_kind::table and
           (file.find("device_type") != nullptr or device->find("channels") != nullptr);
}

void import_wirenboard(source_value const& file, std::optional<std::int64_t> base, register_file_writer& into)
{
    source_value const& device = *file.find("device");
    std::string const protocol = device.text_of("protocol");
    bool const is_module = protocol.starts_with("modbus_io");
    if (not is_module) {
        refuse_base(into, base);
    }
    if (not protocol.empty() and not protocol.starts_with("modbus")) {
        refuse_word(told_place(into.file(), device.find("protocol")->place) + "its protocol is '" + protocol +
                    "', and not Modbus");
    }
    if (is_module and not base) {
        refuse_word(
            told_place(into.file(), device.find("protocol")->place) +
            "addresses of a module count from its place behind its coupler: say that place, such as --base 1000");
    }
    into.add_comment(device.text_of("name"));
    into.add_comment("Imported from a template of wb-mqtt-serial.");
    lose_other_fields(into, device, "the device", device_fields);
    if (auto const most = whole_field(into, device, "max_read_registers"); most and *most > 0) {
        into.limit_requests(device.find("max_read_registers")->place, *most);
    }
    if (auto const pause = number_field(into, device, "guard_interval_us")) {
        into.pause(device.find("guard_interval_us")->place, *pause / 1000);
    }
    wirenboard_reader reader{is_module ? base : std::nullopt, into};
    if (source_value const* const channels = device.find("channels")) {
        reader.read_list(*channels, false);
    }
    if (source_value const* const parameters = device.find("parameters")) {
        reader.read_list(*parameters, true);
    }
}

} // namespace tool
