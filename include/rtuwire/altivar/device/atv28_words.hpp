// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The words of the ATV28, bit by bit. Bit 15 of CMD selects the DRIVECOM commands (0) or the direct ones (1), and bit
// 4 of ETA is inverted: 1 means that the mains is absent.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv28 {

/// CMD and CMDD.
enum class command_bit : std::uint8_t {
    switch_on = 0,
    enable_voltage = 1, ///< disable voltage at 0
    quick_stop = 2,     ///< at 0, DRIVECOM only
    enable_operation = 3,
    fault_reset = 7,  ///< on its rising edge
    release_link = 8, ///< with bit 15: the serial link gives the control back
    reverse = 11,
    ramp_stop = 12,
    dc_injection_stop = 13,
    fast_stop = 14,
    direct_control = 15,
};
using command_word = flags<command_bit>;

/// ETA and ETAD.
enum class status_bit : std::uint8_t {
    ready_to_switch_on = 0,
    switched_on = 1,
    operation_enabled = 2,
    fault = 3,
    mains_absent = 4,
    quick_stop = 5, ///< at 0
    switch_on_disabled = 6,
    thermal_alarm = 7,
    remote = 9, ///< forced local at 0
    reference_reached = 10,
    reference_out_of_limits = 11,
    stop_key = 14,
    reverse = 15,
};
using status_word = flags<status_bit>;

/// CMI.
enum class extended_command_bit : std::uint8_t {
    factory_settings = 0, ///< the first three stop communication for up to 2 s
    save_to_eeprom = 1,
    restore_from_eeprom = 2,
    ramp_switching = 4,
    lock_at_stop = 13,
    no_link_supervision = 14,
};
using extended_command_word = flags<extended_command_bit>;

/// ETI.
enum class extended_status_bit : std::uint8_t {
    motor_running = 4,
    dc_injection = 5,
    transient = 6,
    thermal_overload = 7,
    excessive_braking = 8,
    current_limit = 11,
    source_keypad = 13,
    source_link = 14,
    reverse_requested = 15,
};
using extended_status_word = flags<extended_status_bit>;

/// ETI2.
enum class threshold_bit : std::uint8_t { reference = 4, frequency = 5, current = 6 };
using extended_status_word_2 = flags<threshold_bit>;

/// IOLR.
enum class logic_bit : std::uint8_t { li1 = 0, li2 = 1, li3 = 2, li4 = 3, r1 = 8, r2 = 9 };
using logic_image = flags<logic_bit>;

/// DF1.
enum class active_fault_1_bit : std::uint8_t {
    calibration = 0,
    unknown_rating = 1,
    unknown_hardware = 2,
    eeprom = 3,
    serial_link = 8,
    motor_short_circuit = 13,
};
using active_faults_1 = flags<active_fault_1_bit>;

/// DF2.
enum class active_fault_2_bit : std::uint8_t {
    overcurrent = 3,
    drive_overheat = 7,
    motor_overload = 8,
    dc_bus_overvoltage = 10,
    line_overvoltage = 11,
    motor_phase = 12,
    line_phase = 13,
    undervoltage = 14,
    control_supply = 15,
};
using active_faults_2 = flags<active_fault_2_bit>;

/// ETI3, which is reserved, and CPU: low byte the upgrade index, high byte the firmware version.
using reserved_word = flags<detail::unnamed_bit>;
using firmware_word = flags<detail::unnamed_bit>;

} // namespace altivar::atv28
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
