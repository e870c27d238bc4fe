// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the registers of the ATV28 hold. Its words bit by bit: bit 15 of CMD selects the DRIVECOM commands (0) or the
// direct ones (1), and bit 4 of ETA is inverted: 1 means that the mains is absent. Then the values of its enumerations,
// with the mnemonics of the display; numbers that the scan of its bulletin lost are not here: such a word has no name.
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

// clang-format off
/// How the terminals command.
enum class control_mode : std::uint16_t { two_wire = 0, three_wire = 1, option = 2 };

/// The line's bit rate.
enum class serial_rate : std::uint16_t { baud_9600 = 7, baud_19200 = 8 };

/// The motor's base frequency.
enum class base_frequency : std::uint16_t { at_50_hertz = 0, at_60_hertz = 1 };

/// The range of the analog output.
enum class analog_output_range : std::uint16_t { from_0_milliamperes = 0, from_4_milliamperes = 1 };

/// The state of the auto-tuning.
enum class autotune : std::uint16_t { no = 0, done = 1, yes = 2 };

/// A switch.
enum class no_yes : std::uint16_t { no = 0, yes = 1 };

/// The voltage/frequency law.
enum class motor_ratio : std::uint16_t { l = 0, p = 1, n = 2, nld = 3 };

/// What logic input 1 does.
enum class input_1_function : std::uint16_t { no = 0, stop = 1, forward = 2 };

/// What a logic input does.
enum class input_function : std::uint16_t {
    no = 0, forward = 2, rrs = 3, rp2 = 4, jog = 5, ps2 = 8, ps4 = 9, ps8 = 10, rfc = 11, nst = 12,
    dci = 13, fst = 14, flo = 17, rst = 18,
};

/// What one of the inputs 3 and 4 does: the same, but never forward.
enum class free_input_function : std::uint16_t {
    no = 0, rrs = 3, rp2 = 4, jog = 5, ps2 = 8, ps4 = 9, ps8 = 10, rfc = 11, nst = 12, dci = 13,
    fst = 14, flo = 17, rst = 18,
};

/// What the analog input does; only one number survived.
enum class analog_input_function : std::uint16_t { no = 0 };

/// What relay R2 shows.
enum class relay_function : std::uint16_t { no = 0, fta = 4, cta = 6, sra = 7, tsa = 8 };

/// What the analog output shows; some numbers are lost.
enum class analog_output_function : std::uint16_t { no = 0, ocr = 1, rfr = 2 };

/// When the drive restarts by itself.
enum class restart_mode : std::uint16_t { no = 0, yes = 1, usf = 2 };

/// The direction in local control.
enum class direction : std::uint16_t { forward = 0, rrs = 1 };

/// Why the drive tripped.
enum class fault_code : std::uint16_t {
    nof = 0, inf = 1, eef = 2, slf = 5, ocf = 9, ohf = 16, olf = 17, obf = 18, osf = 19, opf = 20,
    phf = 21, scf = 23, tnf = 25,
};

/// The drive's size.
enum class rating : std::uint16_t {
    u09 = 4, u18 = 5, u29 = 6, u41 = 7, u54 = 8, u72 = 10, u90 = 11, d12 = 12, d16 = 13, d23 = 14,
};

/// The drive's supply.
enum class mains : std::uint16_t { single_phase_230 = 1, three_phase_400 = 2, three_phase_230 = 3 };

/// The fault in the drive profile's numbers.
enum class profile_fault : std::uint16_t {
    nof = 0x0000, olf = 0x1000, ocf = 0x2310, osf = 0x3110, usf = 0x3120, phf = 0x3130,
    obf_opf = 0x3310, ohf = 0x4210, eef = 0x5520, inf = 0x6100, slf = 0x7510,
};
// clang-format on

} // namespace altivar::atv28

