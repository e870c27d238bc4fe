// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: registers of which too little is known to write them: no access, no limits, or values that no public list
// explains. They are read-only here, and doubtful.
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
// The state of an EtherCAT slave.
inline constexpr choice ethercat_state[]{
    {1, "InIt", "Init"}, {2, "PrOP", "Pre-Operational"}, {3, "bOOt", "Bootstrap"},
    {4, "SFOP", "Safe-Operational"}, {8, "OP", "Operational"},
};
// The supply of an encoder card.
inline constexpr choice encoder_card[]{
    {0, "nO", "none"}, {1, "rS05", "RS-422, 5 V"}, {2, "PP24", "push-pull, 24 V"},
    {3, "OC15", "open collector, 15 V"}, {4, "OC12", "open collector, 12 V"}, {5, "rS15", "RS-422, 15 V"},
    {6, "PP15", "push-pull, 15 V"}, {7, "PP12", "push-pull, 12 V"},
};
// As which drive it shows itself on a network.
inline constexpr choice network_identity[]{{0, "AtV320", "ATV320"}, {1, "AtV32", "ATV32"}};
// Which difference of speed trips.
inline constexpr choice slip_direction[]{{0, "OVEr", "too fast"}, {1, "bOtH", "too fast or too slow"}};
// Which drives share the DC bus.
inline constexpr choice dc_bus_partner[]{{0, "AtV", "Altivar"}, {1, "LHM", "Lexium"}};
// What feeds the drive.
inline constexpr choice dc_bus_supply[]{
    {0, "nO", "not shared"}, {1, "MAIn", "by the bus and the mains"}, {2, "bUS", "by the bus only"},
};
// The state of the guard door lock.
inline constexpr choice gdl_state[]{
    {0, "nO", "not configured"}, {1, "OFF", "inactive"}, {2, "Std", "short delay runs"},
    {3, "LGd", "long delay runs"}, {4, "On", "active"}, {5, "FLt", "in fault"},
};
// The state of safe maximum speed.
inline constexpr choice sms_state[]{
    {0, "nO", "not configured"}, {1, "SMS", "active"}, {2, "FtI", "internal fault (FtI)"},
    {3, "FtO", "overspeed fault (FtO)"},
};
// The signals of an encoder.
inline constexpr choice encoder_signals[]{{1, "AAbb", "A, /A, B, /B"}, {2, "Ab", "A, B"}};
// What an encoder is for.
inline constexpr choice encoder_use[]{{0, "nO", "not used"}, {1, "SEC", "speed supervision"}};
// Which data of the motor are given.
inline constexpr choice motor_data_choice[]{{0, "nPr", "rated power (NPR)"}, {1, "COS", "power factor (COS)"}};

// What the drive shows.
inline constexpr parameter unverified_monitoring[]{
    {"FRHT", 3222, doubtful(ro), in<signed_count16>,   {}, {}, {}, "Frequency reference, high resolution"},
    {"APH",  3230, doubtful(ro), in<count16>,          {}, {}, {}, "Energy consumed"},
    {"FRO",  9021, doubtful(ro), in<signed_decihertz>, {}, {}, {}, "Frequency reference after the ramp"},
};

// Words that command the drive, and its speed mode.
inline constexpr parameter unverified_control[]{
    {"FROD", 8641, doubtful(ro), in<signed_rpm>, {}, {}, {}, "Speed reference after the ramp"},
};

// The motor and its control.
inline constexpr parameter unverified_motor_control[]{
    {"MPC",  9614, doubtful(ro), motor_data_choice, {}, {}, {}, "Motor data: power or power factor"},
    {"NCRS", 9670, doubtful(ro), in<deciamperes>,   {}, {}, {}, "Rated current, synchronous motor"},
};

