// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: its functions. How to read a line stands in parameters/parameter.hpp.
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
// The shape of a ramp.
inline constexpr choice ramp_shape[]{
    {0, "LIn", "linear"}, {1, "S", "S"}, {2, "U", "U"}, {3, "CUS", "as TA1 to TA4 say"},
};
// Whether a ramp is stretched when braking raises the DC bus.
inline constexpr choice ramp_adaptation[]{
    {0, "nO", "off"}, {1, "YES", "on"}, {2, "dYnA", "on, with more braking in the motor"},
};
// DC injection at standstill.
inline constexpr choice auto_injection[]{{0, "nO", "off"}, {1, "YES", "for a time"}, {2, "Ct", "continuous"}};
// Where a speed set by two inputs is kept.
inline constexpr choice speed_memory[]{{0, "nO", "not stored"}, {1, "rAM", "in RAM"}, {2, "EEP", "in EEPROM"}};
// How the load moves.
inline constexpr choice brake_movement[]{{0, "HOr", "horizontal"}, {1, "VEr", "vertical"}};
// Torque before the brake opens.
inline constexpr choice brake_impulse[]{
    {0, "nO", "in the requested direction"}, {1, "YES", "always forward"},
    {2, "2Ibr", "in the direction of each current"},
};
// The output that commands the brake.
inline constexpr choice brake_output[]{
    {0, "nO", "not assigned"}, {2, "r2", "R2"}, {17, "LO1", "LO1"}, {64, "dO1", "logic output on AO1"},
};
// How the speed of a hoist is raised.
inline constexpr choice fast_hoisting[]{
    {0, "nO", "off"}, {1, "SSO", "limited by reference"}, {2, "CSO", "limited by current"},
};
// How a slack rope is found.
inline constexpr choice slack_rope[]{
    {0, "nO", "off"}, {1, "drI", "estimated by the drive"}, {2, "PES", "by the weight sensor"},
};
// The size of a torque step.
inline constexpr choice torque_step[]{{0, "001", "0.01 %"}, {1, "01", "0.1 %"}, {2, "1", "1 %"}};
// The output of a contactor.
inline constexpr choice contactor[]{
    {0, "nO", "not assigned"}, {146, "r2", "R2"}, {129, "LO1", "LO1"}, {161, "dO1", "logic output on AO1"},
};
// How the ramp after a slowdown switch is found.
inline constexpr choice slowdown_type[]{{0, "Std", "by the ramp in use"}, {1, "OPt", "by the speed at the switch"}};

