// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: inputs, outputs and lines. How to read a line stands in parameters/parameter.hpp.
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
// Bit rate of CANopen.
inline constexpr choice can_rate[]{
    {38, "50", "50 kbit/s"}, {52, "125", "125 kbit/s"}, {60, "250", "250 kbit/s"}, {68, "500", "500 kbit/s"},
    {76, "1M", "1 Mbit/s"},
};
// Profile of Profibus.
inline constexpr choice profibus_profile[]{
    {0, "UnCG", "not configured"}, {1, "1", "profile 1"}, {2, "2", "profile 2"}, {7, "7", "profile 7"},
    {9, "9", "profile 9"}, {100, "100", "profile 100"}, {101, "101", "profile 101"},
    {102, "102", "profile 102"},
};
// Which Profibus master commands.
inline constexpr choice profibus_master[]{{1, "1", "class 1"}, {2, "2", "class 2"}};
// The assembly of inputs or outputs on DeviceNet and EtherNet/IP.
inline constexpr choice io_assembly[]{
    {0, "20", "20/70"}, {1, "21", "21/71"}, {2, "100", "100/101"}, {3, "UnCG", "not configured"},
};
// A switch.
inline constexpr choice off_on[]{{0, "OFF", "off"}, {1, "On", "on"}};
// What an analog input or output works with.
inline constexpr choice analog_type[]{{1, "10U", "0 to 10 V"}, {2, "0A", "current"}, {5, "n10U", "-10 to 10 V"}};
// The level of an output that is on.
inline constexpr choice output_level[]{{0, "POS", "1 when active"}, {1, "nEG", "0 when active"}};
// The range of an analog input.
inline constexpr choice input_polarity[]{{0, "POS", "positive only"}, {1, "POSnEG", "positive and negative"}};
// The outputs.
inline constexpr choice output_image[]{{0, "r1", "R1"}, {1, "r2", "R2"}, {8, "lo1", "LO1"}};

// Analog inputs and outputs.
inline constexpr parameter analog_io[]{
    {"AI1T", 4402, cfg,          analog_type,            {},    {},   1,    "AI1 type", &scaling},
    {"AI2T", 4403, cfg,          analog_type,            {},    {},   5,    "AI2 type", &scaling},
    {"AI3T", 4404, cfg,          analog_type,            {},    {},   2,    "AI3 type", &scaling},
    {"UIL1", 4412, cfg,          in<decivolts>,          0,     100,  0,    "AI1 voltage at 0 %", &scaling},
    {"UIL2", 4413, cfg,          in<decivolts>,          0,     100,  0,    "AI2 voltage at 0 %", &scaling},
    {"UIH1", 4422, cfg,          in<decivolts>,          0,     100,  100,  "AI1 voltage at 100 %", &scaling},
    {"UIH2", 4423, cfg,          in<decivolts>,          0,     100,  100,  "AI2 voltage at 100 %", &scaling},
    {"CRL3", 4434, cfg,          in<tenth_milliamperes>, 0,     200,  0,    "AI3 current at 0 %", &scaling},
    {"CRH3", 4444, cfg,          in<tenth_milliamperes>, 0,     200,  200,  "AI3 current at 100 %", &scaling},
    {"AI1F", 4452, cfg,          in<centiseconds>,       0,     1000, 0,    "AI1 filter", &scaling},
    {"AI2F", 4453, cfg,          in<centiseconds>,       0,     1000, 0,    "AI2 filter", &scaling},
    {"AI3F", 4454, cfg,          in<centiseconds>,       0,     1000, 0,    "AI3 filter", &scaling},
    {"AI1E", 4462, cfg,          in<percent>, 0, 100, 0, "AI1 linearisation point: input", &scaling},
    {"AI2E", 4463, cfg,          in<percent>, 0, 100, 0, "AI2 linearisation point: input", &scaling},
    {"AI3E", 4464, cfg,          in<percent>, 0, 100, 0, "AI3 linearisation point: input", &scaling},
    {"AI1S", 4472, cfg,          in<percent>, 0, 100, 0, "AI1 linearisation point: output", &scaling},
    {"AI2S", 4473, cfg,          in<percent>, 0, 100, 0, "AI2 linearisation point: output", &scaling},
    {"AI3S", 4474, cfg,          in<percent>, 0, 100, 0, "AI3 linearisation point: output", &scaling},
    {"AI1L", 4482, cfg,          input_polarity,         {},    {},   0,    "AI1 range", &scaling},
    {"AI2L", 4483, cfg,          input_polarity,         {},    {},   0,    "AI2 range", &scaling},
    {"AI3L", 4484, cfg,          input_polarity,         {},    {},   0,    "AI3 range", &scaling},
    {"AO1T", 4601, cfg,          analog_type,            {},    {},   2,    "AO1 type"},
    {"AO1F", 4611, cfg,          in<centiseconds>,       0,     1000, 0,    "AO1 filter"},
    {"UOL1", 4621, cfg,          in<decivolts>,          0,     100,  0,    "AO1 lowest voltage"},
    {"UOH1", 4631, cfg,          in<decivolts>,          0,     100,  100,  "AO1 highest voltage"},
    {"AOL1", 4641, cfg,          in<tenth_milliamperes>, 0,     200,  0,    "AO1 lowest current"},
    {"AOH1", 4651, cfg,          in<tenth_milliamperes>, 0,     200,  200,  "AO1 highest current"},
    {"ASL1", 4661, cfg,          in<tenth_percent>,      0, 1000, 0, "AO1 scale: value at the lowest output"},
    {"ASH1", 4671, cfg,          in<tenth_percent>, 0, 1000, 1000, "AO1 scale: value at the highest output"},
    {"AO1",  5021, cfg,          signal_source,          {},    {},   0,    "Output AO1 function"},
    {"AIV1", 5281, doubtful(rw), in<tenth_percent>,      0, 1000, 0, "Virtual analog input 1", &setpoint},
    {"AIV2", 5283, ro,           in<signed_count16>,     -8192, 8192, 0,    "Virtual analog input 2"},
    {"AIC2", 5284, cfg,          signal_source, {}, {}, 0, "Source of virtual analog input 2", &scaling},
};