// Analog inputs and outputs.
inline constexpr parameter unverified_analog_io[]{
    {"AOF1", 4293, doubtful(ro), in<no_yes>,              {}, {}, {}, "AO1 fallback"},
    {"AI1R", 5232, doubtful(ro), in<signed_count16>,      {}, {}, {}, "AI1, standardised value"},
    {"AI2R", 5233, doubtful(ro), in<signed_count16>,      {}, {}, {}, "AI2, standardised value"},
    {"AI3R", 5234, doubtful(ro), in<signed_count16>,      {}, {}, {}, "AI3, standardised value"},
    {"AI1C", 5242, doubtful(ro), in<signed_millivolts>,   {}, {}, {}, "AI1, physical value"},
    {"AI2C", 5243, doubtful(ro), in<signed_millivolts>,   {}, {}, {}, "AI2, physical value"},
    {"AI3C", 5244, doubtful(ro), in<signed_microamperes>, {}, {}, {}, "AI3, physical value"},
    {"AO1R", 5261, doubtful(ro), in<signed_count16>,      {}, {}, {}, "AO1, standardised value"},
    {"AO1C", 5271, doubtful(ro), in<signed_count16>,      {}, {}, {}, "AO1, physical value"},
    {"SAI1", 5291, doubtful(ro), in<signed_millivolts>,   {}, {}, {}, "AI1, physical value, unfiltered"},
    {"SAI2", 5292, doubtful(ro), in<signed_millivolts>,   {}, {}, {}, "AI2, physical value, unfiltered"},
    {"SAI3", 5293, doubtful(ro), in<signed_microamperes>, {}, {}, {}, "AI3, physical value, unfiltered"},
    {"SAO1", 5295, doubtful(ro), in<signed_count16>,      {}, {}, {}, "AO1, physical value, unfiltered"},
};

// Logic inputs and outputs, and relays.
inline constexpr parameter unverified_logic_io[]{
    {"R1F",  4290, doubtful(ro), in<no_yes>,      {}, {}, {}, "Relay R1 fallback"},
    {"R2F",  4291, doubtful(ro), in<no_yes>,      {}, {}, {}, "Relay R2 fallback"},
    {"LO1F", 4292, doubtful(ro), in<no_yes>,      {}, {}, {}, "Output LO1 fallback"},
    {"ENU",  5606, doubtful(ro), encoder_use,     {}, {}, {}, "Encoder use"},
    {"ENS",  5608, doubtful(ro), encoder_signals, {}, {}, {}, "Encoder signals"},
};

// Lines and networks.
inline constexpr parameter unverified_communication[]{
    {"ECSS", 6690, doubtful(ro), ethercat_state, {}, {}, {}, "EtherCAT slave state"},
};

// Reactions to faults.
inline constexpr parameter unverified_faults[]{
    {"DANF", 5643,  doubtful(ro), slip_direction, {}, {}, {}, "Load slip: detection direction"},
    {"SDD",  7005,  doubtful(ro), in<no_yes>,     {}, {}, {}, "Load slip detection"},
    {"SCL3", 7018,  doubtful(ro), fault_reaction, {}, {}, {}, "Reaction to a short circuit to earth"},
    {"HRFC", 7150,  doubtful(ro), in<no_yes>, {}, {}, {}, "Configuration of faults that need a power cycle"},
    {"DCCM", 13850, doubtful(ro), dc_bus_supply,  {}, {}, {}, "DC bus sharing"},
    {"DCCC", 13851, doubtful(ro), dc_bus_partner, {}, {}, {}, "DC bus sharing: partner drives"},
};

// What drive this is.
inline constexpr parameter unverified_identification[]{
    {"EBHT", 3561, doubtful(ro), encoder_card, {}, {}, {}, "Encoder card hardware"},
};

// Saving and recalling configurations.
inline constexpr parameter unverified_configuration[]{
    {"FRY",  3022, doubtful(ro), in<count16>,      {}, {}, {}, "Parameter groups of the factory reset"},
    {"NTID", 6694, doubtful(ro), network_identity, {}, {}, {}, "Identity reported on the fieldbus"},
};

// Safety functions, as far as the line shows them.
inline constexpr parameter unverified_safety[]{
    {"SMSA", 15380, doubtful(ro), in<no_yes>,   {}, {}, {}, "SMS enabled"},
    {"SMLS", 15383, doubtful(ro), safety_input, {}, {}, {}, "SMS limit input"},
    {"SMSS", 15384, doubtful(ro), sms_state,    {}, {}, {}, "SMS state"},
    {"GDLA", 15390, doubtful(ro), in<no_yes>,   {}, {}, {}, "GDL enabled"},
    {"GDLS", 15393, doubtful(ro), gdl_state,    {}, {}, {}, "GDL state"},
};

