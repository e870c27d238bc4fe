// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV12: all its parameters, by the groups of its menus, from its public parameter file (BBV51917). Those of which too
// little is known to write them stand apart: read-only, doubtful. How to read a line stands in parameters/parameter.hpp.
#pragma once

#include <rtuwire/altivar/device/atv12.hpp>
#include <rtuwire/altivar/parameters/compact_choices.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/altivar/parameters/row_table.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv12::rows {

// clang-format off
using namespace roles;
using namespace compact_choices;

inline constexpr row_access ro{access::read_only, provenance::documented};
inline constexpr row_access rw{access::read_write, provenance::documented};
inline constexpr row_access cfg{access::configuration, provenance::documented};

// What the drive shows.
inline constexpr parameter monitoring[]{
    row_of(eta), row_of(rfr), row_of(frh), row_of(lcr), row_of(eti), row_of(uln), row_of(thd), row_of(opr),
    row_of(rthi), row_of(pth),
    {"TAC",  3235, cfg, in<seconds>,          0, 65535, 0, "Time in transistor temperature alarm", &counter},
    {"PET",  3236, rw,  in<centihours>,       0,  65535, 0,  "Process running time", &counter},
    {"FTH",  3239, ro,  in<centihours>,       0,  65535, 0,  "Fan running time"},
    row_of(hmis),
    {"TAC2", 3242, cfg, in<seconds>, 0, 65535, 0, "Time at the lowest switching frequency", &counter},
    {"CRC",  8441, ro,  bits(active_channel), {}, {},    {}, "Active reference channel"},
    {"CCC",  8442, ro,  bits(active_channel), {}, {},    {}, "Active command channel"},
    row_of(thr),
};

// Words that command the drive, and its speed mode.
inline constexpr parameter control[]{
    {"RPR", 3120, rw, counter_reset, {}, {}, 0, "Counter reset", &clears},
    row_of(cmd, commands), row_of(lfr, setpoint), row_of(pisp, setpoint), row_of(cmi, recalls),
    row_of(cmdd, commands), row_of(lfrd, setpoint), row_of(etad), row_of(rfrd),
};

// Where commands and references come from.
inline constexpr parameter command[]{
    {"RIN",  3108,  cfg, no_yes,           {}, {}, {}, "Reverse direction locked", &speed_range},
    row_of(chcf, commander), row_of(fr1, references), row_of(cd1, commander), row_of(flo, commander),
    {"FLOC", 8432,  cfg, signal_source,    {}, {}, 0,  "Reference channel in local control", &references},
    row_of(tcc, wiring),
    {"TCT",  11102, cfg, two_wire_type,    {}, {}, 1,  "How 2-wire control reacts", &wiring},
    {"RRS",  11105, cfg, input_assignment, {}, {}, {}, "Input for reverse running", &wiring},
    {"PST",  64002, cfg, no_yes,           {}, {}, 1,  "Stop key always active", &stop_input},
};

// Everyday settings.
inline constexpr parameter settings[]{
    row_of(hsp, speed_limit), row_of(lsp, speed_limit), row_of(acc, ramp), row_of(dec, ramp),
    row_of(ith, ordinary),
    {"CTD", 11001, rw, in<deciamperes>, 0, 65535, {}, "Motor current threshold"},
    {"FTD", 11003, rw, in<decihertz>,   0, 4000,  {}, "Frequency threshold"},
};

// The motor and its control.
inline constexpr parameter motor_control[]{
    {"BFR",  3015, cfg, motor_standard,    {}, {},    0,   "Standard motor frequency", &speed_range},
    {"SFT",  3101, cfg, switching_mode,    {}, {},    1,   "Switching frequency mode"},
    row_of(sfr, ordinary), row_of(tfr, speed_limit),
    {"NRD",  3107, cfg, no_yes,            {}, {},    0,   "Motor noise reduction"},
    {"SFC",  9105, rw,  in<count16>,       0,  100,   {},  "Speed loop filter", &tuning},
    row_of(uns, ordinary), row_of(frs, ordinary), row_of(ncr, ordinary), row_of(nsp, ordinary),
    row_of(cos, ordinary),
    {"CTT",  9607, cfg, motor_control_law, {}, {},    {},  "Motor control law"},
    {"TUN",  9608, cfg, tuning_order,      {}, {},    0,   "Autotune", &autotuning},
    row_of(npr, ordinary),
    {"STUN", 9617, ro,  tuning_state,      {}, {},    0,   "Motor model data in use"},
    {"FLG",  9620, rw,  in<percent>,       0,  100,   20,  "Frequency loop gain", &tuning},
    {"STA",  9621, rw,  in<percent>,       0,  100,   20,  "Frequency loop stability", &tuning},
    {"UFR",  9623, rw,  in<percent>,       25, 200,   100, "IR compensation", &tuning},
    {"PFL",  9624, rw,  in<percent>,       0,  100,   20,  "V/f flux profile", &tuning},
    {"SLP",  9625, rw,  in<percent>,       0,  150,   {},  "Slip compensation", &tuning},
    {"SPGU", 9629, rw,  in<percent>,       0,  1000,  40,  "Inertia compensation of the V/f laws", &tuning},
    {"RSM",  9640, ro,  in<milliohms>,     0,  65535, 0,   "Stator resistance in use"},
    {"RSMI", 9641, ro,  in<count16>,       0,  65535, 0,   "Stator resistance measured"},
};

