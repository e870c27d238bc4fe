// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: what the values of its enumerations mean that the registers for driving have.
#pragma once

#include <rtuwire/altivar/device/atv320_values.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

// clang-format off
template <> inline constexpr auto detail::words_of<altivar::atv320::rating> = detail::name_list({
    {0, "unknown"}, {1, "0.10 kW"}, {2, "0.18 kW"}, {3, "0.25 kW"}, {4, "0.37 kW"}, {5, "0.55 kW"},
    {6, "0.75 kW"}, {7, "0.90 kW"}, {8, "1.1 kW"}, {9, "1.5 kW"}, {10, "1.85 kW"}, {11, "2.2 kW"},
    {12, "3.0 kW"}, {13, "3.7 kW"}, {14, "4.0 kW"}, {15, "5.5 kW"}, {16, "7.5 kW"}, {17, "9.0 kW"},
    {18, "11 kW"}, {19, "15 kW"}, {20, "18.5 kW"}, {21, "22 kW"}, {22, "30 kW"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::mains> = detail::name_list({
    {0, "unknown"}, {1, "100-120 V, one phase"}, {2, "100-120 V, three phases"}, {3, "200-240 V, one phase"},
    {4, "200-240 V, three phases"}, {5, "380-500 V, one phase"}, {6, "380-500 V, three phases"},
    {7, "525-600 V, one phase"}, {8, "525-600 V, three phases"}, {9, "600 V, one phase"},
    {10, "600 V, three phases"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::disable_stop> = detail::name_list({
    {0, "freewheel"}, {1, "ramp"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::no_yes> = detail::name_list({
    {0, "no"}, {1, "yes"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::control_mode> = detail::name_list({
    {0, "2-wire"}, {1, "3-wire"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::reference_channel> = detail::name_list({
    {0, "not assigned"}, {1, "AI1"}, {2, "AI2"}, {3, "AI3"}, {129, "motor current"}, {130, "output frequency"},
    {131, "ramp output"}, {132, "motor torque"}, {133, "motor torque, signed"}, {134, "ramp output, signed"},
    {135, "PI reference"}, {136, "PI feedback"}, {137, "PI error"}, {138, "PI output"}, {139, "motor power"},
    {140, "motor thermal state"}, {141, "drive thermal state"}, {142, "torque of master and slave"},
    {160, "+/- speed by logic inputs"}, {161, "+/- speed by the keypad"}, {163, "remote terminal"},
    {164, "Modbus"}, {167, "CANopen"}, {169, "communication card"}, {173, "output frequency, signed"},
    {174, "motor 2 thermal state"}, {175, "motor 3 thermal state"}, {179, "torque limit"},
    {180, "motor voltage"}, {181, "pulse input"}, {183, "virtual analog input 1"}, {184, "logic output on AO1"},
    {185, "virtual analog input 2"}, {240, "function block output OA01"}, {241, "function block output OA02"},
    {242, "function block output OA03"}, {243, "function block output OA04"},
    {244, "function block output OA05"}, {245, "function block output OA06"},
    {246, "function block output OA07"}, {247, "function block output OA08"},
    {248, "function block output OA09"}, {249, "function block output OA10"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::channel_mode> = detail::name_list({
    {1, "command and reference together"}, {2, "command and reference apart"}, {3, "I/O profile"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::command_channel> = detail::name_list({
    {1, "terminals"}, {2, "local keypad"}, {3, "remote terminal"}, {10, "Modbus"}, {20, "CANopen"},
    {30, "communication card"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::ramp_step> = detail::name_list({
    {0, "0.01 s"}, {1, "0.1 s"}, {2, "1 s"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::stop_mode> = detail::name_list({
    {0, "ramp"}, {1, "fast stop"}, {2, "freewheel"}, {3, "DC injection"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::link_lost_reaction> = detail::name_list({
    {0, "ignored"}, {1, "freewheel stop"}, {2, "stop as STT says"}, {4, "fallback speed"},
    {5, "speed maintained"}, {6, "ramp stop"}, {7, "fast stop"}, {8, "DC injection stop"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::serial_rate> = detail::name_list({
    {0, "not set"}, {4, "found automatically"}, {8, "300 bit/s"}, {12, "600 bit/s"}, {16, "1200 bit/s"},
    {20, "2400 bit/s"}, {24, "4800 bit/s"}, {28, "9600 bit/s"}, {30, "10000 bit/s"}, {32, "19200 bit/s"},
    {34, "20000 bit/s"}, {35, "28800 bit/s"}, {36, "38400 bit/s"}, {37, "45450 bit/s"}, {38, "50000 bit/s"},
    {40, "57600 bit/s"}, {42, "93750 bit/s"}, {44, "100 kbit/s"}, {48, "115.2 kbit/s"}, {52, "125 kbit/s"},
    {53, "156 kbit/s"}, {54, "187.5 kbit/s"}, {56, "230.4 kbit/s"}, {60, "250 kbit/s"}, {64, "460.8 kbit/s"},
    {68, "500 kbit/s"}, {69, "625 kbit/s"}, {70, "800 kbit/s"}, {72, "921.6 kbit/s"}, {76, "1 Mbit/s"},
    {80, "1.5 Mbit/s"}, {81, "2.5 Mbit/s"}, {82, "3 Mbit/s"}, {83, "6 Mbit/s"}, {84, "10 Mbit/s"},
    {86, "5 Mbit/s"}, {88, "12 Mbit/s"}, {92, "100 Mbit/s"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::serial_format> = detail::name_list({
    {0, "not set"}, {1, "found automatically"}, {2, "8O1"}, {3, "8E1"}, {4, "8N1"}, {5, "8N2"}, {6, "7O1"},
    {7, "7E1"}, {8, "7O2"}, {9, "7E2"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
