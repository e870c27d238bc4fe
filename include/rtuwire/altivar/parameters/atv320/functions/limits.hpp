// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: torque and current limits.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
#include <rtuwire/altivar/parameters/atv320/values/drive.hpp>
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
inline constexpr reg<logic_input> lc2{.code = "LC2", .address = 9202, .mode = access::configuration, .factory = 0, .name = "Input for the second current limit", .source = provenance::inferred};
inline constexpr reg<logic_input> tla{.code = "TLA", .address = 9210, .mode = access::configuration, .name = "Input that enables the torque limits", .source = provenance::inferred};
inline constexpr reg<logic_input> tlc{.code = "TLC", .address = 9213, .mode = access::configuration, .factory = 128, .name = "Input that enables the torque limit signal", .source = provenance::inferred};
inline constexpr reg<signal_source> taa{.code = "TAA", .address = 9214, .mode = access::configuration, .factory = 0, .name = "Torque limit signal", .source = provenance::inferred};
inline constexpr reg<torque_step> intp{.code = "INTP", .address = 9215, .mode = access::configuration, .factory = 2, .name = "Size of a torque limit step", .source = provenance::inferred};
inline constexpr reg<fault_reaction> ssb{.code = "SSB", .address = 9240, .mode = access::configuration, .factory = 0, .name = "Reaction to the torque or current limit", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> sto{.code = "STO", .address = 9241, .min = {0}, .max = {9999}, .factory = 1000, .name = "Time in limit before the reaction", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Torque and current limits.
struct functions_limits : parameter_list<lc2, tla, tlc, taa, intp, ssb, sto> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
