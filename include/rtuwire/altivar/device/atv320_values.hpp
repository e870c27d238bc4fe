// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The values of the enumerations of the ATV320, with the mnemonics of the display.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320 {

// clang-format off
/// The line's bit rate.
enum class serial_rate : std::uint16_t {
    no = 0, auto_ = 4, baud_300 = 8, baud_600 = 12, baud_1200 = 16, baud_2400 = 20, baud_4800 = 24,
    baud_9600 = 28, baud_10000 = 30, baud_19200 = 32, baud_20000 = 34, baud_28800 = 35,
    baud_38400 = 36, baud_45450 = 37, baud_50000 = 38, baud_57600 = 40, baud_93750 = 42,
    baud_100k = 44, baud_115k2 = 48, baud_125k = 52, baud_156k = 53, baud_187k5 = 54,
    baud_230k4 = 56, baud_250k = 60, baud_460k8 = 64, baud_500k = 68, baud_625k = 69,
    baud_800k = 70, baud_921k6 = 72, baud_1m = 76, baud_1m5 = 80, baud_2m5 = 81, baud_3m = 82,
    baud_6m = 83, baud_10m = 84, baud_5m = 86, baud_12m = 88, baud_100m = 92,
};

/// The line's character format.
enum class serial_format : std::uint16_t {
    no = 0, auto_ = 1, odd_8_1 = 2, even_8_1 = 3, none_8_1 = 4, none_8_2 = 5, odd_7_1 = 6,
    even_7_1 = 7, odd_7_2 = 8, even_7_2 = 9,
};

/// Where the reference comes from.
enum class reference_channel : std::uint16_t {
    no = 0, ai1 = 1, ai2 = 2, ai3 = 3, ocr = 129, ofr = 130, orp = 131, trq = 132, stq = 133,
    ors = 134, ops = 135, opf = 136, ope = 137, opi = 138, opr = 139, thr = 140, thd = 141,
    tqms = 142, updt = 160, updh = 161, lcc = 163, mdb = 164, can = 167, net = 169, ofs = 173,
    thr2 = 174, thr3 = 175, tql = 179, uop = 180, pi = 181, aiv1 = 183, do1 = 184, aiv2 = 185,
    oa01 = 240, oa02 = 241, oa03 = 242, oa04 = 243, oa05 = 244, oa06 = 245, oa07 = 246, oa08 = 247,
    oa09 = 248, oa10 = 249,
};

/// Where commands come from.
enum class command_channel : std::uint16_t { ter = 1, loc = 2, lcc = 3, mdb = 10, can = 20, net = 30 };

/// Whether command and reference share a channel.
enum class channel_mode : std::uint16_t { sim = 1, sep = 2, io = 3 };

/// How the motor is stopped.
enum class stop_mode : std::uint16_t { rmp = 0, fst = 1, nst = 2, dci = 3 };

/// What a lost link does.
enum class link_lost_reaction : std::uint16_t {
    no = 0, yes = 1, stt = 2, lff = 4, rls = 5, rmp = 6, fst = 7, dci = 8,
};

/// How the terminals command.
enum class control_mode : std::uint16_t { two_wire = 0, three_wire = 1 };

/// A switch.
enum class no_yes : std::uint16_t { no = 0, yes = 1 };

/// How "disable operation" stops the motor.
enum class disable_stop : std::uint16_t { freewheel = 0, ramp = 1 };

/// What the drive is doing.
enum class product_state : std::uint16_t {
    tun = 0, dcb = 1, rdy = 2, nst = 3, run = 4, acc = 5, dec = 6, cli = 7, fst = 8, flu = 9,
    nlp = 11, pra = 12, ctl = 13, obr = 14, soc = 15, usa = 17, tc = 18, st = 19, fa = 20, ok = 21,
    ep = 22, flt = 23, dcp = 25, ss1 = 28, sls = 29, sto = 30, sms = 31, gdl = 32,
};

