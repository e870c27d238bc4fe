// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A map of some parameters of each kind, as a drive of the family has them, and a drive on paper that fits it.
#pragma once

#include "altivar/maintenance/paper_drive.hpp"

#include <rtuwire/altivar/device/atv320.hpp>
// What its values mean, before a row is made of them.
#include <rtuwire/altivar/parameters/atv320/choices.hpp>
#include <rtuwire/altivar/parameters/family_words.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>

namespace rtuwire::test {

namespace small {

using namespace altivar;
using namespace altivar::roles;
namespace d = altivar::atv320;
inline constexpr row_access rw{access::read_write, provenance::documented};
inline constexpr row_access guess{access::read_write, provenance::inferred};
inline constexpr row_access cfg{access::configuration, provenance::documented};

// clang-format off
inline constexpr parameter settings[]{
    {"CFG", 3052, cfg, in<count16>, {}, {}, {}, "Macro", &macro},
    row_of(d::tfr, speed_limit), row_of(d::hsp, speed_limit), row_of(d::lsp, speed_limit),
    row_of(d::acc, ramp), row_of(d::dec, ramp), row_of(d::inr, steps),
    {"SP2", 11410, rw, in<count16>, 0, 5990, {}, "Speed 2", &roles::speed},
    {"SP3", 11411, guess, in<count16>, {}, {}, {}, "Speed 3", &roles::speed},
    {"SP4", 11412, rw, in<count16>, {}, {}, {}, "Speed 4", &roles::speed},
    {"SP6", 11414, rw, in<count16>, {}, {}, {}, "Speed 6", &roles::speed},
};
inline constexpr parameter others[]{
    {"NCV", 3011, cfg, in<count16>, {}, {}, {}, "Rating", &device_identity},
    {"FLR", 3110, cfg, in<count16>, {}, {}, {}, "Catch", &catching},
    row_of(d::eta), row_of(d::rfr),
    {"TAC", 3235, rw, in<count16>, {}, {}, {}, "Time in alarm", &counter},
    row_of(d::il1r), row_of(d::add, this_line), row_of(d::tbr, this_line), row_of(d::tfo, this_line),
    row_of(d::tto, timeout), row_of(d::sll, link_loss), row_of(d::atr, restarts), row_of(d::chcf, roles::commander),
    row_of(d::fr1, references), row_of(d::cd1, roles::commander), row_of(d::flo, roles::commander),
    row_of(d::cmd, commands), row_of(d::lfr, setpoint), row_of(d::cmi, recalls),
    {"TUN", 9608, cfg, in<count16>, {}, {}, {}, "Autotune", &autotuning},
    row_of(d::tcc, wiring),
    {"NST", 11202, cfg, in<count16>, {}, {}, {}, "Freewheel", &stop_input},
    {"STOA", 15320, cfg, in<count16>, {}, {}, {}, "STO", &of_safety},
};
// clang-format on
inline constexpr parameter_group groups[]{{"settings", settings}, {"others", others}};

} // namespace small

/// 34 parameters, in 14 runs of neighbours.
inline constexpr altivar::parameter_map small_map{small::groups};

/// A drive that has them all, and stands.
inline paper_drive small_drive()
{
    paper_drive drive;
    auto const has = [&](std::uint16_t address, std::uint16_t word) { drive.registers[address].word = word; };
    has(3052, 1), has(3011, 5), has(3110, 0), has(3235, 77), has(5202, 0);
    has(3103, 600), has(3104, 500), has(3105, 0), has(9001, 30), has(9002, 30), has(9020, 1);
    has(6001, 7), has(6003, 32), has(6004, 3), has(6005, 100), has(7010, 1), has(7122, 0);
    has(8401, 1), has(8413, 164), has(8423, 10), has(8431, 0), has(8502, 0), has(8504, 0);
    has(9608, 0), has(11101, 0), has(11202, 0), has(11410, 100), has(11411, 150), has(11412, 200), has(11414, 300);
    has(15320, 0);
    has(3206, 0); // ETI, which the save looks at
    drive.stand();
    drive.save();
    return drive;
}

} // namespace rtuwire::test
