// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV12: its registers, from manual BBV28590 (2012) and the parameter file BBV51917.
#pragma once

#include <rtuwire/altivar/device/compact_values.hpp>
#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/family.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv12 {

using namespace compact;

// clang-format off
inline constexpr reg<rating> ncv{"NCV", 3011, is::cfg, {}, {}, {}, "Drive rating"};
inline constexpr reg<mains> vcal{"VCAL", 3012, is::cfg, {}, {}, {}, "Drive mains voltage"};
inline constexpr reg<deciamperes> inv{"INV", 3017, is::ro, 0, 65535, {}, "Rated drive current"};
inline constexpr reg<hectohertz> sfr{"SFR", 3102, is::rw, 20, 160, 40, "Switching frequency"};
inline constexpr reg<decihertz> tfr{"TFR", 3103, is::cfg, 100, 4000, {}, "Maximum output frequency"};
inline constexpr reg<decihertz> hsp{"HSP", 3104, is::rw, 0, 4000, {}, "High speed"};
inline constexpr reg<decihertz> lsp{"LSP", 3105, is::rw, 0, 4000, 0, "Low speed"};
inline constexpr reg<status_word> eta{"ETA", 3201, is::ro, {}, {}, {}, "Status word"};
inline constexpr reg<signed_decihertz> rfr{"RFR", 3202, is::ro, -5000, 5000, 0, "Output frequency"};
inline constexpr reg<signed_decihertz> frh{"FRH", 3203, is::ro, -32767, 32767, 0, "Frequency reference before the ramp"};
inline constexpr reg<deciamperes> lcr{"LCR", 3204, is::ro, 0, 65535, 0, "Motor current"};
inline constexpr reg<extended_status_word> eti{"ETI", 3206, is::ro, {}, {}, {}, "Extended status word"};
inline constexpr reg<volts> uln{"ULN", 3207, is::ro, 0, 65535, 0, "Mains voltage from the DC bus"};
inline constexpr reg<percent> thd{"THD", 3209, is::ro, 0, 200, 0, "Drive thermal state"};
inline constexpr reg<signed_percent> opr{"OPR", 3211, is::ro, -32767, 32767, 0, "Motor power"};
inline constexpr reg<centihours> rthi{"RTHI", 3232, is::ro, 0, 65535, 0, "Motor running time"};
inline constexpr reg<centihours> pth{"PTH", 3233, is::ro, 0, 65535, 0, "Powered time"};
inline constexpr reg<product_state> hmis{"HMIS", 3240, is::ro, {}, {}, {}, "Product state"};
inline constexpr reg<count16> vdp{"VDP", 3302, is::ro, 0, 65535, 0, "Firmware version"};
inline constexpr reg<input_image> il1i{"IL1I", 5201, is::ro, {}, {}, {}, "Logic inputs"};
inline constexpr reg<count16> add{"ADD", 6001, is::cfg, 0, 247, 0, "Unit address"};
inline constexpr reg<serial_rate> tbr{"TBR", 6003, is::cfg, {}, {}, 32, "Line bit rate"};
inline constexpr reg<serial_format> tfo{"TFO", 6004, is::cfg, {}, {}, 3, "Line character format"};
inline constexpr reg<deciseconds> tto{"TTO", 6005, is::cfg, 1, 300, 100, "Communication time-out"};
inline constexpr reg<link_lost_reaction> sll{"SLL", 7010, is::cfg, {}, {}, {}, "Reaction to a lost link"};
inline constexpr reg<fault_code> lft{"LFT", 7121, is::ro, {}, {}, {}, "Last fault"};
inline constexpr reg<configuration_faults> cic{"CIC", 7130, is::cfg, {}, {}, {}, "What is wrong with the configuration"};
inline constexpr reg<fault_code> dp0{"DP0", 7200, is::ro, {}, {}, {}, "Most recent fault"};
inline constexpr reg<fault_code> dp1{"DP1", 7201, is::ro, {}, {}, {}, "Fault 1 back"};
inline constexpr reg<fault_code> dp2{"DP2", 7202, is::ro, {}, {}, {}, "Fault 2 back"};
inline constexpr reg<fault_code> dp3{"DP3", 7203, is::ro, {}, {}, {}, "Fault 3 back"};
inline constexpr reg<fault_code> dp4{"DP4", 7204, is::ro, {}, {}, {}, "Fault 4 back"};
inline constexpr reg<channel_mode> chcf{"CHCF", 8401, is::cfg, {}, {}, {}, "Channel configuration"};
inline constexpr reg<reference_channel> fr1{"FR1", 8413, is::cfg, {}, {}, {}, "Reference channel 1"};
inline constexpr reg<command_channel> cd1{"CD1", 8423, is::cfg, {}, {}, {}, "Command channel 1"};
inline constexpr reg<local_input> flo{"FLO", 8431, is::cfg, {}, {}, {}, "Input that forces local control"};
inline constexpr reg<command_word> cmd{"CMD", 8501, is::rw, {}, {}, 0, "Command word"};
inline constexpr reg<signed_decihertz> lfr{"LFR", 8502, is::rw, -32767, 32767, 0, "Frequency setpoint"};
inline constexpr reg<tenth_percent> pisp{"PISP", 8503, is::rw, 0, 1000, 0, "PI regulator setpoint"};
inline constexpr reg<extended_command_word> cmi{"CMI", 8504, is::rw, {}, {}, {}, "Extended command word"};
inline constexpr reg<command_word> cmdd{"CMDD", 8601, is::rw, {}, {}, {}, "Command word, speed mode"};
inline constexpr reg<signed_rpm> lfrd{"LFRD", 8602, is::rw, {}, {}, 0, "Speed setpoint"};
inline constexpr reg<status_word> etad{"ETAD", 8603, is::ro, {}, {}, {}, "Status word, speed mode"};
inline constexpr reg<signed_rpm> rfrd{"RFRD", 8604, is::ro, {}, {}, {}, "Output speed"};
inline constexpr reg<deciseconds> acc{"ACC", 9001, is::rw, 0, 9999, 30, "Acceleration ramp time"};
inline constexpr reg<deciseconds> dec{"DEC", 9002, is::rw, 0, 9999, 30, "Deceleration ramp time"};
inline constexpr reg<deciseconds> ac2{"AC2", 9012, is::rw, 0, 9999, 50, "Second acceleration ramp time"};
inline constexpr reg<deciseconds> de2{"DE2", 9013, is::rw, 0, 9999, 50, "Second deceleration ramp time"};
inline constexpr reg<volts> uns{"UNS", 9601, is::cfg, 100, 480, 230, "Rated motor voltage"};
inline constexpr reg<decihertz> frs{"FRS", 9602, is::cfg, 100, 4000, {}, "Rated motor frequency"};
inline constexpr reg<deciamperes> ncr{"NCR", 9603, is::cfg, 0, 65535, {}, "Rated motor current"};
inline constexpr reg<rpm> nsp{"NSP", 9604, is::cfg, 0, 24000, {}, "Rated motor speed"};
inline constexpr reg<count16_hundredths> cos{"COS", 9606, is::cfg, 50, 100, {}, "Motor power factor"};
inline constexpr reg<count16> npr{"NPR", 9613, is::cfg, {}, {}, {}, "Rated motor power", is::doubtful};
inline constexpr reg<deciamperes> ith{"ITH", 9622, is::rw, 0, 65535, {}, "Motor thermal protection current"};
inline constexpr reg<percent> thr{"THR", 9630, is::ro, 0, 200, 0, "Motor thermal state"};
inline constexpr reg<control_mode> tcc{"TCC", 11101, is::cfg, {}, {}, 0, "2-wire/3-wire control via terminals"};
inline constexpr reg<stop_mode> stt{"STT", 11201, is::cfg, {}, {}, {}, "Normal stop"};
inline constexpr reg<count16> nma1{"NMA1", 12701, is::cfg, 0, 65535, 3201, "Scanner: address of input word 1"};
inline constexpr reg<count16> nma2{"NMA2", 12702, is::cfg, 0, 65535, 8604, "Scanner: address of input word 2"};
inline constexpr reg<count16> nma3{"NMA3", 12703, is::cfg, 0, 65535, 0, "Scanner: address of input word 3"};
inline constexpr reg<count16> nma4{"NMA4", 12704, is::cfg, 0, 65535, 0, "Scanner: address of input word 4"};
inline constexpr reg<count16> nca1{"NCA1", 12721, is::cfg, 0, 65535, 8501, "Scanner: address of output word 1"};
inline constexpr reg<count16> nca2{"NCA2", 12722, is::cfg, 0, 65535, 8602, "Scanner: address of output word 2"};
inline constexpr reg<count16> nca3{"NCA3", 12723, is::cfg, 0, 65535, 0, "Scanner: address of output word 3"};
inline constexpr reg<count16> nca4{"NCA4", 12724, is::cfg, 0, 65535, 0, "Scanner: address of output word 4"};
inline constexpr reg<count16> nm1{"NM1", 12741, is::ro, 0, 65535, {}, "Scanner: input word 1"};
inline constexpr reg<count16> nm2{"NM2", 12742, is::ro, 0, 65535, {}, "Scanner: input word 2"};
inline constexpr reg<count16> nm3{"NM3", 12743, is::ro, 0, 65535, {}, "Scanner: input word 3"};
inline constexpr reg<count16> nm4{"NM4", 12744, is::ro, 0, 65535, {}, "Scanner: input word 4"};
inline constexpr reg<count16> nc1{"NC1", 12761, is::rw, 0, 65535, {}, "Scanner: output word 1"};
inline constexpr reg<count16> nc2{"NC2", 12762, is::rw, 0, 65535, {}, "Scanner: output word 2"};
inline constexpr reg<count16> nc3{"NC3", 12763, is::rw, 0, 65535, {}, "Scanner: output word 3"};
inline constexpr reg<count16> nc4{"NC4", 12764, is::rw, 0, 65535, {}, "Scanner: output word 4"};
// clang-format on

