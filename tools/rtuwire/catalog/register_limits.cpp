// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/register_limits.hpp"

#include <algorithm>

#include "catalog/value_text.hpp"

namespace tool {

namespace {

/// What a register holds now, as a count. A name that the drive does not have sets nothing.
std::optional<std::int32_t> count_of(register_entry const& entry, known_words const& known)
{
    auto const word = known ? known(entry.code) : std::nullopt;
    return word ? std::optional{entry.count_of(*word)} : std::nullopt;
}

/// Whether a register holds what its table does not allow for it. A frequency that no table limits is one that the
/// drive's own reference can reach.
bool is_absurd(register_entry const& entry, std::int32_t count, drive_catalog const& drive)
{
    std::int32_t highest = entry.highest_count();
    register_entry const* const reference = drive.at(drive.frequency_reference);
    bool const is_frequency = reference != nullptr and entry.unit == reference->unit and
                              entry.step.numerator == reference->step.numerator and
                              entry.step.denominator == reference->step.denominator;
    if (is_frequency) {
        highest = std::min(highest, reference->highest_count());
    }
    return count < entry.lowest_count() or count > highest;
}

register_limit limit_of(rtuwire::bound const& limit, std::int32_t widest, drive_catalog const& drive,
                        known_words const& known)
{
    if (limit.is_open() or limit.is_number()) {
        return {widest};
    }
    register_limit found{.count = std::nullopt, .set_by = text_of_bound(limit)};
    std::optional<std::int32_t> values[2]{{}, 1};
    std::string_view const codes[2]{limit.code(), limit.factor()};
    for (std::size_t i = 0; i < 2; ++i) {
        register_entry const* const entry = codes[i].empty() ? nullptr : drive.by_code(codes[i]);
        if (entry != nullptr) {
            found.needed.push_back(entry);
            values[i] = count_of(*entry, known);
            found.is_absurd = found.is_absurd or (values[i] and is_absurd(*entry, *values[i], drive));
        }
    }
    if (values[0] and values[1]) {
        found.count = limit.with(*values[0], *values[1]);
    }
    return found;
}

std::string end_text(register_limit const& limit, register_entry const& entry, step_size step)
{
    if (not limit.count) {
        return limit.set_by;
    }
    std::string const text =
        entry.is_amount() ? amount_text(*limit.count, step, entry.unit) : std::to_string(*limit.count);
    return limit.set_by.empty() ? text : text + " (" + limit.set_by + ")";
}

} // namespace

register_limit lowest_of(register_entry const& entry, drive_catalog const& drive, known_words const& known)
{
    return limit_of(entry.min, entry.lowest_count(), drive, known);
}

register_limit highest_of(register_entry const& entry, drive_catalog const& drive, known_words const& known)
{
    return limit_of(entry.max, entry.highest_count(), drive, known);
}

std::string limits_text(register_entry const& entry, step_size step, known_words const& known,
                        drive_catalog const& drive)
{
    return end_text(lowest_of(entry, drive, known), entry, step) + " to " +
           end_text(highest_of(entry, drive, known), entry, step);
}

} // namespace tool
