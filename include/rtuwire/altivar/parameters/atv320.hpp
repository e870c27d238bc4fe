// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: all its parameters, from public parameter files, most of it by a sister drive; by the groups of its menus.
// Those of which too little is known stand apart.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/drive.hpp>
#include <rtuwire/altivar/parameters/atv320/faults.hpp>
#include <rtuwire/altivar/parameters/atv320/functions.hpp>
#include <rtuwire/altivar/parameters/atv320/io.hpp>
#include <rtuwire/altivar/parameters/atv320/unverified.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/altivar/parameters/row_table.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320 {

/// The parameters by group.
/// Internal.
inline constexpr parameter_group menu_groups[]{
    {"monitoring", rows::monitoring},
    {"control", rows::control},
    {"command", rows::command},
    {"settings", rows::settings},
    {"motor_control", rows::motor_control},
    {"analog_io", rows::analog_io},
    {"logic_io", rows::logic_io},
    {"communication", rows::communication},
    {"scanner", rows::scanner},
    {"faults", rows::faults},
    {"process_monitoring", rows::process_monitoring},
    {"identification", rows::identification},
    {"configuration", rows::configuration},
    {"display", rows::display},
    {"safety", rows::safety},
    {"function_blocks", rows::function_blocks},
    {"history_state", rows::history_state},
    {"history_values", rows::history_values},
    {"functions_speed", rows::functions_speed},
    {"functions_ramp", rows::functions_ramp},
    {"functions_stop", rows::functions_stop},
    {"functions_pid", rows::functions_pid},
    {"functions_limits", rows::functions_limits},
    {"functions_brake", rows::functions_brake},
    {"functions_hoisting", rows::functions_hoisting},
    {"functions_traverse", rows::functions_traverse},
    {"functions_contactor", rows::functions_contactor},
    {"functions_parameter_sets", rows::functions_parameter_sets},
};

/// All parameters that can be used, as rows to walk.
inline constexpr parameter_map parameters{menu_groups, "ATV320"};

/// Internal.
inline constexpr parameter_group unverified_groups[]{
    {"monitoring", rows::unverified_monitoring},
    {"control", rows::unverified_control},
    {"motor_control", rows::unverified_motor_control},
    {"analog_io", rows::unverified_analog_io},
    {"logic_io", rows::unverified_logic_io},
    {"communication", rows::unverified_communication},
    {"faults", rows::unverified_faults},
    {"identification", rows::unverified_identification},
    {"configuration", rows::unverified_configuration},
    {"safety", rows::unverified_safety},
    {"history_state", rows::unverified_history_state},
    {"functions_stop", rows::unverified_functions_stop},
    {"functions_pid", rows::unverified_functions_pid},
    {"functions_limits", rows::unverified_functions_limits},
    {"functions_brake", rows::unverified_functions_brake},
    {"functions_hoisting", rows::unverified_functions_hoisting},
};

/// Registers of which too little is known to write them: read-only, doubtful.
inline constexpr parameter_map unverified_parameters{unverified_groups, "ATV320"};

/// An ATV320 with every register of these maps for typed access: `station<full_device>`.
struct full_device : device {
    using registers = row_table<full_device, device::registers, parameters, unverified_parameters>;
};

/// A parameter by its mnemonic, where a register is wanted: `read<parameter<"LFF">>(drive)`. What has an object of its own,
/// as `acc`, is named by that.
template <mnemonic Code> inline constexpr auto const& parameter = parameter_called<full_device, Code>;

} // namespace altivar::atv320
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
