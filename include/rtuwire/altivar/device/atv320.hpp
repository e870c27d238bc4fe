// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: its registers and the values of its enumerations, with the mnemonics of the display, from manual NVE41308
// (2016), which ends early, and public parameter files. Ramp times count in steps that INR sets.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/family.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
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
