// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV28: its 109 registers, from bulletin VVDED399092US (2000). The numbers of some choices were lost in
// its scan; they are missing here too.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/altivar/device/atv28_values.hpp>
#include <rtuwire/altivar/device/atv28_words.hpp>
#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/read_plan.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv28 {

// clang-format off
inline constexpr reg<count16> cod{.code = "COD", .address = 2, .mode = access::configuration, .min = {0}, .max = {9999},
    .name = "Access code"};
inline constexpr reg<tenth_milliamperes> crl{.code = "CRL", .address = 4, .mode = access::configuration, .min = {0}, .max = {200},
    .name = "Minimum reference of input AI2"};
inline constexpr reg<tenth_milliamperes> crh{.code = "CRH", .address = 5, .mode = access::configuration, .min = {40}, .max = {200},
    .name = "Maximum reference of input AI2"};
inline constexpr reg<control_mode> tcc{.code = "TCC", .address = 6, .mode = access::configuration, .min = {0}, .max = {1},
    .name = "2-wire/3-wire control via terminals"};
inline constexpr reg<count16> add{.code = "ADD", .address = 10, .mode = access::configuration, .min = {1}, .max = {31},
    .name = "Drive address on the serial link"};
inline constexpr reg<serial_rate> bdr{.code = "BDR", .address = 16, .mode = access::configuration,
    .name = "Serial link speed"};
inline constexpr reg<base_frequency> bfr{.code = "BFR", .address = 40, .mode = access::configuration,
    .name = "Motor configuration (base frequency)"};
inline constexpr reg<count16> sds{.code = "SDS", .address = 41, .min = {1}, .max = {200},
    .name = "Scale factor of SPd (speed display)"};
inline constexpr reg<analog_output_range> aot{.code = "AOT", .address = 42, .mode = access::configuration,
    .name = "Analog output configuration"};
inline constexpr reg<hectohertz> sfr{.code = "SFR", .address = 51, .min = {20}, .max = {150},
    .name = "Switching frequency"};
inline constexpr reg<decihertz> tfr{.code = "TFR", .address = 52, .mode = access::configuration, .min = {400}, .max = {4000},
    .name = "Maximum frequency"};
inline constexpr reg<decihertz> frs{.code = "FRS", .address = 53, .mode = access::configuration, .min = {400}, .max = {4000},
    .name = "Nominal motor frequency"};
inline constexpr reg<volts> uns{.code = "UNS", .address = 55, .mode = access::configuration, .min = {200}, .max = {500},
    .name = "Nominal motor voltage", .gap = {241, 379}};
inline constexpr reg<autotune> tun{.code = "TUN", .address = 59, .mode = access::configuration, .name = "Autotune"};
inline constexpr reg<no_yes> nrd{.code = "NRD", .address = 60, .mode = access::configuration,
    .name = "Motor noise reduction"};
inline constexpr reg<motor_ratio> uft{.code = "UFT", .address = 61, .mode = access::configuration,
    .name = "Voltage/frequency ratio"};
inline constexpr reg<no_yes> bra{.code = "BRA", .address = 64, .mode = access::configuration,
    .name = "Deceleration ramp adaptation"};
inline constexpr reg<decihertz> frt{.code = "FRT", .address = 65, .min = {0}, .max = "HSP",
    .name = "Ramp switching threshold"};
inline constexpr reg<input_1_function> li1{.code = "LI1", .address = 100, .mode = access::read_only,
    .name = "Assignment of logic input LI1"};
inline constexpr reg<input_function> li2{.code = "LI2", .address = 101, .mode = access::read_only,
    .name = "Assignment of logic input LI2", .source = provenance::inferred};
inline constexpr reg<free_input_function> li3{.code = "LI3", .address = 102, .mode = access::configuration,
    .name = "Assignment of logic input LI3", .source = provenance::inferred};
inline constexpr reg<free_input_function> li4{.code = "LI4", .address = 103, .mode = access::configuration,
    .name = "Assignment of logic input LI4", .source = provenance::inferred};
inline constexpr reg<analog_input_function> ai2{.code = "AI2", .address = 107, .mode = access::configuration,
    .name = "Assignment of analog input AIC/AI2", .source = provenance::doubtful};
inline constexpr reg<relay_function> r2{.code = "R2", .address = 110, .mode = access::configuration,
    .name = "Assignment of relay R2", .source = provenance::inferred};
inline constexpr reg<analog_output_function> ao{.code = "AO", .address = 112, .mode = access::configuration,
    .name = "Assignment of analog output AO", .source = provenance::doubtful};
