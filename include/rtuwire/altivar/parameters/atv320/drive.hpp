// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: what it shows, everyday settings, the motor, what drive it is. How to read a
// line stands in parameters/parameter.hpp.
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
// Where the configuration is saved.
inline constexpr choice configuration_save[]{
    {0, "nO", "none"}, {1, "Str0", "save as configuration 0"}, {2, "Str1", "save as configuration 1"},
    {3, "Str2", "save as configuration 2"},
};
// Which configuration is recalled.
inline constexpr choice configuration_recall[]{
    {0, "nO", "none"}, {2, "rEC1", "load configuration 1"}, {3, "rEC2", "load configuration 2"},
    {64, "InI", "factory settings"}, {71, "InI1", "factory settings, variant InI1"},
};
// What a function key does.
inline constexpr choice key_function[]{
    {0, "nO", "not assigned"}, {180, "FnJOG", "jog"}, {181, "FnPS1", "preset speed 1"},
    {182, "FnPS2", "preset speed 2"}, {183, "FnPr1", "PI preset reference 1"},
    {184, "FnPr2", "PI preset reference 2"}, {185, "FnUSP", "faster"}, {186, "FndSP", "slower"},
    {187, "FntK", "control by the keypad"},
};
// What happens when the keypad takes over.
inline constexpr choice keypad_takeover[]{
    {0, "StOP", "cleared: the motor stops"}, {1, "bUMP", "command and reference taken over"},
};
// What the drive is prepared for.
inline constexpr choice macro_configuration[]{
    {0, "StS", "start and stop"}, {1, "HdG", "material handling"}, {2, "HSt", "hoisting"},
    {3, "GEn", "general use"}, {4, "PId", "PI regulator"}, {5, "nEt", "network"},
};
// Which counter is set to zero.
inline constexpr choice counter_reset[]{
    {0, "nO", "none"}, {1, "APH", "energy"}, {2, "rtH", "motor running time"},
    {3, "rtHI", "internal running time (rtHI)"}, {4, "PtH", "powered time"}, {64, "ALL", "all"},
};
// Which configuration is in use.
inline constexpr choice active_configuration[]{
    {0, "nO", "none"}, {1, "CnF0", "configuration 0"}, {2, "CnF1", "configuration 1"},
    {3, "CnF2", "configuration 2"},
};
// What follows a quick stop.
inline constexpr choice quick_stop_end[]{
    {2, "FSt2", "fast stop, then switch on disabled"}, {6, "FSt6", "fast stop, stays in quick stop"},
};
// Which parameter set is in use.
inline constexpr choice parameter_set[]{
    {0, "nO", "none"}, {1, "CFP1", "set 1"}, {2, "CFP2", "set 2"}, {3, "CFP3", "set 3"},
};
// When the fan runs.
inline constexpr choice fan_mode[]{{0, "Std", "when needed"}, {1, "rUn", "always"}, {2, "StP", "never"}};
// What starts the motor in 2-wire control.
inline constexpr choice two_wire_type[]{
    {0, "LEL", "by level"}, {1, "trn", "by transition"}, {2, "PFO", "by level, forward has priority"},
};
// What is copied when the channel changes.
inline constexpr choice channel_copy[]{
    {0, "nO", "none"}, {1, "SP", "reference"}, {2, "Cd", "command"}, {3, "ALL", "command and reference"},
};
// Which channel is in command.
inline constexpr choice active_channel[]{
    {0, "terminals", "terminals"}, {1, "keypad", "local keypad"}, {2, "remote_terminal", "remote terminal"},
    {3, "modbus", "Modbus"}, {6, "canopen", "CANopen"},
    {7, "speed_by_terminals", "+/- speed by the terminals"},
    {8, "speed_by_terminal", "+/- speed by the remote terminal"},
    {9, "communication_card", "communication card"}, {15, "pc_software", "SoMove"},
};
// LRS1.
inline constexpr choice state_word_1[]{
    {1, "fault", "in fault"}, {2, "running", "unlocked: the motor can be powered"},
    {3, "output_contactor", "output contactor commanded"},
    {4, "frequency_threshold", "frequency threshold FTD reached"}, {5, "high_speed", "high speed reached"},
    {6, "current_threshold", "current threshold CTD reached"}, {7, "reference_reached", "reference reached"},
    {8, "motor_thermal_threshold", "motor thermal threshold TTD reached"},
    {9, "brake_command", "brake commanded"}, {10, "pi_error", "PI error alarm"},
    {11, "pi_feedback", "PI feedback alarm"},
    {13, "frequency_threshold_2", "frequency threshold F2D reached"},
    {14, "drive_thermal_threshold", "drive thermal threshold THA reached"},
    {15, "traverse", "traverse control active"},
};
// LRS2.
inline constexpr choice state_word_2[]{
    {5, "underload", "underload alarm"}, {6, "overload", "overload alarm"}, {11, "slack_rope", "slack rope"},
    {12, "torque_high", "torque high threshold TTH reached"},
    {13, "torque_low", "torque low threshold TTL reached"}, {14, "forward", "turning forward"},
    {15, "reverse", "turning in reverse"},
};
// LRS3.
inline constexpr choice state_word_3[]{
    {0, "reference_channel_2", "reference channel 2 active, else 1"},
    {1, "command_channel_2", "command channel 2 active, else 1"},
    {2, "second_ramp", "second ramps (AC2, DE2) in use"},
    {3, "second_current_limit", "second current limit CL2 in use"},
    {5, "motor_2_threshold", "motor 2 thermal threshold reached"},
    {6, "motor_3_threshold", "motor 3 thermal threshold reached"},
    {8, "external_24v", "external 24 V present"}, {9, "low_speed_stop", "stopped after TLS at low speed"},
    {15, "torque_negative", "torque negative"},
};
// LRS4.
inline constexpr choice state_word_4[]{
    {0, "configuration_0", "configuration 0 active"}, {1, "configuration_1", "configuration 1 active"},
    {2, "configuration_2", "configuration 2 active"}, {4, "parameter_set_1", "parameter set 1 active"},
    {5, "parameter_set_2", "parameter set 2 active"}, {6, "parameter_set_3", "parameter set 3 active"},
    {8, "no_power", "power section not supplied"}, {9, "fluxing", "fluxing the motor"},
    {10, "fluxed", "motor fluxed"}, {11, "dc_injection", "DC injection (ETI bit 5)"},
    {12, "current_limit", "in current limit"}, {13, "accelerating", "accelerating (ETI bit 9)"},
    {14, "decelerating", "decelerating (ETI bit 10)"}, {15, "fast_stop", "fast stop (ETI bit 12)"},
};
// LRS5.
inline constexpr choice state_word_5[]{
    {0, "bus_charging", "DC bus charging"}, {1, "braking", "braking"}, {2, "power_removed", "power removed"},
    {3, "restarting", "automatic restart under way"}, {4, "tuning", "autotune under way"},
    {5, "controlled_stop", "controlled stop after mains loss"},
    {6, "ramp_adapted", "deceleration ramp adapted"}, {7, "output_cut", "output cut off"},
    {8, "pulse_warning", "pulse warning level FQL reached"}, {9, "line_contactor", "line contactor active"},
    {10, "tuned", "autotune done"}, {13, "motor_current", "motor current present"},
    {14, "limit_switch", "stop switch reached"}, {15, "load_variation", "load variation alarm"},
};
// LRS6.
inline constexpr choice state_word_6[]{
    {0, "alarm_group_1", "alarm group 1 active"}, {1, "alarm_group_2", "alarm group 2 active"},
    {2, "alarm_group_3", "alarm group 3 active"}, {5, "li6_probe", "LI6 probe alarm"},
    {7, "external_fault", "external fault alarm"}, {8, "undervoltage", "undervoltage alarm"},
    {9, "undervoltage_prevention", "controlled stop voltage reached"},
    {11, "drive_overheated", "drive thermal alarm"},
    {15, "limit_reached", "torque or current limit, time is up"},
};
// LRS7.
inline constexpr choice state_word_7[]{
    {0, "reference_1_or_1b", "reference channel 1 or 1B active"},
    {1, "reference_2", "reference channel 2 active"}, {2, "command_1", "command channel 1 active"},
    {3, "command_2", "command channel 2 active"}, {4, "reference_1b", "reference channel 1B active"},
    {5, "end_of_reel", "end of reel"}, {6, "wobble_synchronised", "wobble synchronisation"},
    {8, "transistor_alarm", "transistor temperature alarm"}, {11, "ai3_lost", "AI3 signal lost"},
};
// LRS8.
inline constexpr choice state_word_8[]{{9, "forced_local", "forced local control"}, {15, "ready", "drive ready"}};
// Whose data the motor model uses.
inline constexpr choice motor_model[]{
    {0, "tAb", "table values"}, {1, "MEAS", "measured values"}, {2, "CUS", "user values"},
};
// How much the inductances of a synchronous motor differ.
inline constexpr choice saliency[]{{0, "nO", "unknown"}, {1, "LLS", "low"}, {2, "MLS", "medium"}, {3, "HLS", "high"}};
// The mains frequency that motors are rated for.
inline constexpr choice motor_standard[]{{0, "50", "50 Hz"}, {1, "60", "60 Hz"}};
// Whether the motor is measured, and the result dropped.
inline constexpr choice tuning_order[]{{0, "nO", "none"}, {1, "YES", "tune now"}, {2, "CLr", "erase the results"}};
// When the motor is measured without being asked for.
inline constexpr choice automatic_tuning[]{
    {0, "nO", "no"}, {1, "YES", "at each power-on"}, {2, "OnE", "at the first run order"},
};
// How far tuning is.
inline constexpr choice tuning_state[]{
    {0, "tAb", "not tuned, table values"}, {1, "PEnd", "pending"}, {2, "PrOG", "running"},
    {3, "FAIL", "failed"}, {4, "dOnE", "done, measured values"},
};
// How voltage follows frequency.
inline constexpr choice motor_control_law[]{
    {0, "UUC", "sensorless vector"}, {3, "Std", "V/f"}, {4, "UF5", "V/f by five points"},
    {5, "SYn", "synchronous motor"}, {6, "UFq", "quadratic V/f"}, {7, "nLd", "energy saving"},
};
// Whether the switching frequency may fall.
inline constexpr choice switching_mode[]{
    {1, "HF1", "HF1: frequency may be reduced"}, {2, "HF2", "HF2: frequency is kept"},
};
// How the boost works.
inline constexpr choice boost_mode[]{{0, "nO", "off"}, {1, "dYnA", "dynamic"}, {2, "StAt", "static"}};
// The time between voltage steps at the motor, against surges.
inline constexpr choice surge_time[]{{6, "6", "6 us"}, {8, "8", "8 us"}, {10, "10", "10 us"}};
// How a low reference is treated.
inline constexpr choice reference_shape[]{
    {0, "bSd", "from LSP to HSP"}, {1, "bLS", "limited below at LSP"}, {2, "bnS", "deadband up to LSP"},
    {4, "bnS0", "deadband at zero"},
};
// When the motor is fluxed.
inline constexpr choice fluxing[]{
    {0, "FnC", "by a run order"}, {1, "FCt", "continuous, from power-on"}, {2, "FnO", "none"},
};
// How the angle of a synchronous motor is found.
inline constexpr choice angle_setting[]{
    {3, "IPMA", "IPM alignment"}, {4, "SPMA", "SPM alignment"}, {5, "PSI", "pulse injection"},
    {6, "PSIO", "pulse injection, optimised"}, {254, "nO", "none"},
};
// How temperature enters the measured data.
inline constexpr choice tuning_temperature[]{
    {0, "nO", "not followed"}, {1, "tM", "by the thermal model"}, {2, "Ct", "values of the cold motor"},
};

