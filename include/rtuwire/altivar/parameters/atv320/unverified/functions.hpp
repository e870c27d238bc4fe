// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: registers of which too little is known to write them: no access, no limits, or values that no public list
// explains. They are read-only here, and doubtful.
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
inline constexpr reg<deciamperes> sdc1{.code = "SDC1", .address = 10403, .mode = access::read_only, .name = "Automatic DC injection: first current", .source = provenance::doubtful};
inline constexpr reg<deciamperes> sdc2{.code = "SDC2", .address = 10405, .mode = access::read_only, .name = "Automatic DC injection: second current", .source = provenance::doubtful};
inline constexpr reg<deciamperes> idc{.code = "IDC", .address = 11210, .mode = access::read_only, .name = "DC injection: first current", .source = provenance::doubtful};
inline constexpr reg<deciamperes> idc2{.code = "IDC2", .address = 11212, .mode = access::read_only, .name = "DC injection: second current", .source = provenance::doubtful};
inline constexpr reg<no_yes> mstp{.code = "MSTP", .address = 12523, .mode = access::read_only, .name = "Stop switch is remembered", .source = provenance::doubtful};
inline constexpr reg<no_yes> prst{.code = "PRST", .address = 12524, .mode = access::read_only, .name = "Run order overrides a stop switch", .source = provenance::doubtful};
inline constexpr reg<count16> pal{.code = "PAL", .address = 11961, .mode = access::read_only, .name = "PI feedback low alarm threshold", .source = provenance::doubtful};
inline constexpr reg<count16> pah{.code = "PAH", .address = 11962, .mode = access::read_only, .name = "PI feedback high alarm threshold", .source = provenance::doubtful};
inline constexpr reg<count16> per{.code = "PER", .address = 11963, .mode = access::read_only, .name = "PI error alarm threshold", .source = provenance::doubtful};
inline constexpr reg<deciamperes> cli{.code = "CLI", .address = 9201, .mode = access::read_only, .name = "Current limit", .source = provenance::doubtful};
inline constexpr reg<deciamperes> cl2{.code = "CL2", .address = 9203, .mode = access::read_only, .name = "Second current limit", .source = provenance::doubtful};
inline constexpr reg<count16> tlim{.code = "TLIM", .address = 9211, .mode = access::read_only, .name = "Torque limit, motoring", .source = provenance::doubtful};
inline constexpr reg<count16> tlig{.code = "TLIG", .address = 9212, .mode = access::read_only, .name = "Torque limit, generating", .source = provenance::doubtful};
inline constexpr reg<no_yes> i2ta{.code = "I2TA", .address = 9631, .mode = access::read_only, .name = "I2t current limitation", .source = provenance::doubtful};
inline constexpr reg<count16> i2ti{.code = "I2TI", .address = 9632, .mode = access::read_only, .name = "I2t model: maximum current", .source = provenance::doubtful};
inline constexpr reg<count16> i2tt{.code = "I2TT", .address = 9633, .mode = access::read_only, .name = "I2t model: maximum time", .source = provenance::doubtful};
inline constexpr reg<count16> i2tm{.code = "I2TM", .address = 9634, .mode = access::read_only, .name = "I2t model: load level", .source = provenance::doubtful};
inline constexpr reg<deciamperes> ibr{.code = "IBR", .address = 10006, .mode = access::read_only, .name = "Brake release current", .source = provenance::doubtful};
inline constexpr reg<deciamperes> ird{.code = "IRD", .address = 10011, .mode = access::read_only, .name = "Brake release current, reverse", .source = provenance::doubtful};
inline constexpr reg<deciamperes> ibra{.code = "IBRA", .address = 10075, .mode = access::read_only, .name = "Brake release current without weight signal", .source = provenance::doubtful};
inline constexpr reg<deciamperes> clo{.code = "CLO", .address = 12302, .mode = access::read_only, .name = "Current limit at high speed", .source = provenance::doubtful};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::unverified {

/// Stopping and DC injection.
struct functions_stop : parameter_list<sdc1, sdc2, idc, idc2, mstp, prst> {};

/// The PID regulator.
struct functions_pid : parameter_list<pal, pah, per> {};

/// Torque and current limits.
struct functions_limits : parameter_list<cli, cl2, tlim, tlig, i2ta, i2ti, i2tt, i2tm> {};

/// Brake control.
struct functions_brake : parameter_list<ibr, ird, ibra> {};

/// High-speed hoisting and load sharing.
struct functions_hoisting : parameter_list<clo> {};

} // namespace altivar::atv320::unverified
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
