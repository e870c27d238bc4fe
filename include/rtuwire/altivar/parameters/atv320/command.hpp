// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: where commands and references come from.
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
inline constexpr reg<no_yes> rin{.code = "RIN", .address = 3108, .mode = access::configuration, .factory = 0, .name = "Reverse direction locked", .source = provenance::inferred};
inline constexpr reg<channel_copy> cop{.code = "COP", .address = 8402, .mode = access::configuration, .factory = 0, .name = "What is copied from channel 1 to 2", .source = provenance::inferred};
inline constexpr reg<logic_input> rfc{.code = "RFC", .address = 8411, .mode = access::configuration, .name = "Input that selects reference channel 1 or 2", .source = provenance::inferred};
inline constexpr reg<logic_input> rcb{.code = "RCB", .address = 8412, .mode = access::configuration, .factory = 96, .name = "Input that selects reference channel 1 or 1B", .source = provenance::inferred};
inline constexpr reg<reference_channel> fr1b{.code = "FR1B", .address = 8415, .mode = access::configuration, .factory = 0, .name = "Reference channel 1B", .source = provenance::inferred};
inline constexpr reg<logic_input> ccs{.code = "CCS", .address = 8421, .mode = access::configuration, .factory = 98, .name = "Input that selects the command channel", .source = provenance::inferred};
inline constexpr reg<signal_source> floc{.code = "FLOC", .address = 8432, .mode = access::configuration, .factory = 0, .name = "Reference channel in local control", .source = provenance::inferred};
inline constexpr reg<deciseconds> flot{.code = "FLOT", .address = 8433, .mode = access::configuration, .min = {1}, .max = {300}, .factory = 100, .name = "Time-out after leaving local control", .source = provenance::inferred};
inline constexpr reg<two_wire_type> tct{.code = "TCT", .address = 11102, .mode = access::configuration, .factory = 1, .name = "How 2-wire control reacts", .source = provenance::inferred};
inline constexpr reg<logic_input> rrs{.code = "RRS", .address = 11105, .mode = access::configuration, .name = "Input for reverse running", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Where commands and references come from.
struct command
    : parameter_list<rin, chcf, cop, rfc, rcb, fr1, fr2, fr1b, ccs, cd1, cd2, flo, floc, flot, tcc, tct, rrs> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