// Analog inputs and outputs.
inline constexpr parameter analog_io[]{
    {"AI1T", 4402, cfg, analog_type,              {},     {},    {},  "AI1 type", &scaling},
    {"CRL1", 4432, cfg, in<tenth_milliamperes>,   0,      200,   40,  "AI1 current at 0 %", &scaling},
    {"CRH1", 4442, cfg, in<tenth_milliamperes>,   0,      200,   200, "AI1 current at 100 %", &scaling},
    {"AO1T", 4601, cfg, analog_type,              {},     {},    2,   "AO1 type"},
    {"AO1",  5021, cfg, signal_source,            {},     {},    0,   "Output AO1 function"},
    {"AI1I", 5222, ro,  in<signed_count16>,       -32767, 32767, 0,   "AI1 at the terminal, in steps"},
    {"AI1R", 5232, ro,  in<signed_count16>,       -32767, 32767, 0,   "AI1, standardised value"},
    {"AO1R", 5261, rw,  in<signed_count16>,       -32767, 32767, 0, "AO1, standardised value", &sets_output},
    {"AIV1", 5281, rw,  in<signed_tenth_percent>, 0,      1000,  0,   "Virtual analog input 1", &setpoint},
};

// Logic inputs and outputs, and relays.
inline constexpr parameter logic_io[]{
    {"NPL",  4099, cfg, logic_level,        {}, {}, 0,  "Active level of the logic inputs", &wiring},
    {"R1S",  4201, cfg, logic_level,        {}, {}, 0,  "Relay R1 active level", &relay},
    {"LO1S", 4209, cfg, logic_level,        {}, {}, 0,  "Output LO1 active level", &relay},
    {"R1",   5001, cfg, input_assignment,   {}, {}, 1,  "Relay R1 function", &relay},
    {"LO1",  5009, cfg, input_assignment,   {}, {}, 0,  "Output LO1 function", &relay},
    row_of(il1i),
    {"OL1R", 5212, rw,  bits(output_image), {}, {}, {}, "Logic outputs", &sets_output},
};

// Lines and networks.
inline constexpr parameter communication[]{
    row_of(add, this_line), row_of(tbr, this_line), row_of(tfo, this_line), row_of(tto, timeout),
};

// The scanner: words that one request moves.
inline constexpr parameter scanner[]{
    row_of(nma1, ordinary), row_of(nma2, ordinary), row_of(nma3, ordinary), row_of(nma4, ordinary),
    row_of(nca1, cyclic_words), row_of(nca2, cyclic_words), row_of(nca3, cyclic_words),
    row_of(nca4, cyclic_words), row_of(nm1), row_of(nm2), row_of(nm3), row_of(nm4), row_of(nc1, passed_on),
    row_of(nc2, passed_on), row_of(nc3, passed_on), row_of(nc4, passed_on),
};

// Reactions to faults.
inline constexpr parameter faults[]{
    {"EPL",  7006, cfg, fault_reaction,   {}, {},   1,  "Reaction to an external fault", &reaction},
    row_of(sll, link_loss),
    {"LFL1", 7017, cfg, fault_reaction,   {}, {},   {}, "Reaction to a lost signal on AI1", &reaction},
    {"LFF",  7080, cfg, in<decihertz>,    0,  4000, 0,  "Fallback speed", &speed},
    row_of(lft),
    {"INH",  7125, cfg, input_assignment, {}, {},   0,  "Input that inhibits faults", &stop_input},
    row_of(cic, accepts),
    {"ETF",  7131, cfg, input_assignment, {}, {},   0,  "Input for external fault", &stop_input},
    {"MTM",  9616, cfg, no_yes,           {}, {},   0,  "Motor thermal state is remembered", &blind},
};