// What the drive shows.
inline constexpr parameter monitoring[]{
    row_of(eta), row_of(rfr), row_of(frh), row_of(lcr), row_of(otr), row_of(eti), row_of(uln), row_of(uop),
    row_of(thd), row_of(opr),
    {"SLCR", 3224,  ro, in<deciamperes>,          0,      65535, {}, "Motor current, unfiltered"},
    {"SRFR", 3225,  ro, in<signed_decihertz>,     -32767, 32767, {}, "Output frequency, unfiltered"},
    {"SOTR", 3226,  ro, in<signed_tenth_percent>, -32767, 32767, {}, "Motor torque, unfiltered"},
    {"SULN", 3229,  ro, in<decivolts>,            0,      65535, {}, "Mains voltage, unfiltered"},
    row_of(rth), row_of(pth),
    {"TAC",  3235,  ro, in<seconds>,              0,      65535, {}, "Time in transistor temperature alarm"},
    row_of(hmis),
    {"TAC2", 3242,  ro, in<seconds>,              0, 65535, {}, "Time at the lowest switching frequency"},
    {"LRS1", 3250,  ro, bits(state_word_1),       {},     {},    {}, "Logic states 0 to 15"},
    {"LRS2", 3251,  ro, bits(state_word_2),       {},     {},    {}, "Logic states 16 to 31"},
    {"LRS3", 3252,  ro, bits(state_word_3),       {},     {},    {}, "Logic states 32 to 47"},
    {"LRS4", 3253,  ro, bits(state_word_4),       {},     {},    {}, "Logic states 48 to 63"},
    {"LRS5", 3254,  ro, bits(state_word_5),       {},     {},    {}, "Logic states 64 to 79"},
    {"LRS6", 3255,  ro, bits(state_word_6),       {},     {},    {}, "Logic states 80 to 95"},
    {"LRS7", 3256,  ro, bits(state_word_7),       {},     {},    {}, "Logic states 96 to 111"},
    {"LRS8", 3257,  ro, bits(state_word_8),       {},     {},    {}, "Logic states 112 to 127"},
    {"SOPR", 3290,  ro, in<signed_percent>,       -32767, 32767, {}, "Motor power, unfiltered"},
    {"CNFS", 8020,  ro, active_configuration,     {},     {},    {}, "Active configuration"},
    {"CRC",  8441,  ro, bits(active_channel),     {},     {},    {}, "Active reference channel"},
    {"CCC",  8442,  ro, bits(active_channel),     {},     {},    {}, "Active command channel"},
    row_of(thr),
    {"CFPS", 12900, ro, parameter_set,            {},     {},    {}, "Active parameter set"},
    {"FQS",  14603, ro, in<hertz>,                0,      20000, {}, "Frequency at the pulse input"},
};

