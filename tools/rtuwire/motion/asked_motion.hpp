// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The speed or the frequency that somebody typed, as a drive takes it.
#pragma once

#include <cstdint>
#include <string>

#include "catalog/catalog.hpp"
#include "choices.hpp"
#include "line/open_line.hpp"

namespace tool {

struct asked_motion {
    std::int16_t count{0}; ///< 1 rpm or 0.1 Hz, without a sign
    bool is_speed{false};  ///< rpm
    bool is_reverse{false};
    std::string text{}; ///< "40.0 Hz, reverse"
};

/// What has to be said of 0 in reverse, to be put behind its text: the motor does not rest there. Empty for any other.
std::string words_of_least(asked_motion const& asked);

/// Refuses what can be refused without the drive: neither or both words, no number, a sign and --reverse.
void refuse_wrong_words(motion_choices const& typed);

/// Reads what limits it, LSP and HSP and the motor's nameplate, and refuses what is outside, or no whole step.
asked_motion motion_asked(motion_choices const& typed, open_line& line, rtuwire::unit_id unit,
                          drive_catalog const& drive);

/// What somebody types while the motor runs at `now`: the same quantity, in the same direction: "30Hz", "1200rpm". Refuses a
/// sign, what is none, or no whole step. What limits it says the drive.
asked_motion motion_typed(std::string const& word, asked_motion const& now, drive_catalog const& drive);

} // namespace tool