// Load monitoring.
inline constexpr parameter process_monitoring[]{
    {"ULT", 14411, cfg, in<seconds>, 0,  100, 0,  "Underload detection delay", &blind},
    {"FTU", 14413, rw,  in<minutes>, 0,  6,   0,  "Underload restart delay", &restarts},
    {"LUL", 14415, rw,  in<percent>, 20, 100, 60, "Underload threshold at zero speed"},
    {"TOL", 14421, cfg, in<seconds>, 0,  100, 0,  "Overload detection delay", &blind},
    {"FTO", 14423, rw,  in<minutes>, 0,  6,   0,  "Overload restart delay", &restarts},
    {"LOC", 14425, rw,  in<percent>, 70, 150, 90, "Overload threshold"},
};

// What drive this is.
inline constexpr parameter identification[]{
    row_of(ncv, device_identity), row_of(vcal, device_identity), row_of(inv),
    {"SPN", 3301, rw, in<count16>, 0, 65535, 0, "Special product number", &device_identity},
    row_of(vdp),
};

// Saving and recalling configurations.
inline constexpr parameter configuration[]{
    {"CFG", 3052, cfg, macro_configuration,  {}, {}, 0, "Macro configuration", &macro},
    {"SCS", 8001, cfg, configuration_save,   {}, {}, 0, "Save the configuration", &recalls},
    {"FCS", 8002, cfg, configuration_recall, {}, {}, 0, "Load a configuration or factory settings", &recalls},
};

// States at past faults.
inline constexpr parameter history_state[]{
    row_of(dp0), row_of(dp1), row_of(dp2), row_of(dp3), row_of(dp4),
    {"EP0", 7210, ro, bits(state_history), {}, {}, {}, "Status word at the most recent fault"},
    {"EP1", 7211, ro, bits(state_history), {}, {}, {}, "Status word at fault 1 back"},
    {"EP2", 7212, ro, bits(state_history), {}, {}, {}, "Status word at fault 2 back"},
    {"EP3", 7213, ro, bits(state_history), {}, {}, {}, "Status word at fault 3 back"},
    {"EP4", 7214, ro, bits(state_history), {}, {}, {}, "Status word at fault 4 back"},
};

