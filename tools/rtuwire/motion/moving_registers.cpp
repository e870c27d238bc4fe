// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/moving_registers.hpp"

#include <utility>

namespace tool {

namespace {

constexpr std::uint16_t first_scanner_output = 12'761; ///< NC1: what the scanner writes to the command

constexpr std::string_view channel = "says who commands the motor, and a run input may be closed there";

constexpr std::pair<std::string_view, std::string_view> reasons[] = {
    {"CHCF", channel},
    {"CD1", channel},
    {"CD2", channel},
    {"FR1", "says whose reference counts"},
    {"FR2", "says whose reference counts"},
    {"FLO", channel},
    {"ATR", "lets the drive start again by itself after a fault"},
};

} // namespace

bool commands_a_motor(std::uint16_t address, drive_catalog const& drive)
{
    register_entry const* const entry = drive.at(address);
    bool const is_scanner_output =
        entry != nullptr and entry->code.starts_with("NC") and address >= first_scanner_output;
    return address == drive.layout.cmd or address == drive.speed_reference or address == drive.frequency_reference or
           is_scanner_output;
}

std::string why_it_may_move(std::string_view code)
{
    if (code.starts_with("NCA")) {
        return "says which registers a controller's scanner words go to, its command among them";
    }
    for (auto const& [each, why] : reasons) {
        if (each == code) {
            return std::string{why};
        }
    }
    return {};
}

std::string why_it_runs_on(std::uint16_t address, std::uint16_t word, drive_catalog const& drive)
{
    rtuwire::altivar::safeguard_layout const& at = drive.layout.safeguards;
    bool const is_reaction = at.sll != 0 and address == at.sll;
    bool const is_timeout = at.tto != 0 and address == at.tto;
    constexpr std::uint16_t off = 0, takes_fallback_speed = 4, keeps_speed = 5;
    if ((is_reaction or is_timeout) and word == off) {
        return "switches the supervision of the link off";
    }
    if (is_reaction and (word == takes_fallback_speed or word == keeps_speed)) {
        return "lets the motor run without its link";
    }
    return {};
}

} // namespace tool
