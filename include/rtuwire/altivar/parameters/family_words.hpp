// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Bits of the command and status words of ATV12, ATV310 and ATV320 in words.
#pragma once

#include <rtuwire/altivar/device/family.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

// clang-format off
template <> inline constexpr auto detail::words_of<altivar::command_bit> = detail::name_list({
    {0, "switch on"}, {1, "enable voltage, disabled at 0"}, {2, "quick stop at 0"}, {3, "enable operation"},
    {7, "fault reset on a rising edge"}, {8, "halt as STT says"}, {11, "reverse by default, assignable"},
    {12, "assignable"}, {13, "assignable"}, {14, "assignable"}, {15, "assignable"},
});
template <> inline constexpr auto detail::words_of<altivar::status_bit> = detail::name_list({
    {0, "ready to switch on"}, {1, "switched on"}, {2, "operation enabled"}, {3, "in fault"},
    {4, "power section supplied"}, {5, "quick stop at 0"}, {6, "switch on disabled"}, {7, "warning"},
    {9, "controlled by the network"}, {10, "reference reached"}, {11, "reference outside LSP to HSP"},
    {14, "stopped by the STOP key"}, {15, "output turns in reverse"},
});
template <> inline constexpr auto detail::words_of<altivar::extended_command_bit> = detail::name_list({
    {0, "load the factory settings"}, {1, "save to EEPROM"}, {9, "frequencies count 1/32767 of TFR"},
    {15, "parameters are not checked"},
});
template <> inline constexpr auto detail::words_of<altivar::extended_status_bit> = detail::name_list({
    {0, "EEPROM being accessed"}, {1, "parameters are checked"}, {2, "cause of the fault gone, not reset"},
    {4, "speed mode"}, {5, "DC injection"}, {6, "not in steady state"}, {7, "motor thermal threshold reached"},
    {8, "excessive braking"}, {9, "accelerating"}, {10, "decelerating"}, {11, "in current limit"},
    {12, "fast stop"}, {13, "command source, low bit"}, {14, "command source, high bit"},
    {15, "reverse asked for before the ramp"},
});
template <> inline constexpr auto detail::words_of<altivar::input_bit> = detail::name_list({
    {0, "LI1"}, {1, "LI2"}, {2, "LI3"}, {3, "LI4"}, {4, "LI5"}, {5, "LI6"},
});
template <> inline constexpr auto detail::words_of<altivar::configuration_fault_bit> = detail::name_list({
    {0, "rating changed"}, {2, "communication card removed"}, {3, "EEPROM inconsistent at power-on"},
    {4, "communication card changed"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
