// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: brake control.
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
inline constexpr reg<brake_output> blc{.code = "BLC", .address = 10001, .mode = access::configuration, .name = "Output that controls the brake", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> ben{.code = "BEN", .address = 10003, .max = {100}, .name = "Brake engage frequency", .source = provenance::inferred};
inline constexpr reg<centiseconds> brt{.code = "BRT", .address = 10004, .min = {0}, .max = {500}, .name = "Brake release time", .source = provenance::inferred};
inline constexpr reg<centiseconds> bet{.code = "BET", .address = 10005, .min = {0}, .max = {500}, .name = "Brake engage time", .source = provenance::inferred};
inline constexpr reg<brake_impulse> bip{.code = "BIP", .address = 10007, .name = "Torque at brake release", .source = provenance::inferred};
inline constexpr reg<brake_movement> bst{.code = "BST", .address = 10008, .mode = access::configuration, .factory = 1, .name = "Movement type", .source = provenance::inferred};
inline constexpr reg<logic_input> bci{.code = "BCI", .address = 10009, .mode = access::configuration, .factory = 0, .name = "Input of the brake contact", .source = provenance::inferred};
inline constexpr reg<centiseconds> tbe{.code = "TBE", .address = 10010, .min = {0}, .max = {500}, .factory = 0, .name = "Brake engage delay", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> bir{.code = "BIR", .address = 10012, .max = {100}, .name = "Brake release frequency", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> jdc{.code = "JDC", .address = 10013, .max = {100}, .name = "Frequency jump at reversal", .source = provenance::inferred};
inline constexpr reg<centiseconds> brr{.code = "BRR", .address = 10015, .min = {0}, .max = {500}, .factory = 0, .name = "Brake release: current ramp time", .source = provenance::inferred};
inline constexpr reg<no_yes> bed{.code = "BED", .address = 10020, .factory = 0, .name = "Brake engaged at reversal", .source = provenance::inferred};
inline constexpr reg<centiseconds> ttr{.code = "TTR", .address = 10022, .min = {0}, .max = {1500}, .factory = 0, .name = "Shortest time before a restart", .source = provenance::inferred};
inline constexpr reg<signal_source> pes{.code = "PES", .address = 10070, .mode = access::configuration, .factory = 0, .name = "Input of the weight sensor", .source = provenance::inferred};
inline constexpr reg<hundredth_percent> lp1{.code = "LP1", .address = 10071, .mode = access::configuration, .min = {0}, .max = {9999}, .factory = 0, .name = "Weight sensor point 1: signal", .source = provenance::inferred};
inline constexpr reg<signed_deciamperes> cp1{.code = "CP1", .address = 10072, .mode = access::configuration, .min = {-32767}, .max = {32767}, .name = "Weight sensor point 1: current", .source = provenance::inferred};
inline constexpr reg<hundredth_percent> lp2{.code = "LP2", .address = 10073, .mode = access::configuration, .min = {1}, .max = {10000}, .factory = 5000, .name = "Weight sensor point 2: signal", .source = provenance::inferred};
inline constexpr reg<signed_deciamperes> cp2{.code = "CP2", .address = 10074, .mode = access::configuration, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Weight sensor point 2: current", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Brake control.
struct functions_brake
    : parameter_list<blc, ben, brt, bet, bip, bst, bci, tbe, bir, jdc, brr, bed, ttr, pes, lp1, cp1, lp2, cp2> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
