// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Rows as the registers of a drive, by table/row_table.hpp: what the further parameters measure, beside the units of
// core/units.hpp, and all the amounts that a row may be of.
#pragma once

#include <cstdint>
#include <ratio>

#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/altivar/parameters/row_demands.hpp>
#include <rtuwire/core/quantity.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/row_table.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What is measured.
/// Internal.
struct resistance {
    static constexpr char symbol[] = "Ohm";
};
/// Internal.
struct inductance {
    static constexpr char symbol[] = "H";
};
/// Internal.
struct distance {
    static constexpr char symbol[] = "m";
};
/// Internal.
struct travelling_speed {
    static constexpr char symbol[] = "m/s";
};
/// The voltage that a turning motor makes.
/// Internal.
struct voltage_of_speed {
    static constexpr char symbol[] = "V/rpm";
};

/// Register types, named by the step they count.
using decahertz = quantity<frequency, std::uint16_t, std::deca>;
using hundredth_percent = quantity<proportion, std::uint16_t, std::centi>;
using minutes = quantity<time_span, std::uint16_t, std::ratio<60>>;
using signed_centiseconds = quantity<time_span, std::int16_t, std::centi>;
using tenth_milliseconds = quantity<time_span, std::uint16_t, std::ratio<1, 10'000>>;
using signed_deciamperes = quantity<current, std::int16_t, std::deci>;
using signed_microamperes = quantity<current, std::int16_t, std::micro>;
using signed_millivolts = quantity<voltage, std::int16_t, std::milli>;
using whole_celsius = quantity<temperature, std::uint16_t>;
using decinewton_metres = quantity<torque, std::uint16_t, std::deci>;
using milliohms = quantity<resistance, std::uint16_t, std::milli>;
using hundredth_millihenries = quantity<inductance, std::uint16_t, std::ratio<1, 100'000>>;
using centimetres = quantity<distance, std::uint16_t, std::centi>;
using centimetres_per_second = quantity<travelling_speed, std::uint16_t, std::centi>;
using tenth_millivolts_per_rpm = quantity<voltage_of_speed, std::uint16_t, std::ratio<1, 10'000>>;

/// Those of this library.
using usual_amounts =
    amount_types<hertz, decihertz, signed_decihertz, hectohertz, decahertz, rpm, signed_rpm, deciamperes,
                 signed_deciamperes, microamperes, signed_microamperes, tenth_milliamperes, volts, decivolts,
                 millivolts, signed_millivolts, percent, signed_percent, tenth_percent, signed_tenth_percent,
                 hundredth_percent, seconds, deciseconds, centiseconds, signed_centiseconds, units::milliseconds,
                 tenth_milliseconds, minutes, hours, centihours, celsius, whole_celsius, centi_per_second, count16,
                 signed_count16, count16_tenths, count16_hundredths, decinewton_metres, milliohms,
                 hundredth_millihenries, centimetres, centimetres_per_second, tenth_millivolts_per_rpm>;

} // namespace altivar

template <> struct detail::usual_amounts_of<altivar::parameter> {
    using type = altivar::usual_amounts;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
