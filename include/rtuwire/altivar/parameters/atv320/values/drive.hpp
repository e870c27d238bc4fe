// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: enumerations and words of bits of the parameters of the drive as a whole: commands, references, monitoring.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/atv320_values.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320_values {

// clang-format off
/// Which counter is set to zero.
enum class counter_reset : std::uint16_t {
    no = 0, energy = 1, running_time = 2, internal_running_time = 3, powered_time = 4, all = 64,
};

/// Which configuration is in use.
enum class active_configuration : std::uint16_t {
    no = 0, configuration_0 = 1, configuration_1 = 2, configuration_2 = 3,
};

/// What follows a quick stop.
enum class quick_stop_end : std::uint16_t {
    leave = 2, stay = 6,
};

/// Which parameter set is in use.
enum class parameter_set : std::uint16_t {
    no = 0, set_1 = 1, set_2 = 2, set_3 = 3,
};

/// When the fan runs.
enum class fan_mode : std::uint16_t {
    standard = 0, always = 1, never = 2,
};

/// What starts the motor in 2-wire control.
enum class two_wire_type : std::uint16_t {
    level = 0, transition = 1, forward_first = 2,
};

/// What is copied when the channel changes.
enum class channel_copy : std::uint16_t {
    no = 0, reference = 1, command = 2, all = 3,
};

/// Which channel is in command.
enum class active_channel_bit : std::uint8_t {
    terminals = 0, keypad = 1, remote_terminal = 2, modbus = 3, canopen = 6, speed_by_terminals = 7,
    speed_by_terminal = 8, communication_card = 9, pc_software = 15,
};
using active_channel = flags<active_channel_bit>;

/// LRS1.
enum class state_word_1_bit : std::uint8_t {
    fault = 1, running = 2, output_contactor = 3, frequency_threshold = 4, high_speed = 5,
    current_threshold = 6, reference_reached = 7, motor_thermal_threshold = 8, brake_command = 9,
    pi_error = 10, pi_feedback = 11, frequency_threshold_2 = 13, drive_thermal_threshold = 14,
    traverse = 15,
};
using state_word_1 = flags<state_word_1_bit>;

/// LRS2.
enum class state_word_2_bit : std::uint8_t {
    underload = 5, overload = 6, slack_rope = 11, torque_high = 12, torque_low = 13, forward = 14,
    reverse = 15,
};
using state_word_2 = flags<state_word_2_bit>;

/// LRS3.
enum class state_word_3_bit : std::uint8_t {
    reference_channel_2 = 0, command_channel_2 = 1, second_ramp = 2, second_current_limit = 3,
    motor_2_threshold = 5, motor_3_threshold = 6, external_24v = 8, low_speed_stop = 9,
    torque_negative = 15,
};
using state_word_3 = flags<state_word_3_bit>;

/// LRS4.
enum class state_word_4_bit : std::uint8_t {
    configuration_0 = 0, configuration_1 = 1, configuration_2 = 2, parameter_set_1 = 4,
    parameter_set_2 = 5, parameter_set_3 = 6, no_power = 8, fluxing = 9, fluxed = 10, dc_injection =
    11, current_limit = 12, accelerating = 13, decelerating = 14, fast_stop = 15,
};
using state_word_4 = flags<state_word_4_bit>;

/// LRS5.
enum class state_word_5_bit : std::uint8_t {
    bus_charging = 0, braking = 1, power_removed = 2, restarting = 3, tuning = 4, controlled_stop =
    5, ramp_adapted = 6, output_cut = 7, pulse_warning = 8, line_contactor = 9, tuned = 10,
    motor_current = 13, limit_switch = 14, load_variation = 15,
};
using state_word_5 = flags<state_word_5_bit>;

/// LRS6.
enum class state_word_6_bit : std::uint8_t {
    alarm_group_1 = 0, alarm_group_2 = 1, alarm_group_3 = 2, li6_probe = 5, external_fault = 7,
    undervoltage = 8, undervoltage_prevention = 9, drive_overheated = 11, limit_reached = 15,
};
using state_word_6 = flags<state_word_6_bit>;

