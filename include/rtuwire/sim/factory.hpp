// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a simulated drive holds as delivered, where its table does not say: a small motor of 1 500 rpm
// at 50 Hz, on ramps of three seconds. Numbers of ours, plausible for each drive.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/core/text.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// The raw count of a register as delivered.
struct factory_value {
    text code;
    std::uint16_t raw;
};

/// For registers of all drives that have one of the name.
inline constexpr std::array<factory_value, 39> factory_values{{
    {"SFR", 40},    {"TFR", 600},   {"HSP", 500},   {"LSP", 0},     {"ACC", 30},     {"DEC", 30},
    {"AC2", 50},    {"DE2", 50},    {"FRS", 500},   {"UNS", 400},   {"NCR", 20},     {"NSP", 1500},
    {"COS", 80},    {"NPR", 8},     {"ITH", 20},    {"INV", 23},    {"SDS", 30},     {"INR", 1},
    {"TTO", 100},   {"SLL", 1},     {"TBR", 32},    {"TFO", 3},     {"VDP", 0x0201}, {"STT", 0},
    {"NMA1", 3201}, {"NMA2", 8604}, {"NCA1", 8501}, {"NCA2", 8602}, {"CPU", 0x1005}, {"NCV", 6},
    {"VCAL", 2},    {"BFR", 0},     {"FR1", 164},   {"CD1", 20},    {"CHCF", 1},     {"FLG", 20},
    {"UFR", 20},    {"SPAL", 1500}, {"SPDL", 1500},
}};

/// The value as delivered of a register called `code`; 0 where nothing is said.
[[nodiscard]] constexpr std::uint16_t factory_value_of(text code) noexcept
{
    for (factory_value const& each : factory_values) {
        if (each.code == code) {
            return each.raw;
        }
    }
    return 0;
}

} // namespace rtuwire::sim
