// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: high-speed hoisting and load sharing.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
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
inline constexpr reg<fast_hoisting> hso{.code = "HSO", .address = 12301, .mode = access::configuration, .factory = 0, .name = "High-speed hoisting", .source = provenance::inferred};
inline constexpr reg<percent> cof{.code = "COF", .address = 12303, .min = {0}, .max = {100}, .factory = 100, .name = "Motoring speed coefficient", .source = provenance::inferred};
inline constexpr reg<percent> cor{.code = "COR", .address = 12304, .min = {0}, .max = {100}, .factory = 50, .name = "Generating speed coefficient", .source = provenance::inferred};
inline constexpr reg<decihertz> osp{.code = "OSP", .address = 12305, .min = {0}, .max = {5990}, .factory = 400, .name = "Load measuring frequency", .source = provenance::inferred};
inline constexpr reg<decihertz> scl{.code = "SCL", .address = 12306, .min = {0}, .max = {5990}, .factory = 400, .name = "Frequency that enables the high-speed limit", .source = provenance::inferred};
inline constexpr reg<centiseconds> tos{.code = "TOS", .address = 12307, .min = {10}, .max = {6500}, .factory = 50, .name = "Load measuring time", .source = provenance::inferred};
inline constexpr reg<slack_rope> rsd{.code = "RSD", .address = 12321, .mode = access::configuration, .factory = 0, .name = "Slack rope detection", .source = provenance::inferred};
inline constexpr reg<percent> rstl{.code = "RSTL", .address = 12322, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "Slack rope torque", .source = provenance::inferred};
inline constexpr reg<no_yes> lba{.code = "LBA", .address = 14301, .mode = access::configuration, .factory = 0, .name = "Load sharing", .source = provenance::inferred};
inline constexpr reg<decihertz> lbc{.code = "LBC", .address = 14302, .min = {0}, .max = {5990}, .factory = 0, .name = "Load sharing: frequency correction", .source = provenance::inferred};
inline constexpr reg<decihertz> lbc1{.code = "LBC1", .address = 14303, .min = {0}, .max = {5989}, .factory = 0, .name = "Load sharing: lower correction frequency", .source = provenance::inferred};
inline constexpr reg<decihertz> lbc2{.code = "LBC2", .address = 14304, .min = {1}, .max = {5990}, .factory = 1, .name = "Load sharing: upper correction frequency", .source = provenance::inferred};
inline constexpr reg<percent> lbc3{.code = "LBC3", .address = 14305, .min = {0}, .max = {300}, .factory = 0, .name = "Load sharing: torque offset", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> lbf{.code = "LBF", .address = 14306, .min = {0}, .max = {20000}, .factory = 100, .name = "Load sharing: filter", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// High-speed hoisting and load sharing.
struct functions_hoisting : parameter_list<hso, cof, cor, osp, scl, tos, rsd, rstl, lba, lbc, lbc1, lbc2, lbc3, lbf> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
