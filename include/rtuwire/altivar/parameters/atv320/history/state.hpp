// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: states at past faults.
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
inline constexpr reg<status_word> ep0{.code = "EP0", .address = 7210, .mode = access::read_only, .name = "Status word at the most recent fault", .source = provenance::inferred};
inline constexpr reg<status_word> ep1{.code = "EP1", .address = 7211, .mode = access::read_only, .name = "Status word at fault 1 back", .source = provenance::inferred};
inline constexpr reg<status_word> ep2{.code = "EP2", .address = 7212, .mode = access::read_only, .name = "Status word at fault 2 back", .source = provenance::inferred};
inline constexpr reg<status_word> ep3{.code = "EP3", .address = 7213, .mode = access::read_only, .name = "Status word at fault 3 back", .source = provenance::inferred};
inline constexpr reg<status_word> ep4{.code = "EP4", .address = 7214, .mode = access::read_only, .name = "Status word at fault 4 back", .source = provenance::inferred};
inline constexpr reg<status_word> ep5{.code = "EP5", .address = 7215, .mode = access::read_only, .name = "Status word at fault 5 back", .source = provenance::inferred};
inline constexpr reg<status_word> ep6{.code = "EP6", .address = 7216, .mode = access::read_only, .name = "Status word at fault 6 back", .source = provenance::inferred};
inline constexpr reg<status_word> ep7{.code = "EP7", .address = 7217, .mode = access::read_only, .name = "Status word at fault 7 back", .source = provenance::inferred};
inline constexpr reg<status_word> ep8{.code = "EP8", .address = 7218, .mode = access::read_only, .name = "Status word at fault 8 back", .source = provenance::inferred};
inline constexpr reg<extended_status_word> ip0{.code = "IP0", .address = 7220, .mode = access::read_only, .name = "Extended status word at the most recent fault", .source = provenance::inferred};
inline constexpr reg<extended_status_word> ip1{.code = "IP1", .address = 7221, .mode = access::read_only, .name = "Extended status word at fault 1 back", .source = provenance::inferred};
inline constexpr reg<extended_status_word> ip2{.code = "IP2", .address = 7222, .mode = access::read_only, .name = "Extended status word at fault 2 back", .source = provenance::inferred};
inline constexpr reg<extended_status_word> ip3{.code = "IP3", .address = 7223, .mode = access::read_only, .name = "Extended status word at fault 3 back", .source = provenance::inferred};
inline constexpr reg<extended_status_word> ip4{.code = "IP4", .address = 7224, .mode = access::read_only, .name = "Extended status word at fault 4 back", .source = provenance::inferred};
inline constexpr reg<extended_status_word> ip5{.code = "IP5", .address = 7225, .mode = access::read_only, .name = "Extended status word at fault 5 back", .source = provenance::inferred};
inline constexpr reg<extended_status_word> ip6{.code = "IP6", .address = 7226, .mode = access::read_only, .name = "Extended status word at fault 6 back", .source = provenance::inferred};
inline constexpr reg<extended_status_word> ip7{.code = "IP7", .address = 7227, .mode = access::read_only, .name = "Extended status word at fault 7 back", .source = provenance::inferred};
inline constexpr reg<extended_status_word> ip8{.code = "IP8", .address = 7228, .mode = access::read_only, .name = "Extended status word at fault 8 back", .source = provenance::inferred};
inline constexpr reg<command_word> cmp0{.code = "CMP0", .address = 7230, .mode = access::read_only, .name = "Command word at the most recent fault", .source = provenance::inferred};
inline constexpr reg<command_word> cmp1{.code = "CMP1", .address = 7231, .mode = access::read_only, .name = "Command word at fault 1 back", .source = provenance::inferred};
inline constexpr reg<command_word> cmp2{.code = "CMP2", .address = 7232, .mode = access::read_only, .name = "Command word at fault 2 back", .source = provenance::inferred};
inline constexpr reg<command_word> cmp3{.code = "CMP3", .address = 7233, .mode = access::read_only, .name = "Command word at fault 3 back", .source = provenance::inferred};
inline constexpr reg<command_word> cmp4{.code = "CMP4", .address = 7234, .mode = access::read_only, .name = "Command word at fault 4 back", .source = provenance::inferred};
inline constexpr reg<command_word> cmp5{.code = "CMP5", .address = 7235, .mode = access::read_only, .name = "Command word at fault 5 back", .source = provenance::inferred};
inline constexpr reg<command_word> cmp6{.code = "CMP6", .address = 7236, .mode = access::read_only, .name = "Command word at fault 6 back", .source = provenance::inferred};
inline constexpr reg<command_word> cmp7{.code = "CMP7", .address = 7237, .mode = access::read_only, .name = "Command word at fault 7 back", .source = provenance::inferred};
inline constexpr reg<command_word> cmp8{.code = "CMP8", .address = 7238, .mode = access::read_only, .name = "Command word at fault 8 back", .source = provenance::inferred};
inline constexpr reg<count16> fnb{.code = "FNB", .address = 7393, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Number of faults", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// States at past faults.
struct history_state
    : parameter_list<dp0, dp1, dp2, dp3, dp4, dp5, dp6, dp7, dp8, ep0, ep1, ep2, ep3, ep4, ep5, ep6, ep7, ep8, ip0, ip1,
                     ip2, ip3, ip4, ip5, ip6, ip7, ip8, cmp0, cmp1, cmp2, cmp3, cmp4, cmp5, cmp6, cmp7, cmp8, fnb> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