// Preset speeds, jogging and other references.
inline constexpr parameter functions_speed[]{
    {"SPM",  8491,  cfg, logic_input,     {}, {},   0,    "Input that stores the reference"},
    {"JOG",  11110, cfg, logic_input,     {}, {},   {},   "Input for jogging", &moves},
    {"JGF",  11111, rw,  in<decihertz>,   0,  100,  100,  "Jog frequency", &speed},
    {"JGT",  11112, rw,  in<deciseconds>, 0,  20,   5,    "Delay between two jogs", &skipped},
    {"JPF",  11301, rw,  in<decihertz>,   0,  5990, 0,    "Skip frequency", &skipped},
    {"JF2",  11302, rw,  in<decihertz>,   0,  5990, 0,    "Skip frequency 2", &skipped},
    {"JF3",  11303, rw,  in<decihertz>,   0,  5990, 0,    "Skip frequency 3", &skipped},
    {"JFH",  11311, rw,  in<decihertz>,   1,  100,  10,   "Width of the skip frequency bands", &skipped},
    {"PS2",  11401, cfg, logic_input,     {}, {},   {},   "Input for 2 preset speeds"},
    {"PS4",  11402, cfg, logic_input,     {}, {},   {},   "Input for 4 preset speeds"},
    {"PS8",  11403, cfg, logic_input,     {}, {},   {},   "Input for 8 preset speeds"},
    {"PS16", 11404, cfg, logic_input,     {}, {},   0,    "Input for 16 preset speeds"},
    {"SP2",  11410, rw,  in<decihertz>,   0,  5990, 100,  "Preset speed 2", &speed},
    {"SP3",  11411, rw,  in<decihertz>,   0,  5990, 150,  "Preset speed 3", &speed},
    {"SP4",  11412, rw,  in<decihertz>,   0,  5990, 200,  "Preset speed 4", &speed},
    {"SP5",  11413, rw,  in<decihertz>,   0,  5990, 250,  "Preset speed 5", &speed},
    {"SP6",  11414, rw,  in<decihertz>,   0,  5990, 300,  "Preset speed 6", &speed},
    {"SP7",  11415, rw,  in<decihertz>,   0,  5990, 350,  "Preset speed 7", &speed},
    {"SP8",  11416, rw,  in<decihertz>,   0,  5990, 400,  "Preset speed 8", &speed},
    {"SP9",  11417, rw,  in<decihertz>,   0,  5990, 450,  "Preset speed 9", &speed},
    {"SP10", 11418, rw,  in<decihertz>,   0,  5990, 500,  "Preset speed 10", &speed},
    {"SP11", 11419, rw,  in<decihertz>,   0,  5990, 550,  "Preset speed 11", &speed},
    {"SP12", 11420, rw,  in<decihertz>,   0,  5990, 600,  "Preset speed 12", &speed},
    {"SP13", 11421, rw,  in<decihertz>,   0,  5990, 700,  "Preset speed 13", &speed},
    {"SP14", 11422, rw,  in<decihertz>,   0,  5990, 800,  "Preset speed 14", &speed},
    {"SP15", 11423, rw,  in<decihertz>,   0,  5990, 900,  "Preset speed 15", &speed},
    {"SP16", 11424, rw,  in<decihertz>,   0,  5990, 1000, "Preset speed 16", &speed},
    {"USP",  11501, cfg, logic_input,     {}, {},   0,    "Input for faster"},
    {"DSP",  11502, cfg, logic_input,     {}, {},   0,    "Input for slower"},
    {"STR",  11503, cfg, speed_memory,    {}, {}, 0, "Where the +/- speed reference is stored", &speed_range},
    {"SRP",  11505, rw,  in<percent>,     0, 50, 10, "+/- speed range around the reference", &speed_range},
    {"USI",  11520, cfg, logic_input,     {}, {},   0,    "Input for faster, around the reference"},
    {"DSI",  11521, cfg, logic_input,     {}, {},   0,    "Input for slower, around the reference"},
    {"TLS",  11701, rw,  in<deciseconds>, 0,  9999, 0,    "Longest time at low speed", &skipped},
    {"SA2",  11801, cfg, signal_source,   {}, {},   {},   "Summing input 2"},
    {"SA3",  11802, cfg, signal_source,   {}, {},   0,    "Summing input 3"},
    {"DA2",  11811, cfg, signal_source,   {}, {},   0,    "Subtracted reference 2"},
    {"DA3",  11812, cfg, signal_source,   {}, {},   0,    "Subtracted reference 3"},
    {"MA2",  11821, cfg, signal_source,   {}, {},   0,    "Multiplier 2 of the reference"},
    {"MA3",  11822, cfg, signal_source,   {}, {},   0,    "Multiplier 3 of the reference"},
    {"MFR",  11831, rw,  in<percent>,     0,  100,  {},   "Gain of the multiplied reference", &speed_range},
    {"SH2",  15101, cfg, logic_input,     {}, {},   0,    "Input for 2 high speeds"},
    {"SH4",  15102, cfg, logic_input,     {}, {},   0,    "Input for 4 high speeds"},
    {"HSP2", 15110, rw,  in<decihertz>,   0,  5990, {},   "High speed 2", &speed},
    {"HSP3", 15111, rw,  in<decihertz>,   0,  5990, {},   "High speed 3", &speed},
    {"HSP4", 15112, rw,  in<decihertz>,   0,  5990, {},   "High speed 4", &speed},
};

// Ramps.
inline constexpr parameter functions_ramp[]{
    {"BRA", 9003, cfg, ramp_adaptation, {}, {},   1,  "Deceleration ramp adaptation", &ramp},
    {"RPT", 9004, rw,  ramp_shape,      {}, {},   0,  "Ramp shape", &ramp},
    {"TA1", 9005, rw,  in<percent>,     0,  100,  10, "Rounding at the start of acceleration", &ramp},
    {"TA2", 9006, rw,  in<percent>,     0,  100,  10, "Rounding at the end of acceleration", &ramp},
    {"TA3", 9007, rw,  in<percent>,     0,  100,  10, "Rounding at the start of deceleration", &ramp},
    {"TA4", 9008, rw,  in<percent>,     0,  100,  10, "Rounding at the end of deceleration", &ramp},
    {"RPS", 9010, cfg, logic_input,     {}, {},   0,  "Input that selects the second ramp"},
    {"FRT", 9011, cfg, in<decihertz>,   0,  5990, 0,  "Frequency that selects the second ramp", &ramp},
    row_of(ac2, ramp), row_of(de2, ramp), row_of(inr, steps),
};

