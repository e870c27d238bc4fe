// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: reactions to faults, supervision, safety, function blocks, and what it keeps of past faults.
// How to read a line stands in parameters/parameter.hpp.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/choices.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/altivar/parameters/row_table.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320::rows {

// clang-format off
// What starts and stops the function blocks.
inline constexpr choice block_command[]{{0, "StOP", "stop"}, {1, "Strt", "start"}};
// What stopped function blocks do to the drive.
inline constexpr choice block_on_fault[]{{0, "StOP", "stop"}, {1, "IGn", "go on"}};
// What is wrong with the function blocks.
inline constexpr choice block_fault[]{
    {0, "nO", "no fault"}, {1, "Int", "internal error"}, {2, "bIn", "wrong binary file"},
    {3, "InP", "wrong internal parameters"}, {4, "PAr", "parameter access refused"},
    {5, "CAL", "calculation error"}, {6, "tOAU", "auxiliary task too slow"},
    {7, "tOPP", "synchronous task too slow"}, {8, "AdL", "wrong address container (ADLC)"},
    {9, "In", "wrong input assignment"},
};
// What the function blocks are doing.
inline constexpr choice block_state[]{
    {0, "IdLE", "no program"}, {1, "CHEC", "checking the program"}, {2, "StOP", "stopped"},
    {3, "InIt", "initialising"}, {4, "rUn", "running"}, {5, "Err", "in error"},
};
// S001, pulses of the function blocks.
inline constexpr choice clock_word[]{
    {5, "clock_100ms", "100 ms clock, half on"}, {6, "clock_1s", "1 s clock, half on"},
    {7, "clock_1min", "1 min clock, half on"}, {13, "first_cycle", "first cycle since start"},
};
// S002, which lines are in order.
inline constexpr choice communication_word[]{
    {11, "option_ok", "option works"}, {12, "canopen_ok", "CANopen works"},
    {13, "modbus_ok", "Modbus works"},
};
// S006.
inline constexpr choice save_word[]{{15, "save_variables", "save the user's variables"}};
// How long automatic restart goes on trying.
inline constexpr choice restart_time[]{
    {0, "5", "5 min"}, {1, "10", "10 min"}, {2, "30", "30 min"}, {3, "1H", "1 h"}, {4, "2H", "2 h"},
    {5, "3H", "3 h"}, {6, "Ct", "unlimited"},
};
// How the motor is cooled.
inline constexpr choice motor_cooling[]{
    {0, "nO", "no protection"}, {1, "ACL", "self-cooled motor"}, {2, "FCL", "force-cooled motor"},
};
// What a lost output phase does.
inline constexpr choice output_phase_loss[]{
    {0, "nO", "not detected"}, {1, "YES", "fault OPF"}, {2, "OAC", "no fault, output may be cut"},
};
// What undervoltage does.
inline constexpr choice undervoltage_reaction[]{
    {0, "0", "fault, relay opens"}, {1, "1", "fault, relay stays"}, {2, "2", "alarm only"},
};
// The rated mains voltage.
inline constexpr choice mains_rating[]{
    {20, "200", "200 V"}, {22, "220", "220 V"}, {23, "230", "230 V"}, {24, "240", "240 V"},
    {38, "380", "380 V"}, {40, "400", "400 V"}, {44, "440", "440 V"}, {46, "460", "460 V"},
    {50, "500", "500 V"}, {53, "525", "525 V"}, {60, "600", "600 V"}, {254, "LHM", "Lexium level"},
};
// How lost mains stop the motor.
inline constexpr choice power_loss_stop[]{
    {0, "nO", "freewheel, then a fault"}, {1, "MMS", "DC bus kept up"}, {2, "rMP", "ramp stop"},
    {4, "LnF", "freewheel, no fault"},
};
// The state of safe torque off.
inline constexpr choice sto_state[]{{0, "IdLE", "inactive"}, {1, "StO", "active"}, {2, "FLt", "in fault"}};
// When a motor probe is watched.
inline constexpr choice ptc_mode[]{
    {0, "nO", "not supervised"}, {1, "AS", "always"}, {2, "rdS", "with the power section on"},
    {3, "rS", "with the motor on"},
};
// Whether the drive has safety functions.
inline constexpr choice safety_state[]{{0, "Std", "standard drive"}, {1, "SAFE", "safety functions configured"}};
// The state of safely limited speed.
inline constexpr choice sls_state[]{
    {0, "nO", "not configured"}, {1, "IdLE", "inactive"}, {2, "SS1", "safe ramp"},
    {3, "SLS", "speed limited"}, {4, "StO", "safe torque off"}, {5, "FLt", "in fault"},
    {6, "WAIt", "waiting (WAIt)"}, {7, "Strt", "starting (Strt)"},
};
// The type of safely limited speed.
inline constexpr choice sls_type[]{
    {0, "tYP1", "type 1"}, {1, "tYP2", "type 2"}, {2, "tYP3", "type 3"}, {3, "tYP4", "type 4"},
    {4, "tYP5", "type 5"}, {5, "tYP6", "type 6"},
};
// The state of safe stop 1.
inline constexpr choice ss1_state[]{
    {0, "nO", "not configured"}, {1, "IdLE", "inactive"}, {2, "SS1", "safe ramp"},
    {3, "StO", "safe torque off"}, {4, "FLt", "in fault"},
};
// The size of a step of the safe ramp.
inline constexpr choice ss1_step[]{{0, "1H", "1 Hz/s"}, {1, "10H", "10 Hz/s"}, {2, "100H", "100 Hz/s"}};