/// LRS7.
enum class state_word_7_bit : std::uint8_t {
    reference_1_or_1b = 0, reference_2 = 1, command_1 = 2, command_2 = 3, reference_1b = 4,
    end_of_reel = 5, wobble_synchronised = 6, transistor_alarm = 8, ai3_lost = 11,
};
using state_word_7 = flags<state_word_7_bit>;

/// LRS8.
enum class state_word_8_bit : std::uint8_t {
    forced_local = 9, ready = 15,
};
using state_word_8 = flags<state_word_8_bit>;
// clang-format on

} // namespace altivar::atv320_values

namespace altivar::atv320 {

/// What a register may point at: an input, a measurement, a reference.
using signal_source = reference_channel;

/// What a fault does; the same list as for a lost link.
using fault_reaction = link_lost_reaction;

using namespace atv320_values;

} // namespace altivar::atv320

// clang-format off
template <>
inline constexpr auto enumerators<altivar::atv320_values::counter_reset> = detail::name_list<altivar::atv320_values::counter_reset>({
    {0, "nO"}, {1, "APH"}, {2, "rtH"}, {3, "rtHI"}, {4, "PtH"}, {64, "ALL"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::counter_reset> = detail::name_list<altivar::atv320_values::counter_reset>({
    {0, "none"}, {1, "energy"}, {2, "motor running time"}, {3, "internal running time (rtHI)"},
    {4, "powered time"}, {64, "all"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::active_configuration> = detail::name_list<altivar::atv320_values::active_configuration>({
    {0, "nO"}, {1, "CnF0"}, {2, "CnF1"}, {3, "CnF2"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::active_configuration> = detail::name_list<altivar::atv320_values::active_configuration>({
    {0, "none"}, {1, "configuration 0"}, {2, "configuration 1"}, {3, "configuration 2"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::quick_stop_end> = detail::name_list<altivar::atv320_values::quick_stop_end>({
    {2, "FSt2"}, {6, "FSt6"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::quick_stop_end> = detail::name_list<altivar::atv320_values::quick_stop_end>({
    {2, "fast stop, then switch on disabled"}, {6, "fast stop, stays in quick stop"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::parameter_set> = detail::name_list<altivar::atv320_values::parameter_set>({
    {0, "nO"}, {1, "CFP1"}, {2, "CFP2"}, {3, "CFP3"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::parameter_set> = detail::name_list<altivar::atv320_values::parameter_set>({
    {0, "none"}, {1, "set 1"}, {2, "set 2"}, {3, "set 3"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::fan_mode> = detail::name_list<altivar::atv320_values::fan_mode>({
    {0, "Std"}, {1, "rUn"}, {2, "StP"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::fan_mode> = detail::name_list<altivar::atv320_values::fan_mode>({
    {0, "when needed"}, {1, "always"}, {2, "never"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::two_wire_type> = detail::name_list<altivar::atv320_values::two_wire_type>({
    {0, "LEL"}, {1, "trn"}, {2, "PFO"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::two_wire_type> = detail::name_list<altivar::atv320_values::two_wire_type>({
    {0, "by level"}, {1, "by transition"}, {2, "by level, forward has priority"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::channel_copy> = detail::name_list<altivar::atv320_values::channel_copy>({
    {0, "nO"}, {1, "SP"}, {2, "Cd"}, {3, "ALL"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::channel_copy> = detail::name_list<altivar::atv320_values::channel_copy>({
    {0, "none"}, {1, "reference"}, {2, "command"}, {3, "command and reference"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::active_channel_bit> = detail::name_list<altivar::atv320_values::active_channel_bit>({
    {0, "terminals"}, {1, "local keypad"}, {2, "remote terminal"}, {3, "Modbus"}, {6, "CANopen"},
    {7, "+/- speed by the terminals"}, {8, "+/- speed by the remote terminal"}, {9, "communication card"},
    {15, "SoMove"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::state_word_1_bit> = detail::name_list<altivar::atv320_values::state_word_1_bit>({
    {1, "in fault"}, {2, "unlocked: the motor can be powered"}, {3, "output contactor commanded"},
    {4, "frequency threshold FTD reached"}, {5, "high speed reached"}, {6, "current threshold CTD reached"},
    {7, "reference reached"}, {8, "motor thermal threshold TTD reached"}, {9, "brake commanded"},
    {10, "PI error alarm"}, {11, "PI feedback alarm"}, {13, "frequency threshold F2D reached"},
    {14, "drive thermal threshold THA reached"}, {15, "traverse control active"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::state_word_2_bit> = detail::name_list<altivar::atv320_values::state_word_2_bit>({
    {5, "underload alarm"}, {6, "overload alarm"}, {11, "slack rope"},
    {12, "torque high threshold TTH reached"}, {13, "torque low threshold TTL reached"},
    {14, "turning forward"}, {15, "turning in reverse"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::state_word_3_bit> = detail::name_list<altivar::atv320_values::state_word_3_bit>({
    {0, "reference channel 2 active, else 1"}, {1, "command channel 2 active, else 1"},
    {2, "second ramps (AC2, DE2) in use"}, {3, "second current limit CL2 in use"},
    {5, "motor 2 thermal threshold reached"}, {6, "motor 3 thermal threshold reached"},
    {8, "external 24 V present"}, {9, "stopped after TLS at low speed"}, {15, "torque negative"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::state_word_4_bit> = detail::name_list<altivar::atv320_values::state_word_4_bit>({
    {0, "configuration 0 active"}, {1, "configuration 1 active"}, {2, "configuration 2 active"},
    {4, "parameter set 1 active"}, {5, "parameter set 2 active"}, {6, "parameter set 3 active"},
    {8, "power section not supplied"}, {9, "fluxing the motor"}, {10, "motor fluxed"},
    {11, "DC injection (ETI bit 5)"}, {12, "in current limit"}, {13, "accelerating (ETI bit 9)"},
    {14, "decelerating (ETI bit 10)"}, {15, "fast stop (ETI bit 12)"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::state_word_5_bit> = detail::name_list<altivar::atv320_values::state_word_5_bit>({
    {0, "DC bus charging"}, {1, "braking"}, {2, "power removed"}, {3, "automatic restart under way"},
    {4, "autotune under way"}, {5, "controlled stop after mains loss"}, {6, "deceleration ramp adapted"},
    {7, "output cut off"}, {8, "pulse warning level FQL reached"}, {9, "line contactor active"},
    {10, "autotune done"}, {13, "motor current present"}, {14, "stop switch reached"},
    {15, "load variation alarm"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::state_word_6_bit> = detail::name_list<altivar::atv320_values::state_word_6_bit>({
    {0, "alarm group 1 active"}, {1, "alarm group 2 active"}, {2, "alarm group 3 active"},
    {5, "LI6 probe alarm"}, {7, "external fault alarm"}, {8, "undervoltage alarm"},
    {9, "controlled stop voltage reached"}, {11, "drive thermal alarm"},
    {15, "torque or current limit, time is up"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::state_word_7_bit> = detail::name_list<altivar::atv320_values::state_word_7_bit>({
    {0, "reference channel 1 or 1B active"}, {1, "reference channel 2 active"}, {2, "command channel 1 active"},
    {3, "command channel 2 active"}, {4, "reference channel 1B active"}, {5, "end of reel"},
    {6, "wobble synchronisation"}, {8, "transistor temperature alarm"}, {11, "AI3 signal lost"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::state_word_8_bit> = detail::name_list<altivar::atv320_values::state_word_8_bit>({
    {9, "forced local control"}, {15, "drive ready"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
