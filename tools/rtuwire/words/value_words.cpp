// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/value_words.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include <rtuwire/frames.hpp>

#include "catalog/named_values.hpp"
#include "catalog/register_limits.hpp"
#include "catalog/value_text.hpp"
#include "words/amount_words.hpp"
#include "words/named_value.hpp"
#include "words/place_value.hpp"
#include "words/register_words.hpp"

namespace tool {

namespace {

/// One check of one word. Each part refuses, or leaves a count behind.
class value_check {
public:
    value_check(std::string_view word, vocabulary const& meant, known_words const& known)
        : word_{word}, drive_{meant.drive}, names_{meant.names}, known_{known}
    {}

    [[nodiscard]] value_to_write run()
    {
        std::size_t const equals = word_.find('=');
        if (equals == word_.npos or equals + 1 == word_.size()) {
            refuse("no_value", "a value is written as REG=VALUE: ACC=1.3s");
        } else if (find_register(word_.substr(0, equals))) {
            std::string_view const text = trimmed(word_.substr(equals + 1));
            if (drive_ == nullptr) {
                static_cast<void>(read_formed(text));
            } else if (read_count(text) and count_) {
                check_count();
            }
        }
        return std::move(found_);
    }

private:
    static std::string_view trimmed(std::string_view text) noexcept
    {
        text.remove_prefix((std::min)(text.find_first_not_of(' '), text.size()));
        return text.substr(0, text.find_last_not_of(' ') + 1);
    }

    bool refuse(std::string kind, std::string const& sentence, std::string nearest = {})
    {
        std::string text = std::string{word_} + ": " + sentence;
        text += nearest.empty() ? "" : "; did you mean " + nearest + "?";
        found_.refused = refusal{std::move(kind), std::string{word_}, std::move(text), std::move(nearest)};
        return false;
    }

    bool find_register(std::string_view name)
    {
        is_by_address_ = not name.empty() and (is_digit(name[0]) or is_place_word(name));
        register_selection const chosen = select_registers(std::span{&name, 1}, {drive_, names_});
        if (chosen.refused) {
            found_.refused = chosen.refused;
            return false;
        }
        if (chosen.registers.size() != 1) {
            return refuse("several_registers", "a value goes to one register");
        }
        found_.where = chosen.registers[0].where;
        found_.entry = chosen.registers[0].entry;
        if (found_.where.bit >= 0 and drive_ != nullptr) {
            return refuse("single_bit", "a register is written as a whole: name all its bits that shall be 1, as in "
                                        "CMD=switch_on+quick_stop");
        }
        if (found_.where.space == register_space::input or found_.where.space == register_space::discrete) {
            return refuse("read_only", "input registers and discrete inputs are read only");
        }
        if (drive_ != nullptr and
            (found_.where.space != register_space::holding or found_.where.form.registers() > 1)) {
            return refuse("not_of_a_drive", "an " + std::string{drive_->name} +
                                                " has holding registers only, which are written one at a time, each "
                                                "checked by what is known of it");
        }
        if (found_.entry != nullptr and not found_.entry->is_writable()) {
            return refuse("read_only", std::string{found_.entry->code} + " is read only");
        }
        if (found_.where.form.registers() > rtuwire::max_write_quantity) {
            return refuse("too_long", "a request writes at most " + std::to_string(rtuwire::max_write_quantity) +
                                          " registers, of a text " + std::to_string(2 * rtuwire::max_write_quantity) +
                                          " characters");
        }
        return check_name(name) and (found_.entry == nullptr or check_form(*found_.entry));
    }

    /// What a register file says of a place counts by whatever words it is meant.
    bool check_name(std::string_view typed)
    {
        found_.named = names_ == nullptr ? nullptr : names_->by_name(typed);
        named_place const* const met =
            found_.named != nullptr or names_ == nullptr ? found_.named : names_->overlapping(found_.where);
        if (met == nullptr) {
            return true;
        }
        if (not met->is_writable) {
            return refuse("read_only", met->where.name + " is read only: " + names_->file + ":" +
                                           std::to_string(met->line) + " gives it no access = \"write\"");
        }
        return found_.named != nullptr or refuse("wrong_place", "this is " + met->where.name + " of " + names_->file +
                                                                    ", which has a form and limits: say that name");
    }

