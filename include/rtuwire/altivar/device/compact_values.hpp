// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The values of the enumerations of the ATV12 and the ATV310, with the mnemonics of the display.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::compact {

// clang-format off
/// The line's bit rate.
enum class serial_rate : std::uint16_t { baud_4800 = 24, baud_9600 = 28, baud_19200 = 32, baud_38400 = 36 };

/// The line's character format.
enum class serial_format : std::uint16_t { odd_8_1 = 2, even_8_1 = 3, none_8_1 = 4, none_8_2 = 5 };

/// What switches to local control.
enum class local_input : std::uint16_t {
    no = 0, flt = 1, run = 2, fta = 4, fla = 5, cta = 6, sra = 7, tsa = 8, pee = 10, pfa = 11,
    ula = 21, ola = 22, ap1 = 123, pmp = 126, li1 = 129, li2 = 130, li3 = 131, li4 = 132,
    l1l = 145, l2l = 146, l3l = 147, l4l = 148,
};

/// Where the reference comes from.
enum class reference_channel : std::uint16_t {
    no = 0, ai1 = 1, ocr = 129, ofr = 130, orp = 131, ops = 135, opf = 136, ope = 137, opr = 139,
    thr = 140, thd = 141, lcc = 163, mdb = 164, aiu1 = 183,
};

/// Where commands come from.
enum class command_channel : std::uint16_t { ter = 1, loc = 2, lcc = 3, mdb = 10 };

/// Whether command and reference share a channel.
enum class channel_mode : std::uint16_t { sim = 1, sep = 2 };

/// How the motor is stopped.
enum class stop_mode : std::uint16_t { rmp = 0, fst = 8, nst = 13 };

/// What a lost link does.
enum class link_lost_reaction : std::uint16_t { no = 0, yes = 1, lff = 4 };

/// How the terminals command.
enum class control_mode : std::uint16_t { two_wire = 0, three_wire = 1 };

/// What the drive is doing.
enum class product_state : std::uint16_t {
    tun = 0, dcb = 1, rdy = 2, nst = 3, run = 4, acc = 5, dec = 6, cli = 7, fst = 8, nlp = 11,
    ctl = 13, obr = 14, flt = 23, frf = 24, rem = 31, loc = 32,
};

/// Why the drive tripped.
enum class fault_code : std::uint16_t {
    nof = 0, inf = 1, cff = 3, cfi = 4, slf1 = 5, epf1 = 8, ocf = 9, crf1 = 10, ohf = 16, olf = 17,
    obf = 18, osf = 19, opf1 = 20, phf = 21, usf = 22, scf1 = 23, sof = 24, tnf = 25, inf1 = 26,
    inf2 = 27, inf3 = 28, inf4 = 29, scf3 = 32, opf2 = 33, slf2 = 42, slf3 = 45, inf9 = 51,
    infb = 53, tjf = 54, scf4 = 55, scf5 = 56, infe = 69, cfi2 = 77, ulf = 100, olc = 101,
    spif = 102, lff1 = 106, xxxx = 253,
};

/// The drive's size.
enum class rating : std::uint16_t {
    no = 0, u010 = 1, u018 = 2, u025 = 3, u037 = 4, u055 = 5, u075 = 6, u090 = 7, u110 = 8,
    u150 = 9, u185 = 10, u220 = 11, u300 = 12, u370 = 13, u400 = 14, u550 = 15, u750 = 16,
};

/// The drive's supply.
enum class mains : std::uint16_t { no = 0, v110m = 1, v110t = 2, v220m = 3, v220t = 4 };
// clang-format on

} // namespace altivar::compact

