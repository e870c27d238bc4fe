// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Quantities: exact, and only from one unit to the same.
#include <rtuwire/core/units.hpp>

#include <limits>
#include <type_traits>

#include <rtuwire/core/time.hpp>

#include "support/proof.hpp"

using namespace rtuwire;

namespace {

STATIC_CHECK(sizeof(decihertz) == 2 and std::is_trivially_copyable_v<decihertz>);

// A literal counts steps of its last digit.
STATIC_CHECK((50_Hz).count() == 50 and std::same_as<decltype(50_Hz)::scale, std::ratio<1>>);
STATIC_CHECK((1.30_s).count() == 130 and std::same_as<decltype(1.30_s)::scale, std::centi>);
STATIC_CHECK((-1500_rpm).count() == -1500);
STATIC_CHECK(std::same_as<decltype(4_kHz)::scale, std::kilo>);

// What each literal is one of, and of what size.
template <typename Dimension, typename Scale, typename Literal> constexpr bool is_one(Literal const& one)
{
    return std::same_as<Literal, quantity<Dimension, std::int64_t, Scale>> and one.count() == 1;
}
STATIC_CHECK(is_one<frequency, std::ratio<1>>(1_Hz) and is_one<frequency, std::kilo>(1_kHz));
STATIC_CHECK(is_one<rotation, std::ratio<1>>(1_rpm) and is_one<voltage, std::ratio<1>>(1_V));
STATIC_CHECK(is_one<current, std::ratio<1>>(1_A) and is_one<current, std::milli>(1_mA));
STATIC_CHECK(is_one<proportion, std::ratio<1>>(1_percent) and is_one<time_span, std::ratio<1>>(1_s));
STATIC_CHECK(is_one<operating_time, std::ratio<1>>(1_h) and is_one<torque, std::ratio<1>>(1_Nm));
STATIC_CHECK(is_one<power, std::ratio<1>>(1_W) and is_one<temperature, std::ratio<1>>(1_celsius));
STATIC_CHECK(is_one<power, std::kilo>(1_kW) and is_one<absolute_temperature, std::ratio<1>>(1_K));
STATIC_CHECK(is_one<apparent_power, std::ratio<1>>(1_VA) and is_one<reactive_power, std::ratio<1>>(1_var));
STATIC_CHECK(is_one<electrical_energy, std::ratio<1>>(1_kWh) and is_one<electrical_energy, std::milli>(1_Wh));
STATIC_CHECK(is_one<pressure, std::ratio<1>>(1_bar) and is_one<volume, std::ratio<1>>(1_m3));
STATIC_CHECK(is_one<dimensionless, std::ratio<1>>(1_raw));

// Each decimal digit is one, wherever it stands; an apostrophe only parts them.
STATIC_CHECK((9_Hz).count() == 9 and (19.9_s).count() == 199);
STATIC_CHECK((1'234'567'890_raw).count() == 1'234'567'890);
STATIC_CHECK((1'000.25_s).count() == 100'025 and std::same_as<decltype(1'000.25_s)::scale, std::centi>);

// Ten of these steps are a milliampere.
STATIC_CHECK(truncated_to<tenth_milliamperes>(1_A).count() == 10'000);
STATIC_CHECK(truncated_to<tenth_milliamperes>(0.1_mA).count() == 1);

// Finer is implicit, coarser is spelled, and what a number cannot hold is neither.
using long_decihertz = quantity<frequency, std::int32_t, std::deci>;
STATIC_CHECK(long_decihertz{hertz{50}}.count() == 500);
STATIC_CHECK(std::is_convertible_v<hertz, long_decihertz>);
STATIC_CHECK(long_decihertz{signed_decihertz{-500}}.count() == -500);
STATIC_CHECK(std::is_convertible_v<signed_decihertz, long_decihertz>);
STATIC_CHECK(not std::is_convertible_v<decihertz, hertz>);
STATIC_CHECK(not std::is_constructible_v<hertz, decihertz>);

// A literal becomes any register type that holds it exactly.
constexpr decihertz fifty = 50_Hz;
constexpr decihertz tenths = 47.5_Hz;
constexpr hertz whole = 50.0_Hz;
constexpr hectohertz switching = 4_kHz;
constexpr signed_rpm backwards = -1500_rpm;
STATIC_CHECK(fifty.count() == 500 and tenths.count() == 475 and whole.count() == 50 and switching.count() == 40);
STATIC_CHECK(backwards.count() == -1500);
constexpr duration wait = 5_s;
STATIC_CHECK(wait == milliseconds(5'000) and duration{0.02_s} == milliseconds(20) and wait == 5.0_s);
STATIC_CHECK(instant{7} + 0.000001_s == instant{8});
STATIC_CHECK(not std::is_convertible_v<decltype(5_h), duration>);
struct options {
    duration limit = 2_s;
    decihertz top = 50_Hz;
    deciseconds ramp{1.3_s};
};
STATIC_CHECK(options{.limit = 3_s, .top = 60_Hz}.top.count() == 600 and options{}.ramp.count() == 13);
STATIC_CHECK(not std::is_constructible_v<decihertz, hertz>);
STATIC_CHECK(not std::is_constructible_v<rpm, signed_rpm>);
STATIC_CHECK(truncated_to<hertz>(decihertz{509}) == hertz{50});
STATIC_CHECK(truncated_to<deciseconds>(1.36_s) == deciseconds{13});

// Nothing leads from one dimension to another, nor from a number without naming the unit.
STATIC_CHECK(not std::is_constructible_v<deciamperes, decihertz>);
STATIC_CHECK(not std::is_convertible_v<std::uint16_t, decihertz>);
STATIC_CHECK(not std::is_convertible_v<decihertz, std::uint16_t>);

// A count of a type that fits may be known only when running; any other is a constant.
constexpr decihertz counted(std::uint8_t steps) { return decihertz(steps); }
STATIC_CHECK(counted(255).count() == 255);
STATIC_CHECK(decihertz(65'535).count() == 65'535 and signed_decihertz(-32'768).count() == -32'768);
// Two types of one size hold the same numbers.
STATIC_CHECK(quantity<frequency, long long>(5L).count() == 5);
STATIC_CHECK(decihertz{500} == decihertz{500} and decihertz{499} < decihertz{500});

// As a number: in the unit of its text, or in another one.
STATIC_CHECK(decihertz{505}.as<double>() == 50.5 and signed_decihertz{-1}.as<double>() == -0.1);
STATIC_CHECK(kilowatts{3}.as<double>() == 3'000.0 and kilowatts{3}.as<double, kilowatts>() == 3.0);
STATIC_CHECK(watts{250}.as<float, kilowatts>() == 0.25F and watt_hours{1'500}.as<double>() == 1.5);
STATIC_CHECK((1.25_s).as<double, units::milliseconds>() == 1'250.0 and hectohertz{40}.as<double>() == 4'000.0);
// Out of range is no number that only looks right.
constexpr quantity<power, std::int64_t> above{std::numeric_limits<std::int64_t>::max()};
STATIC_CHECK(above.as<double>() == std::numeric_limits<double>::infinity());
STATIC_CHECK(quantity<power, std::int64_t>{std::numeric_limits<std::int64_t>::min()}.as<double>() ==
             -std::numeric_limits<double>::infinity());

} // namespace