// Stopping and DC injection.
inline constexpr parameter functions_stop[]{
    {"ADC",  10401, rw,  auto_injection,             {}, {},   {},  "Automatic DC injection", &stopping},
    {"TDC1", 10402, rw,  in<deciseconds>, 1, 300, 5, "Automatic DC injection: first time", &stopping},
    {"TDC2", 10404, rw,  in<deciseconds>, 0, 300, 0, "Automatic DC injection: second time", &stopping},
    row_of(stt, stopping),
    {"NST",  11202, cfg, logic_input,                {}, {},   0,   "Input for freewheel stop", &stop_input},
    {"DCI",  11203, cfg, logic_input,                {}, {},   0,   "Input for DC injection", &stop_input},
    {"FST",  11204, cfg, logic_input,                {}, {},   0,   "Input for fast stop", &stop_input},
    {"TDC",  11211, rw,  in<deciseconds>, 1, 300, 5, "DC injection: time of the second current", &stopping},
    {"TDI",  11213, rw,  in<deciseconds>, 1, 300, 5, "DC injection: time of the first current", &stopping},
    {"FFT",  11220, rw,  in<decihertz>, 2, 5990, {}, "Frequency below which the motor freewheels", &stopping},
    {"DCF",  11230, rw,  in<count16>,                0,  10,   4,   "Fast stop: ramp divider", &stopping},
    {"SAF",  12501, cfg, logic_input, {}, {}, 0, "Input of the forward stop switch", &stop_input},
    {"SAR",  12502, cfg, logic_input, {}, {}, 0, "Input of the reverse stop switch", &stop_input},
    {"DAF",  12503, cfg, logic_input, {}, {}, 0, "Input of the forward slowdown switch", &stop_input},
    {"DAR",  12504, cfg, logic_input, {}, {}, 0, "Input of the reverse slowdown switch", &stop_input},
    {"DSF",  12505, cfg, slowdown_type, {}, {}, 0, "Deceleration after a slowdown switch", &stopping},
    {"PAS",  12506, cfg, in<stop_mode>,              {}, {},   0,   "How a limit switch stops", &stop_input},
    {"CLS",  12507, cfg, logic_input, {}, {}, 0, "Input that disables the limit switches", &stop_input},
    {"SAL",  12508, cfg, input_level, {}, {}, 0, "Active level of the stop switches", &stop_input},
    {"DAL",  12509, cfg, input_level, {}, {}, 0, "Active level of the slowdown switches", &stop_input},
    {"NLS",  12511, cfg, in<centimetres_per_second>, 20, 500,  100, "Rated linear speed", &stopping},
    {"STD",  12521, cfg, in<centimetres>,            0,  1000, 0,   "Stop distance", &stopping},
    {"SFD",  12522, cfg, in<percent>,                50, 200,  100, "Stop distance correction", &stopping},
};

