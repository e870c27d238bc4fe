// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV12 and ATV310: choices of their parameters.
#pragma once

#include <rtuwire/altivar/device/compact_values.hpp>
#include <rtuwire/altivar/parameters/family_words.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

// clang-format off
// What the values mean that the registers for driving have.
template <> inline constexpr auto detail::words_of<altivar::compact::rating> = detail::name_list({
    {0, "unknown"}, {1, "0.10 kW"}, {2, "0.18 kW"}, {3, "0.25 kW"}, {4, "0.37 kW"}, {5, "0.55 kW"},
    {6, "0.75 kW"}, {7, "0.90 kW"}, {8, "1.1 kW"}, {9, "1.5 kW"}, {10, "1.85 kW"}, {11, "2.2 kW"},
    {12, "3.0 kW"}, {13, "3.7 kW"}, {14, "4.0 kW"}, {15, "5.5 kW"}, {16, "7.5 kW"},
});
template <> inline constexpr auto detail::words_of<altivar::compact::mains> = detail::name_list({
    {0, "unknown"}, {1, "100-120 V, one phase"}, {2, "100-120 V, three phases"}, {3, "200-240 V, one phase"},
    {4, "200-240 V, three phases"},
});
template <> inline constexpr auto detail::words_of<altivar::compact::control_mode> = detail::name_list({
    {0, "2-wire"}, {1, "3-wire"},
});
template <> inline constexpr auto detail::words_of<altivar::compact::local_input> = detail::name_list({
    {0, "not assigned"}, {1, "no fault present"}, {2, "drive running"}, {4, "frequency threshold reached"},
    {5, "high speed reached"}, {6, "current threshold reached"}, {7, "reference reached"},
    {8, "motor thermal threshold reached"}, {10, "PI error alarm"}, {11, "PI feedback alarm"},
    {21, "underload alarm"}, {22, "overload alarm"}, {123, "AI1 signal lost"}, {126, "auxiliary pump"},
    {129, "LI1"}, {130, "LI2"}, {131, "LI3"}, {132, "LI4"}, {145, "LI1, active low"}, {146, "LI2, active low"},
    {147, "LI3, active low"}, {148, "LI4, active low"},
});
template <> inline constexpr auto detail::words_of<altivar::compact::reference_channel> = detail::name_list({
    {0, "not assigned"}, {1, "AI1"}, {129, "motor current"}, {130, "output frequency"}, {131, "ramp output"},
    {135, "PI reference"}, {136, "PI feedback"}, {137, "PI error"}, {139, "motor power"},
    {140, "motor thermal state"}, {141, "drive thermal state"}, {163, "remote terminal"}, {164, "Modbus"},
    {183, "keypad dial (AIU1)"},
});
template <> inline constexpr auto detail::words_of<altivar::compact::channel_mode> = detail::name_list({
    {1, "command and reference together"}, {2, "command and reference apart"},
});
template <> inline constexpr auto detail::words_of<altivar::compact::command_channel> = detail::name_list({
    {1, "terminals"}, {2, "local keypad"}, {3, "remote terminal"}, {10, "Modbus"},
});
template <> inline constexpr auto detail::words_of<altivar::compact::stop_mode> = detail::name_list({
    {0, "ramp"}, {8, "fast stop"}, {13, "freewheel"},
});
template <> inline constexpr auto detail::words_of<altivar::compact::link_lost_reaction> = detail::name_list({
    {0, "ignored"}, {1, "freewheel stop"}, {4, "fallback speed"},
});
template <> inline constexpr auto detail::words_of<altivar::compact::serial_rate> = detail::name_list({
    {24, "4800 bit/s"}, {28, "9600 bit/s"}, {32, "19200 bit/s"}, {36, "38400 bit/s"},
});
template <> inline constexpr auto detail::words_of<altivar::compact::serial_format> = detail::name_list({
    {2, "8O1"}, {3, "8E1"}, {4, "8N1"}, {5, "8N2"},
});

