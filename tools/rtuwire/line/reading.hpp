// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A place that was read, in the forms in which a person and a program want it.
#pragma once

#include <string>

#include "line/register_reader.hpp"
#include "output/record.hpp"

namespace tool {

/// "RFR", "ETA.fault"; "3202" where it has no mnemonic, and "input:40:f32" of another place.
std::string label_of(chosen_register const& which);

/// "; list:40001 is holding:0" where a unit has no such register, and a number from a manual's list may be meant.
std::string hint_at_list(chosen_register const& which, rtuwire::errc why);

/// What a place holds.
struct reading {
    std::string label;
    bool is_read;
    cell raw;            ///< the word, or the bit, as it came; of several registers their words in hexadecimal
    cell value;          ///< the amount in its unit, the enumerator, the bit; nothing where it could not be read
    std::string measure; ///< "Hz"
    std::string text;    ///< "50.0 Hz"; the error in words
};

/// Whether it has a unit, whatever it holds.
bool has_measure(chosen_register const& which);

reading reading_of(chosen_register const& which, register_reader const& from, drive_catalog const* drive);

} // namespace tool
