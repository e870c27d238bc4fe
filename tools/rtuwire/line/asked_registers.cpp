// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/asked_registers.hpp"

#include <algorithm>
#include <string_view>

#include "line/who_is_it.hpp"

namespace tool {

void refuse(refusal const& why) { refuse_word(why.sentence); }

std::vector<chosen_register> registers_in(std::vector<std::string> const& words, vocabulary const& known)
{
    std::vector<std::string_view> const views{words.begin(), words.end()};
    register_selection selection = select_registers(views, known);
    if (selection.refused) {
        refuse(*selection.refused);
    }
    return std::move(selection.registers);
}

namespace {

/// The table of a unit of which numbers are asked for. A number of a drive's menu means another register there than
/// the address, so the unit is asked who it is; null where it is none of the drives.
drive_catalog const* drive_of_numbers(open_line& line, rtuwire::unit_id unit, std::string_view menu_number)
{
    if (menu_number.empty()) {
        return nullptr;
    }
    identity_words const who = who_is_it(line, unit);
    if (not who.drive.empty()) {
        return catalog_named(who.drive);
    }
    if (who.is_another) {
        return nullptr;
    }
    std::string const why = who.note.empty() ? "is a '" + who.product + "' of which kind is not known" : who.note;
    throw ended{who.outcome == exit_status::done ? exit_status::differs : who.outcome,
                "unit " + std::to_string(unit.byte()) + ": " + why + "; " + ambiguity_of(menu_number)};
}

} // namespace

asked_registers registers_asked(choices const& chosen, open_line& line)
{
    named_unit const unit = unit_in(chosen.line);
    std::vector<std::string_view> const views{chosen.words.begin(), chosen.words.end()};
    if (auto const wrong = wrong_place_in(views)) {
        refuse(*wrong);
    }
    bool const has_numbers_only = not select_registers(views, nullptr).refused;
    drive_catalog const* const drive = not unit.drive.empty() ? catalog_or_none(unit.drive)
                                       : has_numbers_only ? drive_of_numbers(line, unit.unit, first_menu_number(views))
                                                          : &catalog_of(line, unit.unit, {});
    return {unit, drive, registers_in(chosen.words, {drive, unit.names})};
}

} // namespace tool
