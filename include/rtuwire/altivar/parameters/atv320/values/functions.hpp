// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: enumerations and words of bits of the parameters of its functions.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320_values {

// clang-format off
/// The shape of a ramp.
enum class ramp_shape : std::uint16_t {
    linear = 0, s = 1, u = 2, custom = 3,
};

/// Whether a ramp is stretched when braking raises the DC bus.
enum class ramp_adaptation : std::uint16_t {
    no = 0, yes = 1, dynamic = 2,
};

/// DC injection at standstill.
enum class auto_injection : std::uint16_t {
    no = 0, timed = 1, continuous = 2,
};

/// Where a speed set by two inputs is kept.
enum class speed_memory : std::uint16_t {
    no = 0, ram = 1, eeprom = 2,
};

/// How the load moves.
enum class brake_movement : std::uint16_t {
    horizontal = 0, vertical = 1,
};

/// Torque before the brake opens.
enum class brake_impulse : std::uint16_t {
    no = 0, forward = 1, both = 2,
};

/// The output that commands the brake.
enum class brake_output : std::uint16_t {
    no = 0, r2 = 2, lo1 = 17, do1 = 64,
};

/// How the speed of a hoist is raised.
enum class fast_hoisting : std::uint16_t {
    no = 0, speed = 1, current = 2,
};

/// How a slack rope is found.
enum class slack_rope : std::uint16_t {
    no = 0, estimated = 1, sensor = 2,
};

/// The size of a torque step.
enum class torque_step : std::uint16_t {
    hundredths = 0, tenths = 1, whole = 2,
};

/// The output of a contactor.
enum class contactor_output : std::uint16_t {
    no = 0, r2 = 146, lo1 = 129, do1 = 161,
};

/// How the ramp after a slowdown switch is found.
enum class slowdown_type : std::uint16_t {
    standard = 0, optimised = 1,
};

/// The level that counts as active.
enum class input_level : std::uint16_t {
    low = 0, high = 1,
};
// clang-format on

} // namespace altivar::atv320_values

namespace altivar::atv320 {

using namespace atv320_values;

} // namespace altivar::atv320

// clang-format off
template <>
inline constexpr auto enumerators<altivar::atv320_values::ramp_shape> = detail::name_list<altivar::atv320_values::ramp_shape>({
    {0, "LIn"}, {1, "S"}, {2, "U"}, {3, "CUS"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::ramp_shape> = detail::name_list<altivar::atv320_values::ramp_shape>({
    {0, "linear"}, {1, "S"}, {2, "U"}, {3, "as TA1 to TA4 say"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::ramp_adaptation> = detail::name_list<altivar::atv320_values::ramp_adaptation>({
    {0, "nO"}, {1, "YES"}, {2, "dYnA"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::ramp_adaptation> = detail::name_list<altivar::atv320_values::ramp_adaptation>({
    {0, "off"}, {1, "on"}, {2, "on, with more braking in the motor"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::auto_injection> = detail::name_list<altivar::atv320_values::auto_injection>({
    {0, "nO"}, {1, "YES"}, {2, "Ct"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::auto_injection> = detail::name_list<altivar::atv320_values::auto_injection>({
    {0, "off"}, {1, "for a time"}, {2, "continuous"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::speed_memory> = detail::name_list<altivar::atv320_values::speed_memory>({
    {0, "nO"}, {1, "rAM"}, {2, "EEP"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::speed_memory> = detail::name_list<altivar::atv320_values::speed_memory>({
    {0, "not stored"}, {1, "in RAM"}, {2, "in EEPROM"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::brake_movement> = detail::name_list<altivar::atv320_values::brake_movement>({
    {0, "HOr"}, {1, "VEr"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::brake_movement> = detail::name_list<altivar::atv320_values::brake_movement>({
    {0, "horizontal"}, {1, "vertical"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::brake_impulse> = detail::name_list<altivar::atv320_values::brake_impulse>({
    {0, "nO"}, {1, "YES"}, {2, "2Ibr"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::brake_impulse> = detail::name_list<altivar::atv320_values::brake_impulse>({
    {0, "in the requested direction"}, {1, "always forward"}, {2, "in the direction of each current"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::brake_output> = detail::name_list<altivar::atv320_values::brake_output>({
    {0, "nO"}, {2, "r2"}, {17, "LO1"}, {64, "dO1"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::brake_output> = detail::name_list<altivar::atv320_values::brake_output>({
    {0, "not assigned"}, {2, "R2"}, {17, "LO1"}, {64, "logic output on AO1"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::fast_hoisting> = detail::name_list<altivar::atv320_values::fast_hoisting>({
    {0, "nO"}, {1, "SSO"}, {2, "CSO"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::fast_hoisting> = detail::name_list<altivar::atv320_values::fast_hoisting>({
    {0, "off"}, {1, "limited by reference"}, {2, "limited by current"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::slack_rope> = detail::name_list<altivar::atv320_values::slack_rope>({
    {0, "nO"}, {1, "drI"}, {2, "PES"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::slack_rope> = detail::name_list<altivar::atv320_values::slack_rope>({
    {0, "off"}, {1, "estimated by the drive"}, {2, "by the weight sensor"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::torque_step> = detail::name_list<altivar::atv320_values::torque_step>({
    {0, "001"}, {1, "01"}, {2, "1"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::torque_step> = detail::name_list<altivar::atv320_values::torque_step>({
    {0, "0.01 %"}, {1, "0.1 %"}, {2, "1 %"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::contactor_output> = detail::name_list<altivar::atv320_values::contactor_output>({
    {0, "nO"}, {146, "r2"}, {129, "LO1"}, {161, "dO1"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::contactor_output> = detail::name_list<altivar::atv320_values::contactor_output>({
    {0, "not assigned"}, {146, "R2"}, {129, "LO1"}, {161, "logic output on AO1"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::slowdown_type> = detail::name_list<altivar::atv320_values::slowdown_type>({
    {0, "Std"}, {1, "OPt"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::slowdown_type> = detail::name_list<altivar::atv320_values::slowdown_type>({
    {0, "by the ramp in use"}, {1, "by the speed at the switch"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::input_level> = detail::name_list<altivar::atv320_values::input_level>({
    {0, "LO"}, {1, "HIG"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::input_level> = detail::name_list<altivar::atv320_values::input_level>({
    {0, "active low"}, {1, "active high"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
