// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV310: all its parameters, by the groups of its menus. What its manual does not print comes from the parameter file
// of the ATV12, and is marked so. How to read a line stands in parameters/parameter.hpp.
#pragma once

#include <array>

#include <rtuwire/altivar/device/atv310.hpp>
#include <rtuwire/altivar/parameters/compact_choices.hpp>
#include <rtuwire/altivar/parameters/menu_numbers.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/altivar/parameters/row_table.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv310::rows {

// clang-format off
using namespace roles;
using namespace compact_choices;

inline constexpr row_access ro{access::read_only, provenance::inferred};
inline constexpr row_access rw{access::read_write, provenance::inferred};
inline constexpr row_access cfg{access::configuration, provenance::inferred};

// What the drive shows.
inline constexpr parameter monitoring[]{
    row_of(eta), row_of(rfr), row_of(frh), row_of(lcr), row_of(eti), row_of(uln), row_of(thd), row_of(opr),
    row_of(rthi), row_of(pth), row_of(hmis),
    {"CRC", 8441, ro, bits(active_channel), {}, {}, {}, "Active reference channel"},
    {"CCC", 8442, ro, bits(active_channel), {}, {}, {}, "Active command channel"},
    row_of(thr),
};

// Words that command the drive, and its speed mode.
inline constexpr parameter control[]{
    {"RPR", 3120, rw, counter_reset, {}, {}, 0, "Counter reset", &clears},
    row_of(cmd, commands), row_of(lfr, setpoint), row_of(pisp, setpoint), row_of(cmi, recalls),
    row_of(cmdd, commands), row_of(lfrd, setpoint), row_of(etad), row_of(rfrd),
};

// Where commands and references come from.
inline constexpr parameter command[]{
    row_of(chcf, commander), row_of(fr1, references), row_of(cd1, commander), row_of(flo, commander),
};

// Everyday settings.
inline constexpr parameter settings[]{
    row_of(hsp, speed_limit), row_of(lsp, speed_limit), row_of(acc, ramp), row_of(dec, ramp),
    row_of(ith, ordinary),
};

// The motor and its control.
inline constexpr parameter motor_control[]{
    {"BFR", 3015, cfg, motor_standard,    {}, {}, 0,  "Standard motor frequency", &speed_range},
    row_of(sfr, ordinary), row_of(tfr, speed_limit), row_of(uns, ordinary), row_of(frs, ordinary),
    row_of(ncr, ordinary), row_of(nsp, ordinary), row_of(cos, ordinary),
    {"CTT", 9607, cfg, motor_control_law, {}, {}, {}, "Motor control law"},
    {"TUN", 9608, cfg, tuning_order,      {}, {}, 0,  "Autotune", &autotuning},
    row_of(npr, ordinary),
};

// Analog inputs and outputs.
inline constexpr parameter analog_io[]{
    {"AIV1", 5281, rw, in<signed_tenth_percent>, 0, 1000, 0, "Virtual analog input 1", &setpoint},
};

// Lines and networks.
inline constexpr parameter communication[]{
    row_of(add, this_line), row_of(tbr, this_line), row_of(tfo, this_line), row_of(tto, timeout),
};

// The scanner: words that one request moves.
inline constexpr parameter scanner[]{
    row_of(nma1, ordinary), row_of(nma2, ordinary), row_of(nma3, ordinary), row_of(nma4, ordinary),
    row_of(nma5, ordinary), row_of(nma6, ordinary), row_of(nma7, ordinary), row_of(nma8, ordinary),
    row_of(nca1, cyclic_words), row_of(nca2, cyclic_words), row_of(nca3, cyclic_words),
    row_of(nca4, cyclic_words), row_of(nca5, cyclic_words), row_of(nca6, cyclic_words),
    row_of(nca7, cyclic_words), row_of(nca8, cyclic_words), row_of(nm1), row_of(nm2), row_of(nm3),
    row_of(nm4), row_of(nm5), row_of(nm6), row_of(nm7), row_of(nm8), row_of(nc1, passed_on),
    row_of(nc2, passed_on), row_of(nc3, passed_on), row_of(nc4, passed_on), row_of(nc5, passed_on),
    row_of(nc6, passed_on), row_of(nc7, passed_on), row_of(nc8, passed_on),
};

// The same by the manual of 2014: half as many.
inline constexpr parameter scanner_2014[]{
    row_of(nma1, ordinary), row_of(nma2, ordinary), row_of(nma3, ordinary), row_of(nma4, ordinary),
    row_of(nca1, cyclic_words), row_of(nca2, cyclic_words), row_of(nca3, cyclic_words),
    row_of(nca4, cyclic_words), row_of(nm1), row_of(nm2), row_of(nm3), row_of(nm4), row_of(nc1, passed_on),
    row_of(nc2, passed_on), row_of(nc3, passed_on), row_of(nc4, passed_on),
};

// Reactions to faults.
inline constexpr parameter faults[]{
    row_of(sll, link_loss), row_of(lft), row_of(cic, accepts),
};

// What drive this is.
inline constexpr parameter identification[]{
    row_of(ncv, device_identity), row_of(vcal, device_identity), row_of(inv), row_of(vdp),
};

// Saving and recalling configurations.
inline constexpr parameter configuration[]{
    {"SCS", 8001, cfg, configuration_save,   {}, {}, 0, "Save the configuration", &recalls},
    {"FCS", 8002, cfg, configuration_recall, {}, {}, 0, "Load a configuration or factory settings", &recalls},
};