// clang-format off
template <> inline constexpr auto enumerators<altivar::atv28::control_mode> = detail::name_list({
    {0, "2C"}, {1, "3C"}, {2, "OPt"},
});
template <> inline constexpr auto enumerators<altivar::atv28::serial_rate> = detail::name_list({
    {7, "9600"}, {8, "19200"},
});
template <> inline constexpr auto enumerators<altivar::atv28::base_frequency> = detail::name_list({
    {0, "50Hz"}, {1, "60Hz"},
});
template <> inline constexpr auto enumerators<altivar::atv28::analog_output_range> = detail::name_list({
    {0, "0-20mA"}, {1, "4-20mA"},
});
template <> inline constexpr auto enumerators<altivar::atv28::autotune> = detail::name_list({
    {0, "nO"}, {1, "donE"}, {2, "YES"},
});
template <> inline constexpr auto enumerators<altivar::atv28::no_yes> = detail::name_list({{0, "nO"}, {1, "YES"}});
template <> inline constexpr auto enumerators<altivar::atv28::motor_ratio> = detail::name_list({
    {0, "L"}, {1, "P"}, {2, "n"}, {3, "nLd"},
});
template <> inline constexpr auto enumerators<altivar::atv28::input_1_function> = detail::name_list({
    {0, "nO"}, {1, "Stop"}, {2, "For"},
});
template <> inline constexpr auto enumerators<altivar::atv28::input_function> = detail::name_list({
    {0, "nO"}, {2, "For"}, {3, "rrS"}, {4, "rP2"}, {5, "JOG"}, {8, "PS2"}, {9, "PS4"}, {10, "PS8"},
    {11, "rFC"}, {12, "nSt"}, {13, "dCI"}, {14, "FSt"}, {17, "FLO"}, {18, "rSt"},
});
template <> inline constexpr auto enumerators<altivar::atv28::free_input_function> = detail::name_list({
    {0, "nO"}, {3, "rrS"}, {4, "rP2"}, {5, "JOG"}, {8, "PS2"}, {9, "PS4"}, {10, "PS8"},
    {11, "rFC"}, {12, "nSt"}, {13, "dCI"}, {14, "FSt"}, {17, "FLO"}, {18, "rSt"},
});
template <> inline constexpr auto enumerators<altivar::atv28::analog_input_function> = detail::name_list({{0, "nO"}});
template <> inline constexpr auto enumerators<altivar::atv28::relay_function> = detail::name_list({
    {0, "nO"}, {4, "FtA"}, {6, "CtA"}, {7, "SrA"}, {8, "tSA"},
});
template <> inline constexpr auto enumerators<altivar::atv28::analog_output_function> = detail::name_list({
    {0, "nO"}, {1, "OCr"}, {2, "rFr"},
});
template <> inline constexpr auto enumerators<altivar::atv28::restart_mode> = detail::name_list({
    {0, "nO"}, {1, "YES"}, {2, "USF"},
});
template <> inline constexpr auto enumerators<altivar::atv28::direction> = detail::name_list({
    {0, "FOr"}, {1, "rrS"},
});
template <> inline constexpr auto enumerators<altivar::atv28::fault_code> = detail::name_list({
    {0, "nOF"}, {1, "InF"}, {2, "EEF"}, {5, "SLF"}, {9, "OCF"}, {16, "OHF"}, {17, "OLF"},
    {18, "ObF"}, {19, "OSF"}, {20, "OPF"}, {21, "PHF"}, {23, "SCF"}, {25, "tnF"},
});
template <> inline constexpr auto meanings<altivar::atv28::fault_code> = detail::name_list({
    {0, "no fault"}, {1, "internal fault"}, {2, "memory failed"}, {5, "serial link interrupted"}, {9, "overcurrent"},
    {16, "drive overheated"}, {17, "motor overloaded"}, {18, "DC bus overvoltage"},
    {19, "mains overvoltage"}, {20, "motor phase lost"}, {21, "mains phase lost"}, {23, "motor short circuit"},
    {25, "tuning failed"},
});
template <> inline constexpr auto enumerators<altivar::atv28::rating> = detail::name_list({
    {4, "U09"}, {5, "U18"}, {6, "U29"}, {7, "U41"}, {8, "U54"}, {10, "U72"}, {11, "U90"},
    {12, "D12"}, {13, "D16"}, {14, "D23"},
});
template <> inline constexpr auto enumerators<altivar::atv28::mains> = detail::name_list({
    {1, "single-phase-230"}, {2, "three-phase-400"}, {3, "three-phase-230"},
});
template <> inline constexpr auto enumerators<altivar::atv28::profile_fault> = detail::name_list({
    {0x0000, "nOF"}, {0x1000, "OLF"}, {0x2310, "OCF"}, {0x3110, "OSF"}, {0x3120, "USF"},
    {0x3130, "PHF"}, {0x3310, "ObF_OPF"}, {0x4210, "OHF"}, {0x5520, "EEF"}, {0x6100, "InF"},
    {0x7510, "SLF"},
});
template <> inline constexpr auto meanings<altivar::atv28::profile_fault> = detail::name_list({
    {0x0000, "no fault"}, {0x1000, "motor overloaded"}, {0x2310, "overcurrent"}, {0x3110, "mains overvoltage"},
    {0x3120, "mains undervoltage"}, {0x3130, "mains phase lost"}, {0x3310, "DC bus overvoltage, or motor phase lost"},
    {0x4210, "drive overheated"}, {0x5520, "memory failed"}, {0x6100, "internal fault"},
    {0x7510, "serial link interrupted"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
