// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: function blocks.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
#include <rtuwire/altivar/parameters/atv320/values/configuration.hpp>
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
inline constexpr reg<signal_source> ia01{.code = "IA01", .address = 14900, .mode = access::configuration, .factory = 0, .name = "Function block analog input 1", .source = provenance::inferred};
inline constexpr reg<signal_source> ia02{.code = "IA02", .address = 14901, .mode = access::configuration, .factory = 0, .name = "Function block analog input 2", .source = provenance::inferred};
inline constexpr reg<signal_source> ia03{.code = "IA03", .address = 14902, .mode = access::configuration, .factory = 0, .name = "Function block analog input 3", .source = provenance::inferred};
inline constexpr reg<signal_source> ia04{.code = "IA04", .address = 14903, .mode = access::configuration, .factory = 0, .name = "Function block analog input 4", .source = provenance::inferred};
inline constexpr reg<signal_source> ia05{.code = "IA05", .address = 14904, .mode = access::configuration, .factory = 0, .name = "Function block analog input 5", .source = provenance::inferred};
inline constexpr reg<signal_source> ia06{.code = "IA06", .address = 14905, .mode = access::configuration, .factory = 0, .name = "Function block analog input 6", .source = provenance::inferred};
inline constexpr reg<signal_source> ia07{.code = "IA07", .address = 14906, .mode = access::configuration, .factory = 0, .name = "Function block analog input 7", .source = provenance::inferred};
inline constexpr reg<signal_source> ia08{.code = "IA08", .address = 14907, .mode = access::configuration, .factory = 0, .name = "Function block analog input 8", .source = provenance::inferred};
inline constexpr reg<signal_source> ia09{.code = "IA09", .address = 14908, .mode = access::configuration, .factory = 0, .name = "Function block analog input 9", .source = provenance::inferred};
inline constexpr reg<signal_source> ia10{.code = "IA10", .address = 14909, .mode = access::configuration, .factory = 0, .name = "Function block analog input 10", .source = provenance::inferred};
inline constexpr reg<logic_source> il01{.code = "IL01", .address = 14920, .mode = access::configuration, .factory = 0, .name = "Function block logic input 1", .source = provenance::inferred};
inline constexpr reg<logic_source> il02{.code = "IL02", .address = 14921, .mode = access::configuration, .factory = 0, .name = "Function block logic input 2", .source = provenance::inferred};
inline constexpr reg<logic_source> il03{.code = "IL03", .address = 14922, .mode = access::configuration, .factory = 0, .name = "Function block logic input 3", .source = provenance::inferred};
inline constexpr reg<logic_source> il04{.code = "IL04", .address = 14923, .mode = access::configuration, .factory = 0, .name = "Function block logic input 4", .source = provenance::inferred};
inline constexpr reg<logic_source> il05{.code = "IL05", .address = 14924, .mode = access::configuration, .factory = 0, .name = "Function block logic input 5", .source = provenance::inferred};
inline constexpr reg<logic_source> il06{.code = "IL06", .address = 14925, .mode = access::configuration, .factory = 0, .name = "Function block logic input 6", .source = provenance::inferred};
inline constexpr reg<logic_source> il07{.code = "IL07", .address = 14926, .mode = access::configuration, .factory = 0, .name = "Function block logic input 7", .source = provenance::inferred};
inline constexpr reg<logic_source> il08{.code = "IL08", .address = 14927, .mode = access::configuration, .factory = 0, .name = "Function block logic input 8", .source = provenance::inferred};
inline constexpr reg<logic_source> il09{.code = "IL09", .address = 14928, .mode = access::configuration, .factory = 0, .name = "Function block logic input 9", .source = provenance::inferred};
inline constexpr reg<logic_source> il10{.code = "IL10", .address = 14929, .mode = access::configuration, .factory = 0, .name = "Function block logic input 10", .source = provenance::inferred};
inline constexpr reg<count16> la01{.code = "LA01", .address = 14940, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block address container 1", .source = provenance::inferred};
inline constexpr reg<count16> la02{.code = "LA02", .address = 14941, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block address container 2", .source = provenance::inferred};
inline constexpr reg<count16> la03{.code = "LA03", .address = 14942, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block address container 3", .source = provenance::inferred};
inline constexpr reg<count16> la04{.code = "LA04", .address = 14943, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block address container 4", .source = provenance::inferred};
inline constexpr reg<count16> la05{.code = "LA05", .address = 14944, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block address container 5", .source = provenance::inferred};
inline constexpr reg<count16> la06{.code = "LA06", .address = 14945, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block address container 6", .source = provenance::inferred};
inline constexpr reg<count16> la07{.code = "LA07", .address = 14946, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block address container 7", .source = provenance::inferred};
inline constexpr reg<count16> la08{.code = "LA08", .address = 14947, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block address container 8", .source = provenance::inferred};
inline constexpr reg<block_state> fbst{.code = "FBST", .address = 14960, .mode = access::read_only, .name = "Function block state", .source = provenance::inferred};
inline constexpr reg<block_fault> fbft{.code = "FBFT", .address = 14961, .mode = access::read_only, .name = "Function block fault", .source = provenance::inferred};
inline constexpr reg<block_command> fbcd{.code = "FBCD", .address = 14962, .name = "Function block command", .source = provenance::inferred};
inline constexpr reg<logic_input> fbrm{.code = "FBRM", .address = 14963, .mode = access::configuration, .factory = 0, .name = "Function block start mode", .source = provenance::inferred};
inline constexpr reg<fault_reaction> fbsm{.code = "FBSM", .address = 14964, .mode = access::configuration, .factory = 1, .name = "Motor reaction when function blocks stop", .source = provenance::inferred};
inline constexpr reg<block_on_fault> fbdf{.code = "FBDF", .address = 14965, .mode = access::configuration, .factory = 0, .name = "Function block reaction to a drive fault", .source = provenance::inferred};
inline constexpr reg<count16> m001{.code = "M001", .address = 14970, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block parameter M001", .source = provenance::inferred};
inline constexpr reg<count16> m002{.code = "M002", .address = 14971, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block parameter M002", .source = provenance::inferred};
inline constexpr reg<count16> m003{.code = "M003", .address = 14972, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block parameter M003", .source = provenance::inferred};
inline constexpr reg<count16> m004{.code = "M004", .address = 14973, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block parameter M004", .source = provenance::inferred};
inline constexpr reg<count16> m005{.code = "M005", .address = 14974, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block parameter M005", .source = provenance::inferred};
inline constexpr reg<count16> m006{.code = "M006", .address = 14975, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block parameter M006", .source = provenance::inferred};
inline constexpr reg<count16> m007{.code = "M007", .address = 14976, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block parameter M007", .source = provenance::inferred};
inline constexpr reg<count16> m008{.code = "M008", .address = 14977, .min = {0}, .max = {65535}, .factory = 0, .name = "Function block parameter M008", .source = provenance::inferred};
inline constexpr reg<clock_word> s001{.code = "S001", .address = 14980, .mode = access::read_only, .name = "Function block system word 1", .source = provenance::inferred};
inline constexpr reg<communication_word> s002{.code = "S002", .address = 14981, .mode = access::read_only, .name = "Function block system word 2", .source = provenance::inferred};
inline constexpr reg<save_word> s006{.code = "S006", .address = 14985, .mode = access::read_only, .name = "Function block system word 6", .source = provenance::inferred};
inline constexpr reg<count16> bnv{.code = "BNV", .address = 14990, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Function block program format", .source = provenance::inferred};
inline constexpr reg<count16> ctv{.code = "CTV", .address = 14991, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Function block catalogue version", .source = provenance::inferred};
inline constexpr reg<count16> bns{.code = "BNS", .address = 14992, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Function block program size", .source = provenance::inferred};
inline constexpr reg<count16> bver{.code = "BVER", .address = 14993, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Function block program version", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Function blocks.
struct function_blocks : parameter_list<ia01, ia02, ia03, ia04, ia05, ia06, ia07, ia08, ia09, ia10, il01, il02, il03,
                                        il04, il05, il06, il07, il08, il09, il10, la01, la02, la03, la04, la05, la06,
                                        la07, la08, fbst, fbft, fbcd, fbrm, fbsm, fbdf, m001, m002, m003, m004, m005,
                                        m006, m007, m008, s001, s002, s006, bnv, ctv, bns, bver> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
