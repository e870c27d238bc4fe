// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/known_units.hpp"

#include "device/register_file.hpp"
#include "exit_status.hpp"
#include "frame/names_by_file.hpp"
#include "line/asked_units.hpp"
#include "line/line_words.hpp"
#include "line/who_is_it.hpp"

namespace tool {

register_names const* known_units::named_by(drive_catalog const* drive)
{
    return drive == nullptr ? nullptr : own_.emplace_back(std::make_unique<names_by_drive>(*drive)).get();
}

register_names const* known_units::named_by(named_places const& file)
{
    return own_.emplace_back(std::make_unique<names_by_file>(file)).get();
}

known_units::known_units(line_choices const& line)
{
    bool const has_file = not line.device.empty();
    bool const is_file_of_all = has_file and not line.is_unit_named;
    drive_catalog const* const drive = line.drive.empty() ? nullptr : catalog_or_none(line.drive);
    if (is_file_of_all and drive != nullptr) {
        refuse_word("--device " + line.device +
                    ": a register file is of what is no drive, and each unit is said to be an " + line.drive);
    }
    of_.fill(is_file_of_all ? named_by(register_file_at(line.device)) : named_by(drive));
    for (named_unit const& each : names_in(line)) {
        if (not each.drive.empty()) {
            of_[each.unit.byte()] = is_register_file(each.drive) ? named_by(register_file_at(each.drive))
                                                                 : named_by(catalog_or_none(each.drive));
        }
    }
    if (not has_file or is_file_of_all) {
        return;
    }
    for (named_unit const& each : units_asked(line)) {
        if (each.names != nullptr) {
            of_[each.unit.byte()] = named_by(*each.names);
        }
    }
}

} // namespace tool
