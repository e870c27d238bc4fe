// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV12: its registers, from manual BBV28590 (2012) and the parameter file BBV51917.
#pragma once

#include <rtuwire/altivar/device/compact_values.hpp>
#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/family.hpp>
#include <rtuwire/altivar/device/words.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv12 {

using namespace compact;

// clang-format off
inline constexpr reg<rating> ncv{.code = "NCV", .address = 3011, .mode = access::configuration,
    .name = "Drive rating"};
inline constexpr reg<mains> vcal{.code = "VCAL", .address = 3012, .mode = access::configuration,
    .name = "Drive mains voltage"};
inline constexpr reg<deciamperes> inv{.code = "INV", .address = 3017, .mode = access::read_only, .min = {0}, .max = {65535},
    .name = "Rated drive current"};
inline constexpr reg<hectohertz> sfr{.code = "SFR", .address = 3102, .min = {20}, .max = {160}, .factory = 40, .name = "Switching frequency"};
inline constexpr reg<decihertz> tfr{.code = "TFR", .address = 3103, .mode = access::configuration, .min = {100}, .max = {4000},
    .name = "Maximum output frequency"};
inline constexpr reg<decihertz> hsp{.code = "HSP", .address = 3104, .min = {0}, .max = {4000}, .name = "High speed"};
inline constexpr reg<decihertz> lsp{.code = "LSP", .address = 3105, .min = {0}, .max = {4000}, .factory = 0, .name = "Low speed"};
inline constexpr reg<status_word> eta{.code = "ETA", .address = 3201, .mode = access::read_only,
    .name = "Status word"};
inline constexpr reg<signed_decihertz> rfr{.code = "RFR", .address = 3202, .mode = access::read_only, .min = {-5000}, .max = {5000}, .factory = 0,
    .name = "Output frequency"};
inline constexpr reg<signed_decihertz> frh{.code = "FRH", .address = 3203, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0,
    .name = "Frequency reference before the ramp"};
inline constexpr reg<deciamperes> lcr{.code = "LCR", .address = 3204, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0,
    .name = "Motor current"};
inline constexpr reg<extended_status_word> eti{.code = "ETI", .address = 3206, .mode = access::read_only,
    .name = "Extended status word"};
inline constexpr reg<volts> uln{.code = "ULN", .address = 3207, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0,
    .name = "Mains voltage from the DC bus"};
inline constexpr reg<percent> thd{.code = "THD", .address = 3209, .mode = access::read_only, .min = {0}, .max = {200}, .factory = 0,
    .name = "Drive thermal state"};
inline constexpr reg<signed_percent> opr{.code = "OPR", .address = 3211, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0,
    .name = "Motor power"};
inline constexpr reg<centihours> rthi{.code = "RTHI", .address = 3232, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0,
    .name = "Motor running time"};
inline constexpr reg<centihours> pth{.code = "PTH", .address = 3233, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0,
    .name = "Powered time"};
inline constexpr reg<product_state> hmis{.code = "HMIS", .address = 3240, .mode = access::read_only,
    .name = "Product state"};
inline constexpr reg<count16> vdp{.code = "VDP", .address = 3302, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0,
    .name = "Firmware version"};
inline constexpr reg<input_image> il1i{.code = "IL1I", .address = 5201, .mode = access::read_only,
    .name = "Logic inputs"};
inline constexpr reg<count16> add{.code = "ADD", .address = 6001, .mode = access::configuration, .min = {0}, .max = {247}, .factory = 0,
    .name = "Unit address"};
inline constexpr reg<serial_rate> tbr{.code = "TBR", .address = 6003, .mode = access::configuration, .factory = 32,
    .name = "Line bit rate"};
inline constexpr reg<serial_format> tfo{.code = "TFO", .address = 6004, .mode = access::configuration, .factory = 3,
    .name = "Line character format"};
inline constexpr reg<deciseconds> tto{.code = "TTO", .address = 6005, .mode = access::configuration, .min = {1}, .max = {300}, .factory = 100,
    .name = "Communication time-out"};