// Words that command the drive, and its speed mode.
inline constexpr parameter control[]{
    {"RPR",  3120, rw,           counter_reset,  {}, {},    0,  "Counter reset", &clears},
    row_of(cmd, commands), row_of(lfr, setpoint), row_of(pisp, setpoint), row_of(cmi, recalls),
    row_of(lfrd, setpoint), row_of(etad), row_of(rfrd), row_of(frhd), row_of(errd),
    {"SMIL", 8607, doubtful(rw), in<rpm>, 0, 65535, {}, "Lowest speed of the drive profile", &another_form},
    {"SMAL", 8609, doubtful(rw), in<rpm>, 0, 65535, {}, "Highest speed of the drive profile", &another_form},
    {"SPAL", 8611, rw, in<rpm>, 1, 65535, {}, "Speed step that defines the acceleration", &another_form},
    {"SPAT", 8613, rw, in<seconds>, 0, 65535, {}, "Time step that defines the acceleration", &another_form},
    {"SPDL", 8614, rw, in<rpm>, 1, 65535, {}, "Speed step that defines the deceleration", &another_form},
    {"SPDT", 8616, rw, in<seconds>, 0, 65535, {}, "Time step that defines the deceleration", &another_form},
    {"SPFN", 8642, cfg,          in<count16>,    1,  65535, 1,  "Setpoint scaling: numerator", &scaling},
    {"SPFD", 8643, cfg,          in<count16>,    1,  65535, 1,  "Setpoint scaling: denominator", &scaling},
    {"QSTD", 8651, cfg,          quick_stop_end, {}, {},    6,  "How quick stop stops", &stopping},
    row_of(dotd, stopping),
};

