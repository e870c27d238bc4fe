// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: what the values of its enumerations mean that the registers for driving have, and the choices that parameters of
// several menus have.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/family_words.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

// clang-format off
template <> inline constexpr auto detail::words_of<altivar::atv320::rating> = detail::name_list({
    {0, "unknown"}, {1, "0.10 kW"}, {2, "0.18 kW"}, {3, "0.25 kW"}, {4, "0.37 kW"}, {5, "0.55 kW"},
    {6, "0.75 kW"}, {7, "0.90 kW"}, {8, "1.1 kW"}, {9, "1.5 kW"}, {10, "1.85 kW"}, {11, "2.2 kW"},
    {12, "3.0 kW"}, {13, "3.7 kW"}, {14, "4.0 kW"}, {15, "5.5 kW"}, {16, "7.5 kW"}, {17, "9.0 kW"},
    {18, "11 kW"}, {19, "15 kW"}, {20, "18.5 kW"}, {21, "22 kW"}, {22, "30 kW"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::mains> = detail::name_list({
    {0, "unknown"}, {1, "100-120 V, one phase"}, {2, "100-120 V, three phases"}, {3, "200-240 V, one phase"},
    {4, "200-240 V, three phases"}, {5, "380-500 V, one phase"}, {6, "380-500 V, three phases"},
    {7, "525-600 V, one phase"}, {8, "525-600 V, three phases"}, {9, "600 V, one phase"},
    {10, "600 V, three phases"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::disable_stop> = detail::name_list({
    {0, "freewheel"}, {1, "ramp"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::no_yes> = detail::name_list({
    {0, "no"}, {1, "yes"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::control_mode> = detail::name_list({
    {0, "2-wire"}, {1, "3-wire"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::reference_channel> = detail::name_list({
    {0, "not assigned"}, {1, "AI1"}, {2, "AI2"}, {3, "AI3"}, {129, "motor current"}, {130, "output frequency"},
    {131, "ramp output"}, {132, "motor torque"}, {133, "motor torque, signed"}, {134, "ramp output, signed"},
    {135, "PI reference"}, {136, "PI feedback"}, {137, "PI error"}, {138, "PI output"}, {139, "motor power"},
    {140, "motor thermal state"}, {141, "drive thermal state"}, {142, "torque of master and slave"},
    {160, "+/- speed by logic inputs"}, {161, "+/- speed by the keypad"}, {163, "remote terminal"},
    {164, "Modbus"}, {167, "CANopen"}, {169, "communication card"}, {173, "output frequency, signed"},
    {174, "motor 2 thermal state"}, {175, "motor 3 thermal state"}, {179, "torque limit"},
    {180, "motor voltage"}, {181, "pulse input"}, {183, "virtual analog input 1"}, {184, "logic output on AO1"},
    {185, "virtual analog input 2"}, {240, "function block output OA01"}, {241, "function block output OA02"},
    {242, "function block output OA03"}, {243, "function block output OA04"},
    {244, "function block output OA05"}, {245, "function block output OA06"},
    {246, "function block output OA07"}, {247, "function block output OA08"},
    {248, "function block output OA09"}, {249, "function block output OA10"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::channel_mode> = detail::name_list({
    {1, "command and reference together"}, {2, "command and reference apart"}, {3, "I/O profile"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::command_channel> = detail::name_list({
    {1, "terminals"}, {2, "local keypad"}, {3, "remote terminal"}, {10, "Modbus"}, {20, "CANopen"},
    {30, "communication card"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::ramp_step> = detail::name_list({
    {0, "0.01 s"}, {1, "0.1 s"}, {2, "1 s"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::stop_mode> = detail::name_list({
    {0, "ramp"}, {1, "fast stop"}, {2, "freewheel"}, {3, "DC injection"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::link_lost_reaction> = detail::name_list({
    {0, "ignored"}, {1, "freewheel stop"}, {2, "stop as STT says"}, {4, "fallback speed"},
    {5, "speed maintained"}, {6, "ramp stop"}, {7, "fast stop"}, {8, "DC injection stop"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::serial_rate> = detail::name_list({
    {0, "not set"}, {4, "found automatically"}, {8, "300 bit/s"}, {12, "600 bit/s"}, {16, "1200 bit/s"},
    {20, "2400 bit/s"}, {24, "4800 bit/s"}, {28, "9600 bit/s"}, {30, "10000 bit/s"}, {32, "19200 bit/s"},
    {34, "20000 bit/s"}, {35, "28800 bit/s"}, {36, "38400 bit/s"}, {37, "45450 bit/s"}, {38, "50000 bit/s"},
    {40, "57600 bit/s"}, {42, "93750 bit/s"}, {44, "100 kbit/s"}, {48, "115.2 kbit/s"}, {52, "125 kbit/s"},
    {53, "156 kbit/s"}, {54, "187.5 kbit/s"}, {56, "230.4 kbit/s"}, {60, "250 kbit/s"}, {64, "460.8 kbit/s"},
    {68, "500 kbit/s"}, {69, "625 kbit/s"}, {70, "800 kbit/s"}, {72, "921.6 kbit/s"}, {76, "1 Mbit/s"},
    {80, "1.5 Mbit/s"}, {81, "2.5 Mbit/s"}, {82, "3 Mbit/s"}, {83, "6 Mbit/s"}, {84, "10 Mbit/s"},
    {86, "5 Mbit/s"}, {88, "12 Mbit/s"}, {92, "100 Mbit/s"},
});
template <> inline constexpr auto detail::words_of<altivar::atv320::serial_format> = detail::name_list({
    {0, "not set"}, {1, "found automatically"}, {2, "8O1"}, {3, "8E1"}, {4, "8N1"}, {5, "8N2"}, {6, "7O1"},
    {7, "7E1"}, {8, "7O2"}, {9, "7E2"},
});
// clang-format on

namespace altivar::atv320::rows {

// clang-format off
using namespace roles;

inline constexpr row_access ro{access::read_only, provenance::inferred};
inline constexpr row_access rw{access::read_write, provenance::inferred};
inline constexpr row_access cfg{access::configuration, provenance::inferred};
// What a register may point at: an input, a measurement, a reference.
inline constexpr auto const& signal_source = in<reference_channel>;
// What a fault does; the same list as for a lost link.
inline constexpr auto const& fault_reaction = in<link_lost_reaction>;
// An input, or a state of the drive, that switches a function.
inline constexpr choice logic_input[]{
    {0, "nO", "not assigned"}, {1, "FLt", "no fault present"}, {4, "FtA", "frequency threshold reached"},
    {13, "F2A", "frequency threshold 2 reached"}, {96, "FR1", "reference channel 1 active"},
    {97, "FR2", "reference channel 2 active"}, {98, "CD1", "command channel 1 active"},
    {99, "CD2", "command channel 2 active"}, {100, "FR1B", "reference channel 1B active"},
    {128, "YES", "always"}, {129, "LI1", "LI1"}, {130, "LI2", "LI2"}, {131, "LI3", "LI3"},
    {132, "LI4", "LI4"}, {133, "LI5", "LI5"}, {134, "LI6", "LI6"}, {143, "LAI1", "AI1 as a logic input"},
    {144, "LAI2", "AI2 as a logic input"}, {160, "CD00", "I/O profile: command bit 0"},
    {161, "CD01", "I/O profile: command bit 1"}, {162, "CD02", "I/O profile: command bit 2"},
    {163, "CD03", "I/O profile: command bit 3"}, {164, "CD04", "I/O profile: command bit 4"},
    {165, "CD05", "I/O profile: command bit 5"}, {166, "CD06", "I/O profile: command bit 6"},
    {167, "CD07", "I/O profile: command bit 7"}, {168, "CD08", "I/O profile: command bit 8"},
    {169, "CD09", "I/O profile: command bit 9"}, {170, "CD10", "I/O profile: command bit 10"},
    {171, "CD11", "I/O profile: command bit 11"}, {172, "CD12", "I/O profile: command bit 12"},
    {173, "CD13", "I/O profile: command bit 13"}, {174, "CD14", "I/O profile: command bit 14"},
    {175, "CD15", "I/O profile: command bit 15"}, {177, "C101", "Modbus command word bit 1"},
    {178, "C102", "Modbus command word bit 2"}, {179, "C103", "Modbus command word bit 3"},
    {180, "C104", "Modbus command word bit 4"}, {181, "C105", "Modbus command word bit 5"},
    {182, "C106", "Modbus command word bit 6"}, {183, "C107", "Modbus command word bit 7"},
    {184, "C108", "Modbus command word bit 8"}, {185, "C109", "Modbus command word bit 9"},
    {186, "C110", "Modbus command word bit 10"}, {187, "C111", "Modbus command word bit 11"},
    {188, "C112", "Modbus command word bit 12"}, {189, "C113", "Modbus command word bit 13"},
    {190, "C114", "Modbus command word bit 14"}, {191, "C115", "Modbus command word bit 15"},
    {193, "C201", "CANopen command word bit 1"}, {194, "C202", "CANopen command word bit 2"},
    {195, "C203", "CANopen command word bit 3"}, {196, "C204", "CANopen command word bit 4"},
    {197, "C205", "CANopen command word bit 5"}, {198, "C206", "CANopen command word bit 6"},
    {199, "C207", "CANopen command word bit 7"}, {200, "C208", "CANopen command word bit 8"},
    {201, "C209", "CANopen command word bit 9"}, {202, "C210", "CANopen command word bit 10"},
    {203, "C211", "CANopen command word bit 11"}, {204, "C212", "CANopen command word bit 12"},
    {205, "C213", "CANopen command word bit 13"}, {206, "C214", "CANopen command word bit 14"},
    {207, "C215", "CANopen command word bit 15"}, {209, "C301", "card command word bit 1"},
    {210, "C302", "card command word bit 2"}, {211, "C303", "card command word bit 3"},
    {212, "C304", "card command word bit 4"}, {213, "C305", "card command word bit 5"},
    {214, "C306", "card command word bit 6"}, {215, "C307", "card command word bit 7"},
    {216, "C308", "card command word bit 8"}, {217, "C309", "card command word bit 9"},
    {218, "C310", "card command word bit 10"}, {219, "C311", "card command word bit 11"},
    {220, "C312", "card command word bit 12"}, {221, "C313", "card command word bit 13"},
    {222, "C314", "card command word bit 14"}, {223, "C315", "card command word bit 15"},
    {240, "OL01", "function block output OL01"}, {241, "OL02", "function block output OL02"},
    {242, "OL03", "function block output OL03"}, {243, "OL04", "function block output OL04"},
    {244, "OL05", "function block output OL05"}, {245, "OL06", "function block output OL06"},
    {246, "OL07", "function block output OL07"}, {247, "OL08", "function block output OL08"},
    {248, "OL09", "function block output OL09"}, {249, "OL10", "function block output OL10"},
};
// What an output shows.
inline constexpr choice logic_source[]{
    {0, "nO", "not assigned"}, {1, "FLt", "no fault present"}, {2, "rUn", "drive running"},
    {3, "OCC", "output contactor command"}, {4, "FtA", "frequency threshold reached"},
    {5, "FLA", "high speed reached"}, {6, "CtA", "current threshold reached"},
    {7, "SrA", "reference reached"}, {8, "tSA", "motor thermal threshold reached"},
    {9, "BLC", "brake command"}, {10, "PEE", "PI error alarm"}, {11, "PFA", "PI feedback alarm"},
    {13, "F2A", "frequency threshold 2 reached"}, {14, "TAD", "drive thermal threshold reached"},
    {21, "ULA", "underload alarm"}, {22, "OLA", "overload alarm"}, {27, "RSDA", "slack rope alarm"},
    {28, "TTHA", "torque high alarm"}, {29, "TTLA", "torque low alarm"}, {30, "MFRD", "running forward"},
    {31, "MRRS", "running in reverse"}, {37, "TS2", "motor 2 thermal threshold reached"},
    {38, "TS3", "motor 3 thermal threshold reached"}, {47, "ATS", "torque negative"},
    {48, "CnF0", "configuration 0 active"}, {49, "CnF1", "configuration 1 active"},
    {50, "CnF2", "configuration 2 active"}, {52, "CFP1", "parameter set 1 active"},
    {53, "CFP2", "parameter set 2 active"}, {54, "CFP3", "parameter set 3 active"},
    {64, "DBL", "DC bus charged"}, {65, "BRS", "braking"}, {66, "PRM", "power removed"},
    {72, "FQLA", "frequency meter alarm"}, {73, "LLC", "line contactor command"},
    {77, "MCP", "motor current present"}, {78, "LSA", "limit switch reached"},
    {79, "DLDA", "load variation alarm"}, {80, "AG1", "alarm group 1"}, {81, "AG2", "alarm group 2"},
    {82, "AG3", "alarm group 3"}, {85, "PLA", "LI6 probe alarm"}, {87, "EFA", "external fault alarm"},
    {88, "USA", "undervoltage alarm"}, {89, "UPA", "undervoltage threshold reached"},
    {91, "THA", "drive thermal alarm"}, {95, "SSA", "torque or current limit reached"},
    {96, "FR1", "reference channel 1 active"}, {97, "FR2", "reference channel 2 active"},
    {98, "CD1", "command channel 1 active"}, {99, "CD2", "command channel 2 active"},
    {100, "FR1B", "reference channel 1B active"}, {101, "EBO", "end of reel"},
    {102, "TSY", "wobble synchronisation"}, {104, "TJA", "transistor temperature alarm"},
    {107, "AP3", "AI3 signal lost"}, {116, "FN1", "terminal key F1"}, {117, "FN2", "terminal key F2"},
    {118, "FN3", "terminal key F3"}, {119, "FN4", "terminal key F4"}, {127, "rdY", "drive ready"},
    {128, "YES", "always"}, {129, "LI1", "LI1"}, {130, "LI2", "LI2"}, {131, "LI3", "LI3"},
    {132, "LI4", "LI4"}, {133, "LI5", "LI5"}, {134, "LI6", "LI6"}, {143, "LAI1", "AI1 as a logic input"},
    {144, "LAI2", "AI2 as a logic input"}, {160, "CD00", "I/O profile: command bit 0"},
    {161, "CD01", "I/O profile: command bit 1"}, {162, "CD02", "I/O profile: command bit 2"},
    {163, "CD03", "I/O profile: command bit 3"}, {164, "CD04", "I/O profile: command bit 4"},
    {165, "CD05", "I/O profile: command bit 5"}, {166, "CD06", "I/O profile: command bit 6"},
    {167, "CD07", "I/O profile: command bit 7"}, {168, "CD08", "I/O profile: command bit 8"},
    {169, "CD09", "I/O profile: command bit 9"}, {170, "CD10", "I/O profile: command bit 10"},
    {171, "CD11", "I/O profile: command bit 11"}, {172, "CD12", "I/O profile: command bit 12"},
    {173, "CD13", "I/O profile: command bit 13"}, {174, "CD14", "I/O profile: command bit 14"},
    {175, "CD15", "I/O profile: command bit 15"}, {176, "C100", "Modbus command word bit 0"},
    {177, "C101", "Modbus command word bit 1"}, {178, "C102", "Modbus command word bit 2"},
    {179, "C103", "Modbus command word bit 3"}, {180, "C104", "Modbus command word bit 4"},
    {181, "C105", "Modbus command word bit 5"}, {182, "C106", "Modbus command word bit 6"},
    {183, "C107", "Modbus command word bit 7"}, {184, "C108", "Modbus command word bit 8"},
    {185, "C109", "Modbus command word bit 9"}, {186, "C110", "Modbus command word bit 10"},
    {187, "C111", "Modbus command word bit 11"}, {188, "C112", "Modbus command word bit 12"},
    {189, "C113", "Modbus command word bit 13"}, {190, "C114", "Modbus command word bit 14"},
    {191, "C115", "Modbus command word bit 15"}, {192, "C200", "CANopen command word bit 0"},
    {193, "C201", "CANopen command word bit 1"}, {194, "C202", "CANopen command word bit 2"},
    {195, "C203", "CANopen command word bit 3"}, {196, "C204", "CANopen command word bit 4"},
    {197, "C205", "CANopen command word bit 5"}, {198, "C206", "CANopen command word bit 6"},
    {199, "C207", "CANopen command word bit 7"}, {200, "C208", "CANopen command word bit 8"},
    {201, "C209", "CANopen command word bit 9"}, {202, "C210", "CANopen command word bit 10"},
    {203, "C211", "CANopen command word bit 11"}, {204, "C212", "CANopen command word bit 12"},
    {205, "C213", "CANopen command word bit 13"}, {206, "C214", "CANopen command word bit 14"},
    {207, "C215", "CANopen command word bit 15"}, {208, "C300", "card command word bit 0"},
    {209, "C301", "card command word bit 1"}, {210, "C302", "card command word bit 2"},
    {211, "C303", "card command word bit 3"}, {212, "C304", "card command word bit 4"},
    {213, "C305", "card command word bit 5"}, {214, "C306", "card command word bit 6"},
    {215, "C307", "card command word bit 7"}, {216, "C308", "card command word bit 8"},
    {217, "C309", "card command word bit 9"}, {218, "C310", "card command word bit 10"},
    {219, "C311", "card command word bit 11"}, {220, "C312", "card command word bit 12"},
    {221, "C313", "card command word bit 13"}, {222, "C314", "card command word bit 14"},
    {223, "C315", "card command word bit 15"}, {240, "OL01", "function block output OL01"},
    {241, "OL02", "function block output OL02"}, {242, "OL03", "function block output OL03"},
    {243, "OL04", "function block output OL04"}, {244, "OL05", "function block output OL05"},
    {245, "OL06", "function block output OL06"}, {246, "OL07", "function block output OL07"},
    {247, "OL08", "function block output OL08"}, {248, "OL09", "function block output OL09"},
    {249, "OL10", "function block output OL10"}, {250, "GdL", "GDL"},
};
// The input of a safety function.
inline constexpr choice safety_input[]{
    {0, "nO", "not assigned"}, {1, "L34", "LI3 and LI4"}, {2, "L56", "LI5 and LI6"},
    {3, "L3PW", "LI3 and PWRM"}, {4, "PWrM", "PWRM"},
};
// The level that counts as active.
inline constexpr choice input_level[]{{0, "LO", "active low"}, {1, "HIG", "active high"}};
// clang-format on

} // namespace altivar::atv320::rows
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
