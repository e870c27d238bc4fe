// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: what the drive shows.
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
inline constexpr reg<deciamperes> slcr{.code = "SLCR", .address = 3224, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor current, unfiltered", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> srfr{.code = "SRFR", .address = 3225, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Output frequency, unfiltered", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> sotr{.code = "SOTR", .address = 3226, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor torque, unfiltered", .source = provenance::inferred};
inline constexpr reg<decivolts> suln{.code = "SULN", .address = 3229, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Mains voltage, unfiltered", .source = provenance::inferred};
inline constexpr reg<seconds> tac{.code = "TAC", .address = 3235, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Time in transistor temperature alarm", .source = provenance::inferred};
inline constexpr reg<seconds> tac2{.code = "TAC2", .address = 3242, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Time at the lowest switching frequency", .source = provenance::inferred};
inline constexpr reg<state_word_1> lrs1{.code = "LRS1", .address = 3250, .mode = access::read_only, .name = "Logic states 0 to 15", .source = provenance::inferred};
inline constexpr reg<state_word_2> lrs2{.code = "LRS2", .address = 3251, .mode = access::read_only, .name = "Logic states 16 to 31", .source = provenance::inferred};
inline constexpr reg<state_word_3> lrs3{.code = "LRS3", .address = 3252, .mode = access::read_only, .name = "Logic states 32 to 47", .source = provenance::inferred};
inline constexpr reg<state_word_4> lrs4{.code = "LRS4", .address = 3253, .mode = access::read_only, .name = "Logic states 48 to 63", .source = provenance::inferred};
inline constexpr reg<state_word_5> lrs5{.code = "LRS5", .address = 3254, .mode = access::read_only, .name = "Logic states 64 to 79", .source = provenance::inferred};
inline constexpr reg<state_word_6> lrs6{.code = "LRS6", .address = 3255, .mode = access::read_only, .name = "Logic states 80 to 95", .source = provenance::inferred};
inline constexpr reg<state_word_7> lrs7{.code = "LRS7", .address = 3256, .mode = access::read_only, .name = "Logic states 96 to 111", .source = provenance::inferred};
inline constexpr reg<state_word_8> lrs8{.code = "LRS8", .address = 3257, .mode = access::read_only, .name = "Logic states 112 to 127", .source = provenance::inferred};
inline constexpr reg<signed_percent> sopr{.code = "SOPR", .address = 3290, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor power, unfiltered", .source = provenance::inferred};
inline constexpr reg<active_configuration> cnfs{.code = "CNFS", .address = 8020, .mode = access::read_only, .name = "Active configuration", .source = provenance::inferred};
inline constexpr reg<active_channel> crc{.code = "CRC", .address = 8441, .mode = access::read_only, .name = "Active reference channel", .source = provenance::inferred};
inline constexpr reg<active_channel> ccc{.code = "CCC", .address = 8442, .mode = access::read_only, .name = "Active command channel", .source = provenance::inferred};
inline constexpr reg<parameter_set> cfps{.code = "CFPS", .address = 12900, .mode = access::read_only, .name = "Active parameter set", .source = provenance::inferred};
inline constexpr reg<hertz> fqs{.code = "FQS", .address = 14603, .mode = access::read_only, .min = {0}, .max = {20000}, .name = "Frequency at the pulse input", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// What the drive shows.
struct monitoring
    : parameter_list<eta, rfr, frh, lcr, otr, eti, uln, uop, thd, opr, slcr, srfr, sotr, suln, rth, pth, tac, hmis,
                     tac2, lrs1, lrs2, lrs3, lrs4, lrs5, lrs6, lrs7, lrs8, sopr, cnfs, crc, ccc, thr, cfps, fqs> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
