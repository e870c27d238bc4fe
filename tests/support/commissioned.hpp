// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive as somebody commissioned it: what it answers where it is checked before the first order.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/procedure/inspection/supervision_report.hpp>

namespace rtuwire::test {

/// The words of an ATV12, ATV310 or ATV320 that Modbus commands and that watches its link.
constexpr std::uint16_t commissioned_word(std::uint16_t address, std::uint16_t tto = 100)
{
    switch (address) {
    case 3104: return 500;  // HSP: 50 Hz
    case 9602: return 500;  // FRS
    case 9604: return 1440; // NSP
    case 7010: return 1;    // SLL: freewheel
    case 6005: return tto;
    case 8401: return 1;   // CHCF: together
    case 8423: return 10;  // CD1: Modbus
    case 8413: return 164; // FR1: Modbus
    case 8652: return 1;   // DOTD: on the ramp
    case 3201: return 0x0250;
    default: return 0; // FLO, ATR
    }
}

/// For a check of a drive whose limits are of no interest.
inline constexpr altivar::supervision_options unlimited{.beyond = altivar::beyond_limits::limit};

/// What a check of it found.
constexpr altivar::supervision_report commissioned(duration timeout = milliseconds(10'000))
{
    altivar::supervision_report found;
    found.finding = altivar::outcome_kind::succeeded;
    found.period.timeout = timeout;
    found.words = altivar::word_meaning::cia402;
    return found;
}

} // namespace rtuwire::test