// Reactions to faults.
inline constexpr parameter faults[]{
    {"FLR",  3110,  cfg, in<no_yes>,              {},  {},    0,    "Catch a spinning load", &catching},
    {"STRT", 3112,  cfg, in<no_yes>,              {},  {},    0,    "Power transistor test at start"},
    {"ERCO", 6056,  ro,  in<count16>,             0,   5,     {},   "CANopen error code"},
    {"IPL",  7002,  cfg, fault_reaction,          {}, {}, {}, "Reaction to an input phase loss", &reaction},
    {"STP",  7004,  cfg, power_loss_stop,         {}, {}, 0, "Controlled stop on mains loss", &reaction},
    {"EPL",  7006,  cfg, fault_reaction,          {}, {}, 1, "Reaction to an external fault", &reaction},
    {"OHL",  7008,  cfg, fault_reaction,          {}, {}, 1, "Reaction to an overheated drive", &reaction},
    {"OLL",  7009,  cfg, fault_reaction,          {}, {}, 1, "Reaction to a motor overload", &reaction},
    row_of(sll, link_loss),
    {"COL",  7011,  cfg, fault_reaction,          {}, {}, 1, "Reaction to a lost CANopen link", &link_loss},
    {"TNL",  7012,  cfg, fault_reaction,          {}, {}, 1, "Reaction to a failed autotune", &reaction},
    {"LFL3", 7013,  cfg, fault_reaction,          {}, {}, 0, "Reaction to a lost signal on AI3", &reaction},
    {"CLL",  7015,  cfg, fault_reaction, {}, {}, 1, "Reaction to a lost communication card", &link_loss},
    {"LFF",  7080,  cfg, in<decihertz>,           0,   5990,  0,    "Fallback speed", &speed},
    {"ODT",  7081,  rw,  in<deciseconds>,         5, 100, 5, "Output phase loss detection time", &blind},
    {"LET",  7090,  cfg, input_level,             {}, {}, 1, "Active level of external fault", &stop_input},
    row_of(lft), row_of(atr, restarts),
    {"TAR",  7123,  cfg, restart_time,            {}, {}, 0, "Longest time of automatic restart", &restarts},
    {"RSF",  7124,  cfg, logic_input,             {},  {},    {},   "Input for fault reset", &reset_input},
    {"INH",  7125,  cfg, logic_input,             {}, {}, 0, "Input that inhibits faults", &stop_input},
    {"RP",   7128,  cfg, in<no_yes>,              {},  {},    0,    "Restart the drive", &drive_restart},
    {"RPA",  7129,  cfg, logic_input,             {}, {}, 0, "Input that restarts the drive", &reset_input},
    row_of(cic, accepts),
    {"ETF",  7131,  cfg, logic_input,             {},  {},    {},   "Input for external fault", &stop_input},
    {"CNF",  7132,  ro,  in<count16>,             0,   65535, {},   "Communication card fault code"},
    {"ILF1", 7134,  ro,  in<count16>,             0,   65535, {},   "Internal link fault code"},
    {"OPL",  9611,  cfg, output_phase_loss,       {},  {},    {},   "Output phase loss detection", &reaction},
    {"THT",  9612,  cfg, motor_cooling,           {},  {},    1,    "Motor thermal protection", &blind},
    {"SAT",  11021, cfg, in<no_yes>,              {},  {},    0,    "Stop at thermal alarm", &reaction},
    {"DLD",  12311, cfg, in<percent>,             1,   100,   100,  "Load variation threshold"},
    {"TLD",  12312, cfg, in<signed_centiseconds>, 0,   1000,  {},   "Load variation time", &blind},
    {"DLB",  12313, cfg, fault_reaction,          {}, {}, 1, "Reaction to a load variation", &reaction},
    {"PTCL", 13203, cfg, ptc_mode,                {},  {},    0,    "PTC probe on LI6", &blind},
    {"URES", 13801, cfg, mains_rating,            {},  {},    {},   "Rated mains voltage"},
    {"USL",  13802, cfg, in<volts>,               100, 276,   {},   "Undervoltage trip level"},
    {"USB",  13803, cfg, undervoltage_reaction,   {},  {},    0,    "Reaction to undervoltage", &reaction},
    {"UST",  13804, cfg, in<deciseconds>,         2,   9999,  2,    "Undervoltage time"},
    {"UPL",  13811, cfg, in<volts>,               141, 318,   {},   "Controlled stop: voltage level"},
    {"TBS",  13812, rw,  in<seconds>,             1,   9999,  9999, "Time the DC bus is kept up"},
    {"TSM",  13813, rw,  in<deciseconds>,         10, 9999, 10, "Controlled stop: restart time", &stopping},
    {"STM",  13814, rw,  in<centiseconds>,        1, 6000, 100, "Controlled stop: longest time", &stopping},
};

