// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/known_units.hpp"

#include "line/line_words.hpp"
#include "line/who_is_it.hpp"

namespace tool {

known_units::known_units(line_choices const& line)
{
    if (not line.drive.empty()) {
        drives_.fill(catalog_or_none(line.drive));
    }
    for (named_unit const& each : names_in(line)) {
        if (not each.drive.empty() and not is_register_file(each.drive)) {
            drives_[each.unit.byte()] = catalog_or_none(each.drive);
        }
    }
}

} // namespace tool
