// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: ramps.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
#include <rtuwire/altivar/parameters/atv320/values/functions.hpp>
#include <rtuwire/altivar/parameters/atv320/values/known.hpp>
#include <rtuwire/altivar/parameters/family_words.hpp>
#include <rtuwire/altivar/parameters/parameter_list.hpp>
#include <rtuwire/altivar/parameters/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320 {

// clang-format off
inline constexpr reg<ramp_adaptation> bra{.code = "BRA", .address = 9003, .mode = access::configuration, .factory = 1, .name = "Deceleration ramp adaptation", .source = provenance::inferred};
inline constexpr reg<ramp_shape> rpt{.code = "RPT", .address = 9004, .factory = 0, .name = "Ramp shape", .source = provenance::inferred};
inline constexpr reg<percent> ta1{.code = "TA1", .address = 9005, .min = {0}, .max = {100}, .factory = 10, .name = "Rounding at the start of acceleration", .source = provenance::inferred};
inline constexpr reg<percent> ta2{.code = "TA2", .address = 9006, .min = {0}, .max = {100}, .factory = 10, .name = "Rounding at the end of acceleration", .source = provenance::inferred};
inline constexpr reg<percent> ta3{.code = "TA3", .address = 9007, .min = {0}, .max = {100}, .factory = 10, .name = "Rounding at the start of deceleration", .source = provenance::inferred};
inline constexpr reg<percent> ta4{.code = "TA4", .address = 9008, .min = {0}, .max = {100}, .factory = 10, .name = "Rounding at the end of deceleration", .source = provenance::inferred};
inline constexpr reg<logic_input> rps{.code = "RPS", .address = 9010, .mode = access::configuration, .factory = 0, .name = "Input that selects the second ramp", .source = provenance::inferred};
inline constexpr reg<decihertz> frt{.code = "FRT", .address = 9011, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "Frequency that selects the second ramp", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Ramps.
struct functions_ramp : parameter_list<bra, rpt, ta1, ta2, ta3, ta4, rps, frt, ac2, de2, inr> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
