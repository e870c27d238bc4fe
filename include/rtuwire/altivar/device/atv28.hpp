// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV28: its 109 registers and what they hold, from bulletin VVDED399092US (2000). Bit 15 of CMD selects the DRIVECOM
// commands (0) or the direct ones (1), and bit 4 of ETA is inverted: 1 means that the mains is absent. Enumerations have
// the mnemonics of the display; numbers that the scan of the bulletin lost are missing here too: such a word has no name.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/read_plan.hpp>

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

namespace altivar::atv28 {

// clang-format off
inline constexpr reg<count16> cod{"COD", 2, is::cfg, 0, 9999, {}, "Access code"};
inline constexpr reg<tenth_milliamperes> crl{"CRL", 4, is::cfg, 0, 200, {}, "Minimum reference of input AI2"};
inline constexpr reg<tenth_milliamperes> crh{"CRH", 5, is::cfg, 40, 200, {}, "Maximum reference of input AI2"};
inline constexpr reg<control_mode> tcc{"TCC", 6, is::cfg, 0, 1, {}, "2-wire/3-wire control via terminals"};
inline constexpr reg<count16> add{"ADD", 10, is::cfg, 1, 31, {}, "Drive address on the serial link"};
inline constexpr reg<serial_rate> bdr{"BDR", 16, is::cfg, {}, {}, {}, "Serial link speed"};
inline constexpr reg<base_frequency> bfr{"BFR", 40, is::cfg, {}, {}, {}, "Motor configuration (base frequency)"};
inline constexpr reg<count16> sds{"SDS", 41, is::rw, 1, 200, {}, "Scale factor of SPd (speed display)"};
inline constexpr reg<analog_output_range> aot{"AOT", 42, is::cfg, {}, {}, {}, "Analog output configuration"};
inline constexpr reg<hectohertz> sfr{"SFR", 51, is::rw, 20, 150, {}, "Switching frequency"};
inline constexpr reg<decihertz> tfr{"TFR", 52, is::cfg, 400, 4000, {}, "Maximum frequency"};
inline constexpr reg<decihertz> frs{"FRS", 53, is::cfg, 400, 4000, {}, "Nominal motor frequency"};
inline constexpr reg<volts> uns{"UNS", 55, is::cfg, 200, 500, {}, "Nominal motor voltage", is::documented, {}, {241, 379}};
inline constexpr reg<autotune> tun{"TUN", 59, is::cfg, {}, {}, {}, "Autotune"};
inline constexpr reg<no_yes> nrd{"NRD", 60, is::cfg, {}, {}, {}, "Motor noise reduction"};
inline constexpr reg<motor_ratio> uft{"UFT", 61, is::cfg, {}, {}, {}, "Voltage/frequency ratio"};
inline constexpr reg<no_yes> bra{"BRA", 64, is::cfg, {}, {}, {}, "Deceleration ramp adaptation"};
inline constexpr reg<decihertz> frt{"FRT", 65, is::rw, 0, "HSP", {}, "Ramp switching threshold"};
inline constexpr reg<input_1_function> li1{"LI1", 100, is::ro, {}, {}, {}, "Assignment of logic input LI1"};
inline constexpr reg<input_function> li2{"LI2", 101, is::ro, {}, {}, {}, "Assignment of logic input LI2", is::inferred};
inline constexpr reg<free_input_function> li3{"LI3", 102, is::cfg, {}, {}, {}, "Assignment of logic input LI3", is::inferred};
inline constexpr reg<free_input_function> li4{"LI4", 103, is::cfg, {}, {}, {}, "Assignment of logic input LI4", is::inferred};
inline constexpr reg<analog_input_function> ai2{"AI2", 107, is::cfg, {}, {}, {}, "Assignment of analog input AIC/AI2", is::doubtful};
inline constexpr reg<relay_function> r2{"R2", 110, is::cfg, {}, {}, {}, "Assignment of relay R2", is::inferred};
inline constexpr reg<analog_output_function> ao{"AO", 112, is::cfg, {}, {}, {}, "Assignment of analog output AO", is::doubtful};
inline constexpr reg<restart_mode> atr{"ATR", 150, is::rw, {}, {}, {}, "Automatic restart"};
inline constexpr reg<no_yes> opl{"OPL", 151, is::rw, {}, {}, {}, "Motor phase loss detection"};
inline constexpr reg<no_yes> ipl{"IPL", 152, is::rw, {}, {}, {}, "Line supply phase loss detection"};
inline constexpr reg<no_yes> flr{"FLR", 155, is::rw, {}, {}, {}, "Catch a spinning load"};
inline constexpr reg<no_yes> stp{"STP", 156, is::rw, {}, {}, {}, "Controlled stop on line supply loss"};
inline constexpr reg<no_yes> drn{"DRN", 190, is::rw, {}, {}, {}, "Downgraded operation below 40 % line voltage"};
inline constexpr reg<decihertz> hsp{"HSP", 250, is::rw, "LSP", "TFR", {}, "High speed"};
inline constexpr reg<decihertz> lsp{"LSP", 251, is::rw, 0, "HSP", {}, "Low speed"};
inline constexpr reg<deciseconds> acc{"ACC", 252, is::rw, 0, 36000, {}, "Acceleration ramp"};
inline constexpr reg<deciseconds> dec{"DEC", 253, is::rw, 0, 36000, {}, "Deceleration ramp"};
inline constexpr reg<percent> ufr{"UFR", 254, is::rw, 0, 100, {}, "IR compensation"};
inline constexpr reg<percent> flg{"FLG", 255, is::rw, 0, 100, {}, "Frequency loop gain"};
inline constexpr reg<deciamperes> ith{"ITH", 258, is::rw, detail::share_of("INV", 1, 2), detail::share_of("INV", 23, 20), {},
    "Motor thermal protection current"};
inline constexpr reg<decihertz> slp{"SLP", 259, is::rw, 0, 50, {}, "Slip compensation"};
inline constexpr reg<deciseconds> ac2{"AC2", 260, is::rw, 0, 36000, {}, "Acceleration ramp 2"};
inline constexpr reg<deciseconds> de2{"DE2", 261, is::rw, 0, 36000, {}, "Deceleration ramp 2"};
inline constexpr reg<decihertz> jog{"JOG", 262, is::rw, 0, 100, {}, "Jog frequency"};
inline constexpr reg<decihertz> sp2{"SP2", 264, is::rw, "LSP", "HSP", {}, "Preset speed 2"};
inline constexpr reg<decihertz> sp3{"SP3", 265, is::rw, "LSP", "HSP", {}, "Preset speed 3"};
inline constexpr reg<decihertz> sp4{"SP4", 266, is::rw, "LSP", "HSP", {}, "Preset speed 4"};
inline constexpr reg<decihertz> sp5{"SP5", 267, is::rw, "LSP", "HSP", {}, "Preset speed 5"};
inline constexpr reg<decihertz> sp6{"SP6", 268, is::rw, "LSP", "HSP", {}, "Preset speed 6"};
inline constexpr reg<decihertz> sp7{"SP7", 269, is::rw, "LSP", "HSP", {}, "Preset speed 7"};
inline constexpr reg<deciamperes> idc{"IDC", 270, is::rw, detail::share_of("ITH", 1, 10), "INV", {}, "DC injection current"};
inline constexpr reg<deciseconds> tdc{"TDC", 271, is::rw, 0, 255, {}, "DC injection time"};
inline constexpr reg<deciseconds> tls{"TLS", 272, is::rw, 0, 255, {}, "Maximum time at low speed"};
inline constexpr reg<count16_hundredths> rpg{"RPG", 279, is::rw, 1, 10000, {}, "PI proportional gain"};
inline constexpr reg<centi_per_second> rig{"RIG", 280, is::rw, 1, 10000, {}, "PI integral gain"};
inline constexpr reg<count16_tenths> fbs{"FBS", 281, is::rw, 1, 1000, {}, "PI feedback scale factor"};
inline constexpr reg<deciamperes> ctd{"CTD", 282, is::rw, detail::share_of("INV", 1, 10), detail::share_of("INV", 3, 2), {},
    "Current threshold"};
inline constexpr reg<percent> ttd{"TTD", 283, is::rw, 1, 118, {}, "Thermal threshold"};
inline constexpr reg<decihertz> ftd{"FTD", 284, is::rw, 0, "HSP", {}, "Frequency threshold"};
inline constexpr reg<decihertz> jpf{"JPF", 286, is::rw, 0, "HSP", {}, "Skip frequency (+/- 1 Hz band)"};
inline constexpr reg<no_yes> pic{"PIC", 287, is::rw, {}, {}, {}, "Reversal of PI correction direction"};
inline constexpr reg<direction> rot{"ROT", 340, is::ro, {}, {}, {}, "Operating direction, local control option"};
inline constexpr reg<command_word> cmd{"CMD", 400, is::rw, {}, {}, 0x00F0, "DRIVECOM control word", is::documented, {}, {0x00F0, 0x00F0}};
inline constexpr reg<signed_decihertz> lfr{"LFR", 401, is::rw, "LSP", "HSP", {}, "Frequency reference (line mode)"};
inline constexpr reg<extended_command_word> cmi{"CMI", 402, is::rw, {}, {}, {}, "Internal control register"};
inline constexpr reg<tenth_percent> rpi{"RPI", 440, is::rw, 0, 1000, {}, "PI regulator internal setpoint"};
inline constexpr reg<decihertz> frh{"FRH", 450, is::ro, {}, {}, {}, "Frequency reference (absolute)"};
inline constexpr reg<decihertz> rfr{"RFR", 451, is::ro, {}, {}, {}, "Output frequency (absolute)"};
inline constexpr reg<rpm> spd{"SPD", 452, is::ro, {}, {}, {}, "Motor speed estimate (absolute)"};
inline constexpr reg<deciamperes> lcr{"LCR", 453, is::ro, {}, {}, {}, "Motor current"};
inline constexpr reg<decivolts> uln{"ULN", 454, is::ro, {}, {}, {}, "Line voltage (from DC bus)"};
inline constexpr reg<percent> thr{"THR", 455, is::ro, {}, {}, {}, "Motor thermal state"};
inline constexpr reg<percent> thd{"THD", 456, is::ro, {}, {}, {}, "Drive thermal state"};
inline constexpr reg<fault_code> lft{"LFT", 457, is::ro, {}, {}, {}, "Last fault", is::inferred};
inline constexpr reg<status_word> eta{"ETA", 458, is::ro, {}, {}, {}, "DRIVECOM status register"};
inline constexpr reg<extended_status_word> eti{"ETI", 459, is::ro, {}, {}, {}, "Internal status register 1"};
inline constexpr reg<extended_status_word_2> eti2{"ETI2", 460, is::ro, {}, {}, {}, "Internal status register 2"};
inline constexpr reg<reserved_word> eti3{"ETI3", 461, is::ro, {}, {}, {}, "Internal status register 3"};
inline constexpr reg<fault_code> dp1{"DP1", 462, is::ro, {}, {}, {}, "Past fault 1 (most recent)", is::inferred};
inline constexpr reg<fault_code> dp2{"DP2", 464, is::ro, {}, {}, {}, "Past fault 2", is::inferred};
inline constexpr reg<fault_code> dp3{"DP3", 466, is::ro, {}, {}, {}, "Past fault 3", is::inferred};
inline constexpr reg<fault_code> dp4{"DP4", 468, is::ro, {}, {}, {}, "Past fault 4", is::inferred};
inline constexpr reg<logic_image> iolr{"IOLR", 478, is::rw, {}, {}, {}, "Image of logic I/O", is::inferred};
inline constexpr reg<millivolts> ai1r{"AI1R", 479, is::ro, {}, {}, {}, "Image of analog input AI1", is::doubtful};
inline constexpr reg<microamperes> ai2r{"AI2R", 480, is::ro, {}, {}, {}, "Image of analog input AIC/AI2"};
inline constexpr reg<microamperes> aor{"AOR", 482, is::rw, 0, 20000, {}, "Image of analog output AO"};
inline constexpr reg<active_faults_1> df1{"DF1", 483, is::ro, {}, {}, {}, "Active faults register 1"};
inline constexpr reg<active_faults_2> df2{"DF2", 484, is::ro, {}, {}, {}, "Active faults register 2"};
inline constexpr reg<percent> olo{"OLO", 487, is::ro, {}, {}, {}, "Motor torque", is::inferred};
inline constexpr reg<percent> opr{"OPR", 491, is::ro, {}, {}, {}, "Output power", is::inferred};
inline constexpr reg<hours> tim{"TIM", 530, is::ro, {}, {}, {}, "Cumulative operating time"};
inline constexpr reg<firmware_word> cpu{"CPU", 551, is::ro, {}, {}, {}, "Drive firmware version"};
inline constexpr reg<rating> ncv{"NCV", 552, is::ro, {}, {}, {}, "Drive power rating", is::inferred};
inline constexpr reg<mains> vcal{"VCAL", 553, is::ro, {}, {}, {}, "Drive voltage rating"};
inline constexpr reg<deciamperes> inv{"INV", 555, is::ro, {}, {}, {}, "Drive nominal current"};
inline constexpr reg<profile_fault> errd{"ERRD", 600, is::ro, {}, {}, {}, "DRIVECOM error code (603Fh)"};
inline constexpr reg<command_word> cmdd{"CMDD", 601, is::rw, {}, {}, 0x00F0,
    "Control word (same as W400)", is::documented, {}, {0x00F0, 0x00F0}};
inline constexpr reg<status_word> etad{"ETAD", 602, is::ro, {}, {}, {}, "Status word (same as W458)"};
inline constexpr reg<signed_rpm> lfrd{"LFRD", 603, is::rw, -32768, 32767, {}, "Speed reference (not peak limited)"};
inline constexpr reg<signed_rpm> frhd{"FRHD", 604, is::ro, -32768, 32767, {}, "Ramp output, signed"};
inline constexpr reg<rpm> rfrd{"RFRD", 605, is::ro, 0, 65535, {}, "Motor speed", is::inferred};
inline constexpr reg<rpm> smil{"SMIL", 606, is::rw, 0, detail::product_of("HSP", "SDS", 10), {}, "Low speed in rpm (LSP)"};
inline constexpr reg<count16> smih{"SMIH", 607, is::ro, 0, 0, 0, "Reserved (0)"};
inline constexpr reg<rpm> smal{"SMAL", 608, is::rw, detail::product_of("LSP", "SDS", 10), detail::product_of("TFR", "SDS", 10), {},
    "High speed in rpm (HSP)"};
inline constexpr reg<count16> smah{"SMAH", 609, is::ro, 0, 0, 0, "Reserved (0)"};
inline constexpr reg<rpm> spal{"SPAL", 610, is::rw, 1, 65535, {}, "Speed for acceleration ramp"};
inline constexpr reg<count16> spah{"SPAH", 611, is::ro, 0, 0, 0, "Reserved (0)"};
inline constexpr reg<seconds> spat{"SPAT", 612, is::rw, 0, 65535, {}, "Time for acceleration ramp (0 to SPAL)"};
inline constexpr reg<rpm> spdl{"SPDL", 613, is::rw, 1, 65535, {}, "Speed for deceleration ramp"};
inline constexpr reg<count16> spdh{"SPDH", 614, is::ro, 0, 0, 0, "Reserved (0)"};
inline constexpr reg<seconds> spdt{"SPDT", 615, is::rw, 0, 65535, {}, "Time for deceleration ramp (SPDL to 0)"};
// clang-format on

/// An ATV28. Its time-out is fixed, unless CMI bit 14 switches it off.
struct device {
    static constexpr literal name{"atv28"};
    static constexpr literal reference{"ATV28HU29N4"}; ///< one of the family
    static constexpr function_set functions{function_code::read_holding_registers, function_code::write_single_register,
                                            function_code::write_multiple_registers};
    static constexpr device_limits limits{7, 7, 0, 0};
    static constexpr unit_range units{1, 31};
    static constexpr std::array<address_range, 0> readable{}; ///< nothing is known beyond the table
    static constexpr character_format formats[]{character_format::none_8_1};
    static constexpr std::uint32_t rates[]{9'600, 19'200};
    static constexpr link_timeout silence{milliseconds(7'000), milliseconds(7'000), false};
    static constexpr auto const& speed_reference = lfrd;
    static constexpr auto const& frequency_reference = lfr;
    static constexpr drive_layout layout{.cmd = cmd.address,
                                         .eta = eta.address,
                                         .lft = lft.address,
                                         .cmi = cmi.address,
                                         .eti = eti.address,
                                         .rfr = rfr.address,
                                         .lsp = lsp.address,
                                         .hsp = hsp.address,
                                         .sds = sds.address,
                                         .state_machine = {.quick_stop_waits = true},
                                         .mains_bit_is_inverted = true,
                                         .refuses_commands_in_local = true,
                                         .shows_forced_local_only = true,
                                         .falls_back_when_configured = false,
                                         .shows_eeprom_access = false,
                                         .halt = 0,
                                         .dc_injection = 0xA00A,
                                         .direct_control = 0x8000,
                                         .longest_silence = milliseconds(7'000),
                                         .fails_when_cut_short = true,
                                         .eeprom_time = milliseconds(2'100),
                                         .cmi_orders = 0x0007,
                                         .other_cmd = later_control_word,
                                         .safeguards = {.nto = 0x4000,
                                                        .fixed_timeout = milliseconds(7'000),
                                                        .atr = atr.address,
                                                        .inputs = iolr.address,
                                                        .tcc = tcc.address,
                                                        .is_local_at_power_up = true}};
    static constexpr scanner_registers scanner{}; ///< it has none
    /// The seven words up to ETA, which are as many as it takes, by function 03; then CMD and LFR by function 16.
    static constexpr cycle_registers cycle{
        .by = function_code::write_multiple_registers,
        .reads = {spd.address, lcr.address, uln.address, thr.address, thd.address, lft.address, eta.address},
        .writes = {cmd.address, lfr.address},
        .speed = spd.address};
    static constexpr simulated_behaviour behaviour{.eeprom_work = milliseconds(2'000),
                                                   .is_silent_while_saving = true,
                                                   .clears_eeprom_orders = true,
                                                   .forgets_orders_on_loss = true,
                                                   .sets_line_at_power_up = true,
                                                   .extended_status_bits = 0xF9FA,
                                                   .input_bits = 0x000F};
    /// The registers that identify it, without function 43.
    struct nameplate {
        template <typename Device> using plan = read_plan<Device, cpu, ncv, vcal, inv>;
    };
    using registers =
        table<cod, crl, crh, tcc, add, bdr, bfr, sds, aot, sfr, tfr, frs, uns, tun, nrd, uft, bra, frt, li1, li2, li3,
              li4, ai2, r2, ao, atr, opl, ipl, flr, stp, drn, hsp, lsp, acc, dec, ufr, flg, ith, slp, ac2, de2, jog,
              sp2, sp3, sp4, sp5, sp6, sp7, idc, tdc, tls, rpg, rig, fbs, ctd, ttd, ftd, jpf, pic, rot, cmd, lfr, cmi,
              rpi, frh, rfr, spd, lcr, uln, thr, thd, lft, eta, eti, eti2, eti3, dp1, dp2, dp3, dp4, iolr, ai1r, ai2r,
              aor, df1, df2, olo, opr, tim, cpu, ncv, vcal, inv, errd, cmdd, etad, lfrd, frhd, rfrd, smil, smih, smal,
              smah, spal, spah, spat, spdl, spdh, spdt>;
};

} // namespace altivar::atv28

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
