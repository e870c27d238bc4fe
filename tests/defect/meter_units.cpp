// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Units of meters: a floating point register of amperes is read as amperes. What a meter tells stands here in the bits of
// IEEE 754, and what comes of it in the digits that people write. tests/fail has the step that is refused.
#include <rtuwire/table/form/floating.hpp>

#include <string_view>

#include "support/proof.hpp"

#include <rtuwire/table/form/real_text.hpp>
#include <rtuwire/table/form/whole.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// The text of the two words of a register.
template <typename Form> constexpr bool tells(std::uint16_t high, std::uint16_t low, std::string_view text)
{
    auto const value = Form::from_words({high, low});
    auto const shown = text_of(*value);
    return std::string_view{shown.begin(), static_cast<std::size_t>(shown.end() - shown.begin())} == text;
}

// 40A66666 is 5.2, 44BB8000 is 1500, C2C80000 is -100, 3F000000 is 0.5.
constexpr bool floats_are_in_their_unit()
{
    using test::is;
    return is(tells<float32<amperes>>(0x40A6, 0x6666, "5.2 A"), "amperes") and
           is(tells<float32<milliamperes>>(0x44BB, 0x8000, "1.5 A"), "milliamperes") and
           is(tells<float32<kilovolts>>(0x3F00, 0x0000, "500 V"), "kilovolts") and
           is(tells<float32<kilowatts>>(0x3F00, 0x0000, "500 W"), "kilowatts") and
           is(tells<float32<megawatt_hours>>(0x3F00, 0x0000, "500 kWh"), "megawatt hours") and
           is(tells<float32<volt_amperes>>(0x44BB, 0x8000, "1500 VA"), "volt-amperes") and
           is(tells<float32<kilovolt_amperes>>(0x3F00, 0x0000, "500 VA"), "kilovolt-amperes") and
           is(tells<float32<vars>>(0xC2C8, 0x0000, "-100 var"), "var") and
           is(tells<float32<kilovars>>(0x3F00, 0x0000, "500 var"), "kilovar") and
           is(tells<float32<kilovar_hours>>(0x44BB, 0x8000, "1500 kvarh"), "kilovar hours") and
           is(tells<float32<kilovolt_ampere_hours>>(0x44BB, 0x8000, "1500 kVAh"), "kilovolt-ampere hours") and
           is(tells<float32<bars>>(0x40A6, 0x6666, "5.2 bar"), "bar") and
           is(tells<float32<millibars>>(0x44BB, 0x8000, "1.5 bar"), "millibar") and
           is(tells<float32<cubic_metres>>(0x44BB, 0x8000, "1500 m3"), "cubic metres") and
           is(tells<float32<litres>>(0x44BB, 0x8000, "1.5 m3"), "litres") and
           is(tells<float32<cubic_metres_per_hour>>(0x3F00, 0x0000, "0.5 m3/h"), "cubic metres in an hour") and
           is(tells<float32<litres_per_minute>>(0x40A6, 0x6666, "5.2 l/min"), "litres in a minute") and
           is(tells<float32<kelvins>>(0x44BB, 0x8000, "1500 K"), "kelvin") and
           is(tells<unsigned32<amperes>>(0x0000, 0x0005, "5 A"), "a count");
}
PROOF("defect: D43 a floating point register tells its unit, not a step of it", floats_are_in_their_unit)

// Amounts as they are written, and of one dimension only.
STATIC_CHECK(amperes{5_A} == 5'000_mA and kilowatts{3_kW} == 3'000_W and volt_amperes{7_VA} == 7_VA);
STATIC_CHECK(millibars{1.5_bar} == millibars{std::int16_t{1'500}} and litres{2_m3} == litres{std::uint16_t{2'000}});
STATIC_CHECK(vars{7_var} == 7_var and kelvins{273_K} == 273_K);
static_assert(not measures_the_same<watts, volt_amperes> and not measures_the_same<volt_amperes, vars>);
static_assert(not measures_the_same<celsius, kelvins>);

} // namespace