    /// What a drive's register is, its table says: a form may not contradict it.
    bool check_form(register_entry const& entry)
    {
        value_form const& form = found_.where.form;
        bool const has_scale =
            form.factor != short_decimal{1, 0} or form.offset != short_decimal{} or not form.unit.empty();
        bool const is_signed = entry.kind == register_kind::signed_number;
        bool const has_its_sign = form.type == (is_signed ? value_type::i16 : value_type::u16) or
                                  form.type == value_type::none or form.type == value_type::hex or
                                  form.type == value_type::bits;
        if (not has_scale and has_its_sign and (form.order.empty() or form.order == "abcd")) {
            return true;
        }
        return refuse("wrong_form", "this is " + std::string{entry.code} + " (" + std::string{entry.name} + "), " +
                                        (is_signed ? "a number that may be below 0" : "no number below 0") +
                                        (entry.unit.empty() ? "" : ", in " + std::string{entry.unit}) +
                                        ", and its drive says its scale: leave out '" + form.said + '\'');
    }

    /// Leaves the words that a text stands for by the form of its place, or refuses.
    bool read_formed(std::string_view text)
    {
        words_typed typed = found_.named != nullptr ? words_for(*found_.named, text) : words_for(found_.where, text);
        if (not typed.wrong.empty()) {
            return refuse("not_a_number", typed.wrong);
        }
        found_.words = std::move(typed.words);
        count_ = typed.count;
        bool const is_plain = count_ and found_.where.form.said.empty() and found_.named == nullptr;
        found_.text = is_plain ? std::to_string(*count_) : found_.text_of_words(found_.words);
        return true;
    }

    /// The same of a drive's register: the count, as its table has it. A number below zero is none of a register without a
    /// sign.
    bool read_formed_count(std::string_view text)
    {
        if (not read_formed(text)) {
            return false;
        }
        std::uint16_t const word = found_.words[0];
        count_ = count_ ? *count_ : found_.entry != nullptr ? found_.entry->count_of(word) : word;
        found_.where.form = found_.entry != nullptr ? value_form{} : found_.where.form;
        return true;
    }

    /// Leaves the count that a text stands for, or refuses; or needs the register that sets the step.
    bool read_count(std::string_view text)
    {
        register_entry const* const entry = found_.entry;
        if (not found_.where.form.said.empty()) {
            return read_formed_count(text);
        }
        bool const is_hex = text.starts_with("0x") or text.starts_with("0X");
        if (entry == nullptr or is_hex or text.starts_with('#')) {
            return read_raw(text, is_hex);
        }
        if (entry->is_amount()) {
            return read_steps(text);
        }
        named_reading const named = read_named(*entry, text);
        count_ = named.word;
        return named.word or refuse(named.kind, named.sentence, named.nearest);
    }

    bool read_raw(std::string_view text, bool is_hex)
    {
        std::string_view digits = text.substr(text.starts_with('#') ? 1 : 0);
        auto const hex = is_hex ? word_number(digits) : std::nullopt;
        std::int32_t number = 0;
        auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        bool const is_whole = error == std::errc{} and end == digits.data() + digits.size();
        if (is_hex ? not hex : not is_whole or number < -32'768 or number > 65'535) {
            return refuse("not_a_number", found_.entry == nullptr
                                              ? "no table knows this register, so its value is a whole number from "
                                                "-32768 to 65535, or 0x0000 to 0xFFFF"
                                              : "a raw count is a whole number from -32768 to 65535, or 0x0000 to "
                                                "0xFFFF");
        }
        count_ = is_hex ? (found_.entry != nullptr ? found_.entry->count_of(*hex) : *hex) : number;
        return true;
    }

    /// The step of an amount; nothing where it is not known.
    std::optional<step_size> find_step(register_entry const& entry)
    {
        auto const set_by = entry.steps_set_by.empty() ? nullptr : drive_->by_code(entry.steps_set_by);
        auto const setting = set_by != nullptr and known_ ? known_(set_by->code) : std::nullopt;
        step_ = step_of(entry, *drive_, setting);
        return step_;
    }

