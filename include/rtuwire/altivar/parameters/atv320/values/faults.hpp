// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: enumerations and words of bits of the parameters of faults and safety functions.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320_values {

// clang-format off
/// How long automatic restart goes on trying.
enum class restart_time : std::uint16_t {
    minutes_5 = 0, minutes_10 = 1, minutes_30 = 2, hours_1 = 3, hours_2 = 4, hours_3 = 5, unlimited
    = 6,
};

/// How the motor is cooled.
enum class motor_cooling : std::uint16_t {
    no = 0, self_cooled = 1, forced = 2,
};

/// What a lost output phase does.
enum class output_phase_loss : std::uint16_t {
    no = 0, fault = 1, output_cut = 2,
};

/// What undervoltage does.
enum class undervoltage_reaction : std::uint16_t {
    fault = 0, fault_no_relay = 1, alarm = 2,
};

/// The rated mains voltage.
enum class mains_rating : std::uint16_t {
    v200 = 20, v220 = 22, v230 = 23, v240 = 24, v380 = 38, v400 = 40, v440 = 44, v460 = 46, v500 =
    50, v525 = 53, v600 = 60, lexium = 254,
};

/// How lost mains stop the motor.
enum class power_loss_stop : std::uint16_t {
    freewheel = 0, maintain = 1, ramp = 2, freewheel_no_fault = 4,
};

/// The state of safe torque off.
enum class sto_state : std::uint16_t {
    idle = 0, active = 1, fault = 2,
};

/// Which difference of speed trips.
enum class slip_direction : std::uint16_t {
    overspeed = 0, both = 1,
};

/// Which drives share the DC bus.
enum class dc_bus_partner : std::uint16_t {
    altivar = 0, lexium = 1,
};

/// What feeds the drive.
enum class dc_bus_supply : std::uint16_t {
    no = 0, bus_and_mains = 1, bus = 2,
};

/// The state of the guard door lock.
enum class gdl_state : std::uint16_t {
    no = 0, off = 1, short_delay = 2, long_delay = 3, on = 4, fault = 5,
};

/// When a motor probe is watched.
enum class ptc_mode : std::uint16_t {
    no = 0, always = 1, powered = 2, motor_on = 3,
};

/// The input of a safety function.
enum class safety_input : std::uint16_t {
    no = 0, li3_li4 = 1, li5_li6 = 2, li3_pwrm = 3, pwrm = 4,
};

/// Whether the drive has safety functions.
enum class safety_state : std::uint16_t {
    standard = 0, safe = 1,
};

/// The state of safely limited speed.
enum class sls_state : std::uint16_t {
    no = 0, idle = 1, ramp = 2, limited = 3, sto = 4, fault = 5, waiting = 6, starting = 7,
};

/// The type of safely limited speed.
enum class sls_type : std::uint16_t {
    type_1 = 0, type_2 = 1, type_3 = 2, type_4 = 3, type_5 = 4, type_6 = 5,
};

/// The state of safe maximum speed.
enum class sms_state : std::uint16_t {
    no = 0, active = 1, internal_fault = 2, overspeed = 3,
};

/// The state of safe stop 1.
enum class ss1_state : std::uint16_t {
    no = 0, idle = 1, ramp = 2, sto = 3, fault = 4,
};

/// The size of a step of the safe ramp.
enum class ss1_step : std::uint16_t {
    hz_1 = 0, hz_10 = 1, hz_100 = 2,
};
// clang-format on

} // namespace altivar::atv320_values

namespace altivar::atv320 {

using namespace atv320_values;

} // namespace altivar::atv320

