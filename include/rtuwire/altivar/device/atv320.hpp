// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: its registers, from manual NVE41308 (2016), which ends early, and public parameter files.
// Ramp times count in steps that INR sets.
#pragma once

#include <rtuwire/altivar/device/atv320_values.hpp>
#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/family.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320 {

// clang-format off
inline constexpr reg<rating> ncv{"NCV", 3011, is::ro, {}, {}, {}, "Drive rating", is::inferred};
inline constexpr reg<mains> vcal{"VCAL", 3012, is::ro, {}, {}, {}, "Drive mains voltage", is::inferred};
inline constexpr reg<deciamperes> inv{"INV", 3017, is::ro, {}, {}, {}, "Rated drive current", is::inferred};
inline constexpr reg<hectohertz> sfr{"SFR", 3102, is::rw, {}, {}, {}, "Switching frequency"};
inline constexpr reg<decihertz> tfr{"TFR", 3103, is::cfg, {}, {}, {}, "Maximum output frequency"};
inline constexpr reg<decihertz> hsp{"HSP", 3104, is::rw, "LSP", "TFR", {}, "High speed"};
inline constexpr reg<decihertz> lsp{"LSP", 3105, is::rw, 0, "HSP", {}, "Low speed"};
inline constexpr reg<status_word> eta{"ETA", 3201, is::ro, {}, {}, {}, "Status word", is::inferred};
inline constexpr reg<signed_decihertz> rfr{"RFR", 3202, is::ro, -32767, 32767, {}, "Output frequency", is::inferred};
inline constexpr reg<signed_decihertz> frh{"FRH", 3203, is::ro, -5990, 5990, {}, "Frequency reference before the ramp", is::inferred};
inline constexpr reg<deciamperes> lcr{"LCR", 3204, is::ro, 0, 65535, {}, "Motor current", is::inferred};
inline constexpr reg<signed_tenth_percent> otr{"OTR", 3205, is::ro, -32767, 32767, {}, "Motor torque", is::inferred};
inline constexpr reg<extended_status_word> eti{"ETI", 3206, is::ro, {}, {}, {}, "Extended status word", is::inferred};
inline constexpr reg<decivolts> uln{"ULN", 3207, is::ro, 0, 65535, {}, "Mains voltage from the DC bus", is::inferred};
inline constexpr reg<volts> uop{"UOP", 3208, is::ro, 0, 65535, {}, "Motor voltage", is::inferred};
inline constexpr reg<percent> thd{"THD", 3209, is::ro, 0, 200, {}, "Drive thermal state", is::inferred};
inline constexpr reg<signed_percent> opr{"OPR", 3211, is::ro, -32767, 32767, {}, "Motor power", is::inferred};
inline constexpr reg<count16> rth{"RTH", 3231, is::ro, {}, {}, {}, "Motor running time", is::doubtful};
inline constexpr reg<count16> pth{"PTH", 3233, is::ro, {}, {}, {}, "Powered time", is::doubtful};
inline constexpr reg<product_state> hmis{"HMIS", 3240, is::ro, {}, {}, {}, "Product state", is::inferred};
inline constexpr reg<count16> vdp{"VDP", 3302, is::ro, 0, 65535, {}, "Firmware version", is::inferred};
inline constexpr reg<input_image> il1r{"IL1R", 5202, is::ro, {}, {}, {}, "Logic inputs", is::inferred};
inline constexpr reg<count16> add{"ADD", 6001, is::cfg, 0, 247, 0, "Unit address", is::inferred};
inline constexpr reg<serial_rate> tbr{"TBR", 6003, is::cfg, {}, {}, {}, "Line bit rate", is::inferred};
inline constexpr reg<serial_format> tfo{"TFO", 6004, is::cfg, {}, {}, {}, "Line character format", is::inferred};
inline constexpr reg<deciseconds> tto{"TTO", 6005, is::cfg, 1, 300, {}, "Communication time-out", is::inferred};
inline constexpr reg<link_lost_reaction> sll{"SLL", 7010, is::cfg, {}, {}, {}, "Reaction to a lost link", is::inferred};
inline constexpr reg<fault_code> lft{"LFT", 7121, is::ro, {}, {}, {}, "Last fault", is::inferred};
inline constexpr reg<no_yes> atr{"ATR", 7122, is::cfg, {}, {}, 0, "Automatic restart", is::inferred};
inline constexpr reg<configuration_faults> cic{"CIC", 7130, is::cfg, {}, {}, {}, "What is wrong with the configuration", is::inferred};
inline constexpr reg<fault_code> dp0{"DP0", 7200, is::ro, {}, {}, {}, "Most recent fault", is::inferred};
inline constexpr reg<fault_code> dp1{"DP1", 7201, is::ro, {}, {}, {}, "Fault 1 back", is::inferred};
inline constexpr reg<fault_code> dp2{"DP2", 7202, is::ro, {}, {}, {}, "Fault 2 back", is::inferred};
inline constexpr reg<fault_code> dp3{"DP3", 7203, is::ro, {}, {}, {}, "Fault 3 back", is::inferred};
inline constexpr reg<fault_code> dp4{"DP4", 7204, is::ro, {}, {}, {}, "Fault 4 back", is::inferred};
inline constexpr reg<fault_code> dp5{"DP5", 7205, is::ro, {}, {}, {}, "Fault 5 back", is::inferred};
inline constexpr reg<fault_code> dp6{"DP6", 7206, is::ro, {}, {}, {}, "Fault 6 back", is::inferred};
inline constexpr reg<fault_code> dp7{"DP7", 7207, is::ro, {}, {}, {}, "Fault 7 back", is::inferred};
inline constexpr reg<fault_code> dp8{"DP8", 7208, is::ro, {}, {}, {}, "Fault 8 back", is::inferred};
inline constexpr reg<channel_mode> chcf{"CHCF", 8401, is::cfg, {}, {}, {}, "Channel configuration", is::inferred};
inline constexpr reg<reference_channel> fr1{"FR1", 8413, is::cfg, {}, {}, {}, "Reference channel 1", is::inferred};
inline constexpr reg<reference_channel> fr2{"FR2", 8414, is::cfg, {}, {}, {}, "Reference channel 2", is::inferred};
inline constexpr reg<command_channel> cd1{"CD1", 8423, is::cfg, {}, {}, {}, "Command channel 1", is::inferred};
inline constexpr reg<command_channel> cd2{"CD2", 8424, is::cfg, {}, {}, {}, "Command channel 2", is::inferred};
inline constexpr reg<count16> flo{"FLO", 8431, is::cfg, {}, {}, {}, "Input that forces local control", is::inferred};
inline constexpr reg<command_word> cmd{"CMD", 8501, is::rw, {}, {}, {}, "Command word", is::inferred};
inline constexpr reg<signed_decihertz> lfr{"LFR", 8502, is::rw, -5990, 5990, {}, "Frequency setpoint", is::inferred};
inline constexpr reg<count16> pisp{"PISP", 8503, is::rw, 0, 1000, {}, "PI regulator setpoint", is::inferred};
inline constexpr reg<extended_command_word> cmi{"CMI", 8504, is::rw, {}, {}, {}, "Extended command word", is::inferred};
inline constexpr reg<signed_rpm> lfrd{"LFRD", 8602, is::rw, {}, {}, {}, "Speed setpoint", is::inferred};
inline constexpr reg<status_word> etad{"ETAD", 8603, is::ro, {}, {}, {}, "Status word, speed mode", is::inferred};
inline constexpr reg<signed_rpm> rfrd{"RFRD", 8604, is::ro, {}, {}, {}, "Output speed", is::inferred};
inline constexpr reg<signed_rpm> frhd{"FRHD", 8605, is::ro, {}, {}, {}, "Speed reference before the ramp", is::inferred};
inline constexpr reg<count16> errd{"ERRD", 8606, is::ro, {}, {}, {}, "Fault code of the drive profile", is::inferred};
inline constexpr reg<disable_stop> dotd{"DOTD", 8652, is::cfg, {}, {}, 1, "How disable operation stops", is::inferred};
inline constexpr reg<deciseconds> acc{"ACC", 9001, is::rw, {}, {}, {}, "Acceleration ramp time", is::documented, "INR"};
inline constexpr reg<deciseconds> dec{"DEC", 9002, is::rw, {}, {}, {}, "Deceleration ramp time", is::documented, "INR"};
inline constexpr reg<deciseconds> ac2{"AC2", 9012, is::rw, {}, {}, {}, "Second acceleration ramp time", is::inferred, "INR"};
inline constexpr reg<deciseconds> de2{"DE2", 9013, is::rw, {}, {}, {}, "Second deceleration ramp time", is::inferred, "INR"};
inline constexpr reg<ramp_step> inr{"INR", 9020, is::rw, {}, {}, {}, "Size of a ramp step", is::inferred};
inline constexpr reg<volts> uns{"UNS", 9601, is::cfg, 100, 690, {}, "Rated motor voltage", is::inferred};
inline constexpr reg<decihertz> frs{"FRS", 9602, is::cfg, 100, 8000, {}, "Rated motor frequency", is::inferred};
inline constexpr reg<deciamperes> ncr{"NCR", 9603, is::cfg, {}, {}, {}, "Rated motor current", is::inferred};
inline constexpr reg<rpm> nsp{"NSP", 9604, is::cfg, 0, 65535, {}, "Rated motor speed", is::inferred};
inline constexpr reg<count16_hundredths> cos{"COS", 9606, is::cfg, 50, 100, {}, "Motor power factor", is::inferred};
inline constexpr reg<count16> npr{"NPR", 9613, is::cfg, {}, {}, {}, "Rated motor power", is::doubtful};
inline constexpr reg<deciamperes> ith{"ITH", 9622, is::rw, {}, {}, {}, "Motor thermal protection current", is::inferred};
inline constexpr reg<percent> thr{"THR", 9630, is::ro, 0, 200, {}, "Motor thermal state", is::inferred};
inline constexpr reg<control_mode> tcc{"TCC", 11101, is::cfg, {}, {}, 0, "2-wire/3-wire control via terminals", is::inferred};
inline constexpr reg<stop_mode> stt{"STT", 11201, is::cfg, {}, {}, {}, "Normal stop", is::inferred};
inline constexpr reg<count16> nma1{"NMA1", 12701, is::cfg, 0, 65535, 3201, "Scanner: address of input word 1", is::inferred};
inline constexpr reg<count16> nma2{"NMA2", 12702, is::cfg, 0, 65535, 8604, "Scanner: address of input word 2", is::inferred};
inline constexpr reg<count16> nma3{"NMA3", 12703, is::cfg, 0, 65535, 0, "Scanner: address of input word 3", is::inferred};
inline constexpr reg<count16> nma4{"NMA4", 12704, is::cfg, 0, 65535, 0, "Scanner: address of input word 4", is::inferred};
inline constexpr reg<count16> nma5{"NMA5", 12705, is::cfg, 0, 65535, 0, "Scanner: address of input word 5", is::inferred};
inline constexpr reg<count16> nma6{"NMA6", 12706, is::cfg, 0, 65535, 0, "Scanner: address of input word 6", is::inferred};
inline constexpr reg<count16> nma7{"NMA7", 12707, is::cfg, 0, 65535, 0, "Scanner: address of input word 7", is::inferred};
inline constexpr reg<count16> nma8{"NMA8", 12708, is::cfg, 0, 65535, 0, "Scanner: address of input word 8", is::inferred};
inline constexpr reg<count16> nca1{"NCA1", 12721, is::cfg, 0, 65535, 8501, "Scanner: address of output word 1", is::inferred};
inline constexpr reg<count16> nca2{"NCA2", 12722, is::cfg, 0, 65535, 8602, "Scanner: address of output word 2", is::inferred};
inline constexpr reg<count16> nca3{"NCA3", 12723, is::cfg, 0, 65535, 0, "Scanner: address of output word 3", is::inferred};
inline constexpr reg<count16> nca4{"NCA4", 12724, is::cfg, 0, 65535, 0, "Scanner: address of output word 4", is::inferred};
inline constexpr reg<count16> nca5{"NCA5", 12725, is::cfg, 0, 65535, 0, "Scanner: address of output word 5", is::inferred};
inline constexpr reg<count16> nca6{"NCA6", 12726, is::cfg, 0, 65535, 0, "Scanner: address of output word 6", is::inferred};
inline constexpr reg<count16> nca7{"NCA7", 12727, is::cfg, 0, 65535, 0, "Scanner: address of output word 7", is::inferred};
inline constexpr reg<count16> nca8{"NCA8", 12728, is::cfg, 0, 65535, 0, "Scanner: address of output word 8", is::inferred};
inline constexpr reg<count16> nm1{"NM1", 12741, is::ro, 0, 65535, {}, "Scanner: input word 1", is::inferred};
inline constexpr reg<count16> nm2{"NM2", 12742, is::ro, 0, 65535, {}, "Scanner: input word 2", is::inferred};
inline constexpr reg<count16> nm3{"NM3", 12743, is::ro, 0, 65535, {}, "Scanner: input word 3", is::inferred};
inline constexpr reg<count16> nm4{"NM4", 12744, is::ro, 0, 65535, {}, "Scanner: input word 4", is::inferred};
inline constexpr reg<count16> nm5{"NM5", 12745, is::ro, 0, 65535, {}, "Scanner: input word 5", is::inferred};
inline constexpr reg<count16> nm6{"NM6", 12746, is::ro, 0, 65535, {}, "Scanner: input word 6", is::inferred};
inline constexpr reg<count16> nm7{"NM7", 12747, is::ro, 0, 65535, {}, "Scanner: input word 7", is::inferred};
inline constexpr reg<count16> nm8{"NM8", 12748, is::ro, 0, 65535, {}, "Scanner: input word 8", is::inferred};
inline constexpr reg<count16> nc1{"NC1", 12761, is::rw, 0, 65535, {}, "Scanner: output word 1", is::inferred};
inline constexpr reg<count16> nc2{"NC2", 12762, is::rw, 0, 65535, {}, "Scanner: output word 2", is::inferred};
inline constexpr reg<count16> nc3{"NC3", 12763, is::rw, 0, 65535, {}, "Scanner: output word 3", is::inferred};
inline constexpr reg<count16> nc4{"NC4", 12764, is::rw, 0, 65535, {}, "Scanner: output word 4", is::inferred};
inline constexpr reg<count16> nc5{"NC5", 12765, is::rw, 0, 65535, {}, "Scanner: output word 5", is::inferred};
inline constexpr reg<count16> nc6{"NC6", 12766, is::rw, 0, 65535, {}, "Scanner: output word 6", is::inferred};
inline constexpr reg<count16> nc7{"NC7", 12767, is::rw, 0, 65535, {}, "Scanner: output word 7", is::inferred};
inline constexpr reg<count16> nc8{"NC8", 12768, is::rw, 0, 65535, {}, "Scanner: output word 8", is::inferred};
// clang-format on