// The PID regulator.
inline constexpr parameter functions_pid[]{
    {"PIF",  11901, cfg,          signal_source,          {}, {}, {}, "PI feedback source", &regulation},
    {"PIF1", 11904, rw,           in<count16>,            0, 32767, 100, "PI feedback minimum", &regulation},
    {"PIF2", 11905, rw,           in<count16>,            0, 32767, 1000, "PI feedback maximum", &regulation},
    {"PIP1", 11906, rw,           in<count16>,            0, 32767, 150, "PI reference minimum", &regulation},
    {"PIP2", 11907, rw,           in<count16>,            0, 32767, 900, "PI reference maximum", &regulation},
    {"PII",  11908, cfg,          in<no_yes>,             {}, {}, 0, "PI reference is internal", &regulation},
    {"PR2",  11909, cfg,          logic_input,            {}, {}, {}, "Input for 2 preset PI references"},
    {"PR4",  11910, cfg,          logic_input,            {}, {}, {}, "Input for 4 preset PI references"},
    {"RPI",  11920, doubtful(rw), in<count16>, 0, 32767, 150, "PI internal reference", &regulation},
    {"RP2",  11921, doubtful(rw), in<count16>, 0, 32767, 300, "Preset PI reference 2", &regulation},
    {"RP3",  11922, doubtful(rw), in<count16>, 0, 32767, 600, "Preset PI reference 3", &regulation},
    {"RP4",  11923, doubtful(rw), in<count16>, 0, 32767, 900, "Preset PI reference 4", &regulation},
    {"PIC",  11940, cfg,          in<no_yes>,             {}, {}, 0, "PI correction reversed", &regulation},
    {"RPG",  11941, rw,           in<count16_hundredths>, 1, 10000, 100, "PI proportional gain", &regulation},
    {"RIG",  11942, rw,           in<count16_hundredths>, 1, 10000, 100, "PI integral gain", &regulation},
    {"RDG",  11943, rw,           in<count16_hundredths>, 0, 10000, 0, "PID derivative gain", &regulation},
    {"PIS",  11944, cfg,          logic_input,            {}, {}, {}, "Input that resets the PI integral"},
    {"FPI", 11950, cfg, signal_source, {}, {}, 0, "Speed reference added to the PI output", &regulation},
    {"PSR", 11951, rw, in<percent>, 1, 100, 100, "Share of the added speed reference", &regulation},
    {"POL",  11952, rw,           in<signed_decihertz>,   -5990, 5990, 0, "PI output minimum", &regulation},
    {"POH",  11953, rw,           in<signed_decihertz>,   0, 5990, 600, "PI output maximum", &regulation},
    {"PIM",  11954, cfg,          signal_source,          {}, {}, 0, "Reference in manual mode", &regulation},
    {"RSL", 11960, cfg, in<count16_tenths>, 0, 1000, 0, "PI error that wakes the drive", &regulation},
    {"PAU",  11970, cfg,          logic_input, {}, {}, 0, "Input that selects automatic or manual"},
    {"RPE",  11980, doubtful(ro), in<signed_count16>,     -32767, 32767, {},   "PI error"},
    {"RPF",  11981, doubtful(ro), in<count16>,            0,      65535, {},   "PI feedback"},
    {"RPC",  11982, doubtful(ro), in<count16>,            0,      65535, {},   "PI reference"},
    {"RPO",  11983, ro,           in<signed_decihertz>,   -32767, 32767, {},   "PI output"},
    {"PRP",  11984, rw,           in<deciseconds>,        0, 999, 0, "PI reference ramp time", &regulation},
};

// Torque and current limits.
inline constexpr parameter functions_limits[]{
    {"LC2",  9202, cfg, logic_input,             {}, {},   0,    "Input for the second current limit"},
    {"TLA",  9210, cfg, logic_input,             {}, {},   {},   "Input that enables the torque limits"},
    {"TLC",  9213, cfg, logic_input,             {}, {}, 128, "Input that enables the torque limit signal"},
    {"TAA",  9214, cfg, signal_source,           {}, {},   0,    "Torque limit signal"},
    {"INTP", 9215, cfg, torque_step,             {}, {},   2,    "Size of a torque limit step", &steps},
    {"SSB",  9240, cfg, fault_reaction, {}, {}, 0, "Reaction to the torque or current limit", &reaction},
    {"STO",  9241, rw,  in<units::milliseconds>, 0,  9999, 1000, "Time in limit before the reaction"},
};

// Brake control.
inline constexpr parameter functions_brake[]{
    {"BLC", 10001, cfg, brake_output,           {}, {}, {}, "Output that controls the brake", &relay},
    {"BEN", 10003, rw,  in<signed_decihertz>,   {},     100,   {},   "Brake engage frequency", &brake},
    {"BRT", 10004, rw,  in<centiseconds>,       0,      500,   {},   "Brake release time", &brake},
    {"BET", 10005, rw,  in<centiseconds>,       0,      500,   {},   "Brake engage time", &brake},
    {"BIP", 10007, rw,  brake_impulse,          {},     {},    {},   "Torque at brake release", &brake},
    {"BST", 10008, cfg, brake_movement,         {},     {},    1,    "Movement type", &brake},
    {"BCI", 10009, cfg, logic_input,            {},     {},    0,    "Input of the brake contact", &blind},
    {"TBE", 10010, rw,  in<centiseconds>,       0,      500,   0,    "Brake engage delay", &brake},
    {"BIR", 10012, rw,  in<signed_decihertz>,   {},     100,   {},   "Brake release frequency", &brake},
    {"JDC", 10013, rw,  in<signed_decihertz>,   {},     100,   {},   "Frequency jump at reversal", &brake},
    {"BRR", 10015, rw,  in<centiseconds>,       0, 500, 0, "Brake release: current ramp time", &brake},
    {"BED", 10020, rw,  in<no_yes>,             {},     {},    0,    "Brake engaged at reversal", &brake},
    {"TTR", 10022, rw,  in<centiseconds>,       0, 1500, 0, "Shortest time before a restart", &brake},
    {"PES", 10070, cfg, signal_source,          {},     {},    0,    "Input of the weight sensor"},
    {"LP1", 10071, cfg, in<hundredth_percent>,  0,      9999,  0,    "Weight sensor point 1: signal", &brake},
    {"CP1", 10072, cfg, in<signed_deciamperes>, -32767, 32767, {}, "Weight sensor point 1: current", &brake},
    {"LP2", 10073, cfg, in<hundredth_percent>,  1,      10000, 5000, "Weight sensor point 2: signal", &brake},
    {"CP2", 10074, cfg, in<signed_deciamperes>, -32767, 32767, 0, "Weight sensor point 2: current", &brake},
};

