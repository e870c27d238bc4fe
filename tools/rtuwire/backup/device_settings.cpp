// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "backup/device_settings.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "backup/backup_text.hpp"
#include "backup/drive_settings.hpp"
#include "line/register_reader.hpp"
#include "line/who_is_it.hpp"
#include "words/named_value.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

bool is_bits(value_type type) noexcept { return type == value_type::bits or type == value_type::hex; }

/// A value of a file, without its unit: what `words_to_hold` reads.
saved_value value_to_save(named_place const& named, std::span<std::uint16_t const> words)
{
    if (words.empty()) {
        return {};
    }
    place where = named.where;
    where.form.unit.clear();
    where.form.type = where.form.type == value_type::none ? value_type::u16 : where.form.type;
    formed_value const formed = value_of(where, words);
    bool const is_number = named.choices.empty() and not is_bits(where.form.type) and
                           where.form.type != value_type::text and
                           not std::holds_alternative<std::monostate>(formed.value);
    if (is_number) {
        return {formed.text, true, named.where.form.unit};
    }
    if (is_bits(where.form.type)) {
        return {hex_words(words), false, {}};
    }
    cell const value = named.choices.empty() ? formed.value : value_of(named, words).value;
    return {text_of_cell(value), false, {}};
}

/// One register in digits, several as they came: "0x4366199A".
std::string raw_text(std::span<std::uint16_t const> words)
{
    return words.size() == 1 ? std::to_string(words[0]) : words.empty() ? std::string{} : hex_words(words);
}

std::optional<std::vector<std::uint16_t>> words_of_raw(place const& where, std::string_view text)
{
    std::size_t const size = where.size();
    bool const is_hex = text.starts_with("0x") or text.starts_with("0X");
    std::string_view const digits = text.substr(is_hex ? 2 : 0);
    std::vector<std::uint16_t> words;
    for (std::size_t i = 0; i < size; ++i) {
        std::string_view const part = is_hex ? digits.substr(std::min(4 * i, digits.size()), 4) : digits;
        std::uint16_t word = 0;
        auto const [end, why] = std::from_chars(part.data(), part.data() + part.size(), word, is_hex ? 16 : 10);
        if (part.empty() or why != std::errc{} or end != part.data() + part.size()) {
            return std::nullopt;
        }
        words.push_back(word);
    }
    bool const is_whole = is_hex ? digits.size() == 4 * size : size == 1;
    bool const fits = not where.is_single_bit() or words[0] <= 1;
    return is_whole and fits ? std::optional{std::move(words)} : std::nullopt;
}

backup_rows rows_of(device_settings const& settings)
{
    backup_rows all{settings.head, {}};
    for (device_value const& each : settings.values) {
        named_place const& named = *each.named;
        saved_value value = value_to_save(named, each.words);
        bool const may_be_formula = not value.is_number and value.text.find_first_of("=+-@") == 0;
        all.rows.push_back({named.group,
                            named.where.address,
                            named.where.name,
                            {},
                            raw_text(each.words),
                            each.words.size() == 1,
                            may_be_formula ? saved_value{} : std::move(value),
                            {},
                            each.error});
    }
    return all;
}

class device_rows_reader {
public:
    device_rows_reader(std::string const& path, saved_text const& text, named_places const& names)
        : path_{path}, text_{text}, names_{names}
    {}

    device_settings run()
    {
        if (auto const fault = text_.fault ? text_.fault : why_no_whole_backup(text_)) {
            refuse(fault->place, fault->sentence);
        }
        for (auto const& [name, value] : text_.head) {
            if (name == "drive") {
                refuse(value.place, "it is of an " + value.text + ", and --device says " + names_.file);
            }
            if (name != "rows") {
                found_.head.emplace_back(name, value.text);
            }
        }
        for (saved_row const& row : text_.rows) {
            take(row);
        }
        std::ranges::sort(found_.values, {}, &device_value::named); // places of one list
        return std::move(found_);
    }

private:
    [[noreturn]] void refuse(text_place place, std::string const& sentence) const
    {
        refuse_word(place_text(path_, place) + sentence);
    }

