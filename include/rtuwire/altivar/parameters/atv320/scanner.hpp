// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: the scanner: words that one request moves.
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
inline constexpr reg<count16> oma1{.code = "OMA1", .address = 15401, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 3201, .name = "Card scanner: address of input word 1", .source = provenance::inferred};
inline constexpr reg<count16> oma2{.code = "OMA2", .address = 15402, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 8604, .name = "Card scanner: address of input word 2", .source = provenance::inferred};
inline constexpr reg<count16> oma3{.code = "OMA3", .address = 15403, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Card scanner: address of input word 3", .source = provenance::inferred};
inline constexpr reg<count16> oma4{.code = "OMA4", .address = 15404, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Card scanner: address of input word 4", .source = provenance::inferred};
inline constexpr reg<count16> oma5{.code = "OMA5", .address = 15405, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Card scanner: address of input word 5", .source = provenance::inferred};
inline constexpr reg<count16> oma6{.code = "OMA6", .address = 15406, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Card scanner: address of input word 6", .source = provenance::inferred};
inline constexpr reg<count16> oca1{.code = "OCA1", .address = 15421, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 8501, .name = "Card scanner: address of output word 1", .source = provenance::inferred};
inline constexpr reg<count16> oca2{.code = "OCA2", .address = 15422, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 8602, .name = "Card scanner: address of output word 2", .source = provenance::inferred};
inline constexpr reg<count16> oca3{.code = "OCA3", .address = 15423, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Card scanner: address of output word 3", .source = provenance::inferred};
inline constexpr reg<count16> oca4{.code = "OCA4", .address = 15424, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Card scanner: address of output word 4", .source = provenance::inferred};
inline constexpr reg<count16> oca5{.code = "OCA5", .address = 15425, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Card scanner: address of output word 5", .source = provenance::inferred};
inline constexpr reg<count16> oca6{.code = "OCA6", .address = 15426, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Card scanner: address of output word 6", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// The scanner: words that one request moves.
struct scanner : parameter_list<nma1, nma2, nma3, nma4, nma5, nma6, nma7, nma8, nca1, nca2, nca3, nca4, nca5, nca6,
                                nca7, nca8, nm1, nm2, nm3, nm4, nm5, nm6, nm7, nm8, nc1, nc2, nc3, nc4, nc5, nc6, nc7,
                                nc8, oma1, oma2, oma3, oma4, oma5, oma6, oca1, oca2, oca3, oca4, oca5, oca6> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
