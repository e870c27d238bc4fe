// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: enumerations and words of bits of the parameters of its inputs and outputs.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320_values {

// clang-format off
/// What an analog input or output works with.
enum class analog_type : std::uint16_t {
    volts_10 = 1, milliamperes = 2, volts_bipolar = 5,
};

/// The level of an output that is on.
enum class output_level : std::uint16_t {
    active_high = 0, active_low = 1,
};

/// The signals of an encoder.
enum class encoder_signals : std::uint16_t {
    aabb = 1, ab = 2,
};

/// What an encoder is for.
enum class encoder_use : std::uint16_t {
    no = 0, supervision = 1,
};

/// The range of an analog input.
enum class input_polarity : std::uint16_t {
    unipolar = 0, bipolar = 1,
};

/// The outputs.
enum class output_image_bit : std::uint8_t {
    r1 = 0, r2 = 1, lo1 = 8,
};
using output_image = flags<output_image_bit>;
// clang-format on

} // namespace altivar::atv320_values

namespace altivar::atv320 {

using namespace atv320_values;

} // namespace altivar::atv320

// clang-format off
template <>
inline constexpr auto enumerators<altivar::atv320_values::analog_type> = detail::name_list<altivar::atv320_values::analog_type>({
    {1, "10U"}, {2, "0A"}, {5, "n10U"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::analog_type> = detail::name_list<altivar::atv320_values::analog_type>({
    {1, "0 to 10 V"}, {2, "current"}, {5, "-10 to 10 V"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::output_level> = detail::name_list<altivar::atv320_values::output_level>({
    {0, "POS"}, {1, "nEG"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::output_level> = detail::name_list<altivar::atv320_values::output_level>({
    {0, "1 when active"}, {1, "0 when active"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::encoder_signals> = detail::name_list<altivar::atv320_values::encoder_signals>({
    {1, "AAbb"}, {2, "Ab"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::encoder_signals> = detail::name_list<altivar::atv320_values::encoder_signals>({
    {1, "A, /A, B, /B"}, {2, "A, B"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::encoder_use> = detail::name_list<altivar::atv320_values::encoder_use>({
    {0, "nO"}, {1, "SEC"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::encoder_use> = detail::name_list<altivar::atv320_values::encoder_use>({
    {0, "not used"}, {1, "speed supervision"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::input_polarity> = detail::name_list<altivar::atv320_values::input_polarity>({
    {0, "POS"}, {1, "POSnEG"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::input_polarity> = detail::name_list<altivar::atv320_values::input_polarity>({
    {0, "positive only"}, {1, "positive and negative"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::output_image_bit> = detail::name_list<altivar::atv320_values::output_image_bit>({
    {0, "R1"}, {1, "R2"}, {8, "LO1"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
