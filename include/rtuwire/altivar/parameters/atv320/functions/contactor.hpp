// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: contactors.
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
inline constexpr reg<centiseconds> dbs{.code = "DBS", .address = 13101, .min = {5}, .max = {6000}, .factory = 15, .name = "Delay before starting the motor", .source = provenance::inferred};
inline constexpr reg<centiseconds> das{.code = "DAS", .address = 13102, .min = {0}, .max = {500}, .factory = 10, .name = "Delay before opening the contactor", .source = provenance::inferred};
inline constexpr reg<logic_input> rca{.code = "RCA", .address = 13103, .mode = access::configuration, .factory = 0, .name = "Input of the output contactor's feedback", .source = provenance::inferred};
inline constexpr reg<contactor_output> occ{.code = "OCC", .address = 13104, .mode = access::configuration, .name = "Output that controls the output contactor", .source = provenance::doubtful};
inline constexpr reg<logic_input> les{.code = "LES", .address = 13601, .mode = access::configuration, .factory = 0, .name = "Input for emergency stop", .source = provenance::inferred};
inline constexpr reg<contactor_output> llc{.code = "LLC", .address = 13602, .mode = access::configuration, .name = "Output that controls the line contactor", .source = provenance::doubtful};
inline constexpr reg<seconds> lct{.code = "LCT", .address = 13603, .mode = access::configuration, .min = {5}, .max = {999}, .factory = 5, .name = "Time-out of the line contactor", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Contactors.
struct functions_contactor : parameter_list<dbs, das, rca, occ, les, llc, lct> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
