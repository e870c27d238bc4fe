// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV12: all its parameters, by the groups of its menus, from its public parameter file (BBV51917). Those of which too
// little is known to write them stand apart: read-only, doubtful.
#pragma once

#include <rtuwire/altivar/device/atv12.hpp>
#include <rtuwire/altivar/parameters/compact_values.hpp>
#include <rtuwire/altivar/parameters/family_words.hpp>
#include <rtuwire/altivar/parameters/parameter_list.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/altivar/parameters/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv12 {

// clang-format off
inline constexpr reg<seconds> tac{.code = "TAC", .address = 3235, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Time in transistor temperature alarm"};
inline constexpr reg<centihours> pet{.code = "PET", .address = 3236, .min = {0}, .max = {65535}, .factory = 0, .name = "Process running time"};
inline constexpr reg<centihours> fth{.code = "FTH", .address = 3239, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Fan running time"};
inline constexpr reg<seconds> tac2{.code = "TAC2", .address = 3242, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Time at the lowest switching frequency"};
inline constexpr reg<active_channel> crc{.code = "CRC", .address = 8441, .mode = access::read_only, .name = "Active reference channel"};
inline constexpr reg<active_channel> ccc{.code = "CCC", .address = 8442, .mode = access::read_only, .name = "Active command channel"};
inline constexpr reg<counter_reset> rpr{.code = "RPR", .address = 3120, .factory = 0, .name = "Counter reset"};
inline constexpr reg<no_yes> rin{.code = "RIN", .address = 3108, .mode = access::configuration, .name = "Reverse direction locked"};
inline constexpr reg<signal_source> floc{.code = "FLOC", .address = 8432, .mode = access::configuration, .factory = 0, .name = "Reference channel in local control"};
inline constexpr reg<two_wire_type> tct{.code = "TCT", .address = 11102, .mode = access::configuration, .factory = 1, .name = "How 2-wire control reacts"};
inline constexpr reg<input_assignment> rrs{.code = "RRS", .address = 11105, .mode = access::configuration, .name = "Input for reverse running"};
inline constexpr reg<no_yes> pst{.code = "PST", .address = 64002, .mode = access::configuration, .factory = 1, .name = "Stop key always active"};
inline constexpr reg<deciamperes> ctd{.code = "CTD", .address = 11001, .min = {0}, .max = {65535}, .name = "Motor current threshold"};
inline constexpr reg<decihertz> ftd{.code = "FTD", .address = 11003, .min = {0}, .max = {4000}, .name = "Frequency threshold"};
inline constexpr reg<motor_standard> bfr{.code = "BFR", .address = 3015, .mode = access::configuration, .factory = 0, .name = "Standard motor frequency"};
inline constexpr reg<switching_mode> sft{.code = "SFT", .address = 3101, .mode = access::configuration, .factory = 1, .name = "Switching frequency mode"};
inline constexpr reg<no_yes> nrd{.code = "NRD", .address = 3107, .mode = access::configuration, .factory = 0, .name = "Motor noise reduction"};
inline constexpr reg<count16> sfc{.code = "SFC", .address = 9105, .min = {0}, .max = {100}, .name = "Speed loop filter"};
inline constexpr reg<motor_control_law> ctt{.code = "CTT", .address = 9607, .mode = access::configuration, .name = "Motor control law"};
inline constexpr reg<tuning_order> tun{.code = "TUN", .address = 9608, .mode = access::configuration, .factory = 0, .name = "Autotune"};
inline constexpr reg<tuning_state> stun{.code = "STUN", .address = 9617, .mode = access::read_only, .factory = 0, .name = "Motor model data in use"};
inline constexpr reg<percent> flg{.code = "FLG", .address = 9620, .min = {0}, .max = {100}, .factory = 20, .name = "Frequency loop gain"};
inline constexpr reg<percent> sta{.code = "STA", .address = 9621, .min = {0}, .max = {100}, .factory = 20, .name = "Frequency loop stability"};
inline constexpr reg<percent> ufr{.code = "UFR", .address = 9623, .min = {25}, .max = {200}, .factory = 100, .name = "IR compensation"};
inline constexpr reg<percent> pfl{.code = "PFL", .address = 9624, .min = {0}, .max = {100}, .factory = 20, .name = "V/f flux profile"};
inline constexpr reg<percent> slp{.code = "SLP", .address = 9625, .min = {0}, .max = {150}, .name = "Slip compensation"};
inline constexpr reg<percent> spgu{.code = "SPGU", .address = 9629, .min = {0}, .max = {1000}, .factory = 40, .name = "Inertia compensation of the V/f laws"};
inline constexpr reg<milliohms> rsm{.code = "RSM", .address = 9640, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Stator resistance in use"};
inline constexpr reg<count16> rsmi{.code = "RSMI", .address = 9641, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Stator resistance measured"};
inline constexpr reg<analog_type> ai1t{.code = "AI1T", .address = 4402, .mode = access::configuration, .name = "AI1 type"};
inline constexpr reg<tenth_milliamperes> crl1{.code = "CRL1", .address = 4432, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 40, .name = "AI1 current at 0 %"};
inline constexpr reg<tenth_milliamperes> crh1{.code = "CRH1", .address = 4442, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 200, .name = "AI1 current at 100 %"};
inline constexpr reg<analog_type> ao1t{.code = "AO1T", .address = 4601, .mode = access::configuration, .factory = 2, .name = "AO1 type"};
inline constexpr reg<signal_source> ao1{.code = "AO1", .address = 5021, .mode = access::configuration, .factory = 0, .name = "Output AO1 function"};
inline constexpr reg<signed_count16> ai1i{.code = "AI1I", .address = 5222, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "AI1 at the terminal, in steps"};
inline constexpr reg<signed_count16> ai1r{.code = "AI1R", .address = 5232, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "AI1, standardised value"};
inline constexpr reg<signed_count16> ao1r{.code = "AO1R", .address = 5261, .min = {-32767}, .max = {32767}, .factory = 0, .name = "AO1, standardised value"};
inline constexpr reg<signed_tenth_percent> aiv1{.code = "AIV1", .address = 5281, .min = {0}, .max = {1000}, .factory = 0, .name = "Virtual analog input 1"};
inline constexpr reg<logic_level> npl{.code = "NPL", .address = 4099, .mode = access::configuration, .factory = 0, .name = "Active level of the logic inputs"};
inline constexpr reg<logic_level> r1s{.code = "R1S", .address = 4201, .mode = access::configuration, .factory = 0, .name = "Relay R1 active level"};
inline constexpr reg<logic_level> lo1s{.code = "LO1S", .address = 4209, .mode = access::configuration, .factory = 0, .name = "Output LO1 active level"};
inline constexpr reg<input_assignment> r1{.code = "R1", .address = 5001, .mode = access::configuration, .factory = 1, .name = "Relay R1 function"};
inline constexpr reg<input_assignment> lo1{.code = "LO1", .address = 5009, .mode = access::configuration, .factory = 0, .name = "Output LO1 function"};
inline constexpr reg<output_image> ol1r{.code = "OL1R", .address = 5212, .name = "Logic outputs"};
inline constexpr reg<fault_reaction> epl{.code = "EPL", .address = 7006, .mode = access::configuration, .factory = 1, .name = "Reaction to an external fault"};
inline constexpr reg<fault_reaction> lfl1{.code = "LFL1", .address = 7017, .mode = access::configuration, .name = "Reaction to a lost signal on AI1"};
inline constexpr reg<decihertz> lff{.code = "LFF", .address = 7080, .mode = access::configuration, .min = {0}, .max = {4000}, .factory = 0, .name = "Fallback speed"};
inline constexpr reg<input_assignment> inh{.code = "INH", .address = 7125, .mode = access::configuration, .factory = 0, .name = "Input that inhibits faults"};
inline constexpr reg<input_assignment> etf{.code = "ETF", .address = 7131, .mode = access::configuration, .factory = 0, .name = "Input for external fault"};
inline constexpr reg<no_yes> mtm{.code = "MTM", .address = 9616, .mode = access::configuration, .factory = 0, .name = "Motor thermal state is remembered"};
inline constexpr reg<seconds> ult{.code = "ULT", .address = 14411, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "Underload detection delay"};
inline constexpr reg<minutes> ftu{.code = "FTU", .address = 14413, .min = {0}, .max = {6}, .factory = 0, .name = "Underload restart delay"};
inline constexpr reg<percent> lul{.code = "LUL", .address = 14415, .min = {20}, .max = {100}, .factory = 60, .name = "Underload threshold at zero speed"};
inline constexpr reg<seconds> tol{.code = "TOL", .address = 14421, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "Overload detection delay"};
inline constexpr reg<minutes> fto{.code = "FTO", .address = 14423, .min = {0}, .max = {6}, .factory = 0, .name = "Overload restart delay"};
inline constexpr reg<percent> loc{.code = "LOC", .address = 14425, .min = {70}, .max = {150}, .factory = 90, .name = "Overload threshold"};
inline constexpr reg<count16> spn{.code = "SPN", .address = 3301, .min = {0}, .max = {65535}, .factory = 0, .name = "Special product number"};
inline constexpr reg<macro_configuration> cfg{.code = "CFG", .address = 3052, .mode = access::configuration, .factory = 0, .name = "Macro configuration"};
inline constexpr reg<configuration_save> scs{.code = "SCS", .address = 8001, .mode = access::configuration, .factory = 0, .name = "Save the configuration"};
inline constexpr reg<configuration_recall> fcs{.code = "FCS", .address = 8002, .mode = access::configuration, .factory = 0, .name = "Load a configuration or factory settings"};
inline constexpr reg<state_history> ep0{.code = "EP0", .address = 7210, .mode = access::read_only, .name = "Status word at the most recent fault"};
inline constexpr reg<state_history> ep1{.code = "EP1", .address = 7211, .mode = access::read_only, .name = "Status word at fault 1 back"};
inline constexpr reg<state_history> ep2{.code = "EP2", .address = 7212, .mode = access::read_only, .name = "Status word at fault 2 back"};
inline constexpr reg<state_history> ep3{.code = "EP3", .address = 7213, .mode = access::read_only, .name = "Status word at fault 3 back"};
inline constexpr reg<state_history> ep4{.code = "EP4", .address = 7214, .mode = access::read_only, .name = "Status word at fault 4 back"};
inline constexpr reg<signed_deciamperes> lcp1{.code = "LCP1", .address = 7241, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Motor current at fault 1 back"};
inline constexpr reg<signed_deciamperes> lcp2{.code = "LCP2", .address = 7242, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Motor current at fault 2 back"};
inline constexpr reg<signed_deciamperes> lcp3{.code = "LCP3", .address = 7243, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Motor current at fault 3 back"};
inline constexpr reg<signed_deciamperes> lcp4{.code = "LCP4", .address = 7244, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Motor current at fault 4 back"};
inline constexpr reg<signed_decihertz> rfp1{.code = "RFP1", .address = 7251, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Output frequency at fault 1 back"};
inline constexpr reg<signed_decihertz> rfp2{.code = "RFP2", .address = 7252, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Output frequency at fault 2 back"};
inline constexpr reg<signed_decihertz> rfp3{.code = "RFP3", .address = 7253, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Output frequency at fault 3 back"};
inline constexpr reg<signed_decihertz> rfp4{.code = "RFP4", .address = 7254, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Output frequency at fault 4 back"};
inline constexpr reg<hours> rtp1{.code = "RTP1", .address = 7261, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Motor running time at fault 1 back"};
inline constexpr reg<hours> rtp2{.code = "RTP2", .address = 7262, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Motor running time at fault 2 back"};
inline constexpr reg<hours> rtp3{.code = "RTP3", .address = 7263, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Motor running time at fault 3 back"};
inline constexpr reg<hours> rtp4{.code = "RTP4", .address = 7264, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Motor running time at fault 4 back"};
inline constexpr reg<volts> ulp1{.code = "ULP1", .address = 7271, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Mains voltage at fault 1 back"};
inline constexpr reg<volts> ulp2{.code = "ULP2", .address = 7272, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Mains voltage at fault 2 back"};
inline constexpr reg<volts> ulp3{.code = "ULP3", .address = 7273, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Mains voltage at fault 3 back"};
inline constexpr reg<volts> ulp4{.code = "ULP4", .address = 7274, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Mains voltage at fault 4 back"};
inline constexpr reg<signed_percent> otp1{.code = "OTP1", .address = 7331, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Motor torque at fault 1 back"};
inline constexpr reg<signed_percent> otp2{.code = "OTP2", .address = 7332, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Motor torque at fault 2 back"};
inline constexpr reg<signed_percent> otp3{.code = "OTP3", .address = 7333, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Motor torque at fault 3 back"};
inline constexpr reg<signed_percent> otp4{.code = "OTP4", .address = 7334, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "Motor torque at fault 4 back"};
inline constexpr reg<percent> tdp1{.code = "TDP1", .address = 7341, .mode = access::read_only, .min = {0}, .max = {255}, .factory = 0, .name = "Drive thermal state at fault 1 back"};
inline constexpr reg<percent> tdp2{.code = "TDP2", .address = 7342, .mode = access::read_only, .min = {0}, .max = {255}, .factory = 0, .name = "Drive thermal state at fault 2 back"};
inline constexpr reg<percent> tdp3{.code = "TDP3", .address = 7343, .mode = access::read_only, .min = {0}, .max = {255}, .factory = 0, .name = "Drive thermal state at fault 3 back"};
inline constexpr reg<percent> tdp4{.code = "TDP4", .address = 7344, .mode = access::read_only, .min = {0}, .max = {255}, .factory = 0, .name = "Drive thermal state at fault 4 back"};
inline constexpr reg<whole_celsius> tjp1{.code = "TJP1", .address = 7351, .mode = access::read_only, .min = {0}, .max = {255}, .factory = 0, .name = "Transistor temperature at fault 1 back"};
inline constexpr reg<whole_celsius> tjp2{.code = "TJP2", .address = 7352, .mode = access::read_only, .min = {0}, .max = {255}, .factory = 0, .name = "Transistor temperature at fault 2 back"};
inline constexpr reg<whole_celsius> tjp3{.code = "TJP3", .address = 7353, .mode = access::read_only, .min = {0}, .max = {255}, .factory = 0, .name = "Transistor temperature at fault 3 back"};
inline constexpr reg<whole_celsius> tjp4{.code = "TJP4", .address = 7354, .mode = access::read_only, .min = {0}, .max = {255}, .factory = 0, .name = "Transistor temperature at fault 4 back"};
inline constexpr reg<hertz> sfp1{.code = "SFP1", .address = 7361, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Switching frequency at fault 1 back"};
inline constexpr reg<hertz> sfp2{.code = "SFP2", .address = 7362, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Switching frequency at fault 2 back"};
inline constexpr reg<hertz> sfp3{.code = "SFP3", .address = 7363, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Switching frequency at fault 3 back"};
inline constexpr reg<hertz> sfp4{.code = "SFP4", .address = 7364, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "Switching frequency at fault 4 back"};
inline constexpr reg<input_assignment> jog{.code = "JOG", .address = 11110, .mode = access::configuration, .factory = 0, .name = "Input for jogging"};
inline constexpr reg<decihertz> jgf{.code = "JGF", .address = 11111, .min = {0}, .max = {100}, .factory = 50, .name = "Jog frequency"};
inline constexpr reg<decihertz> jpf{.code = "JPF", .address = 11301, .min = {0}, .max = {4000}, .factory = 0, .name = "Skip frequency"};
inline constexpr reg<input_assignment> ps2{.code = "PS2", .address = 11401, .mode = access::configuration, .name = "Input for 2 preset speeds"};
inline constexpr reg<input_assignment> ps4{.code = "PS4", .address = 11402, .mode = access::configuration, .name = "Input for 4 preset speeds"};
inline constexpr reg<input_assignment> ps8{.code = "PS8", .address = 11403, .mode = access::configuration, .factory = 0, .name = "Input for 8 preset speeds"};
inline constexpr reg<decihertz> sp2{.code = "SP2", .address = 11410, .min = {0}, .max = {4000}, .factory = 100, .name = "Preset speed 2"};
inline constexpr reg<decihertz> sp3{.code = "SP3", .address = 11411, .min = {0}, .max = {4000}, .name = "Preset speed 3"};
inline constexpr reg<decihertz> sp4{.code = "SP4", .address = 11412, .min = {0}, .max = {4000}, .name = "Preset speed 4"};
inline constexpr reg<decihertz> sp5{.code = "SP5", .address = 11413, .min = {0}, .max = {4000}, .factory = 250, .name = "Preset speed 5"};
inline constexpr reg<decihertz> sp6{.code = "SP6", .address = 11414, .min = {0}, .max = {4000}, .factory = 300, .name = "Preset speed 6"};
inline constexpr reg<decihertz> sp7{.code = "SP7", .address = 11415, .min = {0}, .max = {4000}, .factory = 350, .name = "Preset speed 7"};
inline constexpr reg<decihertz> sp8{.code = "SP8", .address = 11416, .min = {0}, .max = {4000}, .factory = 400, .name = "Preset speed 8"};
inline constexpr reg<deciseconds> tls{.code = "TLS", .address = 11701, .min = {0}, .max = {9999}, .factory = 0, .name = "Longest time at low speed"};
inline constexpr reg<decihertz> sle{.code = "SLE", .address = 11702, .min = {0}, .max = {4000}, .factory = 10, .name = "Restart margin above low speed"};
inline constexpr reg<input_assignment> sh2{.code = "SH2", .address = 15101, .mode = access::configuration, .factory = 0, .name = "Input for 2 high speeds"};
inline constexpr reg<input_assignment> sh4{.code = "SH4", .address = 15102, .mode = access::configuration, .factory = 0, .name = "Input for 4 high speeds"};
inline constexpr reg<decihertz> hsu{.code = "HSU", .address = 15109, .mode = access::read_only, .min = {0}, .max = {4000}, .factory = 0, .name = "High speed in use"};
inline constexpr reg<decihertz> hsp2{.code = "HSP2", .address = 15110, .min = {0}, .max = {4000}, .name = "High speed 2"};
inline constexpr reg<decihertz> hsp3{.code = "HSP3", .address = 15111, .min = {0}, .max = {4000}, .name = "High speed 3"};
inline constexpr reg<decihertz> hsp4{.code = "HSP4", .address = 15112, .min = {0}, .max = {4000}, .name = "High speed 4"};
inline constexpr reg<ramp_adaptation> bra{.code = "BRA", .address = 9003, .mode = access::configuration, .factory = 1, .name = "Deceleration ramp adaptation"};
inline constexpr reg<ramp_shape> rpt{.code = "RPT", .address = 9004, .factory = 0, .name = "Ramp shape"};
inline constexpr reg<input_assignment> rps{.code = "RPS", .address = 9010, .mode = access::configuration, .factory = 0, .name = "Input that selects the second ramp"};
inline constexpr reg<auto_injection> adc{.code = "ADC", .address = 10401, .factory = 1, .name = "Automatic DC injection"};
inline constexpr reg<deciseconds> tdc1{.code = "TDC1", .address = 10402, .min = {1}, .max = {300}, .factory = 5, .name = "Automatic DC injection: first time"};
inline constexpr reg<deciamperes> sdc1{.code = "SDC1", .address = 10403, .min = {0}, .max = {65535}, .name = "Automatic DC injection: first current"};
inline constexpr reg<input_assignment> nst{.code = "NST", .address = 11202, .mode = access::configuration, .factory = 0, .name = "Input for freewheel stop"};
inline constexpr reg<input_assignment> fst{.code = "FST", .address = 11204, .mode = access::configuration, .factory = 0, .name = "Input for fast stop"};
inline constexpr reg<count16> dcf{.code = "DCF", .address = 11230, .min = {1}, .max = {10}, .factory = 4, .name = "Fast stop: ramp divider"};
inline constexpr reg<signal_source> pif{.code = "PIF", .address = 11901, .mode = access::configuration, .name = "PI feedback source"};
inline constexpr reg<count16_tenths> fbs{.code = "FBS", .address = 11903, .min = {1}, .max = {1000}, .factory = 10, .name = "PI feedback scale factor"};
inline constexpr reg<no_yes> pii{.code = "PII", .address = 11908, .mode = access::configuration, .factory = 0, .name = "PI reference is internal"};
inline constexpr reg<input_assignment> pr2{.code = "PR2", .address = 11909, .mode = access::configuration, .factory = 0, .name = "Input for 2 preset PI references"};
inline constexpr reg<input_assignment> pr4{.code = "PR4", .address = 11910, .mode = access::configuration, .factory = 0, .name = "Input for 4 preset PI references"};
inline constexpr reg<tenth_percent> rpl{.code = "RPL", .address = 11911, .min = {0}, .max = {1000}, .factory = 0, .name = "PI reference lower limit"};
inline constexpr reg<tenth_percent> rph{.code = "RPH", .address = 11912, .min = {0}, .max = {1000}, .factory = 1000, .name = "PI reference upper limit"};
inline constexpr reg<tenth_percent> rpi{.code = "RPI", .address = 11920, .min = {0}, .max = {1000}, .factory = 0, .name = "PI internal reference"};
inline constexpr reg<tenth_percent> rp2{.code = "RP2", .address = 11921, .min = {0}, .max = {1000}, .factory = 250, .name = "Preset PI reference 2"};
inline constexpr reg<tenth_percent> rp3{.code = "RP3", .address = 11922, .min = {0}, .max = {1000}, .factory = 500, .name = "Preset PI reference 3"};
inline constexpr reg<tenth_percent> rp4{.code = "RP4", .address = 11923, .min = {0}, .max = {1000}, .factory = 750, .name = "Preset PI reference 4"};
inline constexpr reg<no_yes> pic{.code = "PIC", .address = 11940, .mode = access::configuration, .factory = 0, .name = "PI correction reversed"};
inline constexpr reg<count16_hundredths> rpg{.code = "RPG", .address = 11941, .min = {1}, .max = {10000}, .factory = 100, .name = "PI proportional gain"};
inline constexpr reg<count16_hundredths> rig{.code = "RIG", .address = 11942, .min = {1}, .max = {10000}, .factory = 100, .name = "PI integral gain"};
inline constexpr reg<count16_hundredths> rdg{.code = "RDG", .address = 11943, .min = {0}, .max = {10000}, .factory = 0, .name = "PID derivative gain"};
inline constexpr reg<signal_source> pim{.code = "PIM", .address = 11954, .mode = access::configuration, .factory = 0, .name = "Reference in manual mode"};
inline constexpr reg<decihertz> sfs{.code = "SFS", .address = 11955, .mode = access::configuration, .min = {0}, .max = {4000}, .factory = 0, .name = "PI speed at start"};
inline constexpr reg<tenth_percent> rsl{.code = "RSL", .address = 11960, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 0, .name = "PI error that wakes the drive"};
inline constexpr reg<tenth_percent> upp{.code = "UPP", .address = 11964, .min = {0}, .max = {1000}, .factory = 0, .name = "PI wake-up level"};
inline constexpr reg<signed_tenth_percent> lpi{.code = "LPI", .address = 11965, .min = {-1}, .max = {1000}, .factory = -1, .name = "PI feedback supervision threshold"};
inline constexpr reg<seconds> tpi{.code = "TPI", .address = 11966, .min = {0}, .max = {600}, .factory = 0, .name = "PI feedback supervision delay"};
inline constexpr reg<fault_reaction> mpi{.code = "MPI", .address = 11967, .mode = access::configuration, .factory = 1, .name = "Reaction to PI feedback supervision"};
inline constexpr reg<input_assignment> pau{.code = "PAU", .address = 11970, .mode = access::configuration, .name = "Input that selects automatic or manual"};
inline constexpr reg<signed_tenth_percent> rpe{.code = "RPE", .address = 11980, .mode = access::read_only, .min = {-32767}, .max = {32767}, .factory = 0, .name = "PI error"};
inline constexpr reg<tenth_percent> rpf{.code = "RPF", .address = 11981, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "PI feedback"};
inline constexpr reg<tenth_percent> rpc{.code = "RPC", .address = 11982, .mode = access::read_only, .min = {0}, .max = {65535}, .factory = 0, .name = "PI reference"};
inline constexpr reg<deciseconds> prp{.code = "PRP", .address = 11984, .min = {0}, .max = {999}, .factory = 0, .name = "PI reference ramp time"};
inline constexpr reg<minutes> nfd{.code = "NFD", .address = 11990, .mode = access::configuration, .min = {0}, .max = {20}, .factory = 0, .name = "Zero flow detection interval"};
inline constexpr reg<decihertz> ffd{.code = "FFD", .address = 11991, .min = {0}, .max = {4000}, .factory = 0, .name = "Zero flow detection threshold"};
inline constexpr reg<decihertz> lfd{.code = "LFD", .address = 11992, .min = {0}, .max = {4000}, .factory = 0, .name = "Zero flow detection offset"};
inline constexpr reg<no_yes> mde{.code = "MDE", .address = 15201, .mode = access::configuration, .factory = 0, .name = "Pump mode"};
inline constexpr reg<decihertz> fon{.code = "FON", .address = 15202, .min = {0}, .max = {4000}, .name = "Auxiliary pump start frequency"};
inline constexpr reg<decihertz> fof{.code = "FOF", .address = 15203, .min = {0}, .max = {4000}, .factory = 0, .name = "Auxiliary pump stop frequency"};
inline constexpr reg<deciseconds> ton{.code = "TON", .address = 15204, .min = {0}, .max = {9999}, .factory = 20, .name = "Auxiliary pump start delay"};
inline constexpr reg<deciseconds> tof{.code = "TOF", .address = 15205, .min = {0}, .max = {9999}, .factory = 20, .name = "Auxiliary pump stop delay"};
inline constexpr reg<deciseconds> ron{.code = "RON", .address = 15206, .min = {0}, .max = {9999}, .factory = 20, .name = "Auxiliary pump start ramp"};
inline constexpr reg<deciseconds> rof{.code = "ROF", .address = 15207, .min = {0}, .max = {9999}, .factory = 20, .name = "Auxiliary pump stop ramp"};
inline constexpr reg<deciamperes> cli{.code = "CLI", .address = 9201, .min = {0}, .max = {65535}, .name = "Current limit"};
inline constexpr reg<signed_count16> ai1c{.code = "AI1C", .address = 5242, .mode = access::read_only, .name = "AI1, physical value", .source = provenance::doubtful};
inline constexpr reg<signed_count16> ao1c{.code = "AO1C", .address = 5271, .mode = access::read_only, .name = "AO1, physical value", .source = provenance::doubtful};
// clang-format on

} // namespace altivar::atv12

namespace altivar::atv12::groups {

/// What the drive shows.
struct monitoring
    : parameter_list<eta, rfr, frh, lcr, eti, uln, thd, opr, rthi, pth, tac, pet, fth, hmis, tac2, crc, ccc, thr> {};

/// Words that command the drive, and its speed mode.
struct control : parameter_list<rpr, cmd, lfr, pisp, cmi, cmdd, lfrd, etad, rfrd> {};

/// Where commands and references come from.
struct command : parameter_list<rin, chcf, fr1, cd1, flo, floc, tcc, tct, rrs, pst> {};

/// Everyday settings.
struct settings : parameter_list<hsp, lsp, acc, dec, ith, ctd, ftd> {};

/// The motor and its control.
struct motor_control : parameter_list<bfr, sft, sfr, tfr, nrd, sfc, uns, frs, ncr, nsp, cos, ctt, tun, npr, stun, flg,
                                      sta, ufr, pfl, slp, spgu, rsm, rsmi> {};

/// Analog inputs and outputs.
struct analog_io : parameter_list<ai1t, crl1, crh1, ao1t, ao1, ai1i, ai1r, ao1r, aiv1> {};

/// Logic inputs and outputs, and relays.
struct logic_io : parameter_list<npl, r1s, lo1s, r1, lo1, il1i, ol1r> {};

/// Lines and networks.
struct communication : parameter_list<add, tbr, tfo, tto> {};

/// The scanner: words that one request moves.
struct scanner
    : parameter_list<nma1, nma2, nma3, nma4, nca1, nca2, nca3, nca4, nm1, nm2, nm3, nm4, nc1, nc2, nc3, nc4> {};

/// Reactions to faults.
struct faults : parameter_list<epl, sll, lfl1, lff, lft, inh, cic, etf, mtm> {};

/// Load monitoring.
struct process_monitoring : parameter_list<ult, ftu, lul, tol, fto, loc> {};

/// What drive this is.
struct identification : parameter_list<ncv, vcal, inv, spn, vdp> {};

/// Saving and recalling configurations.
struct configuration : parameter_list<cfg, scs, fcs> {};

/// States at past faults.
struct history_state : parameter_list<dp0, dp1, dp2, dp3, dp4, ep0, ep1, ep2, ep3, ep4> {};

/// Measurements at past faults.
struct history_values
    : parameter_list<lcp1, lcp2, lcp3, lcp4, rfp1, rfp2, rfp3, rfp4, rtp1, rtp2, rtp3, rtp4, ulp1, ulp2, ulp3, ulp4,
                     otp1, otp2, otp3, otp4, tdp1, tdp2, tdp3, tdp4, tjp1, tjp2, tjp3, tjp4, sfp1, sfp2, sfp3, sfp4> {};

/// Preset speeds, jogging and other references.
struct functions_speed : parameter_list<jog, jgf, jpf, ps2, ps4, ps8, sp2, sp3, sp4, sp5, sp6, sp7, sp8, tls, sle, sh2,
                                        sh4, hsu, hsp2, hsp3, hsp4> {};

/// Ramps.
struct functions_ramp : parameter_list<bra, rpt, rps, ac2, de2> {};

/// Stopping and DC injection.
struct functions_stop : parameter_list<adc, tdc1, sdc1, stt, nst, fst, dcf> {};

/// The PID regulator.
struct functions_pid : parameter_list<pif, fbs, pii, pr2, pr4, rpl, rph, rpi, rp2, rp3, rp4, pic, rpg, rig, rdg, pim,
                                      sfs, rsl, upp, lpi, tpi, mpi, pau, rpe, rpf, rpc, prp> {};

/// Pumps and fans.
struct functions_pump : parameter_list<nfd, ffd, lfd, mde, fon, fof, ton, tof, ron, rof> {};

/// Torque and current limits.
struct functions_limits : parameter_list<cli> {};

} // namespace altivar::atv12::groups

namespace altivar::atv12::unverified {

/// Analog inputs and outputs.
struct analog_io : parameter_list<ai1c, ao1c> {};

} // namespace altivar::atv12::unverified

namespace altivar::atv12 {

/// The parameters by group.
/// Internal.
inline constexpr parameter_group menu_groups[]{
    group_of<groups::monitoring>("monitoring"),
    group_of<groups::control>("control"),
    group_of<groups::command>("command"),
    group_of<groups::settings>("settings"),
    group_of<groups::motor_control>("motor_control"),
    group_of<groups::analog_io>("analog_io"),
    group_of<groups::logic_io>("logic_io"),
    group_of<groups::communication>("communication"),
    group_of<groups::scanner>("scanner"),
    group_of<groups::faults>("faults"),
    group_of<groups::process_monitoring>("process_monitoring"),
    group_of<groups::identification>("identification"),
    group_of<groups::configuration>("configuration"),
    group_of<groups::history_state>("history_state"),
    group_of<groups::history_values>("history_values"),
    group_of<groups::functions_speed>("functions_speed"),
    group_of<groups::functions_ramp>("functions_ramp"),
    group_of<groups::functions_stop>("functions_stop"),
    group_of<groups::functions_pid>("functions_pid"),
    group_of<groups::functions_pump>("functions_pump"),
    group_of<groups::functions_limits>("functions_limits"),
};

/// All parameters that can be used, as rows to walk.
inline constexpr parameter_map parameters{menu_groups, "ATV12"};

/// Internal.
inline constexpr parameter_group unverified_groups[]{
    group_of<unverified::analog_io>("analog_io"),
};

/// Registers that are known to exist, and little more: read-only, doubtful.
inline constexpr parameter_map unverified_parameters{unverified_groups, "ATV12"};

/// An ATV12 with every register of this map for typed access: `station<full_device>`.
struct full_device : device {
    using registers =
        grouped_table<groups::monitoring, groups::control, groups::command, groups::settings, groups::motor_control,
                      groups::analog_io, groups::logic_io, groups::communication, groups::scanner, groups::faults,
                      groups::process_monitoring, groups::identification, groups::configuration, groups::history_state,
                      groups::history_values, groups::functions_speed, groups::functions_ramp, groups::functions_stop,
                      groups::functions_pid, groups::functions_pump, groups::functions_limits, unverified::analog_io>;
};

} // namespace altivar::atv12
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