/// An ATV12.
struct device : family_device {
    static constexpr literal name{"atv12"};
    static constexpr literal reference{"ATV12H075M2"}; ///< one of the family, as function 43 returns it
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
                                         .state_machine = {.enables_from_ready = true},
                                         .other_cmd = 400,
                                         .safeguards = {.sll = sll.address,
                                                        .tto = tto.address,
                                                        .chcf = chcf.address,
                                                        .cd1 = cd1.address,
                                                        .fr1 = fr1.address,
                                                        .flo = flo.address,
                                                        .inputs = il1i.address,
                                                        .tcc = tcc.address}};
    static constexpr scanner_registers scanner{.input_addresses = nma1.address,
                                               .output_addresses = nca1.address,
                                               .input_words = nm1.address,
                                               .output_words = nc1.address,
                                               .words = 4};
    /// Function 23 moves the four words of its scanner; the program may use two each way.
    static constexpr cycle_registers cycle{.by = function_code::read_write_multiple_registers,
                                           .reads = {eta.address, rfrd.address, 0, 0},
                                           .writes = {cmd.address, lfrd.address, 0, 0},
                                           .speed = rfrd.address,
                                           .by_scanner = true};
    static constexpr simulated_behaviour behaviour{.fast_stop = 8, .freewheel = 13};
    using registers =
        table<ncv, vcal, inv, sfr, tfr, hsp, lsp, eta, rfr, frh, lcr, eti, uln, thd, opr, rthi, pth, hmis, vdp, il1i,
              add, tbr, tfo, tto, sll, lft, cic, dp0, dp1, dp2, dp3, dp4, chcf, fr1, cd1, flo, cmd, lfr, pisp, cmi,
              cmdd, lfrd, etad, rfrd, acc, dec, ac2, de2, uns, frs, ncr, nsp, cos, npr, ith, thr, tcc, stt, nma1, nma2,
              nma3, nma4, nca1, nca2, nca3, nca4, nm1, nm2, nm3, nm4, nc1, nc2, nc3, nc4>;
};

} // namespace altivar::atv12
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
