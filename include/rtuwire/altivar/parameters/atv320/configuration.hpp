// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: saving and recalling configurations.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
#include <rtuwire/altivar/parameters/atv320/values/configuration.hpp>
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
inline constexpr reg<macro_configuration> cfg{.code = "CFG", .address = 3052, .mode = access::configuration, .factory = 0, .name = "Macro configuration", .source = provenance::inferred};
inline constexpr reg<no_yes> ccfg{.code = "CCFG", .address = 3053, .mode = access::read_only, .name = "Macro configuration changed by the user", .source = provenance::inferred};
inline constexpr reg<configuration_save> scs{.code = "SCS", .address = 8001, .mode = access::configuration, .factory = 0, .name = "Save the configuration", .source = provenance::inferred};
inline constexpr reg<configuration_recall> fcs{.code = "FCS", .address = 8002, .mode = access::configuration, .factory = 0, .name = "Load a configuration or factory settings", .source = provenance::inferred};
inline constexpr reg<logic_input> cnf1{.code = "CNF1", .address = 8021, .mode = access::configuration, .factory = 0, .name = "Input that selects configuration 2", .source = provenance::inferred};
inline constexpr reg<logic_input> cnf2{.code = "CNF2", .address = 8022, .mode = access::configuration, .factory = 0, .name = "Input that selects configuration 3", .source = provenance::inferred};
inline constexpr reg<no_yes> chm{.code = "CHM", .address = 8025, .mode = access::configuration, .factory = 0, .name = "Configurations used for several motors", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Saving and recalling configurations.
struct configuration : parameter_list<cfg, ccfg, scs, fcs, cnf1, cnf2, chm> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