namespace altivar::compact_choices {

// What a register may point at: an input, a measurement, a reference.
inline constexpr auto const& signal_source = in<compact::reference_channel>;
// What a fault does; the same list as for a lost link.
inline constexpr auto const& fault_reaction = in<compact::link_lost_reaction>;
// What switches a function, or what an output shows.
inline constexpr auto const& input_assignment = in<compact::local_input>;
// Which counter is set to zero.
inline constexpr choice counter_reset[]{
    {0, "nO", "none"}, {3, "rtHI", "motor running time"}, {4, "PtH", "powered time"},
    {7, "FtH", "fan running time"},
};
// The level that counts as 1.
inline constexpr choice logic_level[]{
    {0, "POS", "positive logic"}, {1, "nEG", "negative logic"},
    {2, "EnEG", "negative logic, external supply"},
};
// Where the configuration is saved.
inline constexpr choice configuration_save[]{{0, "nO", "none"}, {2, "Str1", "save as configuration 1"}};
// Which configuration is recalled.
inline constexpr choice configuration_recall[]{
    {0, "nO", "none"}, {2, "rEC1", "load configuration 1"}, {64, "InI", "factory settings"},
    {71, "InI1", "factory settings, variant InI1"},
};
// What the drive is prepared for.
inline constexpr choice macro_configuration[]{
    {0, "StS", "start and stop"}, {4, "PId", "PI regulator"}, {9, "SPd", "speed control"},
};
// The mains frequency that motors are rated for.
inline constexpr choice motor_standard[]{{0, "50Hz", "50 Hz"}, {1, "60Hz", "60 Hz"}};
// A switch.
inline constexpr choice no_yes[]{{0, "nO", "no"}, {1, "YES", "yes"}};
// How far tuning is.
inline constexpr choice tuning_state[]{
    {0, "tAb", "not tuned, table values"}, {1, "PEnd", "pending"}, {2, "PrOG", "running"},
    {3, "FAIL", "failed"}, {4, "dOnE", "done, measured values"},
};
// Whether the motor is measured, and the result dropped.
inline constexpr choice tuning_order[]{{0, "nO", "not tuned"}, {1, "YES", "tune now"}, {2, "dOnE", "tuned"}};
// How voltage follows frequency.
inline constexpr choice motor_control_law[]{
    {0, "PErF", "sensorless vector (PErF)"}, {3, "Std", "V/f (Std)"}, {6, "PUMP", "quadratic V/f (PUMP)"},
};
// Whether the switching frequency may fall.
inline constexpr choice switching_mode[]{
    {1, "HF1", "HF1: frequency may be reduced"}, {2, "HF2", "HF2: frequency is kept"},
};
// What starts the motor in 2-wire control.
inline constexpr choice two_wire_type[]{
    {0, "LEL", "by level"}, {1, "trn", "by transition"}, {2, "PFO", "by level, forward has priority"},
};
// What an analog input or output works with.
inline constexpr choice analog_type[]{
    {0, "5U", "0 to 5 V"}, {1, "10U", "0 to 10 V"}, {2, "0A", "0 to 20 mA"}, {3, "4A", "4 to 20 mA"},
    {5, "n10U", "-10 to 10 V"}, {6, "GALU", "GALU"},
};
// The shape of a ramp.
inline constexpr choice ramp_shape[]{{0, "LIn", "linear"}, {1, "S", "S"}, {2, "U", "U"}};
// Whether a ramp is stretched when braking raises the DC bus.
inline constexpr choice ramp_adaptation[]{
    {0, "nO", "off"}, {1, "YES", "on"}, {2, "dYnA", "on, with more braking in the motor"},
};
// DC injection at standstill.
inline constexpr choice auto_injection[]{{0, "nO", "off"}, {1, "YES", "for a time"}, {2, "Ct", "continuous"}};
// Which channel is in command.
inline constexpr choice active_channel[]{
    {0, "terminals", "terminals"}, {1, "keypad", "local keypad"}, {2, "remote_terminal", "remote terminal"},
    {3, "modbus", "Modbus"}, {15, "pc_software", "SoMove"},
};
// The outputs.
inline constexpr choice output_image[]{{0, "r1", "R1"}, {8, "lo1", "LO1"}};
// States of the drive when a fault came.
inline constexpr choice state_history[]{
    {0, "switched_on", "switched on (ETA bit 1)"}, {1, "quick_stop", "quick stop at 0 (ETA bit 5)"},
    {2, "switch_on_disabled", "switch on disabled (ETA bit 6)"},
    {3, "forced_local", "forced local control at 0"}, {4, "reverse", "output turns in reverse (ETA bit 15)"},
    {5, "run_order", "run order present (ETI bit 4)"}, {6, "dc_injection", "DC injection (ETI bit 5)"},
    {7, "motor_thermal_threshold", "motor thermal threshold (ETI bit 7)"},
    {9, "accelerating", "accelerating (ETI bit 9)"}, {10, "decelerating", "decelerating (ETI bit 10)"},
    {11, "current_limit", "in current limit (ETI bit 11)"}, {12, "fast_stop", "fast stop (ETI bit 12)"},
    {13, "source_low", "command source, low bit (ETI bit 13)"},
    {14, "source_high", "command source, high bit (ETI bit 14)"},
    {15, "reverse_requested", "reverse before the ramp (ETI bit 15)"},
};
// clang-format on

} // namespace altivar::compact_choices
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