// Logic inputs and outputs, and relays.
inline constexpr parameter logic_io[]{
    {"L1D",  4001,  cfg, in<units::milliseconds>, 0,  200,   0,    "LI1 switch-on delay"},
    {"L2D",  4002,  cfg, in<units::milliseconds>, 0,  200,   0,    "LI2 switch-on delay"},
    {"L3D",  4003,  cfg, in<units::milliseconds>, 0,  200,   0,    "LI3 switch-on delay"},
    {"L4D",  4004,  cfg, in<units::milliseconds>, 0,  200,   0,    "LI4 switch-on delay"},
    {"L5D",  4005,  cfg, in<units::milliseconds>, 0,  200,   0,    "LI5 switch-on delay"},
    {"L6D",  4006,  cfg, in<units::milliseconds>, 0,  200,   0,    "LI6 switch-on delay"},
    {"LA1D", 4021,  cfg, in<units::milliseconds>, 0,  200,   0,    "LA1 switch-on delay"},
    {"LA2D", 4022,  cfg, in<units::milliseconds>, 0,  200,   0,    "LA2 switch-on delay"},
    {"R1S",  4201,  cfg, output_level,            {}, {},    0,    "Relay R1 active level", &relay},
    {"R2S",  4202,  cfg, output_level,            {}, {},    0,    "Relay R2 active level", &relay},
    {"LO1S", 4209,  cfg, output_level,            {}, {},    0,    "Output LO1 active level", &relay},
    {"R1H",  4221,  cfg, in<units::milliseconds>, 0,  9999,  0,    "Relay R1 holding time"},
    {"R2H",  4222,  cfg, in<units::milliseconds>, 0,  9999,  0,    "Relay R2 holding time"},
    {"LO1H", 4229,  cfg, in<units::milliseconds>, 0,  9999,  0,    "Output LO1 holding time"},
    {"R1D",  4241,  cfg, in<units::milliseconds>, 0,  60000, 0,    "Relay R1 delay"},
    {"R2D",  4242,  cfg, in<units::milliseconds>, 0,  60000, 0,    "Relay R2 delay"},
    {"LO1D", 4249,  cfg, in<units::milliseconds>, 0,  60000, 0,    "Output LO1 delay"},
    {"DO1S", 4261,  cfg, output_level,            {}, {},    0,    "Output DO1 active level", &relay},
    {"DO1H", 4271,  cfg, in<units::milliseconds>, 0,  9999,  0,    "Output DO1 holding time"},
    {"DO1D", 4281,  cfg, in<units::milliseconds>, 0,  60000, 0,    "Output DO1 delay"},
    {"R1",   5001,  cfg, logic_source,            {}, {},    1,    "Relay R1 function", &relay},
    {"R2",   5002,  cfg, logic_source,            {}, {},    {},   "Relay R2 function", &relay},
    {"LO1",  5009,  cfg, logic_source,            {}, {},    0,    "Output LO1 function", &relay},
    {"DO1",  5031,  cfg, logic_source,            {}, {},    0,    "Output DO1 function", &relay},
    row_of(il1r),
    {"OL1R", 5212,  rw,  bits(output_image),      {}, {},    {},   "Logic outputs", &sets_output},
    {"PIL",  13302, cfg, in<decahertz>,           0, 2000, 0, "Pulse input: minimum frequency", &scaling},
    {"PFR",  13303, cfg, in<decahertz>,           0, 2000, 2000, "Pulse input: maximum frequency", &scaling},
    {"PFI",  13304, cfg, in<units::milliseconds>, 0,  1000,  0,    "Pulse input: filter", &scaling},
};