// clang-format off
template <>
inline constexpr auto enumerators<altivar::atv320_values::restart_time> = detail::name_list<altivar::atv320_values::restart_time>({
    {0, "5"}, {1, "10"}, {2, "30"}, {3, "1H"}, {4, "2H"}, {5, "3H"}, {6, "Ct"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::restart_time> = detail::name_list<altivar::atv320_values::restart_time>({
    {0, "5 min"}, {1, "10 min"}, {2, "30 min"}, {3, "1 h"}, {4, "2 h"}, {5, "3 h"}, {6, "unlimited"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::motor_cooling> = detail::name_list<altivar::atv320_values::motor_cooling>({
    {0, "nO"}, {1, "ACL"}, {2, "FCL"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::motor_cooling> = detail::name_list<altivar::atv320_values::motor_cooling>({
    {0, "no protection"}, {1, "self-cooled motor"}, {2, "force-cooled motor"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::output_phase_loss> = detail::name_list<altivar::atv320_values::output_phase_loss>({
    {0, "nO"}, {1, "YES"}, {2, "OAC"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::output_phase_loss> = detail::name_list<altivar::atv320_values::output_phase_loss>({
    {0, "not detected"}, {1, "fault OPF"}, {2, "no fault, output may be cut"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::undervoltage_reaction> = detail::name_list<altivar::atv320_values::undervoltage_reaction>({
    {0, "0"}, {1, "1"}, {2, "2"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::undervoltage_reaction> = detail::name_list<altivar::atv320_values::undervoltage_reaction>({
    {0, "fault, relay opens"}, {1, "fault, relay stays"}, {2, "alarm only"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::mains_rating> = detail::name_list<altivar::atv320_values::mains_rating>({
    {20, "200"}, {22, "220"}, {23, "230"}, {24, "240"}, {38, "380"}, {40, "400"}, {44, "440"}, {46, "460"},
    {50, "500"}, {53, "525"}, {60, "600"}, {254, "LHM"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::mains_rating> = detail::name_list<altivar::atv320_values::mains_rating>({
    {20, "200 V"}, {22, "220 V"}, {23, "230 V"}, {24, "240 V"}, {38, "380 V"}, {40, "400 V"}, {44, "440 V"},
    {46, "460 V"}, {50, "500 V"}, {53, "525 V"}, {60, "600 V"}, {254, "Lexium level"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::power_loss_stop> = detail::name_list<altivar::atv320_values::power_loss_stop>({
    {0, "nO"}, {1, "MMS"}, {2, "rMP"}, {4, "LnF"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::power_loss_stop> = detail::name_list<altivar::atv320_values::power_loss_stop>({
    {0, "freewheel, then a fault"}, {1, "DC bus kept up"}, {2, "ramp stop"}, {4, "freewheel, no fault"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::sto_state> = detail::name_list<altivar::atv320_values::sto_state>({
    {0, "IdLE"}, {1, "StO"}, {2, "FLt"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::sto_state> = detail::name_list<altivar::atv320_values::sto_state>({
    {0, "inactive"}, {1, "active"}, {2, "in fault"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::slip_direction> = detail::name_list<altivar::atv320_values::slip_direction>({
    {0, "OVEr"}, {1, "bOtH"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::slip_direction> = detail::name_list<altivar::atv320_values::slip_direction>({
    {0, "too fast"}, {1, "too fast or too slow"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::dc_bus_partner> = detail::name_list<altivar::atv320_values::dc_bus_partner>({
    {0, "AtV"}, {1, "LHM"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::dc_bus_partner> = detail::name_list<altivar::atv320_values::dc_bus_partner>({
    {0, "Altivar"}, {1, "Lexium"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::dc_bus_supply> = detail::name_list<altivar::atv320_values::dc_bus_supply>({
    {0, "nO"}, {1, "MAIn"}, {2, "bUS"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::dc_bus_supply> = detail::name_list<altivar::atv320_values::dc_bus_supply>({
    {0, "not shared"}, {1, "by the bus and the mains"}, {2, "by the bus only"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::gdl_state> = detail::name_list<altivar::atv320_values::gdl_state>({
    {0, "nO"}, {1, "OFF"}, {2, "Std"}, {3, "LGd"}, {4, "On"}, {5, "FLt"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::gdl_state> = detail::name_list<altivar::atv320_values::gdl_state>({
    {0, "not configured"}, {1, "inactive"}, {2, "short delay runs"}, {3, "long delay runs"}, {4, "active"},
    {5, "in fault"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::ptc_mode> = detail::name_list<altivar::atv320_values::ptc_mode>({
    {0, "nO"}, {1, "AS"}, {2, "rdS"}, {3, "rS"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::ptc_mode> = detail::name_list<altivar::atv320_values::ptc_mode>({
    {0, "not supervised"}, {1, "always"}, {2, "with the power section on"}, {3, "with the motor on"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::safety_input> = detail::name_list<altivar::atv320_values::safety_input>({
    {0, "nO"}, {1, "L34"}, {2, "L56"}, {3, "L3PW"}, {4, "PWrM"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::safety_input> = detail::name_list<altivar::atv320_values::safety_input>({
    {0, "not assigned"}, {1, "LI3 and LI4"}, {2, "LI5 and LI6"}, {3, "LI3 and PWRM"}, {4, "PWRM"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::safety_state> = detail::name_list<altivar::atv320_values::safety_state>({
    {0, "Std"}, {1, "SAFE"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::safety_state> = detail::name_list<altivar::atv320_values::safety_state>({
    {0, "standard drive"}, {1, "safety functions configured"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::sls_state> = detail::name_list<altivar::atv320_values::sls_state>({
    {0, "nO"}, {1, "IdLE"}, {2, "SS1"}, {3, "SLS"}, {4, "StO"}, {5, "FLt"}, {6, "WAIt"}, {7, "Strt"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::sls_state> = detail::name_list<altivar::atv320_values::sls_state>({
    {0, "not configured"}, {1, "inactive"}, {2, "safe ramp"}, {3, "speed limited"}, {4, "safe torque off"},
    {5, "in fault"}, {6, "waiting (WAIt)"}, {7, "starting (Strt)"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::sls_type> = detail::name_list<altivar::atv320_values::sls_type>({
    {0, "tYP1"}, {1, "tYP2"}, {2, "tYP3"}, {3, "tYP4"}, {4, "tYP5"}, {5, "tYP6"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::sls_type> = detail::name_list<altivar::atv320_values::sls_type>({
    {0, "type 1"}, {1, "type 2"}, {2, "type 3"}, {3, "type 4"}, {4, "type 5"}, {5, "type 6"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::sms_state> = detail::name_list<altivar::atv320_values::sms_state>({
    {0, "nO"}, {1, "SMS"}, {2, "FtI"}, {3, "FtO"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::sms_state> = detail::name_list<altivar::atv320_values::sms_state>({
    {0, "not configured"}, {1, "active"}, {2, "internal fault (FtI)"}, {3, "overspeed fault (FtO)"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::ss1_state> = detail::name_list<altivar::atv320_values::ss1_state>({
    {0, "nO"}, {1, "IdLE"}, {2, "SS1"}, {3, "StO"}, {4, "FLt"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::ss1_state> = detail::name_list<altivar::atv320_values::ss1_state>({
    {0, "not configured"}, {1, "inactive"}, {2, "safe ramp"}, {3, "safe torque off"}, {4, "in fault"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::ss1_step> = detail::name_list<altivar::atv320_values::ss1_step>({
    {0, "1H"}, {1, "10H"}, {2, "100H"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::ss1_step> = detail::name_list<altivar::atv320_values::ss1_step>({
    {0, "1 Hz/s"}, {1, "10 Hz/s"}, {2, "100 Hz/s"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