// High-speed hoisting and load sharing.
inline constexpr parameter functions_hoisting[]{
    {"HSO",  12301, cfg, fast_hoisting,           {}, {},    0,   "High-speed hoisting", &brake},
    {"COF",  12303, rw,  in<percent>,             0,  100,   100, "Motoring speed coefficient", &brake},
    {"COR",  12304, rw,  in<percent>,             0,  100,   50,  "Generating speed coefficient", &brake},
    {"OSP",  12305, rw,  in<decihertz>,           0,  5990,  400, "Load measuring frequency", &brake},
    {"SCL",  12306, rw,  in<decihertz>, 0, 5990, 400, "Frequency that enables the high-speed limit", &brake},
    {"TOS",  12307, rw,  in<centiseconds>,        10, 6500,  50,  "Load measuring time", &brake},
    {"RSD",  12321, cfg, slack_rope,              {}, {},    0,   "Slack rope detection", &reaction},
    {"RSTL", 12322, cfg, in<percent>,             0,  100,   0,   "Slack rope torque", &brake},
    {"LBA",  14301, cfg, in<no_yes>,              {}, {},    0,   "Load sharing", &brake},
    {"LBC",  14302, rw,  in<decihertz>,           0, 5990, 0, "Load sharing: frequency correction", &brake},
    {"LBC1", 14303, rw,  in<decihertz>, 0, 5989, 0, "Load sharing: lower correction frequency", &brake},
    {"LBC2", 14304, rw,  in<decihertz>, 1, 5990, 1, "Load sharing: upper correction frequency", &brake},
    {"LBC3", 14305, rw,  in<percent>,             0,  300,   0,   "Load sharing: torque offset", &brake},
    {"LBF",  14306, rw,  in<units::milliseconds>, 0,  20000, 100, "Load sharing: filter", &brake},
};

// Traverse control.
inline constexpr parameter functions_traverse[]{
    {"TRC", 12201, cfg,           logic_input,     {}, {},   0,  "Input that enables traverse control"},
    {"TRH", 12202, rw,            in<decihertz>, 0, 100, 40, "Traverse frequency, upper amplitude", &winding},
    {"TRL", 12203, rw,            in<decihertz>, 0, 100, 40, "Traverse frequency, lower amplitude", &winding},
    {"QSH", 12204, rw,            in<decihertz>,   0,  100,  0,  "Quick step, upper", &winding},
    {"QSL", 12205, rw,            in<decihertz>,   0,  100,  0,  "Quick step, lower", &winding},
    {"TUP", 12206, rw,            in<deciseconds>, 1,  9999, 40, "Traverse acceleration time", &winding},
    {"TDN", 12207, rw,            in<deciseconds>, 1,  9999, 40, "Traverse deceleration time", &winding},
    {"TBO", 12208, rw,            in<minutes>,     0,  9999, 0,  "Winding time of a reel", &winding},
    {"RTR", 12210, cfg,           logic_input,     {}, {},   0,  "Input that restarts traverse control"},
    {"DTF", 12211, rw, in<decihertz>, 0, 5990, 0, "Decrease of the reference during winding", &winding},
    {"SNC", 12212, cfg,           logic_input,     {}, {},   0,  "Input for counter wobble"},
    {"EBO", 12213, doubtful(cfg), contactor,       {}, {},   {}, "Output for end of reel"},
    {"TSY", 12214, doubtful(cfg), contactor,       {}, {},   {}, "Output that synchronises the wobble"},
};