/// Why the drive tripped.
enum class fault_code : std::uint16_t {
    nof = 0, eef1 = 2, cff = 3, cfi = 4, slf1 = 5, ilf = 6, cnf = 7, epf1 = 8, ocf = 9, crf1 = 10,
    spf = 11, anf = 12, ohf = 16, olf = 17, obf = 18, osf = 19, opf1 = 20, phf = 21, usf = 22,
    scf1 = 23, sof = 24, tnf = 25, inf1 = 26, inf2 = 27, inf3 = 28, inf4 = 29, eef2 = 30,
    scf3 = 32, opf2 = 33, cof = 34, blf = 35, epf2 = 38, brf = 41, slf2 = 42, ssf = 44, slf3 = 45,
    ptfl = 49, otfl = 50, inf9 = 51, infa = 52, infb = 53, tjf = 54, scf4 = 55, scf5 = 56,
    fcf1 = 58, fcf2 = 59, lcf = 64, hdf = 67, inf6 = 68, infe = 69, lff3 = 71, hcf = 73, dlf = 76,
    cfi2 = 77, csf = 99, ulf = 100, olc = 101, asf = 105, saff = 107, fbe = 108, fbes = 109,
};

/// The drive's size.
enum class rating : std::uint16_t {
    no = 0, u010 = 1, u018 = 2, u025 = 3, u037 = 4, u055 = 5, u075 = 6, u090 = 7, u110 = 8,
    u150 = 9, u185 = 10, u220 = 11, u300 = 12, u370 = 13, u400 = 14, u550 = 15, u750 = 16,
    u900 = 17, d110 = 18, d150 = 19, d185 = 20, d220 = 21, d300 = 22,
};

/// The drive's supply.
enum class mains : std::uint16_t {
    no = 0, v110m = 1, v110t = 2, v220m = 3, v220t = 4, v480m = 5, v480t = 6, v690m = 7, v690t = 8,
    v600m = 9, v600t = 10,
};

/// How long one count of a ramp time is.
enum class ramp_step : std::uint16_t { hundredths = 0, tenths = 1, whole = 2 };
// clang-format on

} // namespace altivar::atv320