/// An ATV320.
struct device : family_device {
    static constexpr literal name{"atv320"};
    static constexpr literal reference{"ATV320U07M2B"}; ///< one of the family, as function 43 returns it
    static constexpr function_set functions{
        function_code::read_holding_registers,   function_code::write_single_register,
        function_code::write_multiple_registers, function_code::read_write_multiple_registers,
        function_code::encapsulated_interface,   function_code::diagnostics};
    static constexpr device_limits limits{63, 61, 20, 20};
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
                                         .frs = frs.address,
                                         .nsp = nsp.address,
                                         .state_machine = {.enables_from_ready = true, .quick_stop_waits = true},
                                         .other_cmd = 400,
                                         .safeguards = {.sll = sll.address,
                                                        .tto = tto.address,
                                                        .chcf = chcf.address,
                                                        .cd1 = cd1.address,
                                                        .fr1 = fr1.address,
                                                        .flo = flo.address,
                                                        .atr = atr.address,
                                                        .dotd = dotd.address,
                                                        .inputs = il1r.address,
                                                        .tcc = tcc.address}};
    static constexpr scanner_registers scanner{.input_addresses = nma1.address,
                                               .output_addresses = nca1.address,
                                               .input_words = nm1.address,
                                               .output_words = nc1.address,
                                               .words = 8};
    /// Function 23 moves the first four words of its scanner; the program may use two each way.
    static constexpr cycle_registers cycle{.by = function_code::read_write_multiple_registers,
                                           .reads = {eta.address, rfrd.address, 0, 0},
                                           .writes = {cmd.address, lfrd.address, 0, 0},
                                           .speed = rfrd.address,
                                           .by_scanner = true};
    using registers = table<ncv, vcal, inv, sfr, tfr, hsp, lsp, eta, rfr, frh, lcr, otr, eti, uln, uop, thd, opr, rth,
                            pth, hmis, vdp, il1r, add, tbr, tfo, tto, sll, lft, atr, cic, dp0, dp1, dp2, dp3, dp4, dp5,
                            dp6, dp7, dp8, chcf, fr1, fr2, cd1, cd2, flo, cmd, lfr, pisp, cmi, lfrd, etad, rfrd, frhd,
                            errd, dotd, acc, dec, ac2, de2, inr, uns, frs, ncr, nsp, cos, npr, ith, thr, tcc, stt, nma1,
                            nma2, nma3, nma4, nma5, nma6, nma7, nma8, nca1, nca2, nca3, nca4, nca5, nca6, nca7, nca8,
                            nm1, nm2, nm3, nm4, nm5, nm6, nm7, nm8, nc1, nc2, nc3, nc4, nc5, nc6, nc7, nc8>;
};

} // namespace altivar::atv320
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
