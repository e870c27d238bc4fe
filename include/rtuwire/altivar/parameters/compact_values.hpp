// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Enumerations of the further parameters of ATV12 and ATV310, and bits of their words.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/compact_values.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::compact {

/// What a register may point at: an input, a measurement, a reference.
using signal_source = reference_channel;

/// What a fault does; the same list as for a lost link.
using fault_reaction = link_lost_reaction;

/// What switches a function, or what an output shows.
using input_assignment = local_input;

// clang-format off
/// Which counter is set to zero.
enum class counter_reset : std::uint16_t {
    no = 0, running_time = 3, powered_time = 4, fan_time = 7,
};

/// The level that counts as 1.
enum class logic_level : std::uint16_t {
    positive = 0, negative = 1, negative_external = 2,
};

/// Where the configuration is saved.
enum class configuration_save : std::uint16_t {
    no = 0, configuration_1 = 2,
};

/// Which configuration is recalled.
enum class configuration_recall : std::uint16_t {
    no = 0, configuration_1 = 2, factory = 64, factory_1 = 71,
};

/// What the drive is prepared for.
enum class macro_configuration : std::uint16_t {
    start_stop = 0, pi = 4, speed = 9,
};

/// The mains frequency that motors are rated for.
enum class motor_standard : std::uint16_t {
    hz_50 = 0, hz_60 = 1,
};

/// A switch.
enum class no_yes : std::uint16_t {
    no = 0, yes = 1,
};

/// How far tuning is.
enum class tuning_state : std::uint16_t {
    defaults = 0, pending = 1, running = 2, failed = 3, done = 4,
};

/// Whether the motor is measured, and the result dropped.
enum class tuning_order : std::uint16_t {
    no = 0, run = 1, done = 2,
};

/// How voltage follows frequency.
enum class motor_control_law : std::uint16_t {
    performance = 0, standard = 3, pump = 6,
};

/// Whether the switching frequency may fall.
enum class switching_mode : std::uint16_t {
    hf1 = 1, hf2 = 2,
};

/// What starts the motor in 2-wire control.
enum class two_wire_type : std::uint16_t {
    level = 0, transition = 1, forward_first = 2,
};

/// What an analog input or output works with.
enum class analog_type : std::uint16_t {
    volts_5 = 0, volts_10 = 1, milliamperes_0_20 = 2, milliamperes_4_20 = 3, volts_bipolar = 5, galu
    = 6,
};

/// The shape of a ramp.
enum class ramp_shape : std::uint16_t {
    linear = 0, s = 1, u = 2,
};

/// Whether a ramp is stretched when braking raises the DC bus.
enum class ramp_adaptation : std::uint16_t {
    no = 0, yes = 1, dynamic = 2,
};

/// DC injection at standstill.
enum class auto_injection : std::uint16_t {
    no = 0, timed = 1, continuous = 2,
};

/// Which channel is in command.
enum class active_channel_bit : std::uint8_t {
    terminals = 0, keypad = 1, remote_terminal = 2, modbus = 3, pc_software = 15,
};
using active_channel = flags<active_channel_bit>;

/// The outputs.
enum class output_image_bit : std::uint8_t {
    r1 = 0, lo1 = 8,
};
using output_image = flags<output_image_bit>;

/// States of the drive when a fault came.
enum class state_history_bit : std::uint8_t {
    switched_on = 0, quick_stop = 1, switch_on_disabled = 2, forced_local = 3, reverse = 4,
    run_order = 5, dc_injection = 6, motor_thermal_threshold = 7, accelerating = 9, decelerating =
    10, current_limit = 11, fast_stop = 12, source_low = 13, source_high = 14, reverse_requested =
    15,
};
using state_history = flags<state_history_bit>;
// clang-format on

} // namespace altivar::compact

