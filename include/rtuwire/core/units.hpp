// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What is measured; amounts by their step, and as they are written: `decihertz`, `50_Hz`. core/quantity.hpp says what a
// quantity is, how it compares and how it computes.
#pragma once

#include <cstdint>
#include <ratio>

#include <rtuwire/core/quantity.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// What is measured. Each is a type without values.
struct frequency {
    static constexpr char symbol[] = "Hz";
};
struct rotation {
    static constexpr char symbol[] = "rpm";
};
struct current {
    static constexpr char symbol[] = "A";
};
struct voltage {
    static constexpr char symbol[] = "V";
};
struct proportion {
    static constexpr char symbol[] = "%";
};
struct time_span {
    static constexpr bool is_time = true;
    static constexpr char symbol[] = "s";
};
struct operating_time {
    static constexpr char symbol[] = "h";
};
struct torque {
    static constexpr char symbol[] = "Nm";
};
struct power {
    static constexpr char symbol[] = "W";
};
struct electrical_energy {
    static constexpr char symbol[] = "kWh";
};
struct temperature {
    static constexpr char symbol[] = "°C";
};
/// From absolute zero, or a difference of two temperatures.
struct absolute_temperature {
    static constexpr char symbol[] = "K";
};
struct apparent_power {
    static constexpr char symbol[] = "VA";
};
struct reactive_power {
    static constexpr char symbol[] = "var";
};
struct apparent_energy {
    static constexpr char symbol[] = "kVAh";
};
struct reactive_energy {
    static constexpr char symbol[] = "kvarh";
};
struct pressure {
    static constexpr char symbol[] = "bar";
};
struct volume {
    static constexpr char symbol[] = "m3";
};
struct hourly_flow {
    static constexpr char symbol[] = "m3/h";
};
/// 60 l/min are 3.6 m3/h: a step that has no digits of the other, so that each is measured by itself.
struct flow_by_minute {
    static constexpr char symbol[] = "l/min";
};
struct rate {
    static constexpr char symbol[] = "1/s";
};
/// Plain numbers: addresses, counters, gains.
struct dimensionless {
    static constexpr char symbol[] = "";
};

/// Register types, named by the step they count.
using hertz = quantity<frequency, std::uint16_t>;
using decihertz = quantity<frequency, std::uint16_t, std::deci>;
using signed_decihertz = quantity<frequency, std::int16_t, std::deci>;
using hectohertz = quantity<frequency, std::uint16_t, std::hecto>;
using rpm = quantity<rotation, std::uint16_t>;
using signed_rpm = quantity<rotation, std::int16_t>;
using deciamperes = quantity<current, std::uint16_t, std::deci>;
using centiamperes = quantity<current, std::uint16_t, std::centi>;
using microamperes = quantity<current, std::uint16_t, std::micro>;
using tenth_milliamperes = quantity<current, std::uint16_t, std::ratio<1, 10'000>>;
using volts = quantity<voltage, std::uint16_t>;
using decivolts = quantity<voltage, std::uint16_t, std::deci>;
using millivolts = quantity<voltage, std::uint16_t, std::milli>;
using percent = quantity<proportion, std::uint16_t>;
using signed_percent = quantity<proportion, std::int16_t>;
using tenth_percent = quantity<proportion, std::uint16_t, std::deci>;
using signed_tenth_percent = quantity<proportion, std::int16_t, std::deci>;
using seconds = quantity<time_span, std::uint16_t>;
using deciseconds = quantity<time_span, std::uint16_t, std::deci>;
using centiseconds = quantity<time_span, std::uint16_t, std::centi>;
namespace units {
using milliseconds = quantity<time_span, std::uint16_t, std::milli>;
}
using hours = quantity<operating_time, std::uint16_t>;
using centihours = quantity<operating_time, std::uint16_t, std::centi>;
using newton_metres = quantity<torque, std::int16_t>;
using watts = quantity<power, std::uint16_t>;
using hectowatts = quantity<power, std::uint16_t, std::hecto>;
using kilowatt_hours = quantity<electrical_energy, std::uint16_t>;
using watt_hours = quantity<electrical_energy, std::uint16_t, std::milli>;
using celsius = quantity<temperature, std::int16_t>;
using kelvins = quantity<absolute_temperature, std::uint16_t>;
using centi_per_second = quantity<rate, std::uint16_t, std::centi>;

/// Of meters, most of them for floating point numbers, `float32<amperes>`, and wide counts, `unsigned32<watt_hours>`.
using amperes = quantity<current, std::uint16_t>;
using milliamperes = quantity<current, std::uint16_t, std::milli>;
using kilovolts = quantity<voltage, std::uint16_t, std::kilo>;
using kilowatts = quantity<power, std::uint16_t, std::kilo>;
using megawatt_hours = quantity<electrical_energy, std::uint16_t, std::kilo>;
using volt_amperes = quantity<apparent_power, std::uint16_t>;
using kilovolt_amperes = quantity<apparent_power, std::uint16_t, std::kilo>;
using kilovolt_ampere_hours = quantity<apparent_energy, std::uint16_t>;
using vars = quantity<reactive_power, std::int16_t>;
using kilovars = quantity<reactive_power, std::int16_t, std::kilo>;
using kilovar_hours = quantity<reactive_energy, std::uint16_t>;
using bars = quantity<pressure, std::int16_t>;
using millibars = quantity<pressure, std::int16_t, std::milli>;
using cubic_metres = quantity<volume, std::uint16_t>;
using litres = quantity<volume, std::uint16_t, std::milli>;
using cubic_metres_per_hour = quantity<hourly_flow, std::uint16_t>;
using litres_per_minute = quantity<flow_by_minute, std::uint16_t>;