inline constexpr reg<link_lost_reaction> sll{.code = "SLL", .address = 7010, .mode = access::configuration,
    .name = "Reaction to a lost link"};
inline constexpr reg<fault_code> lft{.code = "LFT", .address = 7121, .mode = access::read_only, .name = "Last fault"};
inline constexpr reg<configuration_faults> cic{.code = "CIC", .address = 7130, .mode = access::configuration,
    .name = "What is wrong with the configuration"};
inline constexpr reg<fault_code> dp0{.code = "DP0", .address = 7200, .mode = access::read_only,
    .name = "Most recent fault"};
inline constexpr reg<fault_code> dp1{.code = "DP1", .address = 7201, .mode = access::read_only,
    .name = "Fault 1 back"};
inline constexpr reg<fault_code> dp2{.code = "DP2", .address = 7202, .mode = access::read_only,
    .name = "Fault 2 back"};
inline constexpr reg<fault_code> dp3{.code = "DP3", .address = 7203, .mode = access::read_only,
    .name = "Fault 3 back"};
inline constexpr reg<fault_code> dp4{.code = "DP4", .address = 7204, .mode = access::read_only,
    .name = "Fault 4 back"};
inline constexpr reg<channel_mode> chcf{.code = "CHCF", .address = 8401, .mode = access::configuration,
    .name = "Channel configuration"};
inline constexpr reg<reference_channel> fr1{.code = "FR1", .address = 8413, .mode = access::configuration,
    .name = "Reference channel 1"};
inline constexpr reg<command_channel> cd1{.code = "CD1", .address = 8423, .mode = access::configuration,
    .name = "Command channel 1"};
inline constexpr reg<local_input> flo{.code = "FLO", .address = 8431, .mode = access::configuration,
    .name = "Input that forces local control"};
inline constexpr reg<command_word> cmd{.code = "CMD", .address = 8501, .factory = 0, .name = "Command word"};
inline constexpr reg<signed_decihertz> lfr{.code = "LFR", .address = 8502, .min = {-32767}, .max = {32767}, .factory = 0,
    .name = "Frequency setpoint"};
inline constexpr reg<tenth_percent> pisp{.code = "PISP", .address = 8503, .min = {0}, .max = {1000}, .factory = 0,
    .name = "PI regulator setpoint"};
inline constexpr reg<extended_command_word> cmi{.code = "CMI", .address = 8504, .name = "Extended command word"};
inline constexpr reg<command_word> cmdd{.code = "CMDD", .address = 8601, .name = "Command word, speed mode"};
inline constexpr reg<signed_rpm> lfrd{.code = "LFRD", .address = 8602, .factory = 0, .name = "Speed setpoint"};
inline constexpr reg<status_word> etad{.code = "ETAD", .address = 8603, .mode = access::read_only,
    .name = "Status word, speed mode"};
inline constexpr reg<signed_rpm> rfrd{.code = "RFRD", .address = 8604, .mode = access::read_only,
    .name = "Output speed"};
inline constexpr reg<deciseconds> acc{.code = "ACC", .address = 9001, .min = {0}, .max = {9999}, .factory = 30,
    .name = "Acceleration ramp time"};
inline constexpr reg<deciseconds> dec{.code = "DEC", .address = 9002, .min = {0}, .max = {9999}, .factory = 30,
    .name = "Deceleration ramp time"};
inline constexpr reg<deciseconds> ac2{.code = "AC2", .address = 9012, .min = {0}, .max = {9999}, .factory = 50,
    .name = "Second acceleration ramp time"};
inline constexpr reg<deciseconds> de2{.code = "DE2", .address = 9013, .min = {0}, .max = {9999}, .factory = 50,
    .name = "Second deceleration ramp time"};
inline constexpr reg<volts> uns{.code = "UNS", .address = 9601, .mode = access::configuration, .min = {100}, .max = {480}, .factory = 230,
    .name = "Rated motor voltage"};
