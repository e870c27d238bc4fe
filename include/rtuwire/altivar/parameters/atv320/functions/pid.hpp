// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: the PID regulator.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
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
inline constexpr reg<signal_source> pif{.code = "PIF", .address = 11901, .mode = access::configuration, .name = "PI feedback source", .source = provenance::inferred};
inline constexpr reg<count16> pif1{.code = "PIF1", .address = 11904, .min = {0}, .max = {32767}, .factory = 100, .name = "PI feedback minimum", .source = provenance::inferred};
inline constexpr reg<count16> pif2{.code = "PIF2", .address = 11905, .min = {0}, .max = {32767}, .factory = 1000, .name = "PI feedback maximum", .source = provenance::inferred};
inline constexpr reg<count16> pip1{.code = "PIP1", .address = 11906, .min = {0}, .max = {32767}, .factory = 150, .name = "PI reference minimum", .source = provenance::inferred};
inline constexpr reg<count16> pip2{.code = "PIP2", .address = 11907, .min = {0}, .max = {32767}, .factory = 900, .name = "PI reference maximum", .source = provenance::inferred};
inline constexpr reg<no_yes> pii{.code = "PII", .address = 11908, .mode = access::configuration, .factory = 0, .name = "PI reference is internal", .source = provenance::inferred};
inline constexpr reg<logic_input> pr2{.code = "PR2", .address = 11909, .mode = access::configuration, .name = "Input for 2 preset PI references", .source = provenance::inferred};
inline constexpr reg<logic_input> pr4{.code = "PR4", .address = 11910, .mode = access::configuration, .name = "Input for 4 preset PI references", .source = provenance::inferred};
inline constexpr reg<count16> rpi{.code = "RPI", .address = 11920, .min = {0}, .max = {32767}, .factory = 150, .name = "PI internal reference", .source = provenance::doubtful};
inline constexpr reg<count16> rp2{.code = "RP2", .address = 11921, .min = {0}, .max = {32767}, .factory = 300, .name = "Preset PI reference 2", .source = provenance::doubtful};
inline constexpr reg<count16> rp3{.code = "RP3", .address = 11922, .min = {0}, .max = {32767}, .factory = 600, .name = "Preset PI reference 3", .source = provenance::doubtful};
inline constexpr reg<count16> rp4{.code = "RP4", .address = 11923, .min = {0}, .max = {32767}, .factory = 900, .name = "Preset PI reference 4", .source = provenance::doubtful};
inline constexpr reg<no_yes> pic{.code = "PIC", .address = 11940, .mode = access::configuration, .factory = 0, .name = "PI correction reversed", .source = provenance::inferred};
inline constexpr reg<count16_hundredths> rpg{.code = "RPG", .address = 11941, .min = {1}, .max = {10000}, .factory = 100, .name = "PI proportional gain", .source = provenance::inferred};
inline constexpr reg<count16_hundredths> rig{.code = "RIG", .address = 11942, .min = {1}, .max = {10000}, .factory = 100, .name = "PI integral gain", .source = provenance::inferred};
inline constexpr reg<count16_hundredths> rdg{.code = "RDG", .address = 11943, .min = {0}, .max = {10000}, .factory = 0, .name = "PID derivative gain", .source = provenance::inferred};
inline constexpr reg<logic_input> pis{.code = "PIS", .address = 11944, .mode = access::configuration, .name = "Input that resets the PI integral", .source = provenance::inferred};
inline constexpr reg<signal_source> fpi{.code = "FPI", .address = 11950, .mode = access::configuration, .factory = 0, .name = "Speed reference added to the PI output", .source = provenance::inferred};
inline constexpr reg<percent> psr{.code = "PSR", .address = 11951, .min = {1}, .max = {100}, .factory = 100, .name = "Share of the added speed reference", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> pol{.code = "POL", .address = 11952, .min = {-5990}, .max = {5990}, .factory = 0, .name = "PI output minimum", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> poh{.code = "POH", .address = 11953, .min = {0}, .max = {5990}, .factory = 600, .name = "PI output maximum", .source = provenance::inferred};
inline constexpr reg<signal_source> pim{.code = "PIM", .address = 11954, .mode = access::configuration, .factory = 0, .name = "Reference in manual mode", .source = provenance::inferred};
inline constexpr reg<count16_tenths> rsl{.code = "RSL", .address = 11960, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 0, .name = "PI error that wakes the drive", .source = provenance::inferred};
inline constexpr reg<logic_input> pau{.code = "PAU", .address = 11970, .mode = access::configuration, .factory = 0, .name = "Input that selects automatic or manual", .source = provenance::inferred};
inline constexpr reg<signed_count16> rpe{.code = "RPE", .address = 11980, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "PI error", .source = provenance::doubtful};
inline constexpr reg<count16> rpf{.code = "RPF", .address = 11981, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "PI feedback", .source = provenance::doubtful};
inline constexpr reg<count16> rpc{.code = "RPC", .address = 11982, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "PI reference", .source = provenance::doubtful};
inline constexpr reg<signed_decihertz> rpo{.code = "RPO", .address = 11983, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "PI output", .source = provenance::inferred};
inline constexpr reg<deciseconds> prp{.code = "PRP", .address = 11984, .min = {0}, .max = {999}, .factory = 0, .name = "PI reference ramp time", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// The PID regulator.
struct functions_pid : parameter_list<pif, pif1, pif2, pip1, pip2, pii, pr2, pr4, rpi, rp2, rp3, rp4, pic, rpg, rig,
                                      rdg, pis, fpi, psr, pol, poh, pim, rsl, pau, rpe, rpf, rpc, rpo, prp> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
