// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What ATV12, ATV310 and ATV320 have in common beside registers: their command and status words, bit by bit, and their
// functions, limits and line. Bit 4 of CMD is written 0: the manuals that give it a meaning contradict their own run
// command. Bits marked "at 0" are active low.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// CMD and CMDD.
enum class command_bit : std::uint8_t {
    switch_on = 0,
    enable_voltage = 1, ///< disable voltage at 0
    quick_stop = 2,     ///< at 0
    enable_operation = 3,
    fault_reset = 7, ///< on its rising edge
    halt = 8,        ///< stops as STT says, staying in operation enabled
    reverse = 11,
};
using command_word = flags<command_bit>;

/// ETA and ETAD.
enum class status_bit : std::uint8_t {
    ready_to_switch_on = 0,
    switched_on = 1,
    operation_enabled = 2,
    fault = 3,
    voltage_enabled = 4, ///< always 1 where the power section feeds the control
    quick_stop = 5,      ///< at 0
    switch_on_disabled = 6,
    warning = 7, ///< ATV320 only
    remote = 9,  ///< local control at 0
    reference_reached = 10,
    reference_out_of_limits = 11, ///< below LSP or above HSP
    stop_key = 14,
    reverse = 15,
};
using status_word = flags<status_bit>;

/// CMI.
enum class extended_command_bit : std::uint8_t {
    factory_settings = 0,
    save_to_eeprom = 1,         ///< 100 000 times in a drive's life
    standardized_frequency = 9, ///< LFR and RFR count 1/32767 of TFR instead of 0.1 Hz
    no_consistency_check = 15,
};
using extended_command_word = flags<extended_command_bit>;

/// ETI.
enum class extended_status_bit : std::uint8_t {
    eeprom_access = 0,
    consistency_check = 1,
    fault_is_gone = 2, ///< in fault state, cause gone, not yet reset
    speed_mode = 4,
    dc_injection = 5,
    transient = 6,
    motor_thermal_threshold = 7,
    excessive_braking = 8, ///< ATV320 only
    accelerating = 9,
    decelerating = 10,
    current_limit = 11,
    fast_stop = 12,
    source_low = 13, ///< with the next: 00 terminals or keypad, 10 remote keypad, 01 Modbus
    source_high = 14,
    reverse_requested = 15,
};
using extended_status_word = flags<extended_status_bit>;

/// IL1R and IL1I, the logic inputs; an ATV12 has the first four.
enum class input_bit : std::uint8_t { li1 = 0, li2 = 1, li3 = 2, li4 = 3, li5 = 4, li6 = 5 };
using input_image = flags<input_bit>;

/// CIC.
enum class configuration_fault_bit : std::uint8_t {
    rating_changed = 0,
    card_removed = 2, ///< ATV320 only
    eeprom_inconsistent = 3,
    card_changed = 4, ///< ATV320 only
};
using configuration_faults = flags<configuration_fault_bit>;

/// What each device of the family inherits, unless it says otherwise.
/// Internal.
struct family_device {
    static constexpr function_set functions{function_code::read_holding_registers, function_code::write_single_register,
                                            function_code::write_multiple_registers,
                                            function_code::read_write_multiple_registers,
                                            function_code::encapsulated_interface};
    static constexpr device_limits limits{63, 61, 4, 4};
    static constexpr unit_range units{1, 247};
    static constexpr std::array<address_range, 0> readable{}; ///< nothing is known beyond the table
    static constexpr character_format formats[]{character_format::odd_8_1, character_format::even_8_1,
                                                character_format::none_8_1, character_format::none_8_2};
    static constexpr std::uint32_t rates[]{4'800, 9'600, 19'200, 38'400};
    static constexpr link_timeout silence{milliseconds(10'000), milliseconds(30'000)};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
