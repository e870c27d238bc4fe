// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "backup/restore_record.hpp"

#include <algorithm>

#include "line/open_line.hpp"

namespace tool {

void restore_record::note(register_entry const& entry, rtuwire::altivar::restore_report const& what)
{
    auto const [place, is_new] = places_.emplace(entry.address, parameters_.size());
    if (is_new) {
        parameters_.push_back({&entry});
    }
    restored_parameter* known = &parameters_[place->second];
    if (not is_write(what.outcome) and what.held and not known->was_written) {
        known->before = what.held;
    }
    // What is to be written stands where it comes, behind all that came before it.
    bool const is_step =
        what.outcome == restore_outcome::planned or (is_write(what.outcome) and not known->was_written);
    if (is_step and place->second + 1 != parameters_.size()) {
        std::rotate(parameters_.begin() + static_cast<std::ptrdiff_t>(place->second),
                    parameters_.begin() + static_cast<std::ptrdiff_t>(place->second) + 1, parameters_.end());
        for (std::size_t i = place->second; i < parameters_.size(); ++i) {
            places_[parameters_[i].entry->address] = i;
        }
        known = &parameters_.back();
    }
    known->was_written = known->was_written or is_write(what.outcome);
    known->last = what;
}

std::size_t restore_record::left_out() const noexcept
{
    return static_cast<std::size_t>(
        std::ranges::count_if(parameters_, [](auto const& each) { return needs_option(each.last.outcome); }));
}

restored_parameter const* restore_record::find(std::string_view code) const noexcept
{
    auto const found = std::ranges::find_if(parameters_, [code](auto const& each) { return each.entry->code == code; });
    return found == parameters_.end() ? nullptr : &*found;
}

std::size_t restore_record::count(restore_outcome outcome) const noexcept
{
    return static_cast<std::size_t>(
        std::ranges::count_if(parameters_, [outcome](auto const& each) { return each.last.outcome == outcome; }));
}

bool is_write(restore_outcome outcome) noexcept
{
    return outcome == restore_outcome::written or outcome == restore_outcome::not_read_back or
           outcome == restore_outcome::confirmed or outcome == restore_outcome::unconfirmed or
           outcome == restore_outcome::differs;
}

bool is_worth_a_line(restored_parameter const& of, saved_settings const& wanted) noexcept
{
    switch (of.last.outcome) {
    case restore_outcome::planned:
    case restore_outcome::written:
    case restore_outcome::not_read_back:
    case restore_outcome::confirmed:
    case restore_outcome::unconfirmed:
    case restore_outcome::differs:
    case restore_outcome::refused:
    case restore_outcome::unreadable:
    case restore_outcome::not_reached:
    case restore_outcome::other_steps:
    case restore_outcome::out_of_limits: return true;
    case restore_outcome::holds: return of.was_written;
    case restore_outcome::not_wanted:
    case restore_outcome::never_written: return false;
    case restore_outcome::needs_channels:
    case restore_outcome::needs_link:
    case restore_outcome::needs_inferred:
    case restore_outcome::needs_supervision:
    case restore_outcome::needs_autorestart: return of.last.held != wanted.word_of(of.entry->code);
    }
    return true;
}

std::string sentence_of(rtuwire::altivar::reason const& why)
{
    if (why.kind == rtuwire::altivar::outcome_kind::silent and why.error == rtuwire::errc::timed_out) {
        return words_of(why.error);
    }
    std::string const text{std::string_view{name_of(why.kind)}};
    return why.error == rtuwire::errc::none ? text : text + ": " + words_of(why.error);
}

} // namespace tool