// Contactors.
inline constexpr parameter functions_contactor[]{
    {"DBS", 13101, rw,            in<centiseconds>, 5,  6000, 15, "Delay before starting the motor", &brake},
    {"DAS", 13102, rw,            in<centiseconds>, 0, 500, 10, "Delay before opening the contactor", &brake},
    {"RCA", 13103, cfg,           logic_input, {}, {}, 0, "Input of the output contactor's feedback", &blind},
    {"OCC", 13104, doubtful(cfg), contactor, {}, {}, {}, "Output that controls the output contactor", &relay},
    {"LES", 13601, cfg,           logic_input,      {}, {},   0,  "Input for emergency stop", &stop_input},
    {"LLC", 13602, doubtful(cfg), contactor, {}, {}, {}, "Output that controls the line contactor", &relay},
    {"LCT", 13603, cfg,           in<seconds>,      5,  999,  5,  "Time-out of the line contactor"},
};

// Parameter sets.
inline constexpr parameter functions_parameter_sets[]{
    {"VAL",  12901, rw,  in<count16>, 0,  1,     0, "Load a parameter set", &loads_set},
    {"CHA1", 12902, cfg, logic_input, {}, {},    0, "Input that selects parameter set 2", &selection},
    {"CHA2", 12903, cfg, logic_input, {}, {},    0, "Input that selects parameter set 3", &selection},
    {"AD01", 12911, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 1", &targets},
    {"AD02", 12912, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 2", &targets},
    {"AD03", 12913, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 3", &targets},
    {"AD04", 12914, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 4", &targets},
    {"AD05", 12915, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 5", &targets},
    {"AD06", 12916, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 6", &targets},
    {"AD07", 12917, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 7", &targets},
    {"AD08", 12918, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 8", &targets},
    {"AD09", 12919, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 9", &targets},
    {"AD10", 12920, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 10", &targets},
    {"AD11", 12921, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 11", &targets},
    {"AD12", 12922, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 12", &targets},
    {"AD13", 12923, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 13", &targets},
    {"AD14", 12924, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 14", &targets},
    {"AD15", 12925, rw,  in<count16>, 0,  65535, 0, "Parameter sets: address of register 15", &targets},
    {"S101", 12931, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 1"},
    {"S102", 12932, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 2"},
    {"S103", 12933, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 3"},
    {"S104", 12934, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 4"},
    {"S105", 12935, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 5"},
    {"S106", 12936, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 6"},
    {"S107", 12937, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 7"},
    {"S108", 12938, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 8"},
    {"S109", 12939, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 9"},
    {"S110", 12940, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 10"},
    {"S111", 12941, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 11"},
    {"S112", 12942, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 12"},
    {"S113", 12943, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 13"},
    {"S114", 12944, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 14"},
    {"S115", 12945, rw,  in<count16>, 0,  65535, 0, "Parameter set 1: value of register 15"},
    {"S201", 12951, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 1"},
    {"S202", 12952, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 2"},
    {"S203", 12953, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 3"},
    {"S204", 12954, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 4"},
    {"S205", 12955, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 5"},
    {"S206", 12956, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 6"},
    {"S207", 12957, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 7"},
    {"S208", 12958, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 8"},
    {"S209", 12959, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 9"},
    {"S210", 12960, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 10"},
    {"S211", 12961, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 11"},
    {"S212", 12962, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 12"},
    {"S213", 12963, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 13"},
    {"S214", 12964, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 14"},
    {"S215", 12965, rw,  in<count16>, 0,  65535, 0, "Parameter set 2: value of register 15"},
    {"S301", 12971, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 1"},
    {"S302", 12972, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 2"},
    {"S303", 12973, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 3"},
    {"S304", 12974, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 4"},
    {"S305", 12975, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 5"},
    {"S306", 12976, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 6"},
    {"S307", 12977, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 7"},
    {"S308", 12978, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 8"},
    {"S309", 12979, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 9"},
    {"S310", 12980, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 10"},
    {"S311", 12981, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 11"},
    {"S312", 12982, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 12"},
    {"S313", 12983, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 13"},
    {"S314", 12984, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 14"},
    {"S315", 12985, rw,  in<count16>, 0,  65535, 0, "Parameter set 3: value of register 15"},
};
// clang-format on

} // namespace altivar::atv320::rows
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