// Load monitoring.
inline constexpr parameter process_monitoring[]{
    {"ULT",  14411, cfg, in<seconds>,        0,  100,   0,  "Underload detection delay", &blind},
    {"UDL",  14412, cfg, fault_reaction,     {}, {},    1,  "Reaction to an underload", &reaction},
    {"RMUD", 14414, rw,  in<decihertz>,      0,  5990,  0,  "Underload detection: lowest frequency"},
    {"LUL",  14415, rw,  in<percent>,        0,  100,   0,  "Underload threshold at zero speed"},
    {"LUN",  14416, rw,  in<percent>,        20, 100,   60, "Underload threshold at rated speed"},
    {"TOL",  14421, cfg, in<seconds>,        0,  100,   0,  "Overload detection delay", &blind},
    {"ODL",  14422, cfg, fault_reaction,     {}, {},    1,  "Reaction to an overload", &reaction},
    {"FQF",  14601, cfg, in<no_yes>,         {}, {},    0,  "Frequency meter on the pulse input", &blind},
    {"FQC",  14602, rw,  in<count16_tenths>, 10, 1000,  10, "Pulse scale divider"},
    {"FQA",  14604, cfg, in<hertz>,          0,  20000, 0,  "Pulse overspeed threshold"},
    {"TDS",  14605, cfg, in<deciseconds>,    0,  100,   0,  "Delay of the pulse overspeed", &blind},
    {"FDT",  14606, cfg, in<decihertz>,      0,  5990,  0,  "Pulse supervision lowest frequency"},
    {"FQT",  14607, cfg, in<hertz>,          0,  1000,  0,  "Pulse threshold without run order"},
    {"TQB",  14608, cfg, in<deciseconds>,    0,  100,   0,  "Pulse delay without run order", &blind},
    {"FQL",  14609, cfg, in<hertz>,          0,  20000, 0,  "Pulse supervision: warning level"},
};