// Where commands and references come from.
inline constexpr parameter command[]{
    {"RIN",  3108,  cfg, in<no_yes>,            {}, {},  0,   "Reverse direction locked", &speed_range},
    row_of(chcf, commander),
    {"COP",  8402,  cfg, channel_copy,          {}, {}, 0, "What is copied from channel 1 to 2", &commander},
    {"RFC",  8411,  cfg, logic_input, {}, {}, {}, "Input that selects reference channel 1 or 2", &references},
    {"RCB",  8412, cfg, logic_input, {}, {}, 96, "Input that selects reference channel 1 or 1B", &references},
    row_of(fr1, references), row_of(fr2, references),
    {"FR1B", 8415,  cfg, in<reference_channel>, {}, {},  0,   "Reference channel 1B", &references},
    {"CCS",  8421,  cfg, logic_input, {}, {}, 98, "Input that selects the command channel", &commander},
    row_of(cd1, commander), row_of(cd2, commander), row_of(flo, commander),
    {"FLOC", 8432,  cfg, signal_source,         {}, {}, 0, "Reference channel in local control", &references},
    {"FLOT", 8433,  cfg, in<deciseconds>, 1, 300, 100, "Time-out after leaving local control", &commander},
    row_of(tcc, wiring),
    {"TCT",  11102, cfg, two_wire_type,         {}, {},  1,   "How 2-wire control reacts", &wiring},
    {"RRS",  11105, cfg, logic_input,           {}, {},  {},  "Input for reverse running", &wiring},
};

