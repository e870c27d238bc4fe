// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/reading.hpp"

#include "catalog/value_text.hpp"

namespace tool {

namespace {

/// Fills in what a whole number of steps is.
void measure(reading& it, register_entry const& entry, std::uint16_t word, std::optional<step_size> step)
{
    std::int32_t const count = entry.count_of(word);
    if (not step) {
        it.text = std::to_string(count) + " steps of a size that " + std::string{entry.steps_set_by} + " sets";
        return;
    }
    it.value =
        static_cast<double>(count) * static_cast<double>(step->numerator) / static_cast<double>(step->denominator);
    it.measure = std::string{entry.unit};
    it.text = full_text(entry, word, *step);
}

void show_bit(reading& it, int bit, std::uint16_t word)
{
    bool const is_set = (word >> bit & 1) != 0;
    it.value = is_set;
    it.text = is_set ? "1" : "0";
}

void explain(reading& it, chosen_register const& which, std::uint16_t word, register_reader const& from,
             drive_catalog const& drive)
{
    register_entry const& entry = *which.entry;
    if (entry.is_amount()) {
        auto const setting = entry.steps_set_by.empty() ? std::nullopt : from.known()(entry.steps_set_by);
        measure(it, entry, word, step_of(entry, drive, setting));
    } else {
        it.text = full_text(entry, word);
        it.value = entry.kind == register_kind::bits ? cell{std::int64_t{word}} : cell{text_of(entry, word)};
    }
}

} // namespace

std::string label_of(chosen_register const& which)
{
    if (which.entry == nullptr) {
        return std::to_string(which.address) + (which.bit < 0 ? "" : "." + std::to_string(which.bit));
    }
    std::string const code{which.entry->code};
    if (which.bit < 0) {
        return code;
    }
    std::string const name{which.entry->bits[static_cast<std::size_t>(which.bit)]};
    return code + '.' + (name.empty() ? std::to_string(which.bit) : name);
}

reading reading_of(chosen_register const& which, register_reader const& from, drive_catalog const* drive)
{
    reading it{label_of(which), from.at(which.address), {}, {}, {}};
    if (not it.word) {
        it.text = from.why_not(which.address);
    } else if (which.bit >= 0) {
        show_bit(it, which.bit, *it.word);
    } else if (which.entry != nullptr and drive != nullptr) {
        explain(it, which, *it.word, from, *drive);
    } else {
        it.value = std::int64_t{*it.word};
        it.text = std::to_string(*it.word) + " (" + hex_word(*it.word) + ')';
    }
    return it;
}

} // namespace tool