inline constexpr reg<restart_mode> atr{.code = "ATR", .address = 150, .name = "Automatic restart"};
inline constexpr reg<no_yes> opl{.code = "OPL", .address = 151, .name = "Motor phase loss detection"};
inline constexpr reg<no_yes> ipl{.code = "IPL", .address = 152, .name = "Line supply phase loss detection"};
inline constexpr reg<no_yes> flr{.code = "FLR", .address = 155, .name = "Catch a spinning load"};
inline constexpr reg<no_yes> stp{.code = "STP", .address = 156, .name = "Controlled stop on line supply loss"};
inline constexpr reg<no_yes> drn{.code = "DRN", .address = 190,
    .name = "Downgraded operation below 40 % line voltage"};
inline constexpr reg<decihertz> hsp{.code = "HSP", .address = 250, .min = "LSP", .max = "TFR", .name = "High speed"};
inline constexpr reg<decihertz> lsp{.code = "LSP", .address = 251, .min = {0}, .max = "HSP", .name = "Low speed"};
inline constexpr reg<deciseconds> acc{.code = "ACC", .address = 252, .min = {0}, .max = {36000},
    .name = "Acceleration ramp"};
inline constexpr reg<deciseconds> dec{.code = "DEC", .address = 253, .min = {0}, .max = {36000},
    .name = "Deceleration ramp"};
inline constexpr reg<percent> ufr{.code = "UFR", .address = 254, .min = {0}, .max = {100}, .name = "IR compensation"};
inline constexpr reg<percent> flg{.code = "FLG", .address = 255, .min = {0}, .max = {100},
    .name = "Frequency loop gain"};
inline constexpr reg<deciamperes> ith{.code = "ITH", .address = 258, .min = detail::share_of("INV", 1, 2), .max = detail::share_of("INV", 23, 20),
    .name = "Motor thermal protection current"};
inline constexpr reg<decihertz> slp{.code = "SLP", .address = 259, .min = {0}, .max = {50},
    .name = "Slip compensation"};
inline constexpr reg<deciseconds> ac2{.code = "AC2", .address = 260, .min = {0}, .max = {36000},
    .name = "Acceleration ramp 2"};
inline constexpr reg<deciseconds> de2{.code = "DE2", .address = 261, .min = {0}, .max = {36000},
    .name = "Deceleration ramp 2"};
inline constexpr reg<decihertz> jog{.code = "JOG", .address = 262, .min = {0}, .max = {100}, .name = "Jog frequency"};
inline constexpr reg<decihertz> sp2{.code = "SP2", .address = 264, .min = "LSP", .max = "HSP",
    .name = "Preset speed 2"};
inline constexpr reg<decihertz> sp3{.code = "SP3", .address = 265, .min = "LSP", .max = "HSP",
    .name = "Preset speed 3"};
inline constexpr reg<decihertz> sp4{.code = "SP4", .address = 266, .min = "LSP", .max = "HSP",
    .name = "Preset speed 4"};
inline constexpr reg<decihertz> sp5{.code = "SP5", .address = 267, .min = "LSP", .max = "HSP",
    .name = "Preset speed 5"};
inline constexpr reg<decihertz> sp6{.code = "SP6", .address = 268, .min = "LSP", .max = "HSP",
    .name = "Preset speed 6"};
inline constexpr reg<decihertz> sp7{.code = "SP7", .address = 269, .min = "LSP", .max = "HSP",
    .name = "Preset speed 7"};
inline constexpr reg<deciamperes> idc{.code = "IDC", .address = 270, .min = detail::share_of("ITH", 1, 10), .max = "INV",
    .name = "DC injection current"};
inline constexpr reg<deciseconds> tdc{.code = "TDC", .address = 271, .min = {0}, .max = {255},
    .name = "DC injection time"};
inline constexpr reg<deciseconds> tls{.code = "TLS", .address = 272, .min = {0}, .max = {255},
    .name = "Maximum time at low speed"};
inline constexpr reg<count16_hundredths> rpg{.code = "RPG", .address = 279, .min = {1}, .max = {10000},
    .name = "PI proportional gain"};
inline constexpr reg<centi_per_second> rig{.code = "RIG", .address = 280, .min = {1}, .max = {10000},
    .name = "PI integral gain"};
inline constexpr reg<count16_tenths> fbs{.code = "FBS", .address = 281, .min = {1}, .max = {1000},
    .name = "PI feedback scale factor"};
