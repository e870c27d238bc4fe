// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the registers of a simulated drive hold as delivered, where its table does not say, and after commissioning: a
// small motor of 1 500 rpm at 50 Hz, on ramps of three seconds. Assumed numbers, plausible for each drive.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// The raw count of a register as delivered.
struct factory_value {
    literal code;
    std::uint16_t raw;
};

/// Values where the table of a drive gives no default, for the registers of this name in all drives: commands from
/// the terminals, the reference from an analog input.
inline constexpr std::array<factory_value, 46> factory_values{{
    {"SFR", 40},  {"TFR", 600},   {"HSP", 500},    {"LSP", 0},     {"ACC", 30},     {"DEC", 30}, {"AC2", 50},
    {"DE2", 50},  {"FRS", 500},   {"UNS", 400},    {"NCR", 20},    {"NSP", 1500},   {"COS", 80}, {"NPR", 8},
    {"ITH", 20},  {"INV", 23},    {"SDS", 30},     {"INR", 1},     {"TTO", 100},    {"SLL", 1},  {"TBR", 32},
    {"TFO", 3},   {"STT", 0},     {"VDP", 0x0201}, {"NCV", 6},     {"CPU", 0x1005}, {"VCAL", 2}, {"BFR", 0},
    {"BDR", 8},   {"ADD", 1},     {"FR1", 1},      {"CD1", 1},     {"CHCF", 1},     {"CD2", 10}, {"FLG", 20},
    {"UFR", 20},  {"CRH", 200},   {"IDC", 14},     {"RPG", 100},   {"RIG", 100},    {"FBS", 10}, {"CTD", 23},
    {"TTD", 100}, {"SPAL", 1500}, {"SPDL", 1500},  {"SMAL", 1500},
}};

/// What commissioning has set: Modbus commands the drive, and gives the reference.
inline constexpr std::array<factory_value, 4> commissioned_values{{
    {"CD1", 10},
    {"FR1", 164},
    {"CHCF", 1},
    {"SLL", 1},
}};

/// Words that are orders, not settings: they are neither saved nor restored, and lost at power-off.
inline constexpr std::array<literal, 17> orders{"CMD", "CMDD", "LFR", "LFRD", "CMI", "PISP", "RPI", "IOLR", "AOR",
                                                "NC1", "NC2",  "NC3", "NC4",  "NC5", "NC6",  "NC7", "NC8"};

[[nodiscard]] constexpr bool is_order(literal code) noexcept
{
    for (literal const each : orders) {
        if (each == code) {
            return true;
        }
    }
    return false;
}

/// The value in a list for a register called `code`; else `other`.
template <std::size_t Count>
[[nodiscard]] constexpr std::uint16_t value_in(std::array<factory_value, Count> const& list, literal code,
                                               std::uint16_t other) noexcept
{
    for (factory_value const& each : list) {
        if (each.code == code) {
            return each.raw;
        }
    }
    return other;
}

} // namespace rtuwire::sim
