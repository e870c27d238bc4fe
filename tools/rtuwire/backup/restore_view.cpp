// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "backup/restore_view.hpp"

#include <algorithm>

#include "catalog/entry_words.hpp"
#include "catalog/value_text.hpp"
#include "line/open_line.hpp"

namespace tool {

std::string restore_view::wanted_text(register_entry const& entry, std::uint16_t word) const
{
    return full_text_in(entry, word, *wanted_.drive, wanted_.word_of(entry.steps_set_by));
}

std::string restore_view::held_text(register_entry const& entry, std::uint16_t word, restore_record const& among) const
{
    restored_parameter const* const steps = among.find(entry.steps_set_by);
    return full_text_in(entry, word, *wanted_.drive, steps == nullptr ? std::nullopt : before_of(*steps));
}

std::optional<std::uint16_t> restore_view::before_of(restored_parameter const& of) const
{
    restored_parameter const* const planned = plan_ == nullptr ? nullptr : plan_->find(of.entry->code);
    return planned == nullptr ? of.before : planned->before;
}

record restore_view::row_of(restored_parameter const& of, restore_record const& among, rtuwire::unit_id unit,
                            output_form form) const
{
    register_entry const& entry = *of.entry;
    auto const before = before_of(of);
    auto const wanted = wanted_.word_of(entry.code);
    bool const is_written = of.was_written and of.last.outcome == restore_outcome::holds;
    std::string outcome{is_written ? std::string_view{"written and read back"}
                                   : std::string_view{name_of(of.last.outcome)}};
    outcome += of.last.error == rtuwire::errc::none ? "" : ": " + words_of(of.last.error);
    return {{"unit", std::int64_t{unit.byte()}},
            {"register", form == output_form::table ? code_and_menu(entry) : std::string{entry.code}},
            {"held", before ? cell{held_text(entry, *before, among)} : cell{}},
            {"wanted", wanted ? cell{wanted_text(entry, *wanted)} : cell{}},
            {"outcome", outcome},
            {"note", std::string{std::string_view{rtuwire::altivar::why(*entry.row)}}}};
}

std::string changed_steps(restore_record const& of)
{
    for (restored_parameter const& each : of.parameters()) {
        restored_parameter const* const steps = of.find(each.entry->steps_set_by);
        if (steps != nullptr and steps->was_written and each.last.outcome == restore_outcome::not_reached) {
            return std::string{each.entry->code} + " now counts in other steps, as " + std::string{steps->entry->code} +
                   " says: restore again before the motor runs";
        }
    }
    return {};
}

bool is_bad(restore_outcome outcome) noexcept
{
    switch (outcome) {
    case restore_outcome::refused:
    case restore_outcome::differs:
    case restore_outcome::confirmed:
    case restore_outcome::unconfirmed:
    case restore_outcome::not_reached:
    case restore_outcome::out_of_limits:
    case restore_outcome::unreadable:
    case restore_outcome::other_steps: return true;
    case restore_outcome::holds:
    case restore_outcome::planned:
    case restore_outcome::written:
    case restore_outcome::not_read_back:
    case restore_outcome::not_wanted:
    case restore_outcome::never_written:
    case restore_outcome::needs_channels:
    case restore_outcome::needs_link:
    case restore_outcome::needs_inferred:
    case restore_outcome::needs_supervision:
    case restore_outcome::needs_autorestart: break;
    }
    return false;
}

std::string counts_text(restore_record const& of)
{
    auto const written =
        static_cast<std::size_t>(std::ranges::count_if(of.parameters(), &restored_parameter::was_written));
    auto const part = [](std::size_t count, char const* words) { return std::to_string(count) + " " + words; };
    return part(written, "written, ") + part(of.count(restore_outcome::planned), "to be written, ") +
           part(of.count(restore_outcome::holds), "held, ") + part(of.left_out(), "left out, ") +
           part(of.count(restore_outcome::not_wanted), "not in the file, ") +
           part(of.count(restore_outcome::never_written), "never written by a restore");
}

} // namespace tool
