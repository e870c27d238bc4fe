// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: all its parameters, from public parameter files, most of it by a sister drive; by the groups of its menus.
// Those of which too little is known stand apart.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/command.hpp>
#include <rtuwire/altivar/parameters/atv320/communication.hpp>
#include <rtuwire/altivar/parameters/atv320/configuration.hpp>
#include <rtuwire/altivar/parameters/atv320/control.hpp>
#include <rtuwire/altivar/parameters/atv320/display.hpp>
#include <rtuwire/altivar/parameters/atv320/faults.hpp>
#include <rtuwire/altivar/parameters/atv320/function_blocks.hpp>
#include <rtuwire/altivar/parameters/atv320/functions/brake.hpp>
#include <rtuwire/altivar/parameters/atv320/functions/contactor.hpp>
#include <rtuwire/altivar/parameters/atv320/functions/hoisting.hpp>
#include <rtuwire/altivar/parameters/atv320/functions/limits.hpp>
#include <rtuwire/altivar/parameters/atv320/functions/parameter_sets.hpp>
#include <rtuwire/altivar/parameters/atv320/functions/pid.hpp>
#include <rtuwire/altivar/parameters/atv320/functions/ramp.hpp>
#include <rtuwire/altivar/parameters/atv320/functions/speed.hpp>
#include <rtuwire/altivar/parameters/atv320/functions/stop.hpp>
#include <rtuwire/altivar/parameters/atv320/functions/traverse.hpp>
#include <rtuwire/altivar/parameters/atv320/history/state.hpp>
#include <rtuwire/altivar/parameters/atv320/history/values.hpp>
#include <rtuwire/altivar/parameters/atv320/identification.hpp>
#include <rtuwire/altivar/parameters/atv320/io/analog.hpp>
#include <rtuwire/altivar/parameters/atv320/io/logic.hpp>
#include <rtuwire/altivar/parameters/atv320/monitoring.hpp>
#include <rtuwire/altivar/parameters/atv320/motor_control.hpp>
#include <rtuwire/altivar/parameters/atv320/process_monitoring.hpp>
#include <rtuwire/altivar/parameters/atv320/safety.hpp>
#include <rtuwire/altivar/parameters/atv320/scanner.hpp>
#include <rtuwire/altivar/parameters/atv320/settings.hpp>
#include <rtuwire/altivar/parameters/atv320/unverified/functions.hpp>
#include <rtuwire/altivar/parameters/atv320/unverified/io.hpp>
#include <rtuwire/altivar/parameters/atv320/unverified/others.hpp>
#include <rtuwire/altivar/parameters/atv320/unverified/safety_history_1.hpp>
#include <rtuwire/altivar/parameters/atv320/unverified/safety_history_2.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320 {

/// The parameters by group.
/// Internal.
inline constexpr parameter_group menu_groups[]{
    group_of<groups::monitoring>("monitoring"),
    group_of<groups::control>("control"),
    group_of<groups::command>("command"),
    group_of<groups::settings>("settings"),
    group_of<groups::motor_control>("motor_control"),
    group_of<groups::analog_io>("analog_io"),
    group_of<groups::logic_io>("logic_io"),
    group_of<groups::communication>("communication"),
    group_of<groups::scanner>("scanner"),
    group_of<groups::faults>("faults"),
    group_of<groups::process_monitoring>("process_monitoring"),
    group_of<groups::identification>("identification"),
    group_of<groups::configuration>("configuration"),
    group_of<groups::display>("display"),
    group_of<groups::safety>("safety"),
    group_of<groups::function_blocks>("function_blocks"),
    group_of<groups::history_state>("history_state"),
    group_of<groups::history_values>("history_values"),
    group_of<groups::functions_speed>("functions_speed"),
    group_of<groups::functions_ramp>("functions_ramp"),
    group_of<groups::functions_stop>("functions_stop"),
    group_of<groups::functions_pid>("functions_pid"),
    group_of<groups::functions_limits>("functions_limits"),
    group_of<groups::functions_brake>("functions_brake"),
    group_of<groups::functions_hoisting>("functions_hoisting"),
    group_of<groups::functions_traverse>("functions_traverse"),
    group_of<groups::functions_contactor>("functions_contactor"),
    group_of<groups::functions_parameter_sets>("functions_parameter_sets"),
};

/// All parameters that can be used, as rows to walk.
inline constexpr parameter_map parameters{menu_groups, "ATV320"};

/// Internal.
inline constexpr parameter_group unverified_groups[]{
    group_of<unverified::monitoring>("monitoring"),
    group_of<unverified::control>("control"),
    group_of<unverified::motor_control>("motor_control"),
    group_of<unverified::analog_io>("analog_io"),
    group_of<unverified::logic_io>("logic_io"),
    group_of<unverified::communication>("communication"),
    group_of<unverified::faults>("faults"),
    group_of<unverified::process_monitoring>("process_monitoring"),
    group_of<unverified::identification>("identification"),
    group_of<unverified::configuration>("configuration"),
    group_of<unverified::display>("display"),
    group_of<unverified::safety>("safety"),
    group_of<unverified::history_state>("history_state"),
    group_of<unverified::functions_stop>("functions_stop"),
    group_of<unverified::functions_pid>("functions_pid"),
    group_of<unverified::functions_limits>("functions_limits"),
    group_of<unverified::functions_brake>("functions_brake"),
    group_of<unverified::functions_hoisting>("functions_hoisting"),
    group_of<unverified::history_safety_1>("history_safety_1"),
    group_of<unverified::history_safety_2>("history_safety_2"),
};

/// Registers that are known to exist, and little more: read-only, doubtful.
inline constexpr parameter_map unverified_parameters{unverified_groups, "ATV320"};

/// An ATV320 with every register of this map for typed access: `station<full_device>`.
struct full_device : device {
    using registers =
        grouped_table<groups::monitoring, groups::control, groups::command, groups::settings, groups::motor_control,
                      groups::analog_io, groups::logic_io, groups::communication, groups::scanner, groups::faults,
                      groups::process_monitoring, groups::identification, groups::configuration, groups::display,
                      groups::safety, groups::function_blocks, groups::history_state, groups::history_values,
                      groups::functions_speed, groups::functions_ramp, groups::functions_stop, groups::functions_pid,
                      groups::functions_limits, groups::functions_brake, groups::functions_hoisting,
                      groups::functions_traverse, groups::functions_contactor, groups::functions_parameter_sets,
                      unverified::monitoring, unverified::control, unverified::motor_control, unverified::analog_io,
                      unverified::logic_io, unverified::communication, unverified::faults,
                      unverified::process_monitoring, unverified::identification, unverified::configuration,
                      unverified::display, unverified::safety, unverified::history_state, unverified::functions_stop,
                      unverified::functions_pid, unverified::functions_limits, unverified::functions_brake,
                      unverified::functions_hoisting, unverified::history_safety_1, unverified::history_safety_2>;
};

} // namespace altivar::atv320
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