// clang-format off
template <> inline constexpr auto enumerators<altivar::atv320::serial_rate> = detail::name_list({
    {0, "nO"}, {4, "AUtO"}, {8, "300"}, {12, "600"}, {16, "1200"}, {20, "2400"}, {24, "4800"},
    {28, "9600"}, {30, "10000"}, {32, "19200"}, {34, "20000"}, {35, "28800"}, {36, "38400"},
    {37, "45450"}, {38, "50000"}, {40, "57600"}, {42, "93750"}, {44, "100K"}, {48, "115K2"},
    {52, "125K"}, {53, "156K"}, {54, "187K5"}, {56, "230K4"}, {60, "250K"}, {64, "460K8"},
    {68, "500K"}, {69, "625K"}, {70, "800K"}, {72, "921K6"}, {76, "1M"}, {80, "1M5"}, {81, "2M5"},
    {82, "3M"}, {83, "6M"}, {84, "10M"}, {86, "5M"}, {88, "12M"}, {92, "100M"},
});
template <> inline constexpr auto enumerators<altivar::atv320::serial_format> = detail::name_list({
    {0, "nO"}, {1, "AUtO"}, {2, "8O1"}, {3, "8E1"}, {4, "8n1"}, {5, "8n2"}, {6, "7O1"}, {7, "7E1"},
    {8, "7O2"}, {9, "7E2"},
});
template <> inline constexpr auto enumerators<altivar::atv320::reference_channel> = detail::name_list({
    {0, "nO"}, {1, "AI1"}, {2, "AI2"}, {3, "AI3"}, {129, "OCr"}, {130, "OFr"}, {131, "OrP"},
    {132, "trq"}, {133, "Stq"}, {134, "OrS"}, {135, "OPS"}, {136, "OPF"}, {137, "OPE"},
    {138, "OPI"}, {139, "OPr"}, {140, "tHr"}, {141, "tHd"}, {142, "tqMS"}, {160, "UPdt"},
    {161, "UPdH"}, {163, "LCC"}, {164, "Mdb"}, {167, "CAn"}, {169, "nEt"}, {173, "OFS"},
    {174, "tHr2"}, {175, "tHr3"}, {179, "tqL"}, {180, "UOP"}, {181, "PI"}, {183, "AIV1"},
    {184, "dO1"}, {185, "AIV2"}, {240, "OA01"}, {241, "OA02"}, {242, "OA03"}, {243, "OA04"},
    {244, "OA05"}, {245, "OA06"}, {246, "OA07"}, {247, "OA08"}, {248, "OA09"}, {249, "OA10"},
});
template <> inline constexpr auto enumerators<altivar::atv320::command_channel> = detail::name_list({
    {1, "tEr"}, {2, "LOC"}, {3, "LCC"}, {10, "Mdb"}, {20, "CAn"}, {30, "nEt"},
});
template <> inline constexpr auto enumerators<altivar::atv320::channel_mode> = detail::name_list({
    {1, "SIM"}, {2, "SEP"}, {3, "IO"},
});
template <> inline constexpr auto enumerators<altivar::atv320::stop_mode> = detail::name_list({
    {0, "rMP"}, {1, "FSt"}, {2, "nSt"}, {3, "dCI"},
});
template <> inline constexpr auto enumerators<altivar::atv320::link_lost_reaction> = detail::name_list({
    {0, "nO"}, {1, "YES"}, {2, "Stt"}, {4, "LFF"}, {5, "rLS"}, {6, "rMP"}, {7, "FSt"}, {8, "dCI"},
});
template <> inline constexpr auto enumerators<altivar::atv320::control_mode> = detail::name_list({
    {0, "2C"}, {1, "3C"},
});
template <> inline constexpr auto enumerators<altivar::atv320::no_yes> = detail::name_list({{0, "nO"}, {1, "YES"}});
template <> inline constexpr auto enumerators<altivar::atv320::disable_stop> = detail::name_list({
    {0, "nSt"}, {1, "rMP"},
});
template <> inline constexpr auto enumerators<altivar::atv320::product_state> = detail::name_list({
    {0, "tUn"}, {1, "dCb"}, {2, "rdY"}, {3, "nSt"}, {4, "rUn"}, {5, "ACC"}, {6, "dEC"}, {7, "CLI"},
    {8, "FSt"}, {9, "FLU"}, {11, "nLP"}, {12, "PrA"}, {13, "CtL"}, {14, "Obr"}, {15, "SOC"},
    {17, "USA"}, {18, "tC"}, {19, "St"}, {20, "FA"}, {21, "OK"}, {22, "EP"}, {23, "FLt"},
    {25, "dCP"}, {28, "SS1"}, {29, "SLS"}, {30, "StO"}, {31, "SMS"}, {32, "GdL"},
});
template <> inline constexpr auto meanings<altivar::atv320::product_state> = detail::name_list({
    {0, "tuning"}, {1, "DC injection braking"}, {2, "ready"}, {3, "freewheel stop"}, {4, "running"},
    {5, "accelerating"}, {6, "decelerating"}, {7, "in current limit"}, {8, "fast stop"}, {9, "fluxing the motor"},
    {11, "no mains power"}, {12, "power removed"}, {13, "controlled stop"}, {14, "ramp adapted"},
    {15, "output cut off"}, {17, "undervoltage alarm"}, {18, "test under way"}, {19, "self-test"},
    {20, "self-test failed"}, {21, "self-test passed"}, {22, "memory test"}, {23, "in fault"}, {28, "safe stop 1"},
    {29, "safely limited speed"}, {30, "safe torque off"},
});
template <> inline constexpr auto enumerators<altivar::atv320::fault_code> = detail::name_list({
    {0, "nOF"}, {2, "EEF1"}, {3, "CFF"}, {4, "CFI"}, {5, "SLF1"}, {6, "ILF"}, {7, "CnF"},
    {8, "EPF1"}, {9, "OCF"}, {10, "CrF1"}, {11, "SPF"}, {12, "AnF"}, {16, "OHF"}, {17, "OLF"},
    {18, "ObF"}, {19, "OSF"}, {20, "OPF1"}, {21, "PHF"}, {22, "USF"}, {23, "SCF1"}, {24, "SOF"},
    {25, "tnF"}, {26, "InF1"}, {27, "InF2"}, {28, "InF3"}, {29, "InF4"}, {30, "EEF2"},
    {32, "SCF3"}, {33, "OPF2"}, {34, "COF"}, {35, "bLF"}, {38, "EPF2"}, {41, "brF"}, {42, "SLF2"},
    {44, "SSF"}, {45, "SLF3"}, {49, "PtFL"}, {50, "OtFL"}, {51, "InF9"}, {52, "InFA"},
    {53, "InFb"}, {54, "tJF"}, {55, "SCF4"}, {56, "SCF5"}, {58, "FCF1"}, {59, "FCF2"}, {64, "LCF"},
    {67, "HdF"}, {68, "InF6"}, {69, "InFE"}, {71, "LFF3"}, {73, "HCF"}, {76, "dLF"}, {77, "CFI2"},
    {99, "CSF"}, {100, "ULF"}, {101, "OLC"}, {105, "ASF"}, {107, "SAFF"}, {108, "FbE"},
    {109, "FbES"},
});
template <> inline constexpr auto meanings<altivar::atv320::fault_code> = detail::name_list({
    {0, "no fault"}, {2, "control memory failed"}, {3, "incorrect configuration"}, {4, "invalid configuration"},
    {5, "Modbus interrupted"}, {6, "internal link to the option interrupted"}, {7, "network fault"},
    {8, "external fault by an input"}, {9, "overcurrent"}, {10, "precharge failed"}, {11, "speed feedback lost"},
    {12, "speed does not follow the reference"}, {16, "drive overheated"}, {17, "motor overloaded"},
    {18, "DC bus overvoltage"}, {19, "mains overvoltage"}, {20, "one motor phase lost"},
    {21, "mains phase lost"}, {22, "mains undervoltage"}, {23, "motor short circuit"}, {24, "motor overspeed"},
    {25, "tuning failed"}, {26, "drive rating unknown"}, {27, "power card incompatible"},
    {28, "internal link interrupted"}, {29, "manufacturing data inconsistent"}, {30, "power memory failed"},
    {32, "short circuit to earth"}, {33, "three motor phases lost"}, {34, "CANopen interrupted"},
    {35, "brake control failed"}, {38, "external fault by the line"}, {41, "brake feedback wrong"},
    {42, "PC software interrupted"}, {44, "torque or current limit reached"}, {45, "remote terminal interrupted"},
    {49, "motor temperature probe failed"}, {50, "motor overheated by its probe"}, {51, "current measurement failed"},
    {52, "mains measurement failed"}, {53, "temperature sensor failed"}, {54, "power transistors overheated"},
    {55, "power transistor short circuit"}, {56, "short circuit at the output"},
    {58, "output contactor stuck closed"}, {59, "output contactor stuck open"}, {64, "input contactor failed"},
    {67, "power transistors desaturated"}, {68, "option card failed"}, {69, "processor failed"},
    {71, "current loop of AI3 lost"}, {73, "cards do not belong together"}, {76, "dynamic load fault"},
    {77, "configuration transfer interrupted"}, {99, "channel switching failed"}, {100, "process underloaded"},
    {101, "process overloaded"}, {105, "motor angle not found"}, {107, "safety function fault"},
    {108, "function block fault"}, {109, "function blocks stopped"},
});
template <> inline constexpr auto enumerators<altivar::atv320::rating> = detail::name_list({
    {0, "nO"}, {1, "U010"}, {2, "U018"}, {3, "U025"}, {4, "U037"}, {5, "U055"}, {6, "U075"},
    {7, "U090"}, {8, "U110"}, {9, "U150"}, {10, "U185"}, {11, "U220"}, {12, "U300"}, {13, "U370"},
    {14, "U400"}, {15, "U550"}, {16, "U750"}, {17, "U900"}, {18, "d110"}, {19, "d150"},
    {20, "d185"}, {21, "d220"}, {22, "d300"},
});
template <> inline constexpr auto enumerators<altivar::atv320::mains> = detail::name_list({
    {0, "nO"}, {1, "110M"}, {2, "110t"}, {3, "220M"}, {4, "220t"}, {5, "480M"}, {6, "480t"},
    {7, "690M"}, {8, "690t"}, {9, "600M"}, {10, "600t"},
});
template <> inline constexpr auto enumerators<altivar::atv320::ramp_step> = detail::name_list({
    {0, "001"}, {1, "01"}, {2, "1"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
