// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: enumerations and words of bits of the parameters of inputs and outputs that are assigned to functions.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320_values {

// clang-format off
/// An input, or a state of the drive, that switches a function.
enum class logic_input : std::uint16_t {
    no = 0, flt = 1, fta = 4, f2a = 13, fr1 = 96, fr2 = 97, cd1 = 98, cd2 = 99, fr1b = 100, yes =
    128, li1 = 129, li2 = 130, li3 = 131, li4 = 132, li5 = 133, li6 = 134, lai1 = 143, lai2 = 144,
    cd00 = 160, cd01 = 161, cd02 = 162, cd03 = 163, cd04 = 164, cd05 = 165, cd06 = 166, cd07 = 167,
    cd08 = 168, cd09 = 169, cd10 = 170, cd11 = 171, cd12 = 172, cd13 = 173, cd14 = 174, cd15 = 175,
    c101 = 177, c102 = 178, c103 = 179, c104 = 180, c105 = 181, c106 = 182, c107 = 183, c108 = 184,
    c109 = 185, c110 = 186, c111 = 187, c112 = 188, c113 = 189, c114 = 190, c115 = 191, c201 = 193,
    c202 = 194, c203 = 195, c204 = 196, c205 = 197, c206 = 198, c207 = 199, c208 = 200, c209 = 201,
    c210 = 202, c211 = 203, c212 = 204, c213 = 205, c214 = 206, c215 = 207, c301 = 209, c302 = 210,
    c303 = 211, c304 = 212, c305 = 213, c306 = 214, c307 = 215, c308 = 216, c309 = 217, c310 = 218,
    c311 = 219, c312 = 220, c313 = 221, c314 = 222, c315 = 223, ol01 = 240, ol02 = 241, ol03 = 242,
    ol04 = 243, ol05 = 244, ol06 = 245, ol07 = 246, ol08 = 247, ol09 = 248, ol10 = 249,
};

/// What an output shows.
enum class logic_source : std::uint16_t {
    no = 0, flt = 1, run = 2, occ = 3, fta = 4, fla = 5, cta = 6, sra = 7, tsa = 8, blc = 9, pee =
    10, pfa = 11, f2a = 13, tad = 14, ula = 21, ola = 22, rsda = 27, ttha = 28, ttla = 29, mfrd =
    30, mrrs = 31, ts2 = 37, ts3 = 38, ats = 47, cnf0 = 48, cnf1 = 49, cnf2 = 50, cfp1 = 52, cfp2 =
    53, cfp3 = 54, dbl = 64, brs = 65, prm = 66, fqla = 72, llc = 73, mcp = 77, lsa = 78, dlda = 79,
    ag1 = 80, ag2 = 81, ag3 = 82, pla = 85, efa = 87, usa = 88, upa = 89, tha = 91, ssa = 95, fr1 =
    96, fr2 = 97, cd1 = 98, cd2 = 99, fr1b = 100, ebo = 101, tsy = 102, tja = 104, ap3 = 107, fn1 =
    116, fn2 = 117, fn3 = 118, fn4 = 119, rdy = 127, yes = 128, li1 = 129, li2 = 130, li3 = 131, li4
    = 132, li5 = 133, li6 = 134, lai1 = 143, lai2 = 144, cd00 = 160, cd01 = 161, cd02 = 162, cd03 =
    163, cd04 = 164, cd05 = 165, cd06 = 166, cd07 = 167, cd08 = 168, cd09 = 169, cd10 = 170, cd11 =
    171, cd12 = 172, cd13 = 173, cd14 = 174, cd15 = 175, c100 = 176, c101 = 177, c102 = 178, c103 =
    179, c104 = 180, c105 = 181, c106 = 182, c107 = 183, c108 = 184, c109 = 185, c110 = 186, c111 =
    187, c112 = 188, c113 = 189, c114 = 190, c115 = 191, c200 = 192, c201 = 193, c202 = 194, c203 =
    195, c204 = 196, c205 = 197, c206 = 198, c207 = 199, c208 = 200, c209 = 201, c210 = 202, c211 =
    203, c212 = 204, c213 = 205, c214 = 206, c215 = 207, c300 = 208, c301 = 209, c302 = 210, c303 =
    211, c304 = 212, c305 = 213, c306 = 214, c307 = 215, c308 = 216, c309 = 217, c310 = 218, c311 =
    219, c312 = 220, c313 = 221, c314 = 222, c315 = 223, ol01 = 240, ol02 = 241, ol03 = 242, ol04 =
    243, ol05 = 244, ol06 = 245, ol07 = 246, ol08 = 247, ol09 = 248, ol10 = 249, gdl = 250,
};
// clang-format on

} // namespace altivar::atv320_values