inline constexpr reg<deciamperes> ctd{.code = "CTD", .address = 282, .min = detail::share_of("INV", 1, 10), .max = detail::share_of("INV", 3, 2),
    .name = "Current threshold"};
inline constexpr reg<percent> ttd{.code = "TTD", .address = 283, .min = {1}, .max = {118},
    .name = "Thermal threshold"};
inline constexpr reg<decihertz> ftd{.code = "FTD", .address = 284, .min = {0}, .max = "HSP",
    .name = "Frequency threshold"};
inline constexpr reg<decihertz> jpf{.code = "JPF", .address = 286, .min = {0}, .max = "HSP",
    .name = "Skip frequency (+/- 1 Hz band)"};
inline constexpr reg<no_yes> pic{.code = "PIC", .address = 287, .name = "Reversal of PI correction direction"};
inline constexpr reg<direction> rot{.code = "ROT", .address = 340, .mode = access::read_only,
    .name = "Operating direction, local control option"};
inline constexpr reg<command_word> cmd{.code = "CMD", .address = 400, .factory = 0x00F0, .name = "DRIVECOM control word",
    .gap = {0x00F0, 0x00F0}};
inline constexpr reg<signed_decihertz> lfr{.code = "LFR", .address = 401, .min = "LSP", .max = "HSP",
    .name = "Frequency reference (line mode)"};
inline constexpr reg<extended_command_word> cmi{.code = "CMI", .address = 402, .name = "Internal control register"};
inline constexpr reg<tenth_percent> rpi{.code = "RPI", .address = 440, .min = {0}, .max = {1000},
    .name = "PI regulator internal setpoint"};
inline constexpr reg<decihertz> frh{.code = "FRH", .address = 450, .mode = access::read_only,
    .name = "Frequency reference (absolute)"};
inline constexpr reg<decihertz> rfr{.code = "RFR", .address = 451, .mode = access::read_only,
    .name = "Output frequency (absolute)"};
inline constexpr reg<rpm> spd{.code = "SPD", .address = 452, .mode = access::read_only,
    .name = "Motor speed estimate (absolute)"};
inline constexpr reg<deciamperes> lcr{.code = "LCR", .address = 453, .mode = access::read_only,
    .name = "Motor current"};
inline constexpr reg<decivolts> uln{.code = "ULN", .address = 454, .mode = access::read_only,
    .name = "Line voltage (from DC bus)"};
inline constexpr reg<percent> thr{.code = "THR", .address = 455, .mode = access::read_only,
    .name = "Motor thermal state"};
inline constexpr reg<percent> thd{.code = "THD", .address = 456, .mode = access::read_only,
    .name = "Drive thermal state"};
inline constexpr reg<fault_code> lft{.code = "LFT", .address = 457, .mode = access::read_only, .name = "Last fault",
    .source = provenance::inferred};
inline constexpr reg<status_word> eta{.code = "ETA", .address = 458, .mode = access::read_only,
    .name = "DRIVECOM status register"};
inline constexpr reg<extended_status_word> eti{.code = "ETI", .address = 459, .mode = access::read_only,
    .name = "Internal status register 1"};
inline constexpr reg<extended_status_word_2> eti2{.code = "ETI2", .address = 460, .mode = access::read_only,
    .name = "Internal status register 2"};
inline constexpr reg<reserved_word> eti3{.code = "ETI3", .address = 461, .mode = access::read_only,
    .name = "Internal status register 3"};
inline constexpr reg<fault_code> dp1{.code = "DP1", .address = 462, .mode = access::read_only,
    .name = "Past fault 1 (most recent)", .source = provenance::inferred};
inline constexpr reg<fault_code> dp2{.code = "DP2", .address = 464, .mode = access::read_only,
    .name = "Past fault 2", .source = provenance::inferred};
inline constexpr reg<fault_code> dp3{.code = "DP3", .address = 466, .mode = access::read_only,
    .name = "Past fault 3", .source = provenance::inferred};
inline constexpr reg<fault_code> dp4{.code = "DP4", .address = 468, .mode = access::read_only,
    .name = "Past fault 4", .source = provenance::inferred};
inline constexpr reg<logic_image> iolr{.code = "IOLR", .address = 478,
    .name = "Image of logic I/O", .source = provenance::inferred};
inline constexpr reg<millivolts> ai1r{.code = "AI1R", .address = 479, .mode = access::read_only,
    .name = "Image of analog input AI1", .source = provenance::doubtful};
inline constexpr reg<microamperes> ai2r{.code = "AI2R", .address = 480, .mode = access::read_only,
    .name = "Image of analog input AIC/AI2"};