inline constexpr reg<decihertz> frs{.code = "FRS", .address = 9602, .mode = access::configuration, .min = {100}, .max = {4000},
    .name = "Rated motor frequency"};
inline constexpr reg<deciamperes> ncr{.code = "NCR", .address = 9603, .mode = access::configuration, .min = {0}, .max = {65535},
    .name = "Rated motor current"};
inline constexpr reg<rpm> nsp{.code = "NSP", .address = 9604, .mode = access::configuration, .min = {0}, .max = {24000},
    .name = "Rated motor speed"};
inline constexpr reg<count16_hundredths> cos{.code = "COS", .address = 9606, .mode = access::configuration, .min = {50}, .max = {100},
    .name = "Motor power factor"};
inline constexpr reg<count16> npr{.code = "NPR", .address = 9613, .mode = access::configuration,
    .name = "Rated motor power", .source = provenance::doubtful};
inline constexpr reg<deciamperes> ith{.code = "ITH", .address = 9622, .min = {0}, .max = {65535},
    .name = "Motor thermal protection current"};
inline constexpr reg<percent> thr{.code = "THR", .address = 9630, .mode = access::read_only, .min = {0}, .max = {200}, .factory = 0,
    .name = "Motor thermal state"};
inline constexpr reg<control_mode> tcc{.code = "TCC", .address = 11101, .mode = access::configuration, .factory = 0,
    .name = "2-wire/3-wire control via terminals"};
inline constexpr reg<stop_mode> stt{.code = "STT", .address = 11201, .mode = access::configuration,
    .name = "Normal stop"};
inline constexpr reg<count16> nma1{.code = "NMA1", .address = 12701, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 3201,
    .name = "Scanner: address of input word 1"};
inline constexpr reg<count16> nma2{.code = "NMA2", .address = 12702, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 8604,
    .name = "Scanner: address of input word 2"};
inline constexpr reg<count16> nma3{.code = "NMA3", .address = 12703, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0,
    .name = "Scanner: address of input word 3"};
inline constexpr reg<count16> nma4{.code = "NMA4", .address = 12704, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0,
    .name = "Scanner: address of input word 4"};
inline constexpr reg<count16> nca1{.code = "NCA1", .address = 12721, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 8501,
    .name = "Scanner: address of output word 1"};
inline constexpr reg<count16> nca2{.code = "NCA2", .address = 12722, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 8602,
    .name = "Scanner: address of output word 2"};
inline constexpr reg<count16> nca3{.code = "NCA3", .address = 12723, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0,
    .name = "Scanner: address of output word 3"};
inline constexpr reg<count16> nca4{.code = "NCA4", .address = 12724, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0,
    .name = "Scanner: address of output word 4"};
inline constexpr reg<count16> nm1{.code = "NM1", .address = 12741, .mode = access::read_only, .min = {0}, .max = {65535},
    .name = "Scanner: input word 1"};
inline constexpr reg<count16> nm2{.code = "NM2", .address = 12742, .mode = access::read_only, .min = {0}, .max = {65535},
    .name = "Scanner: input word 2"};
inline constexpr reg<count16> nm3{.code = "NM3", .address = 12743, .mode = access::read_only, .min = {0}, .max = {65535},
    .name = "Scanner: input word 3"};
inline constexpr reg<count16> nm4{.code = "NM4", .address = 12744, .mode = access::read_only, .min = {0}, .max = {65535},
    .name = "Scanner: input word 4"};
inline constexpr reg<count16> nc1{.code = "NC1", .address = 12761, .min = {0}, .max = {65535},
    .name = "Scanner: output word 1"};
inline constexpr reg<count16> nc2{.code = "NC2", .address = 12762, .min = {0}, .max = {65535},
    .name = "Scanner: output word 2"};
inline constexpr reg<count16> nc3{.code = "NC3", .address = 12763, .min = {0}, .max = {65535},
    .name = "Scanner: output word 3"};
inline constexpr reg<count16> nc4{.code = "NC4", .address = 12764, .min = {0}, .max = {65535},
    .name = "Scanner: output word 4"};
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
