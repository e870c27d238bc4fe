// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV310: all its parameters, by the groups of its menus. What its manual does not print comes from the parameter file
// of the ATV12, and is marked so.
#pragma once

#include <array>

#include <rtuwire/altivar/device/atv310.hpp>
#include <rtuwire/altivar/parameters/compact_values.hpp>
#include <rtuwire/altivar/parameters/family_words.hpp>
#include <rtuwire/altivar/parameters/parameter_list.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/altivar/parameters/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv310 {

// clang-format off
inline constexpr reg<active_channel> crc{.code = "CRC", .address = 8441, .mode = access::read_only, .name = "Active reference channel", .source = provenance::inferred};
inline constexpr reg<active_channel> ccc{.code = "CCC", .address = 8442, .mode = access::read_only, .name = "Active command channel", .source = provenance::inferred};
inline constexpr reg<counter_reset> rpr{.code = "RPR", .address = 3120, .factory = 0, .name = "Counter reset", .source = provenance::inferred};
inline constexpr reg<motor_standard> bfr{.code = "BFR", .address = 3015, .mode = access::configuration, .factory = 0, .name = "Standard motor frequency", .source = provenance::inferred};
inline constexpr reg<motor_control_law> ctt{.code = "CTT", .address = 9607, .mode = access::configuration, .name = "Motor control law", .source = provenance::inferred};
inline constexpr reg<tuning_order> tun{.code = "TUN", .address = 9608, .mode = access::configuration, .factory = 0, .name = "Autotune", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> aiv1{.code = "AIV1", .address = 5281, .min = {0}, .max = {1000}, .factory = 0, .name = "Virtual analog input 1", .source = provenance::inferred};
inline constexpr reg<configuration_save> scs{.code = "SCS", .address = 8001, .mode = access::configuration, .factory = 0, .name = "Save the configuration", .source = provenance::inferred};
inline constexpr reg<configuration_recall> fcs{.code = "FCS", .address = 8002, .mode = access::configuration, .factory = 0, .name = "Load a configuration or factory settings", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv310

namespace altivar::atv310::groups {

/// What the drive shows.
struct monitoring : parameter_list<eta, rfr, frh, lcr, eti, uln, thd, opr, rthi, pth, hmis, crc, ccc, thr> {};

/// Words that command the drive, and its speed mode.
struct control : parameter_list<rpr, cmd, lfr, pisp, cmi, cmdd, lfrd, etad, rfrd> {};

/// Where commands and references come from.
struct command : parameter_list<chcf, fr1, cd1, flo> {};

/// Everyday settings.
struct settings : parameter_list<hsp, lsp, acc, dec, ith> {};

/// The motor and its control.
struct motor_control : parameter_list<bfr, sfr, tfr, uns, frs, ncr, nsp, cos, ctt, tun, npr> {};

/// Analog inputs and outputs.
struct analog_io : parameter_list<aiv1> {};

/// Lines and networks.
struct communication : parameter_list<add, tbr, tfo, tto> {};

/// The scanner: words that one request moves.
struct scanner
    : parameter_list<nma1, nma2, nma3, nma4, nma5, nma6, nma7, nma8, nca1, nca2, nca3, nca4, nca5, nca6, nca7, nca8,
                     nm1, nm2, nm3, nm4, nm5, nm6, nm7, nm8, nc1, nc2, nc3, nc4, nc5, nc6, nc7, nc8> {};

/// The same by the manual of 2014: half as many.
struct scanner_2014
    : parameter_list<nma1, nma2, nma3, nma4, nca1, nca2, nca3, nca4, nm1, nm2, nm3, nm4, nc1, nc2, nc3, nc4> {};

/// Reactions to faults.
struct faults : parameter_list<sll, lft, cic> {};

/// What drive this is.
struct identification : parameter_list<ncv, vcal, inv, vdp> {};

/// Saving and recalling configurations.
struct configuration : parameter_list<scs, fcs> {};

/// States at past faults.
struct history_state : parameter_list<dp0, dp1, dp2, dp3, dp4> {};

/// Ramps.
struct functions_ramp : parameter_list<ac2, de2> {};

/// Stopping and DC injection.
struct functions_stop : parameter_list<stt> {};

} // namespace altivar::atv310::groups

namespace altivar::atv310 {

/// The parameters by group, with the scanner of one manual or the other.
/// Internal.
template <typename Scanner>
inline constexpr std::array<parameter_group, 14> menu_groups{{
    group_of<groups::monitoring>("monitoring"),
    group_of<groups::control>("control"),
    group_of<groups::command>("command"),
    group_of<groups::settings>("settings"),
    group_of<groups::motor_control>("motor_control"),
    group_of<groups::analog_io>("analog_io"),
    group_of<groups::communication>("communication"),
    group_of<Scanner>("scanner"),
    group_of<groups::faults>("faults"),
    group_of<groups::identification>("identification"),
    group_of<groups::configuration>("configuration"),
    group_of<groups::history_state>("history_state"),
    group_of<groups::functions_ramp>("functions_ramp"),
    group_of<groups::functions_stop>("functions_stop"),
}};

/// The same as the registers of a device.
/// Internal.
template <typename Scanner>
using all_groups =
    grouped_table<groups::monitoring, groups::control, groups::command, groups::settings, groups::motor_control,
                  groups::analog_io, groups::communication, Scanner, groups::faults, groups::identification,
                  groups::configuration, groups::history_state, groups::functions_ramp, groups::functions_stop>;

/// All parameters that can be used, as rows to walk, by the manual of 2026.
inline constexpr parameter_map parameters{menu_groups<groups::scanner>, "ATV310"};

/// The same by the manual of 2014, whose scanner has half as many words.
inline constexpr parameter_map parameters_2014{menu_groups<groups::scanner_2014>};

/// An ATV310 as its manual of 2026 has it, with every register of this map for typed access: `station<full_device>`.
struct full_device : device_2026 {
    using registers = all_groups<groups::scanner>;
};

/// The same by the manual of 2014.
struct full_device_2014 : device {
    using registers = all_groups<groups::scanner_2014>;
};

} // namespace altivar::atv310
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
