// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: enumerations and words of bits of the parameters of the motor and its control.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320_values {

// clang-format off
/// Whose data the motor model uses.
enum class motor_model : std::uint16_t {
    defaults = 0, measured = 1, custom = 2,
};

/// How much the inductances of a synchronous motor differ.
enum class saliency : std::uint16_t {
    unknown = 0, low = 1, medium = 2, high = 3,
};

/// The mains frequency that motors are rated for.
enum class motor_standard : std::uint16_t {
    hz_50 = 0, hz_60 = 1,
};

/// Whether the motor is measured, and the result dropped.
enum class tuning_order : std::uint16_t {
    no = 0, run = 1, clear = 2,
};

/// When the motor is measured without being asked for.
enum class automatic_tuning : std::uint16_t {
    no = 0, power_on = 1, once = 2,
};

/// How far tuning is.
enum class tuning_state : std::uint16_t {
    defaults = 0, pending = 1, running = 2, failed = 3, done = 4,
};

/// How voltage follows frequency.
enum class motor_control_law : std::uint16_t {
    vector = 0, standard = 3, five_points = 4, synchronous = 5, quadratic = 6, energy_saving = 7,
};

/// Whether the switching frequency may fall.
enum class switching_mode : std::uint16_t {
    hf1 = 1, hf2 = 2,
};

/// How the boost works.
enum class boost_mode : std::uint16_t {
    no = 0, dynamic = 1, steady = 2,
};

/// The time between voltage steps at the motor, against surges.
enum class surge_time : std::uint16_t {
    us_6 = 6, us_8 = 8, us_10 = 10,
};

/// How a low reference is treated.
enum class reference_shape : std::uint16_t {
    standard = 0, pedestal = 1, deadband = 2, deadband_zero = 4,
};

/// When the motor is fluxed.
enum class fluxing : std::uint16_t {
    on_run = 0, continuous = 1, no = 2,
};

/// How the angle of a synchronous motor is found.
enum class angle_setting : std::uint16_t {
    ipm = 3, spm = 4, psi = 5, psi_optimised = 6, no = 254,
};

/// Which data of the motor are given.
enum class motor_data_choice : std::uint16_t {
    power = 0, power_factor = 1,
};

/// How temperature enters the measured data.
enum class tuning_temperature : std::uint16_t {
    no = 0, thermal_model = 1, cold = 2,
};
// clang-format on

} // namespace altivar::atv320_values

namespace altivar::atv320 {

using namespace atv320_values;

} // namespace altivar::atv320

