// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: reactions to faults.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
#include <rtuwire/altivar/parameters/atv320/values/drive.hpp>
#include <rtuwire/altivar/parameters/atv320/values/faults.hpp>
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
inline constexpr reg<no_yes> flr{.code = "FLR", .address = 3110, .mode = access::configuration, .factory = 0, .name = "Catch a spinning load", .source = provenance::inferred};
inline constexpr reg<no_yes> strt{.code = "STRT", .address = 3112, .mode = access::configuration, .factory = 0, .name = "Power transistor test at start", .source = provenance::inferred};
inline constexpr reg<count16> erco{.code = "ERCO", .address = 6056, .mode = access::read_only, .min = {0}, .max = {5}, .name = "CANopen error code", .source = provenance::inferred};
inline constexpr reg<fault_reaction> ipl{.code = "IPL", .address = 7002, .mode = access::configuration, .name = "Reaction to an input phase loss", .source = provenance::inferred};
inline constexpr reg<power_loss_stop> stp{.code = "STP", .address = 7004, .mode = access::configuration, .factory = 0, .name = "Controlled stop on mains loss", .source = provenance::inferred};
inline constexpr reg<fault_reaction> epl{.code = "EPL", .address = 7006, .mode = access::configuration, .factory = 1, .name = "Reaction to an external fault", .source = provenance::inferred};
inline constexpr reg<fault_reaction> ohl{.code = "OHL", .address = 7008, .mode = access::configuration, .factory = 1, .name = "Reaction to an overheated drive", .source = provenance::inferred};
inline constexpr reg<fault_reaction> oll{.code = "OLL", .address = 7009, .mode = access::configuration, .factory = 1, .name = "Reaction to a motor overload", .source = provenance::inferred};
inline constexpr reg<fault_reaction> col{.code = "COL", .address = 7011, .mode = access::configuration, .factory = 1, .name = "Reaction to a lost CANopen link", .source = provenance::inferred};
inline constexpr reg<fault_reaction> tnl{.code = "TNL", .address = 7012, .mode = access::configuration, .factory = 1, .name = "Reaction to a failed autotune", .source = provenance::inferred};
inline constexpr reg<fault_reaction> lfl3{.code = "LFL3", .address = 7013, .mode = access::configuration, .factory = 0, .name = "Reaction to a lost signal on AI3", .source = provenance::inferred};
inline constexpr reg<fault_reaction> cll{.code = "CLL", .address = 7015, .mode = access::configuration, .factory = 1, .name = "Reaction to a lost communication card", .source = provenance::inferred};
inline constexpr reg<decihertz> lff{.code = "LFF", .address = 7080, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "Fallback speed", .source = provenance::inferred};
inline constexpr reg<deciseconds> odt{.code = "ODT", .address = 7081, .min = {5}, .max = {100}, .factory = 5, .name = "Output phase loss detection time", .source = provenance::inferred};
inline constexpr reg<input_level> let{.code = "LET", .address = 7090, .mode = access::configuration, .factory = 1, .name = "Active level of external fault", .source = provenance::inferred};
inline constexpr reg<restart_time> tar{.code = "TAR", .address = 7123, .mode = access::configuration, .factory = 0, .name = "Longest time of automatic restart", .source = provenance::inferred};
inline constexpr reg<logic_input> rsf{.code = "RSF", .address = 7124, .mode = access::configuration, .name = "Input for fault reset", .source = provenance::inferred};
inline constexpr reg<logic_input> inh{.code = "INH", .address = 7125, .mode = access::configuration, .factory = 0, .name = "Input that inhibits faults", .source = provenance::inferred};
inline constexpr reg<no_yes> rp{.code = "RP", .address = 7128, .mode = access::configuration, .factory = 0, .name = "Restart the drive", .source = provenance::inferred};
inline constexpr reg<logic_input> rpa{.code = "RPA", .address = 7129, .mode = access::configuration, .factory = 0, .name = "Input that restarts the drive", .source = provenance::inferred};
inline constexpr reg<logic_input> etf{.code = "ETF", .address = 7131, .mode = access::configuration, .name = "Input for external fault", .source = provenance::inferred};
inline constexpr reg<count16> cnf{.code = "CNF", .address = 7132, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Communication card fault code", .source = provenance::inferred};
inline constexpr reg<count16> ilf1{.code = "ILF1", .address = 7134, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Internal link fault code", .source = provenance::inferred};
inline constexpr reg<output_phase_loss> opl{.code = "OPL", .address = 9611, .mode = access::configuration, .name = "Output phase loss detection", .source = provenance::inferred};
inline constexpr reg<motor_cooling> tht{.code = "THT", .address = 9612, .mode = access::configuration, .factory = 1, .name = "Motor thermal protection", .source = provenance::inferred};
inline constexpr reg<no_yes> sat{.code = "SAT", .address = 11021, .mode = access::configuration, .factory = 0, .name = "Stop at thermal alarm", .source = provenance::inferred};
inline constexpr reg<percent> dld{.code = "DLD", .address = 12311, .mode = access::configuration, .min = {1}, .max = {100}, .factory = 100, .name = "Load variation threshold", .source = provenance::inferred};
inline constexpr reg<signed_centiseconds> tld{.code = "TLD", .address = 12312, .mode = access::configuration, .min = {0}, .max = {1000}, .name = "Load variation time", .source = provenance::inferred};
inline constexpr reg<fault_reaction> dlb{.code = "DLB", .address = 12313, .mode = access::configuration, .factory = 1, .name = "Reaction to a load variation", .source = provenance::inferred};
inline constexpr reg<ptc_mode> ptcl{.code = "PTCL", .address = 13203, .mode = access::configuration, .factory = 0, .name = "PTC probe on LI6", .source = provenance::inferred};
inline constexpr reg<mains_rating> ures{.code = "URES", .address = 13801, .mode = access::configuration, .name = "Rated mains voltage", .source = provenance::inferred};
inline constexpr reg<volts> usl{.code = "USL", .address = 13802, .mode = access::configuration, .min = {100}, .max = {276}, .name = "Undervoltage trip level", .source = provenance::inferred};
inline constexpr reg<undervoltage_reaction> usb{.code = "USB", .address = 13803, .mode = access::configuration, .factory = 0, .name = "Reaction to undervoltage", .source = provenance::inferred};
inline constexpr reg<deciseconds> ust{.code = "UST", .address = 13804, .mode = access::configuration, .min = {2}, .max = {9999}, .factory = 2, .name = "Undervoltage time", .source = provenance::inferred};
inline constexpr reg<volts> upl{.code = "UPL", .address = 13811, .mode = access::configuration, .min = {141}, .max = {318}, .name = "Controlled stop: voltage level", .source = provenance::inferred};
inline constexpr reg<seconds> tbs{.code = "TBS", .address = 13812, .min = {1}, .max = {9999}, .factory = 9999, .name = "Time the DC bus is kept up", .source = provenance::inferred};
inline constexpr reg<deciseconds> tsm{.code = "TSM", .address = 13813, .min = {10}, .max = {9999}, .factory = 10, .name = "Controlled stop: restart time", .source = provenance::inferred};
inline constexpr reg<centiseconds> stm{.code = "STM", .address = 13814, .min = {1}, .max = {6000}, .factory = 100, .name = "Controlled stop: longest time", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Reactions to faults.
struct faults : parameter_list<flr, strt, erco, ipl, stp, epl, ohl, oll, sll, col, tnl, lfl3, cll, lff, odt, let, lft,
                               atr, tar, rsf, inh, rp, rpa, cic, etf, cnf, ilf1, opl, tht, sat, dld, tld, dlb, ptcl,
                               ures, usl, usb, ust, upl, tbs, tsm, stm> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
