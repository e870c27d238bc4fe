// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Asks a unit by one clause, and judges what comes.
#pragma once

#include <string>
#include <vector>

#include "check/checked_unit.hpp"

namespace tool {

enum class verdict {
    holds,
    fails,
    known, ///< fails, as a profile says
    does_not_apply,
    not_tried,
    told,
};

std::string_view name_of(verdict how);

struct judgement {
    verdict how{verdict::holds};
    std::string why{};                  ///< of all but `holds`: "step 2 of 3: ... came, ... may come"
    std::vector<passed_bytes> passed{}; ///< what was said on the line
    bool is_hidden{false};              ///< not tried because of what another clause is for, as its reason says
};

/// The known state is established already.
judgement judged(checked_unit& unit, clause const& which);

} // namespace tool