// Lines and networks.
inline constexpr parameter communication[]{
    row_of(add, this_line), row_of(tbr, this_line), row_of(tfo, this_line), row_of(tto, timeout),
    {"ADCO", 6051, cfg, in<count16>,      0,  127,   0,   "CANopen address", &other_bus},
    {"BDCO", 6053, cfg, can_rate,         {}, {},    60,  "CANopen bit rate", &other_bus},
    {"ADRC", 6601, cfg, in<count16>,      0,  65535, {},  "Communication card address", &other_bus},
    {"BDR",  6603, cfg, in<serial_rate>,  {}, {},    {},  "Communication card bit rate", &other_bus},
    {"PRC",  6606, cfg, in<no_yes>,       {}, {},    0,   "Node number for peer-cop", &other_bus},
    {"GLB",  6607, cfg, in<count16>,      0,  32,    0,   "Peer-cop global transmission", &other_bus},
    {"AMOC", 6651, cfg, in<count16>,      0, 247, 0, "Modbus address of the communication card", &other_bus},
    {"BDRU", 6660, ro,  in<serial_rate>,  {}, {},    4,   "Communication card bit rate in use"},
    {"PRFL", 6665, ro,  profibus_profile, {}, {},    100, "PROFIBUS profile in use"},
    {"DPMA", 6666, ro,  profibus_master,  {}, {},    1,   "PROFIBUS active master"},
    {"CIOA", 6667, ro,  io_assembly,      {}, {},    1,   "I/O assembly in use"},
    {"CIO2", 6668, ro,  io_assembly,      {}, {},    1,   "Second I/O assembly in use"},
    {"BTUA", 6670, cfg, off_on,           {}, {},    0,   "Bluetooth on", &other_bus},
    {"BTUC", 6671, cfg, logic_input,      {}, {},    0,   "Bluetooth visibility", &other_bus},
    {"BTPI", 6673, cfg, in<count16>,      0,  9999,  0,   "Bluetooth PIN", &other_bus},
};

// The scanner: words that one request moves.
inline constexpr parameter scanner[]{
    row_of(nma1, ordinary), row_of(nma2, ordinary), row_of(nma3, ordinary), row_of(nma4, ordinary),
    row_of(nma5, ordinary), row_of(nma6, ordinary), row_of(nma7, ordinary), row_of(nma8, ordinary),
    row_of(nca1, cyclic_words), row_of(nca2, cyclic_words), row_of(nca3, cyclic_words),
    row_of(nca4, cyclic_words), row_of(nca5, cyclic_words), row_of(nca6, cyclic_words),
    row_of(nca7, cyclic_words), row_of(nca8, cyclic_words), row_of(nm1), row_of(nm2), row_of(nm3),
    row_of(nm4), row_of(nm5), row_of(nm6), row_of(nm7), row_of(nm8), row_of(nc1, passed_on),
    row_of(nc2, passed_on), row_of(nc3, passed_on), row_of(nc4, passed_on), row_of(nc5, passed_on),
    row_of(nc6, passed_on), row_of(nc7, passed_on), row_of(nc8, passed_on),
    {"OMA1", 15401, ro, in<count16>, 0, 65535, 3201, "Card scanner: address of input word 1"},
    {"OMA2", 15402, ro, in<count16>, 0, 65535, 8604, "Card scanner: address of input word 2"},
    {"OMA3", 15403, ro, in<count16>, 0, 65535, 0,    "Card scanner: address of input word 3"},
    {"OMA4", 15404, ro, in<count16>, 0, 65535, 0,    "Card scanner: address of input word 4"},
    {"OMA5", 15405, ro, in<count16>, 0, 65535, 0,    "Card scanner: address of input word 5"},
    {"OMA6", 15406, ro, in<count16>, 0, 65535, 0,    "Card scanner: address of input word 6"},
    {"OCA1", 15421, ro, in<count16>, 0, 65535, 8501, "Card scanner: address of output word 1"},
    {"OCA2", 15422, ro, in<count16>, 0, 65535, 8602, "Card scanner: address of output word 2"},
    {"OCA3", 15423, ro, in<count16>, 0, 65535, 0,    "Card scanner: address of output word 3"},
    {"OCA4", 15424, ro, in<count16>, 0, 65535, 0,    "Card scanner: address of output word 4"},
    {"OCA5", 15425, ro, in<count16>, 0, 65535, 0,    "Card scanner: address of output word 5"},
    {"OCA6", 15426, ro, in<count16>, 0, 65535, 0,    "Card scanner: address of output word 6"},
};
// clang-format on

} // namespace altivar::atv320::rows
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