// Safety functions, as far as the line shows them.
inline constexpr parameter safety[]{
    {"SLSA", 15300, cfg, safety_input,            {}, {},   0,  "SLS input", &of_safety},
    {"SLT",  15301, cfg, sls_type,                {}, {},   0,  "SLS type", &of_safety},
    {"SLSP", 15302, cfg, in<decihertz>,           0,  5990, 0,  "SLS speed", &of_safety},
    {"SLTT", 15303, cfg, in<decihertz>,           0,  5990, 0,  "SLS speed tolerance", &of_safety},
    {"SLSS", 15304, ro,  sls_state,               {}, {},   {}, "SLS state"},
    {"SS1A", 15310, cfg, safety_input,            {}, {},   0,  "SS1 input", &of_safety},
    {"SSRT", 15311, cfg, in<count16_tenths>,      1,  5990, 1,  "SS1 ramp", &of_safety},
    {"SSRU", 15312, cfg, ss1_step,                {}, {},   0,  "SS1 ramp unit", &of_safety},
    {"SSSL", 15313, cfg, in<decihertz>,           0,  5990, 0,  "SS1 and SLS standstill level", &of_safety},
    {"SSTT", 15314, cfg, in<decihertz>,           0,  5990, 0,  "SS1 trip threshold", &of_safety},
    {"SS1S", 15315, ro,  ss1_state,               {}, {},   {}, "SS1 state"},
    {"STOA", 15320, cfg, safety_input,            {}, {},   0,  "STO input", &of_safety},
    {"PWRM", 15321, cfg, safety_input,            {}, {},   4,  "PWRM input", &of_safety},
    {"STOS", 15322, ro,  sto_state,               {}, {},   {}, "STO state"},
    {"LIDT", 15330, cfg, in<units::milliseconds>, 0,  2000, 50, "Safety input debounce time", &of_safety},
    {"LIRT", 15331, cfg, in<units::milliseconds>, 0,  50,   0,  "Safety input response time", &of_safety},
    {"SFTY", 15344, ro,  safety_state,            {}, {},   {}, "Safety configured"},
};

