// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/reading.hpp"

#include "catalog/value_text.hpp"
#include "words/named_value.hpp"

namespace tool {

namespace {

register_value value_of(register_entry const& entry, std::uint16_t word, register_reader const& from,
                        drive_catalog const& drive)
{
    auto const setting = entry.steps_set_by.empty() ? std::nullopt : from.known()(entry.steps_set_by);
    return value_of(entry, word, step_of(entry, drive, setting));
}

/// Whether the drive's table says what it is: a form that was typed goes before.
bool is_named(chosen_register const& which) { return which.entry != nullptr and which.where.form.said.empty(); }

/// A unit without function 03 may have what was meant as input registers.
std::string hint_at_inputs(chosen_register const& which, rtuwire::errc why)
{
    bool const may_be_input = why == rtuwire::errc::illegal_function and which.entry == nullptr and
                              which.where.space == register_space::holding;
    return may_be_input ? "; input:" + std::to_string(which.where.address) + " asks by function 04" : std::string{};
}

} // namespace

std::string hint_at_list(chosen_register const& which, rtuwire::errc why)
{
    place const& where = which.where;
    bool const may_be_listed =
        why == rtuwire::errc::illegal_data_address and which.entry == nullptr and not where.is_space_said;
    std::string const listed = may_be_listed ? list_hint(where.address) : std::string{};
    return listed.empty() ? listed : "; " + listed;
}

std::string label_of(chosen_register const& which)
{
    place const& where = which.where;
    if (not is_named(which)) {
        return text_of(where);
    }
    std::string const code{which.entry->code};
    if (where.bit < 0) {
        return code;
    }
    std::string const name{where.last_bit < 0 ? which.entry->bits[static_cast<std::size_t>(where.bit)] : ""};
    std::string const last = where.last_bit < 0 ? std::string{} : '-' + std::to_string(where.last_bit);
    return code + '.' + (name.empty() ? std::to_string(where.bit) + last : name);
}

bool has_measure(chosen_register const& which)
{
    bool const is_amount = is_named(which) and which.where.bit < 0 and which.entry->is_amount();
    return is_amount ? not which.entry->unit.empty() : not which.where.form.unit.empty();
}

reading reading_of(chosen_register const& which, register_reader const& from, drive_catalog const* drive)
{
    place const& where = which.where;
    held_words const& held = from.held(where);
    reading it{label_of(which), held.why == rtuwire::errc::none, {}, {}, {}, held.failure};
    if (not it.is_read) {
        it.text += hint_at_list(which, held.why) + hint_at_inputs(which, held.why);
        return it;
    }
    it.raw = held.words.size() == 1 ? cell{std::int64_t{held.words[0]}} : cell{hex_words(held.words)};
    if (is_named(which) and where.bit < 0 and drive != nullptr) {
        register_value const found = value_of(*which.entry, held.words[0], from, *drive);
        it.value = found.value;
        it.measure = found.measure;
        it.text = found.text;
    } else {
        formed_value const formed =
            which.named != nullptr ? value_of(*which.named, held.words) : value_of(where, held.words);
        it.value = formed.value;
        it.text = formed.text;
        it.measure = where.form.unit;
    }
    return it;
}

} // namespace tool