// clang-format off
template <>
inline constexpr auto enumerators<altivar::compact::counter_reset> = detail::name_list<altivar::compact::counter_reset>({
    {0, "nO"}, {3, "rtHI"}, {4, "PtH"}, {7, "FtH"},
});
template <>
inline constexpr auto meanings<altivar::compact::counter_reset> = detail::name_list<altivar::compact::counter_reset>({
    {0, "none"}, {3, "motor running time"}, {4, "powered time"}, {7, "fan running time"},
});
template <>
inline constexpr auto enumerators<altivar::compact::logic_level> = detail::name_list<altivar::compact::logic_level>({
    {0, "POS"}, {1, "nEG"}, {2, "EnEG"},
});
template <>
inline constexpr auto meanings<altivar::compact::logic_level> = detail::name_list<altivar::compact::logic_level>({
    {0, "positive logic"}, {1, "negative logic"}, {2, "negative logic, external supply"},
});
template <>
inline constexpr auto enumerators<altivar::compact::configuration_save> = detail::name_list<altivar::compact::configuration_save>({
    {0, "nO"}, {2, "Str1"},
});
template <>
inline constexpr auto meanings<altivar::compact::configuration_save> = detail::name_list<altivar::compact::configuration_save>({
    {0, "none"}, {2, "save as configuration 1"},
});
template <>
inline constexpr auto enumerators<altivar::compact::configuration_recall> = detail::name_list<altivar::compact::configuration_recall>({
    {0, "nO"}, {2, "rEC1"}, {64, "InI"}, {71, "InI1"},
});
template <>
inline constexpr auto meanings<altivar::compact::configuration_recall> = detail::name_list<altivar::compact::configuration_recall>({
    {0, "none"}, {2, "load configuration 1"}, {64, "factory settings"}, {71, "factory settings, variant InI1"},
});
template <>
inline constexpr auto enumerators<altivar::compact::macro_configuration> = detail::name_list<altivar::compact::macro_configuration>({
    {0, "StS"}, {4, "PId"}, {9, "SPd"},
});
template <>
inline constexpr auto meanings<altivar::compact::macro_configuration> = detail::name_list<altivar::compact::macro_configuration>({
    {0, "start and stop"}, {4, "PI regulator"}, {9, "speed control"},
});
template <>
inline constexpr auto enumerators<altivar::compact::motor_standard> = detail::name_list<altivar::compact::motor_standard>({
    {0, "50Hz"}, {1, "60Hz"},
});
template <>
inline constexpr auto meanings<altivar::compact::motor_standard> = detail::name_list<altivar::compact::motor_standard>({
    {0, "50 Hz"}, {1, "60 Hz"},
});
template <>
inline constexpr auto enumerators<altivar::compact::no_yes> = detail::name_list<altivar::compact::no_yes>({
    {0, "nO"}, {1, "YES"},
});
template <>
inline constexpr auto meanings<altivar::compact::no_yes> = detail::name_list<altivar::compact::no_yes>({
    {0, "no"}, {1, "yes"},
});
template <>
inline constexpr auto enumerators<altivar::compact::tuning_state> = detail::name_list<altivar::compact::tuning_state>({
    {0, "tAb"}, {1, "PEnd"}, {2, "PrOG"}, {3, "FAIL"}, {4, "dOnE"},
});
template <>
inline constexpr auto meanings<altivar::compact::tuning_state> = detail::name_list<altivar::compact::tuning_state>({
    {0, "not tuned, table values"}, {1, "pending"}, {2, "running"}, {3, "failed"}, {4, "done, measured values"},
});
template <>
inline constexpr auto enumerators<altivar::compact::tuning_order> = detail::name_list<altivar::compact::tuning_order>({
    {0, "nO"}, {1, "YES"}, {2, "dOnE"},
});
template <>
inline constexpr auto meanings<altivar::compact::tuning_order> = detail::name_list<altivar::compact::tuning_order>({
    {0, "not tuned"}, {1, "tune now"}, {2, "tuned"},
});
template <>
inline constexpr auto enumerators<altivar::compact::motor_control_law> = detail::name_list<altivar::compact::motor_control_law>({
    {0, "PErF"}, {3, "Std"}, {6, "PUMP"},
});
template <>
inline constexpr auto meanings<altivar::compact::motor_control_law> = detail::name_list<altivar::compact::motor_control_law>({
    {0, "sensorless vector (PErF)"}, {3, "V/f (Std)"}, {6, "quadratic V/f (PUMP)"},
});
template <>
inline constexpr auto enumerators<altivar::compact::switching_mode> = detail::name_list<altivar::compact::switching_mode>({
    {1, "HF1"}, {2, "HF2"},
});
template <>
inline constexpr auto meanings<altivar::compact::switching_mode> = detail::name_list<altivar::compact::switching_mode>({
    {1, "HF1: frequency may be reduced"}, {2, "HF2: frequency is kept"},
});
template <>
inline constexpr auto enumerators<altivar::compact::two_wire_type> = detail::name_list<altivar::compact::two_wire_type>({
    {0, "LEL"}, {1, "trn"}, {2, "PFO"},
});
template <>
inline constexpr auto meanings<altivar::compact::two_wire_type> = detail::name_list<altivar::compact::two_wire_type>({
    {0, "by level"}, {1, "by transition"}, {2, "by level, forward has priority"},
});
template <>
inline constexpr auto enumerators<altivar::compact::analog_type> = detail::name_list<altivar::compact::analog_type>({
    {0, "5U"}, {1, "10U"}, {2, "0A"}, {3, "4A"}, {5, "n10U"}, {6, "GALU"},
});
template <>
inline constexpr auto meanings<altivar::compact::analog_type> = detail::name_list<altivar::compact::analog_type>({
    {0, "0 to 5 V"}, {1, "0 to 10 V"}, {2, "0 to 20 mA"}, {3, "4 to 20 mA"}, {5, "-10 to 10 V"}, {6, "GALU"},
});
template <>
inline constexpr auto enumerators<altivar::compact::ramp_shape> = detail::name_list<altivar::compact::ramp_shape>({
    {0, "LIn"}, {1, "S"}, {2, "U"},
});
template <>
inline constexpr auto meanings<altivar::compact::ramp_shape> = detail::name_list<altivar::compact::ramp_shape>({
    {0, "linear"}, {1, "S"}, {2, "U"},
});
template <>
inline constexpr auto enumerators<altivar::compact::ramp_adaptation> = detail::name_list<altivar::compact::ramp_adaptation>({
    {0, "nO"}, {1, "YES"}, {2, "dYnA"},
});
template <>
inline constexpr auto meanings<altivar::compact::ramp_adaptation> = detail::name_list<altivar::compact::ramp_adaptation>({
    {0, "off"}, {1, "on"}, {2, "on, with more braking in the motor"},
});
template <>
inline constexpr auto enumerators<altivar::compact::auto_injection> = detail::name_list<altivar::compact::auto_injection>({
    {0, "nO"}, {1, "YES"}, {2, "Ct"},
});
template <>
inline constexpr auto meanings<altivar::compact::auto_injection> = detail::name_list<altivar::compact::auto_injection>({
    {0, "off"}, {1, "for a time"}, {2, "continuous"},
});
template <>
inline constexpr auto meanings<altivar::compact::active_channel_bit> = detail::name_list<altivar::compact::active_channel_bit>({
    {0, "terminals"}, {1, "local keypad"}, {2, "remote terminal"}, {3, "Modbus"}, {15, "SoMove"},
});
template <>
inline constexpr auto meanings<altivar::compact::output_image_bit> = detail::name_list<altivar::compact::output_image_bit>({
    {0, "R1"}, {8, "LO1"},
});
template <>
inline constexpr auto meanings<altivar::compact::state_history_bit> = detail::name_list<altivar::compact::state_history_bit>({
    {0, "switched on (ETA bit 1)"}, {1, "quick stop at 0 (ETA bit 5)"}, {2, "switch on disabled (ETA bit 6)"},
    {3, "forced local control at 0"}, {4, "output turns in reverse (ETA bit 15)"},
    {5, "run order present (ETI bit 4)"}, {6, "DC injection (ETI bit 5)"},
    {7, "motor thermal threshold (ETI bit 7)"}, {9, "accelerating (ETI bit 9)"},
    {10, "decelerating (ETI bit 10)"}, {11, "in current limit (ETI bit 11)"}, {12, "fast stop (ETI bit 12)"},
    {13, "command source, low bit (ETI bit 13)"}, {14, "command source, high bit (ETI bit 14)"},
    {15, "reverse before the ramp (ETI bit 15)"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::rating> = detail::name_list<altivar::compact::rating>({
    {0, "unknown"}, {1, "0.10 kW"}, {2, "0.18 kW"}, {3, "0.25 kW"}, {4, "0.37 kW"}, {5, "0.55 kW"},
    {6, "0.75 kW"}, {7, "0.90 kW"}, {8, "1.1 kW"}, {9, "1.5 kW"}, {10, "1.85 kW"}, {11, "2.2 kW"},
    {12, "3.0 kW"}, {13, "3.7 kW"}, {14, "4.0 kW"}, {15, "5.5 kW"}, {16, "7.5 kW"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::mains> = detail::name_list<altivar::compact::mains>({
    {0, "unknown"}, {1, "100-120 V, one phase"}, {2, "100-120 V, three phases"}, {3, "200-240 V, one phase"},
    {4, "200-240 V, three phases"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::control_mode> = detail::name_list<altivar::compact::control_mode>({
    {0, "2-wire"}, {1, "3-wire"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::local_input> = detail::name_list<altivar::compact::local_input>({
    {0, "not assigned"}, {1, "no fault present"}, {2, "drive running"}, {4, "frequency threshold reached"},
    {5, "high speed reached"}, {6, "current threshold reached"}, {7, "reference reached"},
    {8, "motor thermal threshold reached"}, {10, "PI error alarm"}, {11, "PI feedback alarm"},
    {21, "underload alarm"}, {22, "overload alarm"}, {123, "AI1 signal lost"}, {126, "auxiliary pump"},
    {129, "LI1"}, {130, "LI2"}, {131, "LI3"}, {132, "LI4"}, {145, "LI1, active low"}, {146, "LI2, active low"},
    {147, "LI3, active low"}, {148, "LI4, active low"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::reference_channel> = detail::name_list<altivar::compact::reference_channel>({
    {0, "not assigned"}, {1, "AI1"}, {129, "motor current"}, {130, "output frequency"}, {131, "ramp output"},
    {135, "PI reference"}, {136, "PI feedback"}, {137, "PI error"}, {139, "motor power"},
    {140, "motor thermal state"}, {141, "drive thermal state"}, {163, "remote terminal"}, {164, "Modbus"},
    {183, "keypad dial (AIU1)"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::channel_mode> = detail::name_list<altivar::compact::channel_mode>({
    {1, "command and reference together"}, {2, "command and reference apart"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::command_channel> = detail::name_list<altivar::compact::command_channel>({
    {1, "terminals"}, {2, "local keypad"}, {3, "remote terminal"}, {10, "Modbus"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::stop_mode> = detail::name_list<altivar::compact::stop_mode>({
    {0, "ramp"}, {8, "fast stop"}, {13, "freewheel"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::link_lost_reaction> = detail::name_list<altivar::compact::link_lost_reaction>({
    {0, "ignored"}, {1, "freewheel stop"}, {4, "fallback speed"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::serial_rate> = detail::name_list<altivar::compact::serial_rate>({
    {24, "4800 bit/s"}, {28, "9600 bit/s"}, {32, "19200 bit/s"}, {36, "38400 bit/s"},
});
template <>
inline constexpr auto altivar::words_of<altivar::compact::serial_format> = detail::name_list<altivar::compact::serial_format>({
    {2, "8O1"}, {3, "8E1"}, {4, "8N1"}, {5, "8N2"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