// States at past faults.
inline constexpr parameter unverified_history_state[]{
    {"CRP0", 7290, doubtful(ro), in<count16>,       {}, {}, {}, "Channels at the most recent fault"},
    {"CRP1", 7291, doubtful(ro), in<count16>,       {}, {}, {}, "Channels at fault 1 back"},
    {"CRP2", 7292, doubtful(ro), in<count16>,       {}, {}, {}, "Channels at fault 2 back"},
    {"CRP3", 7293, doubtful(ro), in<count16>,       {}, {}, {}, "Channels at fault 3 back"},
    {"CRP4", 7294, doubtful(ro), in<count16>,       {}, {}, {}, "Channels at fault 4 back"},
    {"CRP5", 7295, doubtful(ro), in<count16>,       {}, {}, {}, "Channels at fault 5 back"},
    {"CRP6", 7296, doubtful(ro), in<count16>,       {}, {}, {}, "Channels at fault 6 back"},
    {"CRP7", 7297, doubtful(ro), in<count16>,       {}, {}, {}, "Channels at fault 7 back"},
    {"CRP8", 7298, doubtful(ro), in<count16>,       {}, {}, {}, "Channels at fault 8 back"},
    {"HS1",  7321, doubtful(ro), in<product_state>, {}, {}, {}, "Product state at fault 1 back"},
    {"HS2",  7322, doubtful(ro), in<product_state>, {}, {}, {}, "Product state at fault 2 back"},
    {"HS3",  7323, doubtful(ro), in<product_state>, {}, {}, {}, "Product state at fault 3 back"},
    {"HS4",  7324, doubtful(ro), in<product_state>, {}, {}, {}, "Product state at fault 4 back"},
    {"HS5",  7325, doubtful(ro), in<product_state>, {}, {}, {}, "Product state at fault 5 back"},
    {"HS6",  7326, doubtful(ro), in<product_state>, {}, {}, {}, "Product state at fault 6 back"},
    {"HS7",  7327, doubtful(ro), in<product_state>, {}, {}, {}, "Product state at fault 7 back"},
    {"HS8",  7328, doubtful(ro), in<product_state>, {}, {}, {}, "Product state at fault 8 back"},
};

// Stopping and DC injection.
inline constexpr parameter unverified_functions_stop[]{
    {"SDC1", 10403, doubtful(ro), in<deciamperes>, {}, {}, {}, "Automatic DC injection: first current"},
    {"SDC2", 10405, doubtful(ro), in<deciamperes>, {}, {}, {}, "Automatic DC injection: second current"},
    {"IDC",  11210, doubtful(ro), in<deciamperes>, {}, {}, {}, "DC injection: first current"},
    {"IDC2", 11212, doubtful(ro), in<deciamperes>, {}, {}, {}, "DC injection: second current"},
    {"MSTP", 12523, doubtful(ro), in<no_yes>,      {}, {}, {}, "Stop switch is remembered"},
    {"PRST", 12524, doubtful(ro), in<no_yes>,      {}, {}, {}, "Run order overrides a stop switch"},
};

// The PID regulator.
inline constexpr parameter unverified_functions_pid[]{
    {"PAL", 11961, doubtful(ro), in<count16>, {}, {}, {}, "PI feedback low alarm threshold"},
    {"PAH", 11962, doubtful(ro), in<count16>, {}, {}, {}, "PI feedback high alarm threshold"},
    {"PER", 11963, doubtful(ro), in<count16>, {}, {}, {}, "PI error alarm threshold"},
};

// Torque and current limits.
inline constexpr parameter unverified_functions_limits[]{
    {"CLI",  9201, doubtful(ro), in<deciamperes>, {}, {}, {}, "Current limit"},
    {"CL2",  9203, doubtful(ro), in<deciamperes>, {}, {}, {}, "Second current limit"},
    {"TLIM", 9211, doubtful(ro), in<count16>,     {}, {}, {}, "Torque limit, motoring"},
    {"TLIG", 9212, doubtful(ro), in<count16>,     {}, {}, {}, "Torque limit, generating"},
    {"I2TA", 9631, doubtful(ro), in<no_yes>,      {}, {}, {}, "I2t current limitation"},
};

// Brake control.
inline constexpr parameter unverified_functions_brake[]{
    {"IBR",  10006, doubtful(ro), in<deciamperes>, {}, {}, {}, "Brake release current"},
    {"IRD",  10011, doubtful(ro), in<deciamperes>, {}, {}, {}, "Brake release current, reverse"},
    {"IBRA", 10075, doubtful(ro), in<deciamperes>, {}, {}, {}, "Brake release current without weight signal"},
};

// High-speed hoisting and load sharing.
inline constexpr parameter unverified_functions_hoisting[]{
    {"CLO", 12302, doubtful(ro), in<deciamperes>, {}, {}, {}, "Current limit at high speed"},
};
// clang-format on

} // namespace altivar::atv320::rows
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