// Function blocks.
inline constexpr parameter function_blocks[]{
    {"IA01", 14900, cfg, signal_source,            {}, {},    0,  "Function block analog input 1"},
    {"IA02", 14901, cfg, signal_source,            {}, {},    0,  "Function block analog input 2"},
    {"IA03", 14902, cfg, signal_source,            {}, {},    0,  "Function block analog input 3"},
    {"IA04", 14903, cfg, signal_source,            {}, {},    0,  "Function block analog input 4"},
    {"IA05", 14904, cfg, signal_source,            {}, {},    0,  "Function block analog input 5"},
    {"IA06", 14905, cfg, signal_source,            {}, {},    0,  "Function block analog input 6"},
    {"IA07", 14906, cfg, signal_source,            {}, {},    0,  "Function block analog input 7"},
    {"IA08", 14907, cfg, signal_source,            {}, {},    0,  "Function block analog input 8"},
    {"IA09", 14908, cfg, signal_source,            {}, {},    0,  "Function block analog input 9"},
    {"IA10", 14909, cfg, signal_source,            {}, {},    0,  "Function block analog input 10"},
    {"IL01", 14920, cfg, logic_source,             {}, {},    0,  "Function block logic input 1"},
    {"IL02", 14921, cfg, logic_source,             {}, {},    0,  "Function block logic input 2"},
    {"IL03", 14922, cfg, logic_source,             {}, {},    0,  "Function block logic input 3"},
    {"IL04", 14923, cfg, logic_source,             {}, {},    0,  "Function block logic input 4"},
    {"IL05", 14924, cfg, logic_source,             {}, {},    0,  "Function block logic input 5"},
    {"IL06", 14925, cfg, logic_source,             {}, {},    0,  "Function block logic input 6"},
    {"IL07", 14926, cfg, logic_source,             {}, {},    0,  "Function block logic input 7"},
    {"IL08", 14927, cfg, logic_source,             {}, {},    0,  "Function block logic input 8"},
    {"IL09", 14928, cfg, logic_source,             {}, {},    0,  "Function block logic input 9"},
    {"IL10", 14929, cfg, logic_source,             {}, {},    0,  "Function block logic input 10"},
    {"LA01", 14940, cfg, in<count16>, 0, 65535, 0, "Function block address container 1", &targets},
    {"LA02", 14941, cfg, in<count16>, 0, 65535, 0, "Function block address container 2", &targets},
    {"LA03", 14942, cfg, in<count16>, 0, 65535, 0, "Function block address container 3", &targets},
    {"LA04", 14943, cfg, in<count16>, 0, 65535, 0, "Function block address container 4", &targets},
    {"LA05", 14944, cfg, in<count16>, 0, 65535, 0, "Function block address container 5", &targets},
    {"LA06", 14945, cfg, in<count16>, 0, 65535, 0, "Function block address container 6", &targets},
    {"LA07", 14946, cfg, in<count16>, 0, 65535, 0, "Function block address container 7", &targets},
    {"LA08", 14947, cfg, in<count16>, 0, 65535, 0, "Function block address container 8", &targets},
    {"FBST", 14960, ro,  block_state,              {}, {},    {}, "Function block state"},
    {"FBFT", 14961, ro,  block_fault,              {}, {},    {}, "Function block fault"},
    {"FBCD", 14962, rw,  block_command,            {}, {},    {}, "Function block command", &runs_blocks},
    {"FBRM", 14963, cfg, logic_input,              {}, {},    0,  "Function block start mode", &selection},
    {"FBSM", 14964, cfg, fault_reaction, {}, {}, 1, "Motor reaction when function blocks stop", &reaction},
    {"FBDF", 14965, cfg, block_on_fault, {}, {}, 0, "Function block reaction to a drive fault", &reaction},
    {"M001", 14970, rw,  in<count16>,              0,  65535, 0,  "Function block parameter M001"},
    {"M002", 14971, rw,  in<count16>,              0,  65535, 0,  "Function block parameter M002"},
    {"M003", 14972, rw,  in<count16>,              0,  65535, 0,  "Function block parameter M003"},
    {"M004", 14973, rw,  in<count16>,              0,  65535, 0,  "Function block parameter M004"},
    {"M005", 14974, rw,  in<count16>,              0,  65535, 0,  "Function block parameter M005"},
    {"M006", 14975, rw,  in<count16>,              0,  65535, 0,  "Function block parameter M006"},
    {"M007", 14976, rw,  in<count16>,              0,  65535, 0,  "Function block parameter M007"},
    {"M008", 14977, rw,  in<count16>,              0,  65535, 0,  "Function block parameter M008"},
    {"S001", 14980, ro,  bits(clock_word),         {}, {},    {}, "Function block system word 1"},
    {"S002", 14981, ro,  bits(communication_word), {}, {},    {}, "Function block system word 2"},
    {"S006", 14985, ro,  bits(save_word),          {}, {},    {}, "Function block system word 6"},
    {"BNV",  14990, ro,  in<count16>,              0,  65535, {}, "Function block program format"},
    {"CTV",  14991, ro,  in<count16>,              0,  65535, {}, "Function block catalogue version"},
    {"BNS",  14992, ro,  in<count16>,              0,  65535, {}, "Function block program size"},
    {"BVER", 14993, ro,  in<count16>,              0,  255,   {}, "Function block program version"},
};

