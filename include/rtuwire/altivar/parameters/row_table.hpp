// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Rows as the registers of a drive, by table/row_table.hpp: the amounts that they may be of.
#pragma once

#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/altivar/parameters/row_demands.hpp>
#include <rtuwire/altivar/parameters/units.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/row_table.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

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