// Measurements at past faults.
inline constexpr parameter history_values[]{
    {"LCP1", 7241, ro, in<signed_deciamperes>, -32767, 32767, 0, "Motor current at fault 1 back"},
    {"LCP2", 7242, ro, in<signed_deciamperes>, -32767, 32767, 0, "Motor current at fault 2 back"},
    {"LCP3", 7243, ro, in<signed_deciamperes>, -32767, 32767, 0, "Motor current at fault 3 back"},
    {"LCP4", 7244, ro, in<signed_deciamperes>, -32767, 32767, 0, "Motor current at fault 4 back"},
    {"RFP1", 7251, ro, in<signed_decihertz>,   -32767, 32767, 0, "Output frequency at fault 1 back"},
    {"RFP2", 7252, ro, in<signed_decihertz>,   -32767, 32767, 0, "Output frequency at fault 2 back"},
    {"RFP3", 7253, ro, in<signed_decihertz>,   -32767, 32767, 0, "Output frequency at fault 3 back"},
    {"RFP4", 7254, ro, in<signed_decihertz>,   -32767, 32767, 0, "Output frequency at fault 4 back"},
    {"RTP1", 7261, ro, in<hours>,              0,      65535, 0, "Motor running time at fault 1 back"},
    {"RTP2", 7262, ro, in<hours>,              0,      65535, 0, "Motor running time at fault 2 back"},
    {"RTP3", 7263, ro, in<hours>,              0,      65535, 0, "Motor running time at fault 3 back"},
    {"RTP4", 7264, ro, in<hours>,              0,      65535, 0, "Motor running time at fault 4 back"},
    {"ULP1", 7271, ro, in<volts>,              0,      65535, 0, "Mains voltage at fault 1 back"},
    {"ULP2", 7272, ro, in<volts>,              0,      65535, 0, "Mains voltage at fault 2 back"},
    {"ULP3", 7273, ro, in<volts>,              0,      65535, 0, "Mains voltage at fault 3 back"},
    {"ULP4", 7274, ro, in<volts>,              0,      65535, 0, "Mains voltage at fault 4 back"},
    {"OTP1", 7331, ro, in<signed_percent>,     -32767, 32767, 0, "Motor torque at fault 1 back"},
    {"OTP2", 7332, ro, in<signed_percent>,     -32767, 32767, 0, "Motor torque at fault 2 back"},
    {"OTP3", 7333, ro, in<signed_percent>,     -32767, 32767, 0, "Motor torque at fault 3 back"},
    {"OTP4", 7334, ro, in<signed_percent>,     -32767, 32767, 0, "Motor torque at fault 4 back"},
    {"TDP1", 7341, ro, in<percent>,            0,      255,   0, "Drive thermal state at fault 1 back"},
    {"TDP2", 7342, ro, in<percent>,            0,      255,   0, "Drive thermal state at fault 2 back"},
    {"TDP3", 7343, ro, in<percent>,            0,      255,   0, "Drive thermal state at fault 3 back"},
    {"TDP4", 7344, ro, in<percent>,            0,      255,   0, "Drive thermal state at fault 4 back"},
    {"TJP1", 7351, ro, in<whole_celsius>,      0,      255,   0, "Transistor temperature at fault 1 back"},
    {"TJP2", 7352, ro, in<whole_celsius>,      0,      255,   0, "Transistor temperature at fault 2 back"},
    {"TJP3", 7353, ro, in<whole_celsius>,      0,      255,   0, "Transistor temperature at fault 3 back"},
    {"TJP4", 7354, ro, in<whole_celsius>,      0,      255,   0, "Transistor temperature at fault 4 back"},
    {"SFP1", 7361, ro, in<hertz>,              0,      65535, 0, "Switching frequency at fault 1 back"},
    {"SFP2", 7362, ro, in<hertz>,              0,      65535, 0, "Switching frequency at fault 2 back"},
    {"SFP3", 7363, ro, in<hertz>,              0,      65535, 0, "Switching frequency at fault 3 back"},
    {"SFP4", 7364, ro, in<hertz>,              0,      65535, 0, "Switching frequency at fault 4 back"},
};

// Preset speeds, jogging and other references.
inline constexpr parameter functions_speed[]{
    {"JOG",  11110, cfg, input_assignment, {}, {},   0,   "Input for jogging", &moves},
    {"JGF",  11111, rw,  in<decihertz>,    0,  100,  50,  "Jog frequency", &speed},
    {"JPF",  11301, rw,  in<decihertz>,    0,  4000, 0,   "Skip frequency", &skipped},
    {"PS2",  11401, cfg, input_assignment, {}, {},   {},  "Input for 2 preset speeds"},
    {"PS4",  11402, cfg, input_assignment, {}, {},   {},  "Input for 4 preset speeds"},
    {"PS8",  11403, cfg, input_assignment, {}, {},   0,   "Input for 8 preset speeds"},
    {"SP2",  11410, rw,  in<decihertz>,    0,  4000, 100, "Preset speed 2", &speed},
    {"SP3",  11411, rw,  in<decihertz>,    0,  4000, {},  "Preset speed 3", &speed},
    {"SP4",  11412, rw,  in<decihertz>,    0,  4000, {},  "Preset speed 4", &speed},
    {"SP5",  11413, rw,  in<decihertz>,    0,  4000, 250, "Preset speed 5", &speed},
    {"SP6",  11414, rw,  in<decihertz>,    0,  4000, 300, "Preset speed 6", &speed},
    {"SP7",  11415, rw,  in<decihertz>,    0,  4000, 350, "Preset speed 7", &speed},
    {"SP8",  11416, rw,  in<decihertz>,    0,  4000, 400, "Preset speed 8", &speed},
    {"TLS",  11701, rw,  in<deciseconds>,  0,  9999, 0,   "Longest time at low speed", &skipped},
    {"SLE",  11702, rw,  in<decihertz>,    0,  4000, 10,  "Restart margin above low speed", &skipped},
    {"SH2",  15101, cfg, input_assignment, {}, {},   0,   "Input for 2 high speeds"},
    {"SH4",  15102, cfg, input_assignment, {}, {},   0,   "Input for 4 high speeds"},
    {"HSU",  15109, ro,  in<decihertz>,    0,  4000, 0,   "High speed in use"},
    {"HSP2", 15110, rw,  in<decihertz>,    0,  4000, {},  "High speed 2", &speed},
    {"HSP3", 15111, rw,  in<decihertz>,    0,  4000, {},  "High speed 3", &speed},
    {"HSP4", 15112, rw,  in<decihertz>,    0,  4000, {},  "High speed 4", &speed},
};