// States at past faults.
inline constexpr parameter history_state[]{
    row_of(dp0), row_of(dp1), row_of(dp2), row_of(dp3), row_of(dp4),
};

// Ramps.
inline constexpr parameter functions_ramp[]{
    row_of(ac2, ramp), row_of(de2, ramp),
};

// Stopping and DC injection.
inline constexpr parameter functions_stop[]{
    row_of(stt, stopping),
};
// clang-format on

} // namespace altivar::atv310::rows

namespace altivar::atv310 {

/// The parameters by group, with the scanner of one manual or the other.
/// Internal.
template <auto const& Scanner>
inline constexpr std::array<parameter_group, 14> menu_groups{
    parameter_group{"monitoring", rows::monitoring},
    parameter_group{"control", rows::control},
    parameter_group{"command", rows::command},
    parameter_group{"settings", rows::settings},
    parameter_group{"motor_control", rows::motor_control},
    parameter_group{"analog_io", rows::analog_io},
    parameter_group{"communication", rows::communication},
    parameter_group{"scanner", Scanner},
    parameter_group{"faults", rows::faults},
    parameter_group{"identification", rows::identification},
    parameter_group{"configuration", rows::configuration},
    parameter_group{"history_state", rows::history_state},
    parameter_group{"functions_ramp", rows::functions_ramp},
    parameter_group{"functions_stop", rows::functions_stop},
};

/// All parameters that can be used, as rows to walk, by the manual of 2026.
inline constexpr parameter_map parameters{menu_groups<rows::scanner>, "ATV310"};

/// The same by the manual of 2014, whose scanner has half as many words.
inline constexpr parameter_map parameters_2014{menu_groups<rows::scanner_2014>};

/// An ATV310 as its manual of 2026 has it, with every register of this map for typed access: `station<full_device>`.
struct full_device : device_2026 {
    using registers = row_table<full_device, device_2026::registers, parameters>;
};

/// The same by the manual of 2014.
struct full_device_2014 : device {
    using registers = row_table<full_device, device::registers, parameters_2014>;
};

/// A parameter by its mnemonic, where a register is wanted: `read<parameter<"CTT">>(drive)`. What has an object of its own,
/// as `acc`, is named by that.
template <mnemonic Code> inline constexpr auto const& parameter = parameter_called<full_device, Code>;

// The menu numbers that its Modbus manuals print. The manual of 2026 has more scanner words than that of 2014, and one
// setting more; no number has another meaning there. Settings whose number only the user manual prints are missing. 705.4
// to 705.7 stand beside 707.4 to 707.7, too, in the manual of 2026: taken as misprints, for the same lines call them 707.4
// to 707.7 and the numbers are those of the scanner's addresses.

/// Internal.
inline constexpr menu_number printed_in_2014[]{
    {"308", "TFR"},    {"315", "SFR"},    {"512.0", "LSP"},  {"512.2", "HSP"},  {"611", "SLL"},
    {"701", "ADD"},    {"702", "TBR"},    {"703", "TFO"},    {"704", "TTO"},    {"705.0", "NMA1"},
    {"705.1", "NMA2"}, {"705.2", "NMA3"}, {"705.3", "NMA4"}, {"706.0", "NCA1"}, {"706.1", "NCA2"},
    {"706.2", "NCA3"}, {"706.3", "NCA4"}, {"707.0", "NM1"},  {"707.1", "NM2"},  {"707.2", "NM3"},
    {"707.3", "NM4"},  {"708.0", "NC1"},  {"708.1", "NC2"},  {"708.2", "NC3"},  {"708.3", "NC4"},
};

/// Internal.
inline constexpr menu_number printed_in_2026[]{
    {"308", "TFR"},    {"315", "SFR"},    {"502.0", "STT"},  {"512.0", "LSP"},  {"512.2", "HSP"},  {"611", "SLL"},
    {"701", "ADD"},    {"702", "TBR"},    {"703", "TFO"},    {"704", "TTO"},    {"705.0", "NMA1"}, {"705.1", "NMA2"},
    {"705.2", "NMA3"}, {"705.3", "NMA4"}, {"705.4", "NMA5"}, {"705.5", "NMA6"}, {"705.6", "NMA7"}, {"705.7", "NMA8"},
    {"706.0", "NCA1"}, {"706.1", "NCA2"}, {"706.2", "NCA3"}, {"706.3", "NCA4"}, {"706.4", "NCA5"}, {"706.5", "NCA6"},
    {"706.6", "NCA7"}, {"706.7", "NCA8"}, {"707.0", "NM1"},  {"707.1", "NM2"},  {"707.2", "NM3"},  {"707.3", "NM4"},
    {"707.4", "NM5"},  {"707.5", "NM6"},  {"707.6", "NM7"},  {"707.7", "NM8"},  {"708.0", "NC1"},  {"708.1", "NC2"},
    {"708.2", "NC3"},  {"708.3", "NC4"},  {"708.4", "NC5"},  {"708.5", "NC6"},  {"708.6", "NC7"},  {"708.7", "NC8"},
};

/// Of the drive `device`, by the manual of 2014.
inline constexpr menu_numbers menu_2014{printed_in_2014};

/// Of the drive `device_2026` and of `full_device`, by the manual of 2026.
inline constexpr menu_numbers menu_2026{printed_in_2026};

} // namespace altivar::atv310

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