    named_place const& named_in(saved_row const& row) const
    {
        placed_text const* const name = row.find("register");
        if (name == nullptr) {
            refuse(row.place, "this row has no 'register'");
        }
        named_place const* const named = names_.by_name(name->text);
        if (named == nullptr) {
            std::vector<std::string_view> known;
            for (named_place const& each : names_.places) {
                known.push_back(each.where.name);
            }
            refuse(name->place,
                   "'" + name->text + "' is no register of " + names_.file + suggestion(name->text, known));
        }
        if (not named->is_setting) {
            refuse(name->place, named->where.name + " is no setting: " + names_.file + ":" +
                                    std::to_string(named->line) + " gives it no setting = true");
        }
        placed_text const* const address = row.find("address");
        if (address != nullptr and address->text != std::to_string(named->where.address)) {
            refuse(address->place, named->where.name + " is register " + std::to_string(named->where.address) +
                                       ", not " + address->text);
        }
        if (found_.find(named) != nullptr) {
            refuse(name->place, named->where.name + " stands here a second time");
        }
        return *named;
    }

    void take(saved_row const& row)
    {
        named_place const& named = named_in(row);
        device_value made{&named, {}, {}, row.place};
        placed_text const* const raw = row.find("raw");
        placed_text const* const value = row.find("value");
        if (placed_text const* const error = row.find("error")) {
            if (raw != nullptr or value != nullptr) {
                refuse(error->place, named.where.name + " has both a value and an error");
            }
            made.error = error->text;
        } else if (raw == nullptr and value == nullptr) {
            refuse(row.place, named.where.name + " has no value");
        } else {
            made.place = (raw != nullptr ? raw : value)->place;
            made.words = raw != nullptr ? words_of(named, *raw) : words_of_value(named, row, *value);
        }
        if (raw != nullptr and value != nullptr and made.error.empty()) {
            refuse_contradiction(made, row, *value);
        }
        found_.values.push_back(std::move(made));
    }

    std::vector<std::uint16_t> words_of(named_place const& named, placed_text const& raw) const
    {
        auto words = words_of_raw(named.where, raw.text);
        if (not words) {
            std::size_t const size = named.where.size();
            refuse(raw.place, named.where.name + ": '" + raw.text + "' is no raw count: " +
                                  (size == 1 ? "a whole number from 0 to 65535, of a coil 0 or 1"
                                             : "0x and " + std::to_string(4 * size) + " hexadecimal digits"));
        }
        return *words;
    }

    static std::string typed_text(named_place const& named, std::string const& text)
    {
        bool const is_amount = named.choices.empty() and named.where.form.type != value_type::text;
        return is_amount ? with_point(text) : text;
    }

    std::vector<std::uint16_t> words_of_value(named_place const& named, saved_row const& row,
                                              placed_text const& value) const
    {
        placed_text const* const unit = row.find("unit");
        if (unit != nullptr and unit->text != named.where.form.unit) {
            refuse(unit->place, named.where.name + " is " +
                                    (named.where.form.unit.empty() ? "without unit" : "in " + named.where.form.unit) +
                                    ", not in " + unit->text);
        }
        words_typed typed = words_to_hold(named, typed_text(named, value.text));
        if (not typed.wrong.empty()) {
            refuse(value.place, named.where.name + ": '" + value.text + "': " + typed.wrong);
        }
        return std::move(typed.words);
    }

    void refuse_contradiction(device_value const& made, saved_row const& row, placed_text const& value) const
    {
        std::string const meant = value_to_save(*made.named, made.words).text;
        std::string const typed = typed_text(*made.named, value.text);
        if (not is_same_word(meant, typed) and words_of_value(*made.named, row, value) != made.words) {
            refuse(value.place, made.named->where.name + ": the raw count " + raw_text(made.words) + " is " + meant +
                                    ", not '" + value.text + "'; empty the one of them that is old");
        }
    }