// States at past faults.
inline constexpr parameter history_state[]{
    row_of(dp0), row_of(dp1), row_of(dp2), row_of(dp3), row_of(dp4), row_of(dp5), row_of(dp6), row_of(dp7),
    row_of(dp8),
    {"EP0",  7210, ro, in<status_word>,          {}, {},    {}, "Status word at the most recent fault"},
    {"EP1",  7211, ro, in<status_word>,          {}, {},    {}, "Status word at fault 1 back"},
    {"EP2",  7212, ro, in<status_word>,          {}, {},    {}, "Status word at fault 2 back"},
    {"EP3",  7213, ro, in<status_word>,          {}, {},    {}, "Status word at fault 3 back"},
    {"EP4",  7214, ro, in<status_word>,          {}, {},    {}, "Status word at fault 4 back"},
    {"EP5",  7215, ro, in<status_word>,          {}, {},    {}, "Status word at fault 5 back"},
    {"EP6",  7216, ro, in<status_word>,          {}, {},    {}, "Status word at fault 6 back"},
    {"EP7",  7217, ro, in<status_word>,          {}, {},    {}, "Status word at fault 7 back"},
    {"EP8",  7218, ro, in<status_word>,          {}, {},    {}, "Status word at fault 8 back"},
    {"IP0",  7220, ro, in<extended_status_word>, {}, {}, {}, "Extended status word at the most recent fault"},
    {"IP1",  7221, ro, in<extended_status_word>, {}, {},    {}, "Extended status word at fault 1 back"},
    {"IP2",  7222, ro, in<extended_status_word>, {}, {},    {}, "Extended status word at fault 2 back"},
    {"IP3",  7223, ro, in<extended_status_word>, {}, {},    {}, "Extended status word at fault 3 back"},
    {"IP4",  7224, ro, in<extended_status_word>, {}, {},    {}, "Extended status word at fault 4 back"},
    {"IP5",  7225, ro, in<extended_status_word>, {}, {},    {}, "Extended status word at fault 5 back"},
    {"IP6",  7226, ro, in<extended_status_word>, {}, {},    {}, "Extended status word at fault 6 back"},
    {"IP7",  7227, ro, in<extended_status_word>, {}, {},    {}, "Extended status word at fault 7 back"},
    {"IP8",  7228, ro, in<extended_status_word>, {}, {},    {}, "Extended status word at fault 8 back"},
    {"CMP0", 7230, ro, in<command_word>,         {}, {},    {}, "Command word at the most recent fault"},
    {"CMP1", 7231, ro, in<command_word>,         {}, {},    {}, "Command word at fault 1 back"},
    {"CMP2", 7232, ro, in<command_word>,         {}, {},    {}, "Command word at fault 2 back"},
    {"CMP3", 7233, ro, in<command_word>,         {}, {},    {}, "Command word at fault 3 back"},
    {"CMP4", 7234, ro, in<command_word>,         {}, {},    {}, "Command word at fault 4 back"},
    {"CMP5", 7235, ro, in<command_word>,         {}, {},    {}, "Command word at fault 5 back"},
    {"CMP6", 7236, ro, in<command_word>,         {}, {},    {}, "Command word at fault 6 back"},
    {"CMP7", 7237, ro, in<command_word>,         {}, {},    {}, "Command word at fault 7 back"},
    {"CMP8", 7238, ro, in<command_word>,         {}, {},    {}, "Command word at fault 8 back"},
    {"FNB",  7393, ro, in<count16>,              0,  65535, {}, "Number of faults"},
};

