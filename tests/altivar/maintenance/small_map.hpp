// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A map of some parameters of each kind, as a drive of the family has them, and a drive on paper that fits it.
#pragma once

#include "altivar/maintenance/paper_drive.hpp"

#include <rtuwire/altivar/device/atv320.hpp>
// What its values mean, before a row is made of them.
#include <rtuwire/altivar/parameters/atv320/values/known.hpp>
#include <rtuwire/altivar/parameters/family_words.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>

namespace rtuwire::test {

namespace small {

inline constexpr reg<count16> cfg{.code = "CFG", .address = 3052, .mode = access::configuration, .name = "Macro"};
inline constexpr reg<count16> flr{.code = "FLR", .address = 3110, .mode = access::configuration, .name = "Catch"};
inline constexpr reg<count16> tac{.code = "TAC", .address = 3235, .name = "Time in alarm"};
inline constexpr reg<count16> ncv{.code = "NCV", .address = 3011, .mode = access::configuration, .name = "Rating"};
inline constexpr reg<count16> tun{.code = "TUN", .address = 9608, .mode = access::configuration, .name = "Autotune"};
inline constexpr reg<count16> nst{.code = "NST", .address = 11202, .mode = access::configuration, .name = "Freewheel"};
inline constexpr reg<count16> sp2{.code = "SP2", .address = 11410, .min = {0}, .max = {5990}, .name = "Speed 2"};
inline constexpr reg<count16> sp3{.code = "SP3", .address = 11411, .name = "Speed 3", .source = provenance::inferred};
inline constexpr reg<count16> sp4{.code = "SP4", .address = 11412, .name = "Speed 4"};
inline constexpr reg<count16> sp6{.code = "SP6", .address = 11414, .name = "Speed 6"};
inline constexpr reg<count16> stoa{.code = "STOA", .address = 15320, .mode = access::configuration, .name = "STO"};

using namespace altivar;
struct settings : parameter_list<cfg, atv320::tfr, atv320::hsp, atv320::lsp, atv320::acc, atv320::dec, atv320::inr, sp2,
                                 sp3, sp4, sp6> {};
struct others
    : parameter_list<ncv, flr, atv320::eta, atv320::rfr, tac, atv320::il1r, atv320::add, atv320::tbr, atv320::tfo,
                     atv320::tto, atv320::sll, atv320::atr, atv320::chcf, atv320::fr1, atv320::cd1, atv320::flo,
                     atv320::cmd, atv320::lfr, atv320::cmi, tun, atv320::tcc, nst, stoa> {};
inline constexpr parameter_group groups[]{group_of<settings>("settings"), group_of<others>("others")};

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
