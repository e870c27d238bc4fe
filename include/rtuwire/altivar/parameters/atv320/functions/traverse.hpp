// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: traverse control.
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
inline constexpr reg<logic_input> trc{.code = "TRC", .address = 12201, .mode = access::configuration, .factory = 0, .name = "Input that enables traverse control", .source = provenance::inferred};
inline constexpr reg<decihertz> trh{.code = "TRH", .address = 12202, .min = {0}, .max = {100}, .factory = 40, .name = "Traverse frequency, upper amplitude", .source = provenance::inferred};
inline constexpr reg<decihertz> trl{.code = "TRL", .address = 12203, .min = {0}, .max = {100}, .factory = 40, .name = "Traverse frequency, lower amplitude", .source = provenance::inferred};
inline constexpr reg<decihertz> qsh{.code = "QSH", .address = 12204, .min = {0}, .max = {100}, .factory = 0, .name = "Quick step, upper", .source = provenance::inferred};
inline constexpr reg<decihertz> qsl{.code = "QSL", .address = 12205, .min = {0}, .max = {100}, .factory = 0, .name = "Quick step, lower", .source = provenance::inferred};
inline constexpr reg<deciseconds> tup{.code = "TUP", .address = 12206, .min = {1}, .max = {9999}, .factory = 40, .name = "Traverse acceleration time", .source = provenance::inferred};
inline constexpr reg<deciseconds> tdn{.code = "TDN", .address = 12207, .min = {1}, .max = {9999}, .factory = 40, .name = "Traverse deceleration time", .source = provenance::inferred};
inline constexpr reg<minutes> tbo{.code = "TBO", .address = 12208, .min = {0}, .max = {9999}, .factory = 0, .name = "Winding time of a reel", .source = provenance::inferred};
inline constexpr reg<logic_input> rtr{.code = "RTR", .address = 12210, .mode = access::configuration, .factory = 0, .name = "Input that restarts traverse control", .source = provenance::inferred};
inline constexpr reg<decihertz> dtf{.code = "DTF", .address = 12211, .min = {0}, .max = {5990}, .factory = 0, .name = "Decrease of the reference during winding", .source = provenance::inferred};
inline constexpr reg<logic_input> snc{.code = "SNC", .address = 12212, .mode = access::configuration, .factory = 0, .name = "Input for counter wobble", .source = provenance::inferred};
inline constexpr reg<contactor_output> ebo{.code = "EBO", .address = 12213, .mode = access::configuration, .name = "Output for end of reel", .source = provenance::doubtful};
inline constexpr reg<contactor_output> tsy{.code = "TSY", .address = 12214, .mode = access::configuration, .name = "Output that synchronises the wobble", .source = provenance::doubtful};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Traverse control.
struct functions_traverse : parameter_list<trc, trh, trl, qsh, qsl, tup, tdn, tbo, rtr, dtf, snc, ebo, tsy> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
