// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive that nobody makes, described by public names alone: addresses, limits, time-out and a cycle that no Altivar
// has. What its scanner moves is in another order, and its reference comes before its command.
#pragma once

#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

namespace atv99 {

using namespace rtuwire;
using namespace rtuwire::altivar;

//! [registers]
inline constexpr reg<command_word> cmd{.code = "CMD", .address = 52'000, .factory = 0};
inline constexpr reg<signed_decihertz> lfr{.code = "LFR", .address = 52'001, .min = {-4000}, .max = {4000}};
inline constexpr reg<signed_rpm> lfrd{.code = "LFRD", .address = 52'010};
inline constexpr reg<extended_command_word> cmi{.code = "CMI", .address = 52'020};
inline constexpr reg<signed_rpm> rfrd{.code = "RFRD", .address = 2'310, .mode = access::read_only};
inline constexpr reg<status_word> eta{.code = "ETA", .address = 2'311, .mode = access::read_only};
inline constexpr reg<extended_status_word> eti{.code = "ETI", .address = 2'330, .mode = access::read_only};
inline constexpr reg<signed_decihertz> rfr{.code = "RFR", .address = 2'340, .mode = access::read_only};
inline constexpr reg<count16> lft{.code = "LFT", .address = 2'350, .mode = access::read_only};
inline constexpr reg<decihertz> hsp{.code = "HSP", .address = 1'000, .min = {0}, .max = {4000}, .factory = 600};
inline constexpr reg<deciseconds> acc{.code = "ACC", .address = 1'001, .min = {1}, .max = {600}, .factory = 10};
inline constexpr reg<deciseconds> dec{.code = "DEC", .address = 1'002, .min = {1}, .max = {600}, .factory = 10};
inline constexpr reg<rpm> nsp{.code = "NSP", .address = 1'010, .mode = access::configuration, .factory = 3000};
inline constexpr reg<decihertz> frs{.code = "FRS", .address = 1'011, .mode = access::configuration, .factory = 500};
inline constexpr reg<count16> add{.code = "ADD", .address = 1'020, .mode = access::configuration};
inline constexpr reg<deciseconds> tto{.code = "TTO", .address = 1'021, .mode = access::configuration, .factory = 20};
inline constexpr reg<count16> sll{.code = "SLL", .address = 1'022, .mode = access::configuration};
inline constexpr reg<count16> fr1{.code = "FR1", .address = 1'030, .mode = access::configuration};
inline constexpr reg<count16> in1{.code = "IN1", .address = 1'100, .mode = access::configuration};
inline constexpr reg<count16> in2{.code = "IN2", .address = 1'101, .mode = access::configuration};
inline constexpr reg<count16> in3{.code = "IN3", .address = 1'102, .mode = access::configuration};
inline constexpr reg<count16> out1{.code = "OUT1", .address = 1'110, .mode = access::configuration};
inline constexpr reg<count16> out2{.code = "OUT2", .address = 1'111, .mode = access::configuration};
inline constexpr reg<count16> out3{.code = "OUT3", .address = 1'112, .mode = access::configuration};
inline constexpr reg<count16> iw1{.code = "IW1", .address = 1'120, .mode = access::read_only};
inline constexpr reg<count16> iw2{.code = "IW2", .address = 1'121, .mode = access::read_only};
inline constexpr reg<count16> iw3{.code = "IW3", .address = 1'122, .mode = access::read_only};
inline constexpr reg<count16> ow1{.code = "OW1", .address = 1'130};
inline constexpr reg<count16> ow2{.code = "OW2", .address = 1'131};
inline constexpr reg<count16> ow3{.code = "OW3", .address = 1'132};
//! [registers]

//! [device]
/// With a scanner of three words.
struct device {
    static constexpr literal name{"atv99"};
    static constexpr literal reference{"ATV99M0"};
    static constexpr function_set functions{function_code::read_holding_registers, function_code::write_single_register,
                                            function_code::write_multiple_registers,
                                            function_code::read_write_multiple_registers,
                                            function_code::encapsulated_interface};
    static constexpr device_limits limits{11, 9, 3, 3};
    static constexpr unit_range units{40, 59};
    static constexpr std::array<address_range, 0> readable{};
    static constexpr auto const& speed_reference = lfrd;
    static constexpr auto const& frequency_reference = lfr;
    static constexpr drive_layout layout{.cmd = cmd.address,
                                         .eta = eta.address,
                                         .lft = lft.address,
                                         .cmi = cmi.address,
                                         .eti = eti.address,
                                         .rfr = rfr.address,
                                         .longest_silence = milliseconds(5'000),
                                         .safeguards = {.sll = sll.address, .tto = tto.address, .fr1 = fr1.address}};
    static constexpr scanner_registers scanner{.input_addresses = in1.address,
                                               .output_addresses = out1.address,
                                               .input_words = iw1.address,
                                               .output_words = ow1.address,
                                               .words = 3};
    static constexpr cycle_registers cycle{.by = function_code::read_write_multiple_registers,
                                           .reads = {rfrd.address, 0, eta.address},
                                           .writes = {lfr.address, cmd.address, 0},
                                           .speed = rfrd.address,
                                           .by_scanner = true};
    using registers = table<cmd, lfr, lfrd, cmi, rfrd, eta, eti, rfr, lft, hsp, acc, dec, nsp, frs, add, tto, sll, fr1,
                            in1, in2, in3, out1, out2, out3, iw1, iw2, iw3, ow1, ow2, ow3>;
};
//! [device]

/// Without it: the cycle reads and writes the registers themselves, by one request or by two.
struct plain_device : device {
    static constexpr scanner_registers scanner{};
    static constexpr cycle_registers cycle{.by = function_code::write_multiple_registers,
                                           .reads = {rfrd.address, eta.address},
                                           .writes = {cmd.address, lfr.address},
                                           .speed = rfrd.address};
};

static_assert(drive_check<device>::passed and drive_check<plain_device>::passed);

} // namespace atv99
