// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: registers of which too little is known to write them: no access, no limits, or values that no public list
// explains. They are read-only here, and doubtful.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/communication.hpp>
#include <rtuwire/altivar/parameters/atv320/values/configuration.hpp>
#include <rtuwire/altivar/parameters/atv320/values/drive.hpp>
#include <rtuwire/altivar/parameters/atv320/values/faults.hpp>
#include <rtuwire/altivar/parameters/atv320/values/known.hpp>
#include <rtuwire/altivar/parameters/atv320/values/motor.hpp>
#include <rtuwire/altivar/parameters/family_words.hpp>
#include <rtuwire/altivar/parameters/parameter_list.hpp>
#include <rtuwire/altivar/parameters/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320 {

// clang-format off
inline constexpr reg<signed_count16> mmf{.code = "MMF", .address = 3219, .mode = access::read_only, .name = "Measured motor frequency", .source = provenance::doubtful};
inline constexpr reg<signed_count16> frht{.code = "FRHT", .address = 3222, .mode = access::read_only, .name = "Frequency reference, high resolution", .source = provenance::doubtful};
inline constexpr reg<count16> aph{.code = "APH", .address = 3230, .mode = access::read_only, .name = "Energy consumed", .source = provenance::doubtful};
inline constexpr reg<count16> unt{.code = "UNT", .address = 3234, .mode = access::read_only, .name = "Units of the energy and time counters", .source = provenance::doubtful};
inline constexpr reg<count16> ntj{.code = "NTJ", .address = 3241, .mode = access::read_only, .name = "Number of transistor temperature alarms", .source = provenance::doubtful};
inline constexpr reg<signed_count16> stfr{.code = "STFR", .address = 3281, .mode = access::read_only, .name = "Stator frequency estimate, signed", .source = provenance::doubtful};
inline constexpr reg<signed_decihertz> fro{.code = "FRO", .address = 9021, .mode = access::read_only, .name = "Frequency reference after the ramp", .source = provenance::doubtful};
inline constexpr reg<count16> hsc{.code = "HSC", .address = 13308, .mode = access::read_only, .name = "High-speed pulse counter", .source = provenance::doubtful};
inline constexpr reg<signed_rpm> frod{.code = "FROD", .address = 8641, .mode = access::read_only, .name = "Speed reference after the ramp", .source = provenance::doubtful};
inline constexpr reg<motor_data_choice> mpc{.code = "MPC", .address = 9614, .mode = access::read_only, .name = "Motor data: power or power factor", .source = provenance::doubtful};
inline constexpr reg<count16> pfl{.code = "PFL", .address = 9624, .mode = access::read_only, .name = "V/f flux profile", .source = provenance::doubtful};
inline constexpr reg<deciamperes> ncrs{.code = "NCRS", .address = 9670, .mode = access::read_only, .name = "Rated current, synchronous motor", .source = provenance::doubtful};
inline constexpr reg<signed_count16> rdae{.code = "RDAE", .address = 9676, .mode = access::read_only, .name = "d-axis current error ratio", .source = provenance::doubtful};
inline constexpr reg<count16> fab{.code = "FAB", .address = 13911, .mode = access::read_only, .name = "Voltage boost range", .source = provenance::doubtful};
inline constexpr reg<signed_count16> boo{.code = "BOO", .address = 13912, .mode = access::read_only, .name = "Voltage boost", .source = provenance::doubtful};
inline constexpr reg<count16> fri{.code = "FRI", .address = 15601, .mode = access::read_only, .name = "High-frequency injection: frequency", .source = provenance::doubtful};
inline constexpr reg<ethercat_state> ecss{.code = "ECSS", .address = 6690, .mode = access::read_only, .name = "EtherCAT slave state", .source = provenance::doubtful};
inline constexpr reg<count16> ecsa{.code = "ECSA", .address = 6691, .mode = access::read_only, .name = "EtherCAT second address", .source = provenance::doubtful};
inline constexpr reg<count16> ecaa{.code = "ECAA", .address = 6692, .mode = access::read_only, .name = "EtherCAT address", .source = provenance::doubtful};
inline constexpr reg<count16> inf6{.code = "INF6", .address = 3699, .mode = access::read_only, .name = "Option link fault code", .source = provenance::doubtful};
inline constexpr reg<count16> lanf{.code = "LANF", .address = 5640, .mode = access::read_only, .name = "Load slip: detection level", .source = provenance::doubtful};
inline constexpr reg<count16> tanf{.code = "TANF", .address = 5641, .mode = access::read_only, .name = "Load slip: detection time", .source = provenance::doubtful};
inline constexpr reg<count16> fanf{.code = "FANF", .address = 5642, .mode = access::read_only, .name = "Load slip: detection frequency", .source = provenance::doubtful};
inline constexpr reg<slip_direction> danf{.code = "DANF", .address = 5643, .mode = access::read_only, .name = "Load slip: detection direction", .source = provenance::doubtful};
inline constexpr reg<no_yes> sdd{.code = "SDD", .address = 7005, .mode = access::read_only, .name = "Load slip detection", .source = provenance::doubtful};
inline constexpr reg<fault_reaction> scl3{.code = "SCL3", .address = 7018, .mode = access::read_only, .name = "Reaction to a short circuit to earth", .source = provenance::doubtful};
inline constexpr reg<no_yes> hrfc{.code = "HRFC", .address = 7150, .mode = access::read_only, .name = "Configuration of faults that need a power cycle", .source = provenance::doubtful};
inline constexpr reg<dc_bus_supply> dccm{.code = "DCCM", .address = 13850, .mode = access::read_only, .name = "DC bus sharing", .source = provenance::doubtful};
inline constexpr reg<dc_bus_partner> dccc{.code = "DCCC", .address = 13851, .mode = access::read_only, .name = "DC bus sharing: partner drives", .source = provenance::doubtful};
inline constexpr reg<count16> ftu{.code = "FTU", .address = 14413, .mode = access::read_only, .name = "Underload restart delay", .source = provenance::doubtful};
inline constexpr reg<count16> fto{.code = "FTO", .address = 14423, .mode = access::read_only, .name = "Overload restart delay", .source = provenance::doubtful};
inline constexpr reg<count16> loc{.code = "LOC", .address = 14425, .mode = access::read_only, .name = "Overload threshold", .source = provenance::doubtful};
inline constexpr reg<encoder_card> ebht{.code = "EBHT", .address = 3561, .mode = access::read_only, .name = "Encoder card hardware", .source = provenance::doubtful};
inline constexpr reg<count16> fry{.code = "FRY", .address = 3022, .mode = access::read_only, .name = "Parameter groups of the factory reset", .source = provenance::doubtful};
inline constexpr reg<network_identity> ntid{.code = "NTID", .address = 6694, .mode = access::read_only, .name = "Identity reported on the fieldbus", .source = provenance::doubtful};
inline constexpr reg<count16> sds{.code = "SDS", .address = 12001, .mode = access::read_only, .name = "Scale factor of the user's speed display", .source = provenance::doubtful};
inline constexpr reg<count16> spd{.code = "SPD", .address = 12004, .mode = access::read_only, .name = "Motor speed for display", .source = provenance::doubtful};
inline constexpr reg<count16> spd1{.code = "SPD1", .address = 12008, .mode = access::read_only, .name = "User-scaled speed 1", .source = provenance::doubtful};
inline constexpr reg<count16> spd2{.code = "SPD2", .address = 12009, .mode = access::read_only, .name = "User-scaled speed 2", .source = provenance::doubtful};
inline constexpr reg<count16> spd3{.code = "SPD3", .address = 12010, .mode = access::read_only, .name = "User-scaled speed 3", .source = provenance::doubtful};
inline constexpr reg<count16> slwt{.code = "SLWT", .address = 15305, .mode = access::read_only, .name = "SLS wait time", .source = provenance::doubtful};
inline constexpr reg<count16> saf1{.code = "SAF1", .address = 15350, .mode = access::read_only, .name = "Safety fault register 1", .source = provenance::doubtful};
inline constexpr reg<count16> sf00{.code = "SF00", .address = 15351, .mode = access::read_only, .name = "Safety fault detail SF00", .source = provenance::doubtful};
inline constexpr reg<count16> sf01{.code = "SF01", .address = 15352, .mode = access::read_only, .name = "Safety fault detail SF01", .source = provenance::doubtful};
inline constexpr reg<count16> sf02{.code = "SF02", .address = 15353, .mode = access::read_only, .name = "Safety fault detail SF02", .source = provenance::doubtful};
inline constexpr reg<count16> sf03{.code = "SF03", .address = 15354, .mode = access::read_only, .name = "Safety fault detail SF03", .source = provenance::doubtful};
inline constexpr reg<count16> sf04{.code = "SF04", .address = 15355, .mode = access::read_only, .name = "Safety fault detail SF04", .source = provenance::doubtful};
inline constexpr reg<count16> sf05{.code = "SF05", .address = 15356, .mode = access::read_only, .name = "Safety fault detail SF05", .source = provenance::doubtful};
inline constexpr reg<count16> sf06{.code = "SF06", .address = 15357, .mode = access::read_only, .name = "Safety fault detail SF06", .source = provenance::doubtful};
inline constexpr reg<count16> sf07{.code = "SF07", .address = 15358, .mode = access::read_only, .name = "Safety fault detail SF07", .source = provenance::doubtful};
inline constexpr reg<count16> saf2{.code = "SAF2", .address = 15359, .mode = access::read_only, .name = "Safety fault register 2", .source = provenance::doubtful};
inline constexpr reg<count16> sf08{.code = "SF08", .address = 15360, .mode = access::read_only, .name = "Safety fault detail SF08", .source = provenance::doubtful};
inline constexpr reg<count16> sf09{.code = "SF09", .address = 15361, .mode = access::read_only, .name = "Safety fault detail SF09", .source = provenance::doubtful};
inline constexpr reg<count16> sf10{.code = "SF10", .address = 15362, .mode = access::read_only, .name = "Safety fault detail SF10", .source = provenance::doubtful};
inline constexpr reg<count16> sf11{.code = "SF11", .address = 15363, .mode = access::read_only, .name = "Safety fault detail SF11", .source = provenance::doubtful};
inline constexpr reg<no_yes> smsa{.code = "SMSA", .address = 15380, .mode = access::read_only, .name = "SMS enabled", .source = provenance::doubtful};
inline constexpr reg<count16> smll{.code = "SMLL", .address = 15381, .mode = access::read_only, .name = "SMS low speed limit", .source = provenance::doubtful};
inline constexpr reg<count16> smlh{.code = "SMLH", .address = 15382, .mode = access::read_only, .name = "SMS high speed limit", .source = provenance::doubtful};
inline constexpr reg<safety_input> smls{.code = "SMLS", .address = 15383, .mode = access::read_only, .name = "SMS limit input", .source = provenance::doubtful};
inline constexpr reg<sms_state> smss{.code = "SMSS", .address = 15384, .mode = access::read_only, .name = "SMS state", .source = provenance::doubtful};
inline constexpr reg<no_yes> gdla{.code = "GDLA", .address = 15390, .mode = access::read_only, .name = "GDL enabled", .source = provenance::doubtful};
inline constexpr reg<count16> glld{.code = "GLLD", .address = 15391, .mode = access::read_only, .name = "GDL unlock delay, long", .source = provenance::doubtful};
inline constexpr reg<count16> glsd{.code = "GLSD", .address = 15392, .mode = access::read_only, .name = "GDL unlock delay, short", .source = provenance::doubtful};
inline constexpr reg<gdl_state> gdls{.code = "GDLS", .address = 15393, .mode = access::read_only, .name = "GDL state", .source = provenance::doubtful};
inline constexpr reg<count16> crp0{.code = "CRP0", .address = 7290, .mode = access::read_only, .name = "Channels at the most recent fault", .source = provenance::doubtful};
inline constexpr reg<count16> crp1{.code = "CRP1", .address = 7291, .mode = access::read_only, .name = "Channels at fault 1 back", .source = provenance::doubtful};
inline constexpr reg<count16> crp2{.code = "CRP2", .address = 7292, .mode = access::read_only, .name = "Channels at fault 2 back", .source = provenance::doubtful};
inline constexpr reg<count16> crp3{.code = "CRP3", .address = 7293, .mode = access::read_only, .name = "Channels at fault 3 back", .source = provenance::doubtful};
inline constexpr reg<count16> crp4{.code = "CRP4", .address = 7294, .mode = access::read_only, .name = "Channels at fault 4 back", .source = provenance::doubtful};
inline constexpr reg<count16> crp5{.code = "CRP5", .address = 7295, .mode = access::read_only, .name = "Channels at fault 5 back", .source = provenance::doubtful};
inline constexpr reg<count16> crp6{.code = "CRP6", .address = 7296, .mode = access::read_only, .name = "Channels at fault 6 back", .source = provenance::doubtful};
inline constexpr reg<count16> crp7{.code = "CRP7", .address = 7297, .mode = access::read_only, .name = "Channels at fault 7 back", .source = provenance::doubtful};
inline constexpr reg<count16> crp8{.code = "CRP8", .address = 7298, .mode = access::read_only, .name = "Channels at fault 8 back", .source = provenance::doubtful};
inline constexpr reg<product_state> hs1{.code = "HS1", .address = 7321, .mode = access::read_only, .name = "Product state at fault 1 back", .source = provenance::doubtful};
inline constexpr reg<product_state> hs2{.code = "HS2", .address = 7322, .mode = access::read_only, .name = "Product state at fault 2 back", .source = provenance::doubtful};
inline constexpr reg<product_state> hs3{.code = "HS3", .address = 7323, .mode = access::read_only, .name = "Product state at fault 3 back", .source = provenance::doubtful};
inline constexpr reg<product_state> hs4{.code = "HS4", .address = 7324, .mode = access::read_only, .name = "Product state at fault 4 back", .source = provenance::doubtful};
inline constexpr reg<product_state> hs5{.code = "HS5", .address = 7325, .mode = access::read_only, .name = "Product state at fault 5 back", .source = provenance::doubtful};
inline constexpr reg<product_state> hs6{.code = "HS6", .address = 7326, .mode = access::read_only, .name = "Product state at fault 6 back", .source = provenance::doubtful};
inline constexpr reg<product_state> hs7{.code = "HS7", .address = 7327, .mode = access::read_only, .name = "Product state at fault 7 back", .source = provenance::doubtful};
inline constexpr reg<product_state> hs8{.code = "HS8", .address = 7328, .mode = access::read_only, .name = "Product state at fault 8 back", .source = provenance::doubtful};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::unverified {

/// What the drive shows.
struct monitoring : parameter_list<mmf, frht, aph, unt, ntj, stfr, fro, hsc> {};

/// Words that command the drive, and its speed mode.
struct control : parameter_list<frod> {};

/// The motor and its control.
struct motor_control : parameter_list<mpc, pfl, ncrs, rdae, fab, boo, fri> {};

/// Lines and networks.
struct communication : parameter_list<ecss, ecsa, ecaa> {};

/// Reactions to faults.
struct faults : parameter_list<inf6, lanf, tanf, fanf, danf, sdd, scl3, hrfc, dccm, dccc> {};

/// Load monitoring.
struct process_monitoring : parameter_list<ftu, fto, loc> {};

/// What drive this is.
struct identification : parameter_list<ebht> {};

/// Saving and recalling configurations.
struct configuration : parameter_list<fry, ntid> {};

/// The display and its access.
struct display : parameter_list<sds, spd, spd1, spd2, spd3> {};

/// Safety functions, as far as the line shows them.
struct safety : parameter_list<slwt, saf1, sf00, sf01, sf02, sf03, sf04, sf05, sf06, sf07, saf2, sf08, sf09, sf10, sf11,
                               smsa, smll, smlh, smls, smss, gdla, glld, glsd, gdls> {};

/// States at past faults.
struct history_state
    : parameter_list<crp0, crp1, crp2, crp3, crp4, crp5, crp6, crp7, crp8, hs1, hs2, hs3, hs4, hs5, hs6, hs7, hs8> {};

} // namespace altivar::atv320::unverified
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
