// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/entry_words.hpp"

#include <algorithm>

#include "catalog/value_text.hpp"

namespace tool {

std::string amount_of(std::int64_t count, register_entry const& entry, drive_catalog const& drive)
{
    auto const step = step_of(entry, drive);
    return entry.is_amount() and step ? amount_text(count, *step, entry.unit)
           : entry.is_amount()        ? std::to_string(count) + " steps"
                                      : std::to_string(count);
}

std::string default_text(std::int32_t count, register_entry const& entry, drive_catalog const& drive)
{
    return entry.is_amount() ? amount_of(count, entry, drive) : text_of(entry, static_cast<std::uint16_t>(count));
}

std::string limit_text(rtuwire::bound const& limit, register_entry const& entry, drive_catalog const& drive)
{
    return limit.is_number() ? amount_of(limit.raw(), entry, drive) : text_of_bound(limit);
}

std::string note_on(register_entry const& entry, drive_catalog const& drive)
{
    std::string note;
    if (not entry.steps_set_by.empty()) {
        note = "steps set by " + std::string{entry.steps_set_by};
    }
    if (entry.gap_first <= entry.gap_last) {
        note += (note.empty() ? "never " : "; never ") + amount_of(entry.gap_first, entry, drive) + " to " +
                amount_of(entry.gap_last, entry, drive);
    }
    return note;
}

bool has_menu(drive_catalog const& drive) noexcept
{
    return std::ranges::any_of(drive.registers, [](register_entry const& each) { return not each.menu.empty(); });
}

std::string code_and_menu(register_entry const& entry)
{
    std::string const code{entry.code};
    return entry.menu.empty() ? code : code + " (" + std::string{entry.menu} + ")";
}

} // namespace tool