/// Numbers without a unit.
using count16 = quantity<dimensionless, std::uint16_t>;
using signed_count16 = quantity<dimensionless, std::int16_t>;
using count16_tenths = quantity<dimensionless, std::uint16_t, std::deci>;
using count16_hundredths = quantity<dimensionless, std::uint16_t, std::centi>;

/// A decimal literal, read digit by digit: 1.30 is 130 hundredths.
template <char... Digits> struct decimal {
    static consteval std::int64_t count() noexcept
    {
        std::int64_t value = 0;
        ((value = Digits >= '0' and Digits <= '9' ? value * 10 + (Digits - '0') : value), ...);
        return value;
    }

    static consteval std::intmax_t steps_per_one() noexcept
    {
        bool after_point = false;
        std::intmax_t steps = 1;
        auto const read = [&](char digit) {
            after_point = after_point or digit == '.';
            steps *= after_point and digit != '.' and digit != '\'' ? 10 : 1;
        };
        (read(Digits), ...);
        return steps;
    }

    static consteval bool is_plain() noexcept
    {
        return ((Digits == '.' or Digits == '\'' or (Digits >= '0' and Digits <= '9')) and ...);
    }
};

/// The quantity that a literal spells, in steps of its last digit.
template <typename Dimension, typename Unit, char... Digits> [[nodiscard]] consteval auto spelled() noexcept
{
    using number = decimal<Digits...>;
    static_assert(number::is_plain(), "a quantity is written in decimal digits, as 50 or 1.3");
    using scale = std::ratio_multiply<Unit, std::ratio<1, number::steps_per_one()>>;
    return quantity<Dimension, std::int64_t, scale>{number::count()};
}

inline namespace literals {

template <char... Text> consteval auto operator""_Hz() noexcept { return spelled<frequency, std::ratio<1>, Text...>(); }
template <char... Text> consteval auto operator""_kHz() noexcept { return spelled<frequency, std::kilo, Text...>(); }
template <char... Text> consteval auto operator""_rpm() noexcept { return spelled<rotation, std::ratio<1>, Text...>(); }
template <char... Text> consteval auto operator""_A() noexcept { return spelled<current, std::ratio<1>, Text...>(); }
template <char... Text> consteval auto operator""_mA() noexcept { return spelled<current, std::milli, Text...>(); }
template <char... Text> consteval auto operator""_V() noexcept { return spelled<voltage, std::ratio<1>, Text...>(); }
template <char... Text> consteval auto operator""_percent() noexcept
{
    return spelled<proportion, std::ratio<1>, Text...>();
}
template <char... Text> consteval auto operator""_s() noexcept { return spelled<time_span, std::ratio<1>, Text...>(); }
template <char... Text> consteval auto operator""_h() noexcept
{
    return spelled<operating_time, std::ratio<1>, Text...>();
}
template <char... Text> consteval auto operator""_Nm() noexcept { return spelled<torque, std::ratio<1>, Text...>(); }
template <char... Text> consteval auto operator""_W() noexcept { return spelled<power, std::ratio<1>, Text...>(); }
template <char... Text> consteval auto operator""_kW() noexcept { return spelled<power, std::kilo, Text...>(); }
template <char... Text> consteval auto operator""_VA() noexcept
{
    return spelled<apparent_power, std::ratio<1>, Text...>();
}
template <char... Text> consteval auto operator""_var() noexcept
{
    return spelled<reactive_power, std::ratio<1>, Text...>();
}
template <char... Text> consteval auto operator""_bar() noexcept { return spelled<pressure, std::ratio<1>, Text...>(); }
template <char... Text> consteval auto operator""_m3() noexcept { return spelled<volume, std::ratio<1>, Text...>(); }
template <char... Text> consteval auto operator""_K() noexcept
{
    return spelled<absolute_temperature, std::ratio<1>, Text...>();
}
template <char... Text> consteval auto operator""_kWh() noexcept
{
    return spelled<electrical_energy, std::ratio<1>, Text...>();
}
template <char... Text> consteval auto operator""_Wh() noexcept
{
    return spelled<electrical_energy, std::milli, Text...>();
}
template <char... Text> consteval auto operator""_celsius() noexcept
{
    return spelled<temperature, std::ratio<1>, Text...>();
}
/// A plain number for a register without a unit.
template <char... Text> consteval auto operator""_raw() noexcept
{
    return spelled<dimensionless, std::ratio<1>, Text...>();
}

} // namespace literals

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