// Ramps.
inline constexpr parameter functions_ramp[]{
    {"BRA", 9003, cfg, ramp_adaptation,  {}, {}, 1, "Deceleration ramp adaptation", &ramp},
    {"RPT", 9004, rw,  ramp_shape,       {}, {}, 0, "Ramp shape", &ramp},
    {"RPS", 9010, cfg, input_assignment, {}, {}, 0, "Input that selects the second ramp"},
    row_of(ac2, ramp), row_of(de2, ramp),
};

// Stopping and DC injection.
inline constexpr parameter functions_stop[]{
    {"ADC",  10401, rw,  auto_injection,   {}, {},    1,  "Automatic DC injection", &stopping},
    {"TDC1", 10402, rw,  in<deciseconds>,  1,  300,   5,  "Automatic DC injection: first time", &stopping},
    {"SDC1", 10403, rw,  in<deciamperes>,  0,  65535, {}, "Automatic DC injection: first current", &stopping},
    row_of(stt, stopping),
    {"NST",  11202, cfg, input_assignment, {}, {},    0,  "Input for freewheel stop", &stop_input},
    {"FST",  11204, cfg, input_assignment, {}, {},    0,  "Input for fast stop", &stop_input},
    {"DCF",  11230, rw,  in<count16>,      1,  10,    4,  "Fast stop: ramp divider", &stopping},
};

// The PID regulator.
inline constexpr parameter functions_pid[]{
    {"PIF", 11901, cfg, signal_source,            {},     {},    {},   "PI feedback source", &regulation},
    {"FBS", 11903, rw,  in<count16_tenths>,       1, 1000, 10, "PI feedback scale factor", &regulation},
    {"PII", 11908, cfg, no_yes,                   {}, {}, 0, "PI reference is internal", &regulation},
    {"PR2", 11909, cfg, input_assignment,         {},     {},    0,    "Input for 2 preset PI references"},
    {"PR4", 11910, cfg, input_assignment,         {},     {},    0,    "Input for 4 preset PI references"},
    {"RPL", 11911, rw,  in<tenth_percent>,        0, 1000, 0, "PI reference lower limit", &regulation},
    {"RPH", 11912, rw,  in<tenth_percent>,        0, 1000, 1000, "PI reference upper limit", &regulation},
    {"RPI", 11920, rw,  in<tenth_percent>,        0,      1000,  0,    "PI internal reference", &regulation},
    {"RP2", 11921, rw,  in<tenth_percent>,        0,      1000,  250,  "Preset PI reference 2", &regulation},
    {"RP3", 11922, rw,  in<tenth_percent>,        0,      1000,  500,  "Preset PI reference 3", &regulation},
    {"RP4", 11923, rw,  in<tenth_percent>,        0,      1000,  750,  "Preset PI reference 4", &regulation},
    {"PIC", 11940, cfg, no_yes,                   {},     {},    0,    "PI correction reversed", &regulation},
    {"RPG", 11941, rw,  in<count16_hundredths>,   1,      10000, 100,  "PI proportional gain", &regulation},
    {"RIG", 11942, rw,  in<count16_hundredths>,   1,      10000, 100,  "PI integral gain", &regulation},
    {"RDG", 11943, rw,  in<count16_hundredths>,   0,      10000, 0,    "PID derivative gain", &regulation},
    {"PIM", 11954, cfg, signal_source,            {}, {}, 0, "Reference in manual mode", &regulation},
    {"SFS", 11955, cfg, in<decihertz>,            0,      4000,  0,    "PI speed at start", &regulation},
    {"RSL", 11960, cfg, in<tenth_percent>,        0, 1000, 0, "PI error that wakes the drive", &regulation},
    {"UPP", 11964, rw,  in<tenth_percent>,        0,      1000,  0,    "PI wake-up level", &regulation},
    {"LPI", 11965, rw,  in<signed_tenth_percent>, -1, 1000, -1, "PI feedback supervision threshold", &blind},
    {"TPI", 11966, rw,  in<seconds>,              0,      600,   0,    "PI feedback supervision delay"},
    {"MPI", 11967, cfg, fault_reaction, {}, {}, 1, "Reaction to PI feedback supervision", &reaction},
    {"PAU", 11970, cfg, input_assignment,         {}, {}, {}, "Input that selects automatic or manual"},
    {"RPE", 11980, ro,  in<signed_tenth_percent>, -32767, 32767, 0,    "PI error"},
    {"RPF", 11981, ro,  in<tenth_percent>,        0,      65535, 0,    "PI feedback"},
    {"RPC", 11982, ro,  in<tenth_percent>,        0,      65535, 0,    "PI reference"},
    {"PRP", 11984, rw,  in<deciseconds>,          0,      999,   0,    "PI reference ramp time", &regulation},
};