// Everyday settings.
inline constexpr parameter settings[]{
    row_of(hsp, speed_limit), row_of(lsp, speed_limit),
    {"FFM",  3130,  rw, fan_mode,           {},   {},    0,   "Fan operation"},
    row_of(acc, ramp), row_of(dec, ramp), row_of(ith, ordinary),
    {"CTD",  11001, rw, in<deciamperes>,    0,    65535, {},  "Motor current threshold"},
    {"TTD",  11002, rw, in<percent>,        0,    118,   100, "Motor thermal threshold"},
    {"FTD",  11003, rw, in<decihertz>,      0,    5990,  {},  "Frequency threshold"},
    {"F2D",  11004, rw, in<decihertz>,      0,    5990,  {},  "Frequency threshold 2"},
    {"TTD2", 11006, rw, in<percent>,        0,    118,   100, "Motor 2 thermal threshold"},
    {"TTD3", 11007, rw, in<percent>,        0,    118,   100, "Motor 3 thermal threshold"},
    {"THA",  11009, rw, in<percent>,        0,    118,   100, "Drive thermal alarm threshold"},
    {"TTL",  11015, rw, in<signed_percent>, -300, 300,   50,  "Torque low threshold"},
    {"TTH",  11016, rw, in<signed_percent>, -300, 300,   100, "Torque high threshold"},
    {"SRB",  14401, rw, in<decihertz>,      3,    5990,  3,   "Hysteresis of frequency reached"},
};