    bool read_steps(std::string_view text)
    {
        register_entry const& entry = *found_.entry;
        typed_amount const typed = read_amount(text, entry.unit);
        switch (typed.fault) {
        case amount_fault::none: break;
        case amount_fault::decimal_comma: return refuse("decimal_comma", decimal_comma_text);
        case amount_fault::too_many_digits: return refuse("not_a_number", "more than 15 digits");
        case amount_fault::wrong_unit: return refuse_unit(typed.unit);
        case amount_fault::not_a_number:
            return refuse("not_a_number", std::string{entry.code} + " takes a number" +
                                              (entry.unit.empty() ? "" : ", in " + units_for(entry.unit)) +
                                              ", or 0x0000 to 0xFFFF");
        }
        if (is_by_address_ and typed.unit.empty() and has_scale(entry)) {
            return refuse_bare_number(text);
        }
        auto const step = find_step(entry);
        if (not step) {
            register_entry const* const set_by = drive_->by_code(entry.steps_set_by);
            auto const setting = known_ ? known_(set_by->code) : std::nullopt;
            if (setting) {
                return refuse("unknown_step", std::string{set_by->code} + " holds " + text_of(*set_by, *setting) +
                                                  ", which is no step that is known");
            }
            found_.needed.push_back(set_by);
            return true;
        }
        std::int64_t const below = typed.amount.counts_below(*step);
        std::int64_t const above = typed.amount.counts_above(*step);
        count_ = below;
        if (below != above and below >= entry.lowest_count() and above <= entry.highest_count()) {
            return refuse("value_between_steps", "not a whole number of steps of " + amount_text(1, *step, entry.unit) +
                                                     ": " + amount_text(below, *step, entry.unit) + " or " +
                                                     amount_text(above, *step, entry.unit));
        }
        count_ = below < entry.lowest_count() ? below : above;
        if (count_ == 0 and text.starts_with('-') and entry.lowest_count() < 0) {
            return refuse("zero_with_a_sign",
                          "a register's 0 has no sign: the least below it is " + amount_text(-1, *step, entry.unit));
        }
        return true;
    }

    /// Whether a count of it is something else than the number that a person reads.
    static bool has_scale(register_entry const& entry) noexcept
    {
        return not entry.unit.empty() or not entry.steps_set_by.empty() or
               entry.step.numerator != entry.step.denominator;
    }

    /// Whoever reads raw counts at an address may write them there: ten times the value, if it counted in the unit.
    bool refuse_bare_number(std::string_view number)
    {
        register_entry const& entry = *found_.entry;
        std::string_view const name = word_.substr(0, word_.find('='));
        std::string const typed = name == entry.menu ? std::string{name} : std::to_string(entry.address);
        std::string const address = typed + "=";
        std::string const raw{word_number(number) ? number : "1"};
        auto const hex = word_number(raw);
        std::string const with_unit = entry.unit.empty() ? std::string{entry.code} + "=" + std::string{number}
                                                         : address + std::string{number} + std::string{entry.unit};
        return refuse("unit_missing", typed + " is " + std::string{entry.code} + " (" + std::string{entry.name} +
                                          "): say " + with_unit + ", or a raw count, " + address + "#" + raw +
                                          (hex ? " or " + address + hex_word(*hex) : ""));
    }

    bool refuse_unit(std::string_view unit)
    {
        register_entry const& entry = *found_.entry;
        if (entry.unit.empty()) {
            return refuse("wrong_unit", std::string{entry.code} + " is a plain number and has no unit");
        }
        std::string sentence =
            std::string{entry.code} + " is in " + units_for(entry.unit) + ", not in " + std::string{unit};
        for (std::uint16_t const other : {drive_->speed_reference, drive_->frequency_reference}) {
            register_entry const* const reference = drive_->at(other);
            bool const is_reference =
                entry.address == drive_->speed_reference or entry.address == drive_->frequency_reference;
            if (is_reference and other != entry.address and reference != nullptr and
                read_amount("1" + std::string{unit}, reference->unit).fault == amount_fault::none) {
                return refuse("wrong_unit", sentence,
                              std::string{reference->code} + word_.data()[word_.find('=')] +
                                  std::string{word_.substr(word_.find('=') + 1)});
            }
        }
        return refuse("wrong_unit", sentence);
    }