    std::string const& path_;
    saved_text const& text_;
    named_places const& names_;
    device_settings found_{};
};

} // namespace

std::string device_settings::said(std::string_view name) const
{
    auto const found = std::ranges::find(head, name, &std::pair<std::string, std::string>::first);
    return found == head.end() ? std::string{} : found->second;
}

device_value const* device_settings::find(named_place const* named) const noexcept
{
    auto const found = std::ranges::find(values, named, &device_value::named);
    return found == values.end() ? nullptr : &*found;
}

identity_words refuse_another_device(open_line& line, rtuwire::unit_id unit, std::string const& vendor,
                                     std::string const& product)
{
    identity_words who;
    rtuwire::errc const outcome = read_identity(line, unit, who);
    if (status_of(outcome) == exit_status::port) {
        throw ended{exit_status::port, line.port().failure()};
    }
    std::string const why =
        outcome == rtuwire::errc::none ? why_another_device(unit, who, vendor, product) : std::string{};
    if (not why.empty()) {
        refuse_for_safety(why);
    }
    return who;
}

std::vector<device_value> read_settings(open_line& line, named_unit const& unit,
                                        std::vector<named_place const*> const& wanted)
{
    std::vector<chosen_register> registers;
    for (named_place const* const each : wanted) {
        registers.push_back({each->where, nullptr, each});
    }
    register_reader reader{registers, {nullptr, unit.names}};
    reader.read(line, unit.unit);
    if (reader.first_error() != rtuwire::errc::none and not rtuwire::is_exception(reader.first_error())) {
        throw ended{status_of(reader.first_error()),
                    "unit " + std::to_string(unit.unit.byte()) + ": " + reader.first_failure() + "; nothing is kept"};
    }
    std::vector<device_value> values;
    for (named_place const* const each : wanted) {
        held_words const& held = reader.held(each->where);
        values.push_back({each, held.words, held.failure, {}});
    }
    return values;
}

device_settings device_settings_of(open_line& line, named_unit const& unit, std::string const& port)
{
    if (unit.names == nullptr) {
        refuse_word("unit " + std::to_string(unit.unit.byte()) + ": nobody says which register file it has");
    }
    named_places const& names = *unit.names;
    std::vector<named_place const*> wanted;
    for (named_place const& each : names.places) {
        if (each.is_setting) {
            wanted.push_back(&each);
        }
    }
    if (wanted.empty()) {
        refuse_word(names.file + ": no register of it says setting = true");
    }
    identity_words const who = refuse_another_device(line, unit.unit, names.vendor, names.product);
    device_settings read;
    read.values = read_settings(line, unit, wanted);
    if (std::ranges::all_of(read.values, [](device_value const& each) { return each.words.empty(); })) {
        throw ended{exit_status::differs, "unit " + std::to_string(unit.unit.byte()) +
                                              " has told none of the settings of " + names.file + "; nothing is kept"};
    }
    for (device_value& each : read.values) {
        if (not each.words.empty() and is_no_value(*each.named, each.words)) {
            each.words.clear();
            each.error = "no value";
        }
    }
    read.head = {{"format", "rtuwire backup 1"},
                 {"made by", "rtuwire " RTUWIRE_TOOL_VERSION},
                 {"time", time_of_backup()},
                 {"port", port},
                 {"unit", std::to_string(unit.unit.byte())},
                 {"device", names.file.substr(names.file.rfind('/') + 1)},
                 {"vendor", who.vendor},
                 {"product", who.product},
                 {"revision", who.revision}};
    return read;
}

device_settings device_settings_of_file(std::string const& path, named_places const& names)
{
    return device_rows_reader{path, saved_text_of_file(path), names}.run();
}

std::string text_of(device_value const& value)
{
    return value.words.empty() ? value.error : value_of(*value.named, value.words).text;
}

std::string json_text_of(device_settings const& settings) { return json_text_of(rows_of(settings)); }
std::string csv_text_of(device_settings const& settings) { return csv_text_of(rows_of(settings)); }

} // namespace tool
