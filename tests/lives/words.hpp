// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Control words on the line, by the drives' manuals: what they do to a motor, and which requests hold one.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/core/bytes.hpp>

namespace rtuwire::lives {

using namespace detail;

/// What a control word asks for. Halt keeps the power.
inline bool enables(std::uint16_t word, altivar::drive_layout const& profile)
{
    bool const is_halt = profile.halt != 0 and (word & profile.halt) != 0;
    bool const is_direct = profile.direct_control != 0 and (word & profile.direct_control) != 0;
    return is_direct ? (word & 0x700AU) == 0x000A : (word & 0x0FU) == 0x0F and not is_halt;
}

/// Whether a control word stops a motor and leaves it its power: halt and DC injection. Behind a look that was out of date
/// it may give the power back to a motor that stands.
inline bool keeps_power(std::uint16_t word, altivar::drive_layout const& profile)
{
    bool const is_halt = profile.halt != 0 and (word & profile.halt) != 0 and (word & 0x0FU) == 0x0F;
    return is_halt or (profile.dc_injection != 0 and word == profile.dc_injection);
}

/// The control word that a request writes, where it writes one.
inline std::optional<std::uint16_t> control_word_in(byte_view frame, altivar::drive_layout const& profile)
{
    if (frame.size() < 8) {
        return std::nullopt;
    }
    std::uint16_t const first = u16_at(frame, 2);
    switch (to_u8(frame[1])) {
    case 6: return first == profile.cmd ? std::optional{u16_at(frame, 4)} : std::nullopt;
    case 16: // the first word of the scanner, or of CMD and LFR
        return first == profile.cmd or first == 12'761 ? std::optional{u16_at(frame, 7)} : std::nullopt;
    case 23: return u16_at(frame, 6) == 12'761 ? std::optional{u16_at(frame, 11)} : std::nullopt;
    default: return std::nullopt;
    }
}

} // namespace rtuwire::lives
