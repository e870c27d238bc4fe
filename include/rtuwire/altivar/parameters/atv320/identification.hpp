// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: what drive this is.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
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
inline constexpr reg<count16> pan0{.code = "PAN0", .address = 3340, .min = {0}, .max = {65535}, .factory = 0, .name = "Device name, characters 1 and 2", .source = provenance::inferred};
inline constexpr reg<count16> pan1{.code = "PAN1", .address = 3341, .min = {0}, .max = {65535}, .factory = 0, .name = "Device name, characters 3 and 4", .source = provenance::inferred};
inline constexpr reg<count16> pan2{.code = "PAN2", .address = 3342, .min = {0}, .max = {65535}, .factory = 0, .name = "Device name, characters 5 and 6", .source = provenance::inferred};
inline constexpr reg<count16> pan3{.code = "PAN3", .address = 3343, .min = {0}, .max = {65535}, .factory = 0, .name = "Device name, characters 7 and 8", .source = provenance::inferred};
inline constexpr reg<count16> pan4{.code = "PAN4", .address = 3344, .min = {0}, .max = {65535}, .factory = 0, .name = "Device name, characters 9 and 10", .source = provenance::inferred};
inline constexpr reg<count16> pan5{.code = "PAN5", .address = 3345, .min = {0}, .max = {65535}, .factory = 0, .name = "Device name, characters 11 and 12", .source = provenance::inferred};
inline constexpr reg<count16> pan6{.code = "PAN6", .address = 3346, .min = {0}, .max = {65535}, .factory = 0, .name = "Device name, characters 13 and 14", .source = provenance::inferred};
inline constexpr reg<count16> pan7{.code = "PAN7", .address = 3347, .min = {0}, .max = {65535}, .factory = 0, .name = "Device name, characters 15 and 16", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// What drive this is.
struct identification : parameter_list<ncv, vcal, inv, vdp, pan0, pan1, pan2, pan3, pan4, pan5, pan6, pan7> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
