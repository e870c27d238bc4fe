// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: everyday settings.
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
inline constexpr reg<fan_mode> ffm{.code = "FFM", .address = 3130, .factory = 0, .name = "Fan operation", .source = provenance::inferred};
inline constexpr reg<deciamperes> ctd{.code = "CTD", .address = 11001, .min = {0}, .max = {65535}, .name = "Motor current threshold", .source = provenance::inferred};
inline constexpr reg<percent> ttd{.code = "TTD", .address = 11002, .min = {0}, .max = {118}, .factory = 100, .name = "Motor thermal threshold", .source = provenance::inferred};
inline constexpr reg<decihertz> ftd{.code = "FTD", .address = 11003, .min = {0}, .max = {5990}, .name = "Frequency threshold", .source = provenance::inferred};
inline constexpr reg<decihertz> f2d{.code = "F2D", .address = 11004, .min = {0}, .max = {5990}, .name = "Frequency threshold 2", .source = provenance::inferred};
inline constexpr reg<percent> ttd2{.code = "TTD2", .address = 11006, .min = {0}, .max = {118}, .factory = 100, .name = "Motor 2 thermal threshold", .source = provenance::inferred};
inline constexpr reg<percent> ttd3{.code = "TTD3", .address = 11007, .min = {0}, .max = {118}, .factory = 100, .name = "Motor 3 thermal threshold", .source = provenance::inferred};
inline constexpr reg<percent> tha{.code = "THA", .address = 11009, .min = {0}, .max = {118}, .factory = 100, .name = "Drive thermal alarm threshold", .source = provenance::inferred};
inline constexpr reg<signed_percent> ttl{.code = "TTL", .address = 11015, .min = {-300}, .max = {300}, .factory = 50, .name = "Torque low threshold", .source = provenance::inferred};
inline constexpr reg<signed_percent> tth{.code = "TTH", .address = 11016, .min = {-300}, .max = {300}, .factory = 100, .name = "Torque high threshold", .source = provenance::inferred};
inline constexpr reg<decihertz> srb{.code = "SRB", .address = 14401, .min = {3}, .max = {5990}, .factory = 3, .name = "Hysteresis of frequency reached", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Everyday settings.
struct settings : parameter_list<hsp, lsp, ffm, acc, dec, ith, ctd, ttd, ftd, f2d, ttd2, ttd3, tha, ttl, tth, srb> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