// Measurements at past faults.
inline constexpr parameter history_values[]{
    {"LCP0", 7240, ro, in<signed_deciamperes>,   -32767, 32767, {}, "Motor current at the most recent fault"},
    {"LCP1", 7241, ro, in<signed_deciamperes>,   -32767, 32767, {}, "Motor current at fault 1 back"},
    {"LCP2", 7242, ro, in<signed_deciamperes>,   -32767, 32767, {}, "Motor current at fault 2 back"},
    {"LCP3", 7243, ro, in<signed_deciamperes>,   -32767, 32767, {}, "Motor current at fault 3 back"},
    {"LCP4", 7244, ro, in<signed_deciamperes>,   -32767, 32767, {}, "Motor current at fault 4 back"},
    {"LCP5", 7245, ro, in<signed_deciamperes>,   -32767, 32767, {}, "Motor current at fault 5 back"},
    {"LCP6", 7246, ro, in<signed_deciamperes>,   -32767, 32767, {}, "Motor current at fault 6 back"},
    {"LCP7", 7247, ro, in<signed_deciamperes>,   -32767, 32767, {}, "Motor current at fault 7 back"},
    {"LCP8", 7248, ro, in<signed_deciamperes>,   -32767, 32767, {}, "Motor current at fault 8 back"},
    {"RFP0", 7250, ro, in<signed_decihertz>, -32767, 32767, {}, "Output frequency at the most recent fault"},
    {"RFP1", 7251, ro, in<signed_decihertz>,     -32767, 32767, {}, "Output frequency at fault 1 back"},
    {"RFP2", 7252, ro, in<signed_decihertz>,     -32767, 32767, {}, "Output frequency at fault 2 back"},
    {"RFP3", 7253, ro, in<signed_decihertz>,     -32767, 32767, {}, "Output frequency at fault 3 back"},
    {"RFP4", 7254, ro, in<signed_decihertz>,     -32767, 32767, {}, "Output frequency at fault 4 back"},
    {"RFP5", 7255, ro, in<signed_decihertz>,     -32767, 32767, {}, "Output frequency at fault 5 back"},
    {"RFP6", 7256, ro, in<signed_decihertz>,     -32767, 32767, {}, "Output frequency at fault 6 back"},
    {"RFP7", 7257, ro, in<signed_decihertz>,     -32767, 32767, {}, "Output frequency at fault 7 back"},
    {"RFP8", 7258, ro, in<signed_decihertz>,     -32767, 32767, {}, "Output frequency at fault 8 back"},
    {"RTP0", 7260, ro, in<hours>,                0, 65535, {}, "Motor running time at the most recent fault"},
    {"RTP1", 7261, ro, in<hours>,                0,      65535, {}, "Motor running time at fault 1 back"},
    {"RTP2", 7262, ro, in<hours>,                0,      65535, {}, "Motor running time at fault 2 back"},
    {"RTP3", 7263, ro, in<hours>,                0,      65535, {}, "Motor running time at fault 3 back"},
    {"RTP4", 7264, ro, in<hours>,                0,      65535, {}, "Motor running time at fault 4 back"},
    {"RTP5", 7265, ro, in<hours>,                0,      65535, {}, "Motor running time at fault 5 back"},
    {"RTP6", 7266, ro, in<hours>,                0,      65535, {}, "Motor running time at fault 6 back"},
    {"RTP7", 7267, ro, in<hours>,                0,      65535, {}, "Motor running time at fault 7 back"},
    {"RTP8", 7268, ro, in<hours>,                0,      65535, {}, "Motor running time at fault 8 back"},
    {"ULP0", 7270, ro, in<decivolts>,            0,      65535, {}, "Mains voltage at the most recent fault"},
    {"ULP1", 7271, ro, in<decivolts>,            0,      65535, {}, "Mains voltage at fault 1 back"},
    {"ULP2", 7272, ro, in<decivolts>,            0,      65535, {}, "Mains voltage at fault 2 back"},
    {"ULP3", 7273, ro, in<decivolts>,            0,      65535, {}, "Mains voltage at fault 3 back"},
    {"ULP4", 7274, ro, in<decivolts>,            0,      65535, {}, "Mains voltage at fault 4 back"},
    {"ULP5", 7275, ro, in<decivolts>,            0,      65535, {}, "Mains voltage at fault 5 back"},
    {"ULP6", 7276, ro, in<decivolts>,            0,      65535, {}, "Mains voltage at fault 6 back"},
    {"ULP7", 7277, ro, in<decivolts>,            0,      65535, {}, "Mains voltage at fault 7 back"},
    {"ULP8", 7278, ro, in<decivolts>,            0,      65535, {}, "Mains voltage at fault 8 back"},
    {"THP0", 7280, ro, in<percent>, 0, 65535, {}, "Motor thermal state at the most recent fault"},
    {"THP1", 7281, ro, in<percent>,              0,      65535, {}, "Motor thermal state at fault 1 back"},
    {"THP2", 7282, ro, in<percent>,              0,      65535, {}, "Motor thermal state at fault 2 back"},
    {"THP3", 7283, ro, in<percent>,              0,      65535, {}, "Motor thermal state at fault 3 back"},
    {"THP4", 7284, ro, in<percent>,              0,      65535, {}, "Motor thermal state at fault 4 back"},
    {"THP5", 7285, ro, in<percent>,              0,      65535, {}, "Motor thermal state at fault 5 back"},
    {"THP6", 7286, ro, in<percent>,              0,      65535, {}, "Motor thermal state at fault 6 back"},
    {"THP7", 7287, ro, in<percent>,              0,      65535, {}, "Motor thermal state at fault 7 back"},
    {"THP8", 7288, ro, in<percent>,              0,      65535, {}, "Motor thermal state at fault 8 back"},
    {"OTP0", 7330, ro, in<signed_tenth_percent>, -32767, 32767, {}, "Motor torque at the most recent fault"},
    {"OTP1", 7331, ro, in<signed_tenth_percent>, -32767, 32767, {}, "Motor torque at fault 1 back"},
    {"OTP2", 7332, ro, in<signed_tenth_percent>, -32767, 32767, {}, "Motor torque at fault 2 back"},
    {"OTP3", 7333, ro, in<signed_tenth_percent>, -32767, 32767, {}, "Motor torque at fault 3 back"},
    {"OTP4", 7334, ro, in<signed_tenth_percent>, -32767, 32767, {}, "Motor torque at fault 4 back"},
    {"OTP5", 7335, ro, in<signed_tenth_percent>, -32767, 32767, {}, "Motor torque at fault 5 back"},
    {"OTP6", 7336, ro, in<signed_tenth_percent>, -32767, 32767, {}, "Motor torque at fault 6 back"},
    {"OTP7", 7337, ro, in<signed_tenth_percent>, -32767, 32767, {}, "Motor torque at fault 7 back"},
    {"OTP8", 7338, ro, in<signed_tenth_percent>, -32767, 32767, {}, "Motor torque at fault 8 back"},
    {"TDP0", 7340, ro, in<percent>,              0, 255, {}, "Drive thermal state at the most recent fault"},
    {"TDP1", 7341, ro, in<percent>,              0,      255,   {}, "Drive thermal state at fault 1 back"},
    {"TDP2", 7342, ro, in<percent>,              0,      255,   {}, "Drive thermal state at fault 2 back"},
    {"TDP3", 7343, ro, in<percent>,              0,      255,   {}, "Drive thermal state at fault 3 back"},
    {"TDP4", 7344, ro, in<percent>,              0,      255,   {}, "Drive thermal state at fault 4 back"},
    {"TDP5", 7345, ro, in<percent>,              0,      255,   {}, "Drive thermal state at fault 5 back"},
    {"TDP6", 7346, ro, in<percent>,              0,      255,   {}, "Drive thermal state at fault 6 back"},
    {"TDP7", 7347, ro, in<percent>,              0,      255,   {}, "Drive thermal state at fault 7 back"},
    {"TDP8", 7348, ro, in<percent>,              0,      255,   {}, "Drive thermal state at fault 8 back"},
    {"TJP0", 7350, ro, in<whole_celsius>, 0, 255, {}, "Transistor temperature at the most recent fault"},
    {"TJP1", 7351, ro, in<whole_celsius>,        0,      255,   {}, "Transistor temperature at fault 1 back"},
    {"TJP2", 7352, ro, in<whole_celsius>,        0,      255,   {}, "Transistor temperature at fault 2 back"},
    {"TJP3", 7353, ro, in<whole_celsius>,        0,      255,   {}, "Transistor temperature at fault 3 back"},
    {"TJP4", 7354, ro, in<whole_celsius>,        0,      255,   {}, "Transistor temperature at fault 4 back"},
    {"TJP5", 7355, ro, in<whole_celsius>,        0,      255,   {}, "Transistor temperature at fault 5 back"},
    {"TJP6", 7356, ro, in<whole_celsius>,        0,      255,   {}, "Transistor temperature at fault 6 back"},
    {"TJP7", 7357, ro, in<whole_celsius>,        0,      255,   {}, "Transistor temperature at fault 7 back"},
    {"TJP8", 7358, ro, in<whole_celsius>,        0,      255,   {}, "Transistor temperature at fault 8 back"},
    {"SFP0", 7360, ro, in<hertz>, 0, 65535, {}, "Switching frequency at the most recent fault"},
    {"SFP1", 7361, ro, in<hertz>,                0,      65535, {}, "Switching frequency at fault 1 back"},
    {"SFP2", 7362, ro, in<hertz>,                0,      65535, {}, "Switching frequency at fault 2 back"},
    {"SFP3", 7363, ro, in<hertz>,                0,      65535, {}, "Switching frequency at fault 3 back"},
    {"SFP4", 7364, ro, in<hertz>,                0,      65535, {}, "Switching frequency at fault 4 back"},
    {"SFP5", 7365, ro, in<hertz>,                0,      65535, {}, "Switching frequency at fault 5 back"},
    {"SFP6", 7366, ro, in<hertz>,                0,      65535, {}, "Switching frequency at fault 6 back"},
    {"SFP7", 7367, ro, in<hertz>,                0,      65535, {}, "Switching frequency at fault 7 back"},
    {"SFP8", 7368, ro, in<hertz>,                0,      65535, {}, "Switching frequency at fault 8 back"},
};
// clang-format on

} // namespace altivar::atv320::rows
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
