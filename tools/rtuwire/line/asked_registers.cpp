// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/asked_registers.hpp"

#include <algorithm>
#include <string_view>

#include "line/who_is_it.hpp"

namespace tool {

void refuse(refusal const& why) { refuse_word(why.sentence); }

std::vector<chosen_register> registers_in(std::vector<std::string> const& words, drive_catalog const* drive)
{
    std::vector<std::string_view> const views{words.begin(), words.end()};
    register_selection selection = select_registers(views, drive);
    if (selection.refused) {
        refuse(*selection.refused);
    }
    return std::move(selection.registers);
}

asked_registers registers_asked(choices const& chosen, open_line& line)
{
    named_unit const unit = unit_in(chosen.line);
    std::vector<std::string_view> const views{chosen.words.begin(), chosen.words.end()};
    bool const has_numbers_only = not select_registers(views, nullptr).refused;
    drive_catalog const* drive = nullptr;
    if (not unit.drive.empty()) {
        drive = &catalog_chosen(unit.drive);
    } else if (not has_numbers_only) {
        drive = &catalog_of(line, unit.unit, {});
    }
    return {unit, drive, registers_in(chosen.words, drive)};
}

} // namespace tool