namespace altivar::atv320 {

using namespace atv320_values;

} // namespace altivar::atv320

// clang-format off
template <>
inline constexpr auto enumerators<altivar::atv320_values::logic_input> = detail::name_list<altivar::atv320_values::logic_input>({
    {0, "nO"}, {1, "FLt"}, {4, "FtA"}, {13, "F2A"}, {96, "FR1"}, {97, "FR2"}, {98, "CD1"}, {99, "CD2"},
    {100, "FR1B"}, {128, "YES"}, {129, "LI1"}, {130, "LI2"}, {131, "LI3"}, {132, "LI4"}, {133, "LI5"},
    {134, "LI6"}, {143, "LAI1"}, {144, "LAI2"}, {160, "CD00"}, {161, "CD01"}, {162, "CD02"}, {163, "CD03"},
    {164, "CD04"}, {165, "CD05"}, {166, "CD06"}, {167, "CD07"}, {168, "CD08"}, {169, "CD09"}, {170, "CD10"},
    {171, "CD11"}, {172, "CD12"}, {173, "CD13"}, {174, "CD14"}, {175, "CD15"}, {177, "C101"}, {178, "C102"},
    {179, "C103"}, {180, "C104"}, {181, "C105"}, {182, "C106"}, {183, "C107"}, {184, "C108"}, {185, "C109"},
    {186, "C110"}, {187, "C111"}, {188, "C112"}, {189, "C113"}, {190, "C114"}, {191, "C115"}, {193, "C201"},
    {194, "C202"}, {195, "C203"}, {196, "C204"}, {197, "C205"}, {198, "C206"}, {199, "C207"}, {200, "C208"},
    {201, "C209"}, {202, "C210"}, {203, "C211"}, {204, "C212"}, {205, "C213"}, {206, "C214"}, {207, "C215"},
    {209, "C301"}, {210, "C302"}, {211, "C303"}, {212, "C304"}, {213, "C305"}, {214, "C306"}, {215, "C307"},
    {216, "C308"}, {217, "C309"}, {218, "C310"}, {219, "C311"}, {220, "C312"}, {221, "C313"}, {222, "C314"},
    {223, "C315"}, {240, "OL01"}, {241, "OL02"}, {242, "OL03"}, {243, "OL04"}, {244, "OL05"}, {245, "OL06"},
    {246, "OL07"}, {247, "OL08"}, {248, "OL09"}, {249, "OL10"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::logic_input> = detail::name_list<altivar::atv320_values::logic_input>({
    {0, "not assigned"}, {1, "no fault present"}, {4, "frequency threshold reached"},
    {13, "frequency threshold 2 reached"}, {96, "reference channel 1 active"},
    {97, "reference channel 2 active"}, {98, "command channel 1 active"}, {99, "command channel 2 active"},
    {100, "reference channel 1B active"}, {128, "always"}, {129, "LI1"}, {130, "LI2"}, {131, "LI3"},
    {132, "LI4"}, {133, "LI5"}, {134, "LI6"}, {143, "AI1 as a logic input"}, {144, "AI2 as a logic input"},
    {160, "I/O profile: command bit 0"}, {161, "I/O profile: command bit 1"},
    {162, "I/O profile: command bit 2"}, {163, "I/O profile: command bit 3"},
    {164, "I/O profile: command bit 4"}, {165, "I/O profile: command bit 5"},
    {166, "I/O profile: command bit 6"}, {167, "I/O profile: command bit 7"},
    {168, "I/O profile: command bit 8"}, {169, "I/O profile: command bit 9"},
    {170, "I/O profile: command bit 10"}, {171, "I/O profile: command bit 11"},
    {172, "I/O profile: command bit 12"}, {173, "I/O profile: command bit 13"},
    {174, "I/O profile: command bit 14"}, {175, "I/O profile: command bit 15"},
    {177, "Modbus command word bit 1"}, {178, "Modbus command word bit 2"}, {179, "Modbus command word bit 3"},
    {180, "Modbus command word bit 4"}, {181, "Modbus command word bit 5"}, {182, "Modbus command word bit 6"},
    {183, "Modbus command word bit 7"}, {184, "Modbus command word bit 8"}, {185, "Modbus command word bit 9"},
    {186, "Modbus command word bit 10"}, {187, "Modbus command word bit 11"},
    {188, "Modbus command word bit 12"}, {189, "Modbus command word bit 13"},
    {190, "Modbus command word bit 14"}, {191, "Modbus command word bit 15"},
    {193, "CANopen command word bit 1"}, {194, "CANopen command word bit 2"},
    {195, "CANopen command word bit 3"}, {196, "CANopen command word bit 4"},
    {197, "CANopen command word bit 5"}, {198, "CANopen command word bit 6"},
    {199, "CANopen command word bit 7"}, {200, "CANopen command word bit 8"},
    {201, "CANopen command word bit 9"}, {202, "CANopen command word bit 10"},
    {203, "CANopen command word bit 11"}, {204, "CANopen command word bit 12"},
    {205, "CANopen command word bit 13"}, {206, "CANopen command word bit 14"},
    {207, "CANopen command word bit 15"}, {209, "card command word bit 1"}, {210, "card command word bit 2"},
    {211, "card command word bit 3"}, {212, "card command word bit 4"}, {213, "card command word bit 5"},
    {214, "card command word bit 6"}, {215, "card command word bit 7"}, {216, "card command word bit 8"},
    {217, "card command word bit 9"}, {218, "card command word bit 10"}, {219, "card command word bit 11"},
    {220, "card command word bit 12"}, {221, "card command word bit 13"}, {222, "card command word bit 14"},
    {223, "card command word bit 15"}, {240, "function block output OL01"}, {241, "function block output OL02"},
    {242, "function block output OL03"}, {243, "function block output OL04"},
    {244, "function block output OL05"}, {245, "function block output OL06"},
    {246, "function block output OL07"}, {247, "function block output OL08"},
    {248, "function block output OL09"}, {249, "function block output OL10"},
});
template <>
inline constexpr auto enumerators<altivar::atv320_values::logic_source> = detail::name_list<altivar::atv320_values::logic_source>({
    {0, "nO"}, {1, "FLt"}, {2, "rUn"}, {3, "OCC"}, {4, "FtA"}, {5, "FLA"}, {6, "CtA"}, {7, "SrA"}, {8, "tSA"},
    {9, "BLC"}, {10, "PEE"}, {11, "PFA"}, {13, "F2A"}, {14, "TAD"}, {21, "ULA"}, {22, "OLA"}, {27, "RSDA"},
    {28, "TTHA"}, {29, "TTLA"}, {30, "MFRD"}, {31, "MRRS"}, {37, "TS2"}, {38, "TS3"}, {47, "ATS"}, {48, "CnF0"},
    {49, "CnF1"}, {50, "CnF2"}, {52, "CFP1"}, {53, "CFP2"}, {54, "CFP3"}, {64, "DBL"}, {65, "BRS"}, {66, "PRM"},
    {72, "FQLA"}, {73, "LLC"}, {77, "MCP"}, {78, "LSA"}, {79, "DLDA"}, {80, "AG1"}, {81, "AG2"}, {82, "AG3"},
    {85, "PLA"}, {87, "EFA"}, {88, "USA"}, {89, "UPA"}, {91, "THA"}, {95, "SSA"}, {96, "FR1"}, {97, "FR2"},
    {98, "CD1"}, {99, "CD2"}, {100, "FR1B"}, {101, "EBO"}, {102, "TSY"}, {104, "TJA"}, {107, "AP3"},
    {116, "FN1"}, {117, "FN2"}, {118, "FN3"}, {119, "FN4"}, {127, "rdY"}, {128, "YES"}, {129, "LI1"},
    {130, "LI2"}, {131, "LI3"}, {132, "LI4"}, {133, "LI5"}, {134, "LI6"}, {143, "LAI1"}, {144, "LAI2"},
    {160, "CD00"}, {161, "CD01"}, {162, "CD02"}, {163, "CD03"}, {164, "CD04"}, {165, "CD05"}, {166, "CD06"},
    {167, "CD07"}, {168, "CD08"}, {169, "CD09"}, {170, "CD10"}, {171, "CD11"}, {172, "CD12"}, {173, "CD13"},
    {174, "CD14"}, {175, "CD15"}, {176, "C100"}, {177, "C101"}, {178, "C102"}, {179, "C103"}, {180, "C104"},
    {181, "C105"}, {182, "C106"}, {183, "C107"}, {184, "C108"}, {185, "C109"}, {186, "C110"}, {187, "C111"},
    {188, "C112"}, {189, "C113"}, {190, "C114"}, {191, "C115"}, {192, "C200"}, {193, "C201"}, {194, "C202"},
    {195, "C203"}, {196, "C204"}, {197, "C205"}, {198, "C206"}, {199, "C207"}, {200, "C208"}, {201, "C209"},
    {202, "C210"}, {203, "C211"}, {204, "C212"}, {205, "C213"}, {206, "C214"}, {207, "C215"}, {208, "C300"},
    {209, "C301"}, {210, "C302"}, {211, "C303"}, {212, "C304"}, {213, "C305"}, {214, "C306"}, {215, "C307"},
    {216, "C308"}, {217, "C309"}, {218, "C310"}, {219, "C311"}, {220, "C312"}, {221, "C313"}, {222, "C314"},
    {223, "C315"}, {240, "OL01"}, {241, "OL02"}, {242, "OL03"}, {243, "OL04"}, {244, "OL05"}, {245, "OL06"},
    {246, "OL07"}, {247, "OL08"}, {248, "OL09"}, {249, "OL10"}, {250, "GdL"},
});
template <>
inline constexpr auto meanings<altivar::atv320_values::logic_source> = detail::name_list<altivar::atv320_values::logic_source>({
    {0, "not assigned"}, {1, "no fault present"}, {2, "drive running"}, {3, "output contactor command"},
    {4, "frequency threshold reached"}, {5, "high speed reached"}, {6, "current threshold reached"},
    {7, "reference reached"}, {8, "motor thermal threshold reached"}, {9, "brake command"},
    {10, "PI error alarm"}, {11, "PI feedback alarm"}, {13, "frequency threshold 2 reached"},
    {14, "drive thermal threshold reached"}, {21, "underload alarm"}, {22, "overload alarm"},
    {27, "slack rope alarm"}, {28, "torque high alarm"}, {29, "torque low alarm"}, {30, "running forward"},
    {31, "running in reverse"}, {37, "motor 2 thermal threshold reached"},
    {38, "motor 3 thermal threshold reached"}, {47, "torque negative"}, {48, "configuration 0 active"},
    {49, "configuration 1 active"}, {50, "configuration 2 active"}, {52, "parameter set 1 active"},
    {53, "parameter set 2 active"}, {54, "parameter set 3 active"}, {64, "DC bus charged"}, {65, "braking"},
    {66, "power removed"}, {72, "frequency meter alarm"}, {73, "line contactor command"},
    {77, "motor current present"}, {78, "limit switch reached"}, {79, "load variation alarm"},
    {80, "alarm group 1"}, {81, "alarm group 2"}, {82, "alarm group 3"}, {85, "LI6 probe alarm"},
    {87, "external fault alarm"}, {88, "undervoltage alarm"}, {89, "undervoltage threshold reached"},
    {91, "drive thermal alarm"}, {95, "torque or current limit reached"}, {96, "reference channel 1 active"},
    {97, "reference channel 2 active"}, {98, "command channel 1 active"}, {99, "command channel 2 active"},
    {100, "reference channel 1B active"}, {101, "end of reel"}, {102, "wobble synchronisation"},
    {104, "transistor temperature alarm"}, {107, "AI3 signal lost"}, {116, "terminal key F1"},
    {117, "terminal key F2"}, {118, "terminal key F3"}, {119, "terminal key F4"}, {127, "drive ready"},
    {128, "always"}, {129, "LI1"}, {130, "LI2"}, {131, "LI3"}, {132, "LI4"}, {133, "LI5"}, {134, "LI6"},
    {143, "AI1 as a logic input"}, {144, "AI2 as a logic input"}, {160, "I/O profile: command bit 0"},
    {161, "I/O profile: command bit 1"}, {162, "I/O profile: command bit 2"},
    {163, "I/O profile: command bit 3"}, {164, "I/O profile: command bit 4"},
    {165, "I/O profile: command bit 5"}, {166, "I/O profile: command bit 6"},
    {167, "I/O profile: command bit 7"}, {168, "I/O profile: command bit 8"},
    {169, "I/O profile: command bit 9"}, {170, "I/O profile: command bit 10"},
    {171, "I/O profile: command bit 11"}, {172, "I/O profile: command bit 12"},
    {173, "I/O profile: command bit 13"}, {174, "I/O profile: command bit 14"},
    {175, "I/O profile: command bit 15"}, {176, "Modbus command word bit 0"},
    {177, "Modbus command word bit 1"}, {178, "Modbus command word bit 2"}, {179, "Modbus command word bit 3"},
    {180, "Modbus command word bit 4"}, {181, "Modbus command word bit 5"}, {182, "Modbus command word bit 6"},
    {183, "Modbus command word bit 7"}, {184, "Modbus command word bit 8"}, {185, "Modbus command word bit 9"},
    {186, "Modbus command word bit 10"}, {187, "Modbus command word bit 11"},
    {188, "Modbus command word bit 12"}, {189, "Modbus command word bit 13"},
    {190, "Modbus command word bit 14"}, {191, "Modbus command word bit 15"},
    {192, "CANopen command word bit 0"}, {193, "CANopen command word bit 1"},
    {194, "CANopen command word bit 2"}, {195, "CANopen command word bit 3"},
    {196, "CANopen command word bit 4"}, {197, "CANopen command word bit 5"},
    {198, "CANopen command word bit 6"}, {199, "CANopen command word bit 7"},
    {200, "CANopen command word bit 8"}, {201, "CANopen command word bit 9"},
    {202, "CANopen command word bit 10"}, {203, "CANopen command word bit 11"},
    {204, "CANopen command word bit 12"}, {205, "CANopen command word bit 13"},
    {206, "CANopen command word bit 14"}, {207, "CANopen command word bit 15"},
    {208, "card command word bit 0"}, {209, "card command word bit 1"}, {210, "card command word bit 2"},
    {211, "card command word bit 3"}, {212, "card command word bit 4"}, {213, "card command word bit 5"},
    {214, "card command word bit 6"}, {215, "card command word bit 7"}, {216, "card command word bit 8"},
    {217, "card command word bit 9"}, {218, "card command word bit 10"}, {219, "card command word bit 11"},
    {220, "card command word bit 12"}, {221, "card command word bit 13"}, {222, "card command word bit 14"},
    {223, "card command word bit 15"}, {240, "function block output OL01"}, {241, "function block output OL02"},
    {242, "function block output OL03"}, {243, "function block output OL04"},
    {244, "function block output OL05"}, {245, "function block output OL06"},
    {246, "function block output OL07"}, {247, "function block output OL08"},
    {248, "function block output OL09"}, {249, "function block output OL10"}, {250, "GDL"},
});
// clang-format on

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