// clang-format off
template <> inline constexpr auto enumerators<altivar::compact::serial_rate> = detail::name_list({
    {24, "4800"}, {28, "9600"}, {32, "19200"}, {36, "38400"},
});
template <> inline constexpr auto enumerators<altivar::compact::serial_format> = detail::name_list({
    {2, "8O1"}, {3, "8E1"}, {4, "8n1"}, {5, "8n2"},
});
template <> inline constexpr auto enumerators<altivar::compact::local_input> = detail::name_list({
    {0, "nO"}, {1, "FLt"}, {2, "rUn"}, {4, "FtA"}, {5, "FLA"}, {6, "CtA"}, {7, "SrA"}, {8, "tSA"},
    {10, "PEE"}, {11, "PFA"}, {21, "ULA"}, {22, "OLA"}, {123, "AP1"}, {126, "PMP"}, {129, "LI1"},
    {130, "LI2"}, {131, "LI3"}, {132, "LI4"}, {145, "L1L"}, {146, "L2L"}, {147, "L3L"},
    {148, "L4L"},
});
template <> inline constexpr auto enumerators<altivar::compact::reference_channel> = detail::name_list({
    {0, "nO"}, {1, "AI1"}, {129, "OCr"}, {130, "OFr"}, {131, "OrP"}, {135, "OPS"}, {136, "OPF"},
    {137, "OPE"}, {139, "OPr"}, {140, "tHr"}, {141, "tHd"}, {163, "LCC"}, {164, "Mdb"},
    {183, "AIU1"},
});
template <> inline constexpr auto enumerators<altivar::compact::command_channel> = detail::name_list({
    {1, "tEr"}, {2, "LOC"}, {3, "LCC"}, {10, "Mdb"},
});
template <> inline constexpr auto enumerators<altivar::compact::channel_mode> = detail::name_list({
    {1, "SIM"}, {2, "SEP"},
});
template <> inline constexpr auto enumerators<altivar::compact::stop_mode> = detail::name_list({
    {0, "rMP"}, {8, "FSt"}, {13, "nSt"},
});
template <> inline constexpr auto enumerators<altivar::compact::link_lost_reaction> = detail::name_list({
    {0, "nO"}, {1, "YES"}, {4, "LFF"},
});
template <> inline constexpr auto enumerators<altivar::compact::control_mode> = detail::name_list({
    {0, "2C"}, {1, "3C"},
});
template <> inline constexpr auto enumerators<altivar::compact::product_state> = detail::name_list({
    {0, "tUn"}, {1, "dCb"}, {2, "rdY"}, {3, "nSt"}, {4, "rUn"}, {5, "ACC"}, {6, "dEC"}, {7, "CLI"},
    {8, "FSt"}, {11, "nLP"}, {13, "CtL"}, {14, "Obr"}, {23, "FLt"}, {24, "FrF"}, {31, "rEM"},
    {32, "LOC"},
});
template <> inline constexpr auto meanings<altivar::compact::product_state> = detail::name_list({
    {0, "tuning"}, {1, "DC injection braking"}, {2, "ready"}, {3, "freewheel stop"}, {4, "running"},
    {5, "accelerating"}, {6, "decelerating"}, {7, "in current limit"}, {8, "fast stop"}, {11, "no mains power"},
    {13, "controlled stop"}, {14, "ramp adapted"}, {23, "in fault"}, {24, "fallback speed"},
});
template <> inline constexpr auto enumerators<altivar::compact::fault_code> = detail::name_list({
    {0, "nOF"}, {1, "InF"}, {3, "CFF"}, {4, "CFI"}, {5, "SLF1"}, {8, "EPF1"}, {9, "OCF"},
    {10, "CrF1"}, {16, "OHF"}, {17, "OLF"}, {18, "ObF"}, {19, "OSF"}, {20, "OPF1"}, {21, "PHF"},
    {22, "USF"}, {23, "SCF1"}, {24, "SOF"}, {25, "tnF"}, {26, "InF1"}, {27, "InF2"}, {28, "InF3"},
    {29, "InF4"}, {32, "SCF3"}, {33, "OPF2"}, {42, "SLF2"}, {45, "SLF3"}, {51, "InF9"},
    {53, "InFb"}, {54, "tJF"}, {55, "SCF4"}, {56, "SCF5"}, {69, "InFE"}, {77, "CFI2"},
    {100, "ULF"}, {101, "OLC"}, {102, "SPIF"}, {106, "LFF1"}, {253, "XXXX"},
});
template <> inline constexpr auto meanings<altivar::compact::fault_code> = detail::name_list({
    {0, "no fault"}, {1, "internal fault"}, {3, "incorrect configuration"}, {4, "invalid configuration"},
    {5, "Modbus interrupted"}, {8, "external fault by an input"}, {9, "overcurrent"}, {10, "precharge failed"},
    {16, "drive overheated"}, {17, "motor overloaded"}, {18, "DC bus overvoltage"},
    {19, "mains overvoltage"}, {20, "one motor phase lost"}, {21, "mains phase lost"}, {22, "mains undervoltage"},
    {23, "motor short circuit"}, {24, "motor overspeed"}, {25, "tuning failed"}, {26, "drive rating unknown"},
    {27, "power card incompatible"}, {28, "internal link interrupted"}, {29, "manufacturing data inconsistent"},
    {32, "short circuit to earth"}, {33, "three motor phases lost"}, {42, "PC software interrupted"},
    {45, "remote terminal interrupted"}, {51, "current measurement failed"}, {53, "temperature sensor failed"},
    {54, "power transistors overheated"}, {55, "power transistor short circuit"}, {56, "short circuit at the output"},
    {69, "processor failed"}, {77, "configuration transfer interrupted"}, {100, "process underloaded"},
    {101, "process overloaded"}, {102, "PI feedback lost"}, {106, "current loop of AI1 lost"},
});
template <> inline constexpr auto enumerators<altivar::compact::rating> = detail::name_list({
    {0, "nO"}, {1, "U010"}, {2, "U018"}, {3, "U025"}, {4, "U037"}, {5, "U055"}, {6, "U075"},
    {7, "U090"}, {8, "U110"}, {9, "U150"}, {10, "U185"}, {11, "U220"}, {12, "U300"}, {13, "U370"},
    {14, "U400"}, {15, "U550"}, {16, "U750"},
});
template <> inline constexpr auto enumerators<altivar::compact::mains> = detail::name_list({
    {0, "nO"}, {1, "110M"}, {2, "110t"}, {3, "220M"}, {4, "220t"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
