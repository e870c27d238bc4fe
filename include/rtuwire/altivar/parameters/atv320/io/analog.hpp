// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: analog inputs and outputs.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/drive.hpp>
#include <rtuwire/altivar/parameters/atv320/values/io.hpp>
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
inline constexpr reg<analog_type> ai1t{.code = "AI1T", .address = 4402, .mode = access::configuration, .factory = 1, .name = "AI1 type", .source = provenance::inferred};
inline constexpr reg<analog_type> ai2t{.code = "AI2T", .address = 4403, .mode = access::configuration, .factory = 5, .name = "AI2 type", .source = provenance::inferred};
inline constexpr reg<analog_type> ai3t{.code = "AI3T", .address = 4404, .mode = access::configuration, .factory = 2, .name = "AI3 type", .source = provenance::inferred};
inline constexpr reg<decivolts> uil1{.code = "UIL1", .address = 4412, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "AI1 voltage at 0 %", .source = provenance::inferred};
inline constexpr reg<decivolts> uil2{.code = "UIL2", .address = 4413, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "AI2 voltage at 0 %", .source = provenance::inferred};
inline constexpr reg<decivolts> uih1{.code = "UIH1", .address = 4422, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 100, .name = "AI1 voltage at 100 %", .source = provenance::inferred};
inline constexpr reg<decivolts> uih2{.code = "UIH2", .address = 4423, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 100, .name = "AI2 voltage at 100 %", .source = provenance::inferred};
inline constexpr reg<tenth_milliamperes> crl3{.code = "CRL3", .address = 4434, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 0, .name = "AI3 current at 0 %", .source = provenance::inferred};
inline constexpr reg<tenth_milliamperes> crh3{.code = "CRH3", .address = 4444, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 200, .name = "AI3 current at 100 %", .source = provenance::inferred};
inline constexpr reg<centiseconds> ai1f{.code = "AI1F", .address = 4452, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 0, .name = "AI1 filter", .source = provenance::inferred};
inline constexpr reg<centiseconds> ai2f{.code = "AI2F", .address = 4453, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 0, .name = "AI2 filter", .source = provenance::inferred};
inline constexpr reg<centiseconds> ai3f{.code = "AI3F", .address = 4454, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 0, .name = "AI3 filter", .source = provenance::inferred};
inline constexpr reg<percent> ai1e{.code = "AI1E", .address = 4462, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "AI1 linearisation point: input", .source = provenance::inferred};
inline constexpr reg<percent> ai2e{.code = "AI2E", .address = 4463, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "AI2 linearisation point: input", .source = provenance::inferred};
inline constexpr reg<percent> ai3e{.code = "AI3E", .address = 4464, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "AI3 linearisation point: input", .source = provenance::inferred};
inline constexpr reg<percent> ai1s{.code = "AI1S", .address = 4472, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "AI1 linearisation point: output", .source = provenance::inferred};
inline constexpr reg<percent> ai2s{.code = "AI2S", .address = 4473, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "AI2 linearisation point: output", .source = provenance::inferred};
inline constexpr reg<percent> ai3s{.code = "AI3S", .address = 4474, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "AI3 linearisation point: output", .source = provenance::inferred};
inline constexpr reg<input_polarity> ai1l{.code = "AI1L", .address = 4482, .mode = access::configuration, .factory = 0, .name = "AI1 range", .source = provenance::inferred};
inline constexpr reg<input_polarity> ai2l{.code = "AI2L", .address = 4483, .mode = access::configuration, .factory = 0, .name = "AI2 range", .source = provenance::inferred};
inline constexpr reg<input_polarity> ai3l{.code = "AI3L", .address = 4484, .mode = access::configuration, .factory = 0, .name = "AI3 range", .source = provenance::inferred};
inline constexpr reg<analog_type> ao1t{.code = "AO1T", .address = 4601, .mode = access::configuration, .factory = 2, .name = "AO1 type", .source = provenance::inferred};
inline constexpr reg<centiseconds> ao1f{.code = "AO1F", .address = 4611, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 0, .name = "AO1 filter", .source = provenance::inferred};
inline constexpr reg<decivolts> uol1{.code = "UOL1", .address = 4621, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "AO1 lowest voltage", .source = provenance::inferred};
inline constexpr reg<decivolts> uoh1{.code = "UOH1", .address = 4631, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 100, .name = "AO1 highest voltage", .source = provenance::inferred};
inline constexpr reg<tenth_milliamperes> aol1{.code = "AOL1", .address = 4641, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 0, .name = "AO1 lowest current", .source = provenance::inferred};
inline constexpr reg<tenth_milliamperes> aoh1{.code = "AOH1", .address = 4651, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 200, .name = "AO1 highest current", .source = provenance::inferred};
inline constexpr reg<tenth_percent> asl1{.code = "ASL1", .address = 4661, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 0, .name = "AO1 scale: value at the lowest output", .source = provenance::inferred};
inline constexpr reg<tenth_percent> ash1{.code = "ASH1", .address = 4671, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 1000, .name = "AO1 scale: value at the highest output", .source = provenance::inferred};
inline constexpr reg<signal_source> ao1{.code = "AO1", .address = 5021, .mode = access::configuration, .factory = 0, .name = "Output AO1 function", .source = provenance::inferred};
inline constexpr reg<tenth_percent> aiv1{.code = "AIV1", .address = 5281, .min = {0}, .max = {1000}, .factory = 0, .name = "Virtual analog input 1", .source = provenance::doubtful};
inline constexpr reg<signed_count16> aiv2{.code = "AIV2", .address = 5283, .mode = access::read_only, .min = {-8192}, .max = {8192}, .factory = 0, .name = "Virtual analog input 2", .source = provenance::inferred};
inline constexpr reg<signal_source> aic2{.code = "AIC2", .address = 5284, .mode = access::configuration, .factory = 0, .name = "Source of virtual analog input 2", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Analog inputs and outputs.
struct analog_io : parameter_list<ai1t, ai2t, ai3t, uil1, uil2, uih1, uih2, crl3, crh3, ai1f, ai2f, ai3f, ai1e, ai2e,
                                  ai3e, ai1s, ai2s, ai3s, ai1l, ai2l, ai3l, ao1t, ao1f, uol1, uoh1, aol1, aoh1, asl1,
                                  ash1, ao1, aiv1, aiv2, aic2> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
