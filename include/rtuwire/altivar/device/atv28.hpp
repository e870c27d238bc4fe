// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV28: its 109 registers, from bulletin VVDED399092US (2000). The numbers of some choices were lost in
// its scan; they are missing here too.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/altivar/device/atv28_values.hpp>
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
