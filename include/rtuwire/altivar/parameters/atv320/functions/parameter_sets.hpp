// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: parameter sets.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
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
inline constexpr reg<count16> val{.code = "VAL", .address = 12901, .min = {0}, .max = {1}, .factory = 0, .name = "Load a parameter set", .source = provenance::inferred};
inline constexpr reg<logic_input> cha1{.code = "CHA1", .address = 12902, .mode = access::configuration, .factory = 0, .name = "Input that selects parameter set 2", .source = provenance::inferred};
inline constexpr reg<logic_input> cha2{.code = "CHA2", .address = 12903, .mode = access::configuration, .factory = 0, .name = "Input that selects parameter set 3", .source = provenance::inferred};
inline constexpr reg<count16> ad01{.code = "AD01", .address = 12911, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 1", .source = provenance::inferred};
inline constexpr reg<count16> ad02{.code = "AD02", .address = 12912, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 2", .source = provenance::inferred};
inline constexpr reg<count16> ad03{.code = "AD03", .address = 12913, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 3", .source = provenance::inferred};
inline constexpr reg<count16> ad04{.code = "AD04", .address = 12914, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 4", .source = provenance::inferred};
inline constexpr reg<count16> ad05{.code = "AD05", .address = 12915, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 5", .source = provenance::inferred};
inline constexpr reg<count16> ad06{.code = "AD06", .address = 12916, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 6", .source = provenance::inferred};
inline constexpr reg<count16> ad07{.code = "AD07", .address = 12917, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 7", .source = provenance::inferred};
inline constexpr reg<count16> ad08{.code = "AD08", .address = 12918, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 8", .source = provenance::inferred};
inline constexpr reg<count16> ad09{.code = "AD09", .address = 12919, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 9", .source = provenance::inferred};
inline constexpr reg<count16> ad10{.code = "AD10", .address = 12920, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 10", .source = provenance::inferred};
inline constexpr reg<count16> ad11{.code = "AD11", .address = 12921, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 11", .source = provenance::inferred};
inline constexpr reg<count16> ad12{.code = "AD12", .address = 12922, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 12", .source = provenance::inferred};
inline constexpr reg<count16> ad13{.code = "AD13", .address = 12923, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 13", .source = provenance::inferred};
inline constexpr reg<count16> ad14{.code = "AD14", .address = 12924, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 14", .source = provenance::inferred};
inline constexpr reg<count16> ad15{.code = "AD15", .address = 12925, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter sets: address of register 15", .source = provenance::inferred};
inline constexpr reg<count16> s101{.code = "S101", .address = 12931, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 1", .source = provenance::inferred};
inline constexpr reg<count16> s102{.code = "S102", .address = 12932, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 2", .source = provenance::inferred};
inline constexpr reg<count16> s103{.code = "S103", .address = 12933, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 3", .source = provenance::inferred};
inline constexpr reg<count16> s104{.code = "S104", .address = 12934, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 4", .source = provenance::inferred};
inline constexpr reg<count16> s105{.code = "S105", .address = 12935, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 5", .source = provenance::inferred};
inline constexpr reg<count16> s106{.code = "S106", .address = 12936, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 6", .source = provenance::inferred};
inline constexpr reg<count16> s107{.code = "S107", .address = 12937, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 7", .source = provenance::inferred};
inline constexpr reg<count16> s108{.code = "S108", .address = 12938, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 8", .source = provenance::inferred};
inline constexpr reg<count16> s109{.code = "S109", .address = 12939, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 9", .source = provenance::inferred};
inline constexpr reg<count16> s110{.code = "S110", .address = 12940, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 10", .source = provenance::inferred};
inline constexpr reg<count16> s111{.code = "S111", .address = 12941, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 11", .source = provenance::inferred};
inline constexpr reg<count16> s112{.code = "S112", .address = 12942, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 12", .source = provenance::inferred};
inline constexpr reg<count16> s113{.code = "S113", .address = 12943, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 13", .source = provenance::inferred};
inline constexpr reg<count16> s114{.code = "S114", .address = 12944, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 14", .source = provenance::inferred};
inline constexpr reg<count16> s115{.code = "S115", .address = 12945, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 1: value of register 15", .source = provenance::inferred};
inline constexpr reg<count16> s201{.code = "S201", .address = 12951, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 1", .source = provenance::inferred};
inline constexpr reg<count16> s202{.code = "S202", .address = 12952, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 2", .source = provenance::inferred};
inline constexpr reg<count16> s203{.code = "S203", .address = 12953, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 3", .source = provenance::inferred};
inline constexpr reg<count16> s204{.code = "S204", .address = 12954, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 4", .source = provenance::inferred};
inline constexpr reg<count16> s205{.code = "S205", .address = 12955, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 5", .source = provenance::inferred};
inline constexpr reg<count16> s206{.code = "S206", .address = 12956, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 6", .source = provenance::inferred};
inline constexpr reg<count16> s207{.code = "S207", .address = 12957, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 7", .source = provenance::inferred};
inline constexpr reg<count16> s208{.code = "S208", .address = 12958, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 8", .source = provenance::inferred};
inline constexpr reg<count16> s209{.code = "S209", .address = 12959, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 9", .source = provenance::inferred};
inline constexpr reg<count16> s210{.code = "S210", .address = 12960, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 10", .source = provenance::inferred};
inline constexpr reg<count16> s211{.code = "S211", .address = 12961, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 11", .source = provenance::inferred};
inline constexpr reg<count16> s212{.code = "S212", .address = 12962, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 12", .source = provenance::inferred};
inline constexpr reg<count16> s213{.code = "S213", .address = 12963, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 13", .source = provenance::inferred};
inline constexpr reg<count16> s214{.code = "S214", .address = 12964, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 14", .source = provenance::inferred};
inline constexpr reg<count16> s215{.code = "S215", .address = 12965, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 2: value of register 15", .source = provenance::inferred};
inline constexpr reg<count16> s301{.code = "S301", .address = 12971, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 1", .source = provenance::inferred};
inline constexpr reg<count16> s302{.code = "S302", .address = 12972, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 2", .source = provenance::inferred};
inline constexpr reg<count16> s303{.code = "S303", .address = 12973, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 3", .source = provenance::inferred};
inline constexpr reg<count16> s304{.code = "S304", .address = 12974, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 4", .source = provenance::inferred};
inline constexpr reg<count16> s305{.code = "S305", .address = 12975, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 5", .source = provenance::inferred};
inline constexpr reg<count16> s306{.code = "S306", .address = 12976, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 6", .source = provenance::inferred};
inline constexpr reg<count16> s307{.code = "S307", .address = 12977, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 7", .source = provenance::inferred};
inline constexpr reg<count16> s308{.code = "S308", .address = 12978, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 8", .source = provenance::inferred};
inline constexpr reg<count16> s309{.code = "S309", .address = 12979, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 9", .source = provenance::inferred};
inline constexpr reg<count16> s310{.code = "S310", .address = 12980, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 10", .source = provenance::inferred};
inline constexpr reg<count16> s311{.code = "S311", .address = 12981, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 11", .source = provenance::inferred};
inline constexpr reg<count16> s312{.code = "S312", .address = 12982, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 12", .source = provenance::inferred};
inline constexpr reg<count16> s313{.code = "S313", .address = 12983, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 13", .source = provenance::inferred};
inline constexpr reg<count16> s314{.code = "S314", .address = 12984, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 14", .source = provenance::inferred};
inline constexpr reg<count16> s315{.code = "S315", .address = 12985, .min = {0}, .max = {65535}, .factory = 0, .name = "Parameter set 3: value of register 15", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Parameter sets.
struct functions_parameter_sets
    : parameter_list<val, cha1, cha2, ad01, ad02, ad03, ad04, ad05, ad06, ad07, ad08, ad09, ad10, ad11, ad12, ad13,
                     ad14, ad15, s101, s102, s103, s104, s105, s106, s107, s108, s109, s110, s111, s112, s113, s114,
                     s115, s201, s202, s203, s204, s205, s206, s207, s208, s209, s210, s211, s212, s213, s214, s215,
                     s301, s302, s303, s304, s305, s306, s307, s308, s309, s310, s311, s312, s313, s314, s315> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