// clang-format off
template <>
inline constexpr auto enumerators<altivar::atv320_values::motor_model> = detail::name_list<altivar::atv320_values::motor_model>({
    {0, "tAb"}, {1, "MEAS"}, {2, "CUS"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::motor_model> = detail::name_list<altivar::atv320_values::motor_model>({
    {0, "table values"}, {1, "measured values"}, {2, "user values"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::saliency> = detail::name_list<altivar::atv320_values::saliency>({
    {0, "nO"}, {1, "LLS"}, {2, "MLS"}, {3, "HLS"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::saliency> = detail::name_list<altivar::atv320_values::saliency>({
    {0, "unknown"}, {1, "low"}, {2, "medium"}, {3, "high"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::motor_standard> = detail::name_list<altivar::atv320_values::motor_standard>({
    {0, "50"}, {1, "60"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::motor_standard> = detail::name_list<altivar::atv320_values::motor_standard>({
    {0, "50 Hz"}, {1, "60 Hz"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::tuning_order> = detail::name_list<altivar::atv320_values::tuning_order>({
    {0, "nO"}, {1, "YES"}, {2, "CLr"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::tuning_order> = detail::name_list<altivar::atv320_values::tuning_order>({
    {0, "none"}, {1, "tune now"}, {2, "erase the results"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::automatic_tuning> = detail::name_list<altivar::atv320_values::automatic_tuning>({
    {0, "nO"}, {1, "YES"}, {2, "OnE"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::automatic_tuning> = detail::name_list<altivar::atv320_values::automatic_tuning>({
    {0, "no"}, {1, "at each power-on"}, {2, "at the first run order"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::tuning_state> = detail::name_list<altivar::atv320_values::tuning_state>({
    {0, "tAb"}, {1, "PEnd"}, {2, "PrOG"}, {3, "FAIL"}, {4, "dOnE"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::tuning_state> = detail::name_list<altivar::atv320_values::tuning_state>({
    {0, "not tuned, table values"}, {1, "pending"}, {2, "running"}, {3, "failed"}, {4, "done, measured values"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::motor_control_law> = detail::name_list<altivar::atv320_values::motor_control_law>({
    {0, "UUC"}, {3, "Std"}, {4, "UF5"}, {5, "SYn"}, {6, "UFq"}, {7, "nLd"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::motor_control_law> = detail::name_list<altivar::atv320_values::motor_control_law>({
    {0, "sensorless vector"}, {3, "V/f"}, {4, "V/f by five points"}, {5, "synchronous motor"},
    {6, "quadratic V/f"}, {7, "energy saving"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::switching_mode> = detail::name_list<altivar::atv320_values::switching_mode>({
    {1, "HF1"}, {2, "HF2"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::switching_mode> = detail::name_list<altivar::atv320_values::switching_mode>({
    {1, "HF1: frequency may be reduced"}, {2, "HF2: frequency is kept"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::boost_mode> = detail::name_list<altivar::atv320_values::boost_mode>({
    {0, "nO"}, {1, "dYnA"}, {2, "StAt"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::boost_mode> = detail::name_list<altivar::atv320_values::boost_mode>({
    {0, "off"}, {1, "dynamic"}, {2, "static"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::surge_time> = detail::name_list<altivar::atv320_values::surge_time>({
    {6, "6"}, {8, "8"}, {10, "10"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::surge_time> = detail::name_list<altivar::atv320_values::surge_time>({
    {6, "6 us"}, {8, "8 us"}, {10, "10 us"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::reference_shape> = detail::name_list<altivar::atv320_values::reference_shape>({
    {0, "bSd"}, {1, "bLS"}, {2, "bnS"}, {4, "bnS0"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::reference_shape> = detail::name_list<altivar::atv320_values::reference_shape>({
    {0, "from LSP to HSP"}, {1, "limited below at LSP"}, {2, "deadband up to LSP"}, {4, "deadband at zero"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::fluxing> = detail::name_list<altivar::atv320_values::fluxing>({
    {0, "FnC"}, {1, "FCt"}, {2, "FnO"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::fluxing> = detail::name_list<altivar::atv320_values::fluxing>({
    {0, "by a run order"}, {1, "continuous, from power-on"}, {2, "none"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::angle_setting> = detail::name_list<altivar::atv320_values::angle_setting>({
    {3, "IPMA"}, {4, "SPMA"}, {5, "PSI"}, {6, "PSIO"}, {254, "nO"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::angle_setting> = detail::name_list<altivar::atv320_values::angle_setting>({
    {3, "IPM alignment"}, {4, "SPM alignment"}, {5, "pulse injection"}, {6, "pulse injection, optimised"},
    {254, "none"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::motor_data_choice> = detail::name_list<altivar::atv320_values::motor_data_choice>({
    {0, "nPr"}, {1, "COS"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::motor_data_choice> = detail::name_list<altivar::atv320_values::motor_data_choice>({
    {0, "rated power (NPR)"}, {1, "power factor (COS)"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::tuning_temperature> = detail::name_list<altivar::atv320_values::tuning_temperature>({
    {0, "nO"}, {1, "tM"}, {2, "Ct"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::tuning_temperature> = detail::name_list<altivar::atv320_values::tuning_temperature>({
    {0, "not followed"}, {1, "by the thermal model"}, {2, "values of the cold motor"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