// The motor and its control.
inline constexpr parameter motor_control[]{
    {"BFR",  3015,  cfg, motor_standard,               {}, {}, 0, "Standard motor frequency", &speed_range},
    {"SFT",  3101,  cfg, switching_mode,               {},  {},    1,   "Switching frequency mode"},
    row_of(sfr, ordinary), row_of(tfr, speed_limit),
    {"BSP",  3106,  rw,  reference_shape, {}, {}, 0, "Shape of the reference near low speed", &scaling},
    {"NRD",  3107,  cfg, in<no_yes>,                   {},  {},    0,   "Motor noise reduction"},
    {"SPG",  9103,  rw,  in<percent>,                  0, 1000, 40, "Speed loop proportional gain", &tuning},
    {"SIT",  9104,  rw,  in<units::milliseconds>,      1,   65535, 63,  "Speed loop integral time", &tuning},
    {"SFC",  9105,  rw,  in<count16>,                  0,   100,   65,  "Speed loop filter", &tuning},
    {"FFH",  9115,  cfg, in<tenth_milliseconds>,       0,   1000,  64,  "Filter of the speed estimate"},
    {"CRTF", 9116,  cfg, in<tenth_milliseconds>,       0,   1000,  32,  "Filter of the current references"},
    row_of(uns, ordinary), row_of(frs, ordinary), row_of(ncr, ordinary), row_of(nsp, ordinary),
    row_of(cos, ordinary),
    {"CTT",  9607,  cfg, motor_control_law,            {},  {},    {},  "Motor control law"},
    {"TUN",  9608,  rw,  tuning_order,                 {},  {},    0,   "Autotune", &autotuning},
    {"TUS",  9609,  ro,  tuning_state,                 {},  {},    0,   "Autotune state"},
    {"TUL",  9610,  cfg, logic_input,                  {},  {},    0,   "Input that starts autotune", &moves},
    row_of(npr, ordinary),
    {"AUT",  9615,  rw,  automatic_tuning,             {},  {},    0,   "Automatic autotune", &self_tuning},
    {"STUN", 9617,  ro,  motor_model,                  {},  {},    0,   "Motor model data in use"},
    {"PPN",  9618,  cfg, in<count16>,                  1,   100,   {},  "Pole pairs, calculated"},
    {"TUNU", 9619,  cfg, tuning_temperature,           {},  {},    1,   "How tuning follows the temperature"},
    {"UFR",  9623,  rw,  in<percent>,                  0,   200,   100, "IR compensation", &tuning},
    {"SLP",  9625,  rw,  in<percent>,                  0,   300,   {},  "Slip compensation", &tuning},
    {"SPGU", 9629,  rw,  in<percent>, 0, 1000, 40, "Inertia compensation of the V/f laws", &tuning},
    {"RSA",  9642,  cfg, in<milliohms>,                0,   65535, 0,   "Stator resistance, user value"},
    {"SMOT", 9645,  ro,  saliency,                     {},  {},    {},  "Motor saliency found by tuning"},
    {"IDA",  9652,  cfg, in<deciamperes>,              0,   65535, 0,   "Magnetising current, user value"},
    {"LFA",  9662,  cfg, in<hundredth_millihenries>,   0,   65535, 0,   "Leakage inductance, user value"},
    {"TRA",  9667,  cfg, in<units::milliseconds>,      0,   65535, 0,   "Rotor time constant, user value"},
    {"NSPS", 9671,  cfg, in<rpm>,                      0,   65535, {},  "Rated speed, synchronous motor"},
    {"PPNS", 9672,  cfg, in<count16>,                  1,   50,    {},  "Pole pairs, synchronous motor"},
    {"PHS",  9673,  cfg, in<tenth_millivolts_per_rpm>, 0,   65535, 0,   "EMF constant, synchronous motor"},
    {"LDS",  9674,  cfg, in<hundredth_millihenries>,   0, 65535, 0, "d-axis inductance, synchronous motor"},
    {"LQS",  9675,  cfg, in<hundredth_millihenries>,   0, 65535, 0, "q-axis inductance, synchronous motor"},
    {"FRSS", 9679,  ro,  in<decihertz>,                100, 8000,  {},  "Rated frequency, synchronous motor"},
    {"RSAS", 9682,  cfg, in<milliohms>, 0, 65535, 0, "Stator resistance, synchronous motor, user value"},
    {"TQS",  9684,  cfg, in<decinewton_metres>,        1,   65535, {},  "Rated motor torque"},
    {"U1",   12403, cfg, in<volts>,                    0,   800,   0,   "V/f point 1: voltage"},
    {"F1",   12404, cfg, in<decihertz>,                0,   5990,  0,   "V/f point 1: frequency"},
    {"U2",   12405, cfg, in<volts>,                    0,   800,   0,   "V/f point 2: voltage"},
    {"F2",   12406, cfg, in<decihertz>,                0,   5990,  0,   "V/f point 2: frequency"},
    {"U3",   12407, cfg, in<volts>,                    0,   800,   0,   "V/f point 3: voltage"},
    {"F3",   12408, cfg, in<decihertz>,                0,   5990,  0,   "V/f point 3: frequency"},
    {"U4",   12409, cfg, in<volts>,                    0,   800,   0,   "V/f point 4: voltage"},
    {"F4",   12410, cfg, in<decihertz>,                0,   5990,  0,   "V/f point 4: frequency"},
    {"U5",   12411, cfg, in<volts>,                    0,   800,   0,   "V/f point 5: voltage"},
    {"F5",   12412, cfg, in<decihertz>,                0,   5990,  0,   "V/f point 5: frequency"},
    {"SVL",  12601, cfg, in<no_yes>,                   {},  {},    0,   "Motor surge voltage limitation"},
    {"SOP",  12602, cfg, surge_time,                   {},  {},    10,  "Motor surge attenuation time"},
    {"FLI",  13901, cfg, logic_input,                  {},  {},    0,   "Input that starts fluxing", &moves},
    {"FLU",  13902, rw,  fluxing,                      {},  {},    2,   "When the motor is fluxed", &moves},
    {"BOA",  13910, cfg, boost_mode,                   {},  {},    1,   "Voltage boost mode"},
    {"AST",  13925, cfg, angle_setting,                {},  {},    6,   "How the rotor angle is found"},
    {"VBR",  14101, rw,  in<volts>,                    335, 820,   {},  "Brake chopper voltage"},
    {"HFI",  15600, cfg, in<no_yes>,                   {},  {},    0,   "High-frequency injection"},
    {"HIR",  15602, cfg, in<percent>,                  0,   200,   25,  "High-frequency injection: current"},
    {"SPB",  15603, cfg, in<hertz>,                    0, 100, 25, "High-frequency injection: PLL bandwidth"},
    {"ILR",  15605, cfg, in<percent>,                  0,   200,   50,  "High-frequency alignment: current"},
    {"SIR",  15606, cfg, in<percent>,                  0,   200,   100, "IPM alignment: boost"},
    {"MCR",  15607, cfg, in<percent>,                  0,   300,   {},  "PSI alignment: maximum current"},
    {"PEC",  15608, cfg, in<percent>,                  0,   500,   0,   "Rotor angle error compensation"},
};