// Pumps and fans.
inline constexpr parameter functions_pump[]{
    {"NFD", 11990, cfg, in<minutes>,     0,  20,   0,  "Zero flow detection interval", &pumping},
    {"FFD", 11991, rw,  in<decihertz>,   0,  4000, 0,  "Zero flow detection threshold", &pumping},
    {"LFD", 11992, rw,  in<decihertz>,   0,  4000, 0,  "Zero flow detection offset", &pumping},
    {"MDE", 15201, cfg, no_yes,          {}, {},   0,  "Pump mode", &pumping},
    {"FON", 15202, rw,  in<decihertz>,   0,  4000, {}, "Auxiliary pump start frequency", &pumping},
    {"FOF", 15203, rw,  in<decihertz>,   0,  4000, 0,  "Auxiliary pump stop frequency", &pumping},
    {"TON", 15204, rw,  in<deciseconds>, 0,  9999, 20, "Auxiliary pump start delay", &pumping},
    {"TOF", 15205, rw,  in<deciseconds>, 0,  9999, 20, "Auxiliary pump stop delay", &pumping},
    {"RON", 15206, rw,  in<deciseconds>, 0,  9999, 20, "Auxiliary pump start ramp", &pumping},
    {"ROF", 15207, rw,  in<deciseconds>, 0,  9999, 20, "Auxiliary pump stop ramp", &pumping},
};

// Torque and current limits.
inline constexpr parameter functions_limits[]{
    {"CLI", 9201, rw, in<deciamperes>, 0, 65535, {}, "Current limit", &tuning},
};

// Analog inputs and outputs.
inline constexpr parameter unverified_analog_io[]{
    {"AI1C", 5242, doubtful(ro), in<signed_count16>, {}, {}, {}, "AI1, physical value"},
    {"AO1C", 5271, doubtful(ro), in<signed_count16>, {}, {}, {}, "AO1, physical value"},
};
// clang-format on

} // namespace altivar::atv12::rows

namespace altivar::atv12 {

/// The parameters by group.
/// Internal.
inline constexpr parameter_group menu_groups[]{
    {"monitoring", rows::monitoring},
    {"control", rows::control},
    {"command", rows::command},
    {"settings", rows::settings},
    {"motor_control", rows::motor_control},
    {"analog_io", rows::analog_io},
    {"logic_io", rows::logic_io},
    {"communication", rows::communication},
    {"scanner", rows::scanner},
    {"faults", rows::faults},
    {"process_monitoring", rows::process_monitoring},
    {"identification", rows::identification},
    {"configuration", rows::configuration},
    {"history_state", rows::history_state},
    {"history_values", rows::history_values},
    {"functions_speed", rows::functions_speed},
    {"functions_ramp", rows::functions_ramp},
    {"functions_stop", rows::functions_stop},
    {"functions_pid", rows::functions_pid},
    {"functions_pump", rows::functions_pump},
    {"functions_limits", rows::functions_limits},
};

/// All parameters that can be used, as rows to walk.
inline constexpr parameter_map parameters{menu_groups, "ATV12"};

/// Internal.
inline constexpr parameter_group unverified_groups[]{
    {"analog_io", rows::unverified_analog_io},
};

/// Registers of which too little is known to write them: read-only, doubtful.
inline constexpr parameter_map unverified_parameters{unverified_groups, "ATV12"};

/// An ATV12 with every register of these maps for typed access: `station<full_device>`.
struct full_device : device {
    using registers = row_table<full_device, device::registers, parameters, unverified_parameters>;
};

/// A parameter by its mnemonic, where a register is wanted: `read<parameter<"LFF">>(drive)`. What has an object of its own,
/// as `acc`, is named by that.
template <mnemonic Code> inline constexpr auto const& parameter = parameter_called<full_device, Code>;

} // namespace altivar::atv12
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