    void check_count();
    bool check_limits(register_entry const& entry);

    std::string_view word_;
    bool is_by_address_{false};
    drive_catalog const* drive_;
    named_places const* names_;
    known_words const& known_;
    value_to_write found_{};
    std::optional<std::int64_t> count_{};
    std::optional<step_size> step_{};
};

bool value_check::check_limits(register_entry const& entry)
{
    step_size const step = step_ ? *step_ : entry.step;
    for (bool const is_highest : {false, true}) {
        register_limit const limit =
            is_highest ? highest_of(entry, *drive_, known_) : lowest_of(entry, *drive_, known_);
        if (limit.count and limit.is_absurd) {
            return refuse("absurd_limit", std::string{entry.code} + " is limited by " + limit.set_by +
                                              ", and what that holds is no value that it can have: " +
                                              limits_text(entry, step, known_, *drive_));
        }
        std::int64_t const widest = is_highest ? entry.highest_count() : entry.lowest_count();
        for (std::int64_t const end : {widest, limit.count ? std::int64_t{*limit.count} : widest}) {
            if (is_highest ? *count_ > end : *count_ < end) {
                return refuse(is_highest ? "value_too_high" : "value_too_low",
                              std::string{entry.code} + " takes " + limits_text(entry, step, known_, *drive_));
            }
        }
        if (not limit.count) {
            for (register_entry const* each : limit.needed) {
                bool const is_listed =
                    std::find(found_.needed.begin(), found_.needed.end(), each) != found_.needed.end();
                found_.needed.insert(found_.needed.end(), is_listed ? 0 : 1, each);
            }
        }
    }
    return true;
}

void value_check::check_count()
{
    if (register_entry const* const entry = found_.entry; entry != nullptr) {
        if (not check_limits(*entry)) {
            return;
        }
        if (*count_ >= entry->gap_first and *count_ <= entry->gap_last) {
            bool const is_one = entry->gap_first == entry->gap_last;
            std::string const range = number_text(entry->gap_first, entry->step) + " to " +
                                      amount_text(entry->gap_last, entry->step, entry->unit);
            auto const only = static_cast<std::uint16_t>(entry->gap_first);
            refuse("value_never_written",
                   (is_one ? text_of(*entry, only) : range) + " is never written to " + std::string{entry->code});
            return;
        }
        if (not has_meaning(*entry, static_cast<std::uint16_t>(*count_))) {
            refuse("value_without_meaning", std::string{entry->code} + " takes " + list_of_values(*entry));
            return;
        }
    }
    found_.words = {static_cast<std::uint16_t>(*count_)};
    if (found_.entry != nullptr) {
        // A raw count has no step yet. Where that cannot be read, it is written all the same, and shown as a count.
        if (not step_ and not find_step(*found_.entry) and not known_) {
            found_.needed.push_back(drive_->by_code(found_.entry->steps_set_by));
        }
        found_.step = step_;
    }
    bool const is_plain = found_.entry == nullptr and found_.where.form.said.empty();
    found_.text = is_plain ? std::to_string(*count_) : found_.text_of_words(found_.words);
}

} // namespace

std::string value_to_write::text_of_words(std::span<std::uint16_t const> held) const
{
    if (entry != nullptr) {
        return step ? full_text(*entry, held[0], *step) : std::to_string(entry->count_of(held[0])) + " steps";
    }
    if (named != nullptr) {
        return value_of(*named, held).text;
    }
    bool const is_plain = where.form.said.empty() and not where.is_single_bit() and where.bit < 0;
    return is_plain ? std::to_string(held[0]) : value_of(where, held).text;
}

bool value_to_write::is_held_by(std::span<std::uint16_t const> held) const
{
    return where.bit < 0 ? std::ranges::equal(held, words) : (held[0] & where.mask()) == words[0];
}

value_to_write check_value(std::string_view word, vocabulary const& meant, known_words const& known)
{
    return value_check{word, meant, known}.run();
}

} // namespace tool