inline constexpr reg<microamperes> aor{.code = "AOR", .address = 482, .min = {0}, .max = {20000},
    .name = "Image of analog output AO"};
inline constexpr reg<active_faults_1> df1{.code = "DF1", .address = 483, .mode = access::read_only,
    .name = "Active faults register 1"};
inline constexpr reg<active_faults_2> df2{.code = "DF2", .address = 484, .mode = access::read_only,
    .name = "Active faults register 2"};
inline constexpr reg<percent> olo{.code = "OLO", .address = 487, .mode = access::read_only,
    .name = "Motor torque", .source = provenance::inferred};
inline constexpr reg<percent> opr{.code = "OPR", .address = 491, .mode = access::read_only,
    .name = "Output power", .source = provenance::inferred};
inline constexpr reg<hours> tim{.code = "TIM", .address = 530, .mode = access::read_only,
    .name = "Cumulative operating time"};
inline constexpr reg<firmware_word> cpu{.code = "CPU", .address = 551, .mode = access::read_only,
    .name = "Drive firmware version"};
inline constexpr reg<rating> ncv{.code = "NCV", .address = 552, .mode = access::read_only,
    .name = "Drive power rating", .source = provenance::inferred};
inline constexpr reg<mains> vcal{.code = "VCAL", .address = 553, .mode = access::read_only,
    .name = "Drive voltage rating"};
inline constexpr reg<deciamperes> inv{.code = "INV", .address = 555, .mode = access::read_only,
    .name = "Drive nominal current"};
inline constexpr reg<profile_fault> errd{.code = "ERRD", .address = 600, .mode = access::read_only,
    .name = "DRIVECOM error code (603Fh)"};
inline constexpr reg<command_word> cmdd{.code = "CMDD", .address = 601, .factory = 0x00F0, .name = "Control word (same as W400)",
    .gap = {0x00F0, 0x00F0}};
inline constexpr reg<status_word> etad{.code = "ETAD", .address = 602, .mode = access::read_only,
    .name = "Status word (same as W458)"};
inline constexpr reg<signed_rpm> lfrd{.code = "LFRD", .address = 603, .min = {-32768}, .max = {32767},
    .name = "Speed reference (not peak limited)"};
inline constexpr reg<signed_rpm> frhd{.code = "FRHD", .address = 604, .mode = access::read_only, .min = {-32768}, .max = {32767},
    .name = "Ramp output, signed"};
inline constexpr reg<rpm> rfrd{.code = "RFRD", .address = 605, .mode = access::read_only, .min = {0}, .max = {65535},
    .name = "Motor speed", .source = provenance::inferred};
inline constexpr reg<rpm> smil{.code = "SMIL", .address = 606, .min = {0}, .max = detail::product_of("HSP", "SDS", 10),
    .name = "Low speed in rpm (LSP)"};
inline constexpr reg<count16> smih{.code = "SMIH", .address = 607, .mode = access::read_only, .min = {0}, .max = {0}, .factory = 0,
    .name = "Reserved (0)"};
inline constexpr reg<rpm> smal{.code = "SMAL", .address = 608, .min = detail::product_of("LSP", "SDS", 10), .max = detail::product_of("TFR", "SDS", 10),
    .name = "High speed in rpm (HSP)"};
inline constexpr reg<count16> smah{.code = "SMAH", .address = 609, .mode = access::read_only, .min = {0}, .max = {0}, .factory = 0,
    .name = "Reserved (0)"};
inline constexpr reg<rpm> spal{.code = "SPAL", .address = 610, .min = {1}, .max = {65535},
    .name = "Speed for acceleration ramp"};
inline constexpr reg<count16> spah{.code = "SPAH", .address = 611, .mode = access::read_only, .min = {0}, .max = {0}, .factory = 0,
    .name = "Reserved (0)"};
inline constexpr reg<seconds> spat{.code = "SPAT", .address = 612, .min = {0}, .max = {65535},
    .name = "Time for acceleration ramp (0 to SPAL)"};
inline constexpr reg<rpm> spdl{.code = "SPDL", .address = 613, .min = {1}, .max = {65535},
    .name = "Speed for deceleration ramp"};
inline constexpr reg<count16> spdh{.code = "SPDH", .address = 614, .mode = access::read_only, .min = {0}, .max = {0}, .factory = 0,
    .name = "Reserved (0)"};
inline constexpr reg<seconds> spdt{.code = "SPDT", .address = 615, .min = {0}, .max = {65535},
    .name = "Time for deceleration ramp (SPDL to 0)"};
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
