// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What can happen to a simulated drive, in the words of `simulate`.
#pragma once

#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <rtuwire/frames.hpp>

#include "usage_error.hpp"

namespace tool {

inline constexpr char drive_events[] = "fault|clear|local|remote|stop|hold|let-go|close N|open N|"
                                       "cycle|write ADDRESS WORD|cut|deaf|mute|join";

/// The words of a line.
inline std::vector<std::string> words_of(std::string const& line)
{
    std::istringstream in{line};
    std::vector<std::string> words;
    for (std::string word; in >> word;) {
        words.push_back(word);
    }
    return words;
}

/// A word as another master on the line writes it; whether the drive took it.
template <typename Drive> bool write_as_another_master(Drive& drive, std::uint32_t address, std::uint32_t word)
{
    if (address > 0xFFFF or word > 0xFFFF) {
        return false;
    }
    rtuwire::register_block const value{static_cast<std::uint16_t>(word)};
    auto const place = static_cast<std::uint16_t>(address);
    drive.note_contact();
    return drive.check_write(place, value) == rtuwire::errc::none and drive.write(place, value) == rtuwire::errc::none;
}

/// What needs a number or two; false for what is not known.
template <typename Drive> bool happens_with_numbers(Drive& drive, std::vector<std::string> const& words)
{
    auto const first = number_in(words[1]);
    if (not first) {
        return false;
    }
    if (words.size() == 2 and (words[0] == "close" or words[0] == "open")) {
        drive.set_input(*first, words[0] == "close");
        return true;
    }
    auto const second = number_in(words.back());
    return words.size() == 3 and words[0] == "write" and second and write_as_another_master(drive, *first, *second);
}

/// Lets something happen to a drive; false for what is not known, and for a word that it does not take.
template <typename Drive> bool happens(Drive& drive, std::vector<std::string> const& words, rtuwire::instant now)
{
    constexpr std::uint16_t overcurrent = 9; // LFT
    if (words.size() != 1) {
        return words.size() > 1 and happens_with_numbers(drive, words);
    }
    std::string const& what = words.front();
    if (what == "fault") {
        drive.inject_fault(overcurrent);
    } else if (what == "clear") {
        drive.clear_cause();
    } else if (what == "local" or what == "remote") {
        drive.set_local(what == "local");
    } else if (what == "stop") {
        drive.press_stop();
    } else if (what == "hold" or what == "let-go") {
        drive.hold_stop(what == "hold");
    } else if (what == "cycle") {
        drive.power_cycle(now);
    } else {
        return false;
    }
    return true;
}

} // namespace tool
