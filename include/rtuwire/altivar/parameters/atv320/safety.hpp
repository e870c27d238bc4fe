// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: safety functions, as far as the line shows them.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/faults.hpp>
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
inline constexpr reg<safety_input> slsa{.code = "SLSA", .address = 15300, .mode = access::configuration, .factory = 0, .name = "SLS input", .source = provenance::inferred};
inline constexpr reg<sls_type> slt{.code = "SLT", .address = 15301, .mode = access::configuration, .factory = 0, .name = "SLS type", .source = provenance::inferred};
inline constexpr reg<decihertz> slsp{.code = "SLSP", .address = 15302, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "SLS speed", .source = provenance::inferred};
inline constexpr reg<decihertz> sltt{.code = "SLTT", .address = 15303, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "SLS speed tolerance", .source = provenance::inferred};
inline constexpr reg<sls_state> slss{.code = "SLSS", .address = 15304, .mode = access::read_only, .name = "SLS state", .source = provenance::inferred};
inline constexpr reg<safety_input> ss1a{.code = "SS1A", .address = 15310, .mode = access::configuration, .factory = 0, .name = "SS1 input", .source = provenance::inferred};
inline constexpr reg<count16_tenths> ssrt{.code = "SSRT", .address = 15311, .mode = access::configuration, .min = {1}, .max = {5990}, .factory = 1, .name = "SS1 ramp", .source = provenance::inferred};
inline constexpr reg<ss1_step> ssru{.code = "SSRU", .address = 15312, .mode = access::configuration, .factory = 0, .name = "SS1 ramp unit", .source = provenance::inferred};
inline constexpr reg<decihertz> sssl{.code = "SSSL", .address = 15313, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "SS1 and SLS standstill level", .source = provenance::inferred};
inline constexpr reg<decihertz> sstt{.code = "SSTT", .address = 15314, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "SS1 trip threshold", .source = provenance::inferred};
inline constexpr reg<ss1_state> ss1s{.code = "SS1S", .address = 15315, .mode = access::read_only, .name = "SS1 state", .source = provenance::inferred};
inline constexpr reg<safety_input> stoa{.code = "STOA", .address = 15320, .mode = access::configuration, .factory = 0, .name = "STO input", .source = provenance::inferred};
inline constexpr reg<safety_input> pwrm{.code = "PWRM", .address = 15321, .mode = access::configuration, .factory = 4, .name = "PWRM input", .source = provenance::inferred};
inline constexpr reg<sto_state> stos{.code = "STOS", .address = 15322, .mode = access::read_only, .name = "STO state", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> lidt{.code = "LIDT", .address = 15330, .mode = access::configuration, .min = {0}, .max = {2000}, .factory = 50, .name = "Safety input debounce time", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> lirt{.code = "LIRT", .address = 15331, .mode = access::configuration, .min = {0}, .max = {50}, .factory = 0, .name = "Safety input response time", .source = provenance::inferred};
inline constexpr reg<safety_state> sfty{.code = "SFTY", .address = 15344, .mode = access::read_only, .name = "Safety configured", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Safety functions, as far as the line shows them.
struct safety : parameter_list<slsa, slt, slsp, sltt, slss, ss1a, ssrt, ssru, sssl, sstt, ss1s, stoa, pwrm, stos, lidt,
                               lirt, sfty> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
