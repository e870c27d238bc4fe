// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: the display and its access.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/configuration.hpp>
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
inline constexpr reg<count16> brh{.code = "BRH", .address = 10050, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Brake logic options", .source = provenance::inferred};
inline constexpr reg<key_function> fn1{.code = "FN1", .address = 13501, .mode = access::configuration, .name = "Function of terminal key F1", .source = provenance::inferred};
inline constexpr reg<key_function> fn2{.code = "FN2", .address = 13502, .mode = access::configuration, .name = "Function of terminal key F2", .source = provenance::inferred};
inline constexpr reg<key_function> fn3{.code = "FN3", .address = 13503, .mode = access::configuration, .name = "Function of terminal key F3", .source = provenance::inferred};
inline constexpr reg<key_function> fn4{.code = "FN4", .address = 13504, .mode = access::configuration, .name = "Function of terminal key F4", .source = provenance::inferred};
inline constexpr reg<keypad_takeover> bmp{.code = "BMP", .address = 13529, .mode = access::configuration, .factory = 0, .name = "What terminal control takes over on a change", .source = provenance::inferred};
inline constexpr reg<count16> ppi{.code = "PPI", .address = 14001, .mode = access::configuration, .min = {0}, .max = {9999}, .factory = 0, .name = "Pairing password", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// The display and its access.
struct display : parameter_list<brh, fn1, fn2, fn3, fn4, bmp, ppi> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
