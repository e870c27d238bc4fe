// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: words that command the drive, and its speed mode.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/drive.hpp>
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
inline constexpr reg<counter_reset> rpr{.code = "RPR", .address = 3120, .factory = 0, .name = "Counter reset", .source = provenance::inferred};
inline constexpr reg<rpm> smil{.code = "SMIL", .address = 8607, .min = {0}, .max = {65535}, .name = "Lowest speed of the drive profile", .source = provenance::doubtful};
inline constexpr reg<rpm> smal{.code = "SMAL", .address = 8609, .min = {0}, .max = {65535}, .name = "Highest speed of the drive profile", .source = provenance::doubtful};
inline constexpr reg<rpm> spal{.code = "SPAL", .address = 8611, .min = {1}, .max = {65535}, .name = "Speed step that defines the acceleration", .source = provenance::inferred};
inline constexpr reg<seconds> spat{.code = "SPAT", .address = 8613, .min = {0}, .max = {65535}, .name = "Time step that defines the acceleration", .source = provenance::inferred};
inline constexpr reg<rpm> spdl{.code = "SPDL", .address = 8614, .min = {1}, .max = {65535}, .name = "Speed step that defines the deceleration", .source = provenance::inferred};
inline constexpr reg<seconds> spdt{.code = "SPDT", .address = 8616, .min = {0}, .max = {65535}, .name = "Time step that defines the deceleration", .source = provenance::inferred};
inline constexpr reg<count16> spfn{.code = "SPFN", .address = 8642, .mode = access::configuration, .min = {1}, .max = {65535}, .factory = 1, .name = "Setpoint scaling: numerator", .source = provenance::inferred};
inline constexpr reg<count16> spfd{.code = "SPFD", .address = 8643, .mode = access::configuration, .min = {1}, .max = {65535}, .factory = 1, .name = "Setpoint scaling: denominator", .source = provenance::inferred};
inline constexpr reg<quick_stop_end> qstd{.code = "QSTD", .address = 8651, .mode = access::configuration, .factory = 6, .name = "How quick stop stops", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Words that command the drive, and its speed mode.
struct control : parameter_list<rpr, cmd, lfr, pisp, cmi, lfrd, etad, rfrd, frhd, errd, smil, smal, spal, spat, spdl,
                                spdt, spfn, spfd, qstd, dotd> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