// What drive this is.
inline constexpr parameter identification[]{
    row_of(ncv), row_of(vcal), row_of(inv), row_of(vdp),
    {"PAN0", 3340, rw, in<count16>, 0, 65535, 0, "Device name, characters 1 and 2"},
    {"PAN1", 3341, rw, in<count16>, 0, 65535, 0, "Device name, characters 3 and 4"},
    {"PAN2", 3342, rw, in<count16>, 0, 65535, 0, "Device name, characters 5 and 6"},
    {"PAN3", 3343, rw, in<count16>, 0, 65535, 0, "Device name, characters 7 and 8"},
    {"PAN4", 3344, rw, in<count16>, 0, 65535, 0, "Device name, characters 9 and 10"},
    {"PAN5", 3345, rw, in<count16>, 0, 65535, 0, "Device name, characters 11 and 12"},
    {"PAN6", 3346, rw, in<count16>, 0, 65535, 0, "Device name, characters 13 and 14"},
    {"PAN7", 3347, rw, in<count16>, 0, 65535, 0, "Device name, characters 15 and 16"},
};

// Saving and recalling configurations.
inline constexpr parameter configuration[]{
    {"CFG",  3052, cfg, macro_configuration,  {}, {}, 0,  "Macro configuration", &macro},
    {"CCFG", 3053, ro,  in<no_yes>,           {}, {}, {}, "Macro configuration changed by the user"},
    {"SCS",  8001, cfg, configuration_save,   {}, {}, 0,  "Save the configuration", &recalls},
    {"FCS", 8002, cfg, configuration_recall, {}, {}, 0, "Load a configuration or factory settings", &recalls},
    {"CNF1", 8021, cfg, logic_input,          {}, {}, 0,  "Input that selects configuration 2", &selection},
    {"CNF2", 8022, cfg, logic_input,          {}, {}, 0,  "Input that selects configuration 3", &selection},
    {"CHM",  8025, cfg, in<no_yes>,           {}, {}, 0,  "Configurations used for several motors"},
};

// The display and its access.
inline constexpr parameter display[]{
    {"BRH", 10050, cfg, in<count16>,     0,  65535, 0,  "Brake logic options", &brake},
    {"FN1", 13501, cfg, key_function,    {}, {},    {}, "Function of terminal key F1", &moves},
    {"FN2", 13502, cfg, key_function,    {}, {},    {}, "Function of terminal key F2", &moves},
    {"FN3", 13503, cfg, key_function,    {}, {},    {}, "Function of terminal key F3", &moves},
    {"FN4", 13504, cfg, key_function,    {}, {},    {}, "Function of terminal key F4", &moves},
    {"BMP", 13529, cfg, keypad_takeover, {}, {}, 0, "What terminal control takes over on a change", &moves},
    {"PPI", 14001, cfg, in<count16>,     0,  9999,  0,  "Pairing password", &cards},
};
// clang-format on

} // namespace altivar::atv320::rows
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
