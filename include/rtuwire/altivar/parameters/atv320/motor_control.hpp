// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: the motor and its control.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
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
inline constexpr reg<motor_standard> bfr{.code = "BFR", .address = 3015, .mode = access::configuration, .factory = 0, .name = "Standard motor frequency", .source = provenance::inferred};
inline constexpr reg<switching_mode> sft{.code = "SFT", .address = 3101, .mode = access::configuration, .factory = 1, .name = "Switching frequency mode", .source = provenance::inferred};
inline constexpr reg<reference_shape> bsp{.code = "BSP", .address = 3106, .factory = 0, .name = "Shape of the reference near low speed", .source = provenance::inferred};
inline constexpr reg<no_yes> nrd{.code = "NRD", .address = 3107, .mode = access::configuration, .factory = 0, .name = "Motor noise reduction", .source = provenance::inferred};
inline constexpr reg<percent> spg{.code = "SPG", .address = 9103, .min = {0}, .max = {1000}, .factory = 40, .name = "Speed loop proportional gain", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> sit{.code = "SIT", .address = 9104, .min = {1}, .max = {65535}, .factory = 63, .name = "Speed loop integral time", .source = provenance::inferred};
inline constexpr reg<count16> sfc{.code = "SFC", .address = 9105, .min = {0}, .max = {100}, .factory = 65, .name = "Speed loop filter", .source = provenance::inferred};
inline constexpr reg<tenth_milliseconds> ffh{.code = "FFH", .address = 9115, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 64, .name = "Filter of the speed estimate", .source = provenance::inferred};
inline constexpr reg<tenth_milliseconds> crtf{.code = "CRTF", .address = 9116, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 32, .name = "Filter of the current references", .source = provenance::inferred};
inline constexpr reg<motor_control_law> ctt{.code = "CTT", .address = 9607, .mode = access::configuration, .name = "Motor control law", .source = provenance::inferred};
inline constexpr reg<tuning_order> tun{.code = "TUN", .address = 9608, .factory = 0, .name = "Autotune", .source = provenance::inferred};
inline constexpr reg<tuning_state> tus{.code = "TUS", .address = 9609, .mode = access::read_only, .factory = 0, .name = "Autotune state", .source = provenance::inferred};
inline constexpr reg<logic_input> tul{.code = "TUL", .address = 9610, .mode = access::configuration, .factory = 0, .name = "Input that starts autotune", .source = provenance::inferred};
inline constexpr reg<automatic_tuning> aut{.code = "AUT", .address = 9615, .factory = 0, .name = "Automatic autotune", .source = provenance::inferred};
inline constexpr reg<motor_model> stun{.code = "STUN", .address = 9617, .mode = access::read_only, .factory = 0, .name = "Motor model data in use", .source = provenance::inferred};
inline constexpr reg<count16> ppn{.code = "PPN", .address = 9618, .mode = access::configuration, .min = {1}, .max = {100}, .name = "Pole pairs, calculated", .source = provenance::inferred};
inline constexpr reg<tuning_temperature> tunu{.code = "TUNU", .address = 9619, .mode = access::configuration, .factory = 1, .name = "How tuning follows the temperature", .source = provenance::inferred};
inline constexpr reg<percent> ufr{.code = "UFR", .address = 9623, .min = {0}, .max = {200}, .factory = 100, .name = "IR compensation", .source = provenance::inferred};
inline constexpr reg<percent> slp{.code = "SLP", .address = 9625, .min = {0}, .max = {300}, .name = "Slip compensation", .source = provenance::inferred};
inline constexpr reg<percent> spgu{.code = "SPGU", .address = 9629, .min = {0}, .max = {1000}, .factory = 40, .name = "Inertia compensation of the V/f laws", .source = provenance::inferred};
inline constexpr reg<milliohms> rsa{.code = "RSA", .address = 9642, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Stator resistance, user value", .source = provenance::inferred};
inline constexpr reg<saliency> smot{.code = "SMOT", .address = 9645, .mode = access::read_only, .name = "Motor saliency found by tuning", .source = provenance::inferred};
inline constexpr reg<deciamperes> ida{.code = "IDA", .address = 9652, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Magnetising current, user value", .source = provenance::inferred};
inline constexpr reg<hundredth_millihenries> lfa{.code = "LFA", .address = 9662, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Leakage inductance, user value", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> tra{.code = "TRA", .address = 9667, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Rotor time constant, user value", .source = provenance::inferred};
inline constexpr reg<rpm> nsps{.code = "NSPS", .address = 9671, .mode = access::configuration, .min = {0}, .max = {65535}, .name = "Rated speed, synchronous motor", .source = provenance::inferred};
inline constexpr reg<count16> ppns{.code = "PPNS", .address = 9672, .mode = access::configuration, .min = {1}, .max = {50}, .name = "Pole pairs, synchronous motor", .source = provenance::inferred};
inline constexpr reg<tenth_millivolts_per_rpm> phs{.code = "PHS", .address = 9673, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "EMF constant, synchronous motor", .source = provenance::inferred};
inline constexpr reg<hundredth_millihenries> lds{.code = "LDS", .address = 9674, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "d-axis inductance, synchronous motor", .source = provenance::inferred};
inline constexpr reg<hundredth_millihenries> lqs{.code = "LQS", .address = 9675, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "q-axis inductance, synchronous motor", .source = provenance::inferred};
inline constexpr reg<decihertz> frss{.code = "FRSS", .address = 9679, .mode = access::read_only, .min = {100}, .max = {8000}, .name = "Rated frequency, synchronous motor", .source = provenance::inferred};
inline constexpr reg<milliohms> rsas{.code = "RSAS", .address = 9682, .mode = access::configuration, .min = {0}, .max = {65535}, .factory = 0, .name = "Stator resistance, synchronous motor, user value", .source = provenance::inferred};
inline constexpr reg<decinewton_metres> tqs{.code = "TQS", .address = 9684, .mode = access::configuration, .min = {1}, .max = {65535}, .name = "Rated motor torque", .source = provenance::inferred};
inline constexpr reg<volts> u1{.code = "U1", .address = 12403, .mode = access::configuration, .min = {0}, .max = {800}, .factory = 0, .name = "V/f point 1: voltage", .source = provenance::inferred};
inline constexpr reg<decihertz> f1{.code = "F1", .address = 12404, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "V/f point 1: frequency", .source = provenance::inferred};
inline constexpr reg<volts> u2{.code = "U2", .address = 12405, .mode = access::configuration, .min = {0}, .max = {800}, .factory = 0, .name = "V/f point 2: voltage", .source = provenance::inferred};
inline constexpr reg<decihertz> f2{.code = "F2", .address = 12406, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "V/f point 2: frequency", .source = provenance::inferred};
inline constexpr reg<volts> u3{.code = "U3", .address = 12407, .mode = access::configuration, .min = {0}, .max = {800}, .factory = 0, .name = "V/f point 3: voltage", .source = provenance::inferred};
inline constexpr reg<decihertz> f3{.code = "F3", .address = 12408, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "V/f point 3: frequency", .source = provenance::inferred};
inline constexpr reg<volts> u4{.code = "U4", .address = 12409, .mode = access::configuration, .min = {0}, .max = {800}, .factory = 0, .name = "V/f point 4: voltage", .source = provenance::inferred};
inline constexpr reg<decihertz> f4{.code = "F4", .address = 12410, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "V/f point 4: frequency", .source = provenance::inferred};
inline constexpr reg<volts> u5{.code = "U5", .address = 12411, .mode = access::configuration, .min = {0}, .max = {800}, .factory = 0, .name = "V/f point 5: voltage", .source = provenance::inferred};
inline constexpr reg<decihertz> f5{.code = "F5", .address = 12412, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "V/f point 5: frequency", .source = provenance::inferred};
inline constexpr reg<no_yes> svl{.code = "SVL", .address = 12601, .mode = access::configuration, .factory = 0, .name = "Motor surge voltage limitation", .source = provenance::inferred};
inline constexpr reg<surge_time> sop{.code = "SOP", .address = 12602, .mode = access::configuration, .factory = 10, .name = "Motor surge attenuation time", .source = provenance::inferred};
inline constexpr reg<logic_input> fli{.code = "FLI", .address = 13901, .mode = access::configuration, .factory = 0, .name = "Input that starts fluxing", .source = provenance::inferred};
inline constexpr reg<fluxing> flu{.code = "FLU", .address = 13902, .factory = 2, .name = "When the motor is fluxed", .source = provenance::inferred};
inline constexpr reg<boost_mode> boa{.code = "BOA", .address = 13910, .mode = access::configuration, .factory = 1, .name = "Voltage boost mode", .source = provenance::inferred};
inline constexpr reg<angle_setting> ast{.code = "AST", .address = 13925, .mode = access::configuration, .factory = 6, .name = "How the rotor angle is found", .source = provenance::inferred};
inline constexpr reg<volts> vbr{.code = "VBR", .address = 14101, .min = {335}, .max = {820}, .name = "Brake chopper voltage", .source = provenance::inferred};
inline constexpr reg<no_yes> hfi{.code = "HFI", .address = 15600, .mode = access::configuration, .factory = 0, .name = "High-frequency injection", .source = provenance::inferred};
inline constexpr reg<percent> hir{.code = "HIR", .address = 15602, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 25, .name = "High-frequency injection: current", .source = provenance::inferred};
inline constexpr reg<hertz> spb{.code = "SPB", .address = 15603, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 25, .name = "High-frequency injection: PLL bandwidth", .source = provenance::inferred};
inline constexpr reg<percent> ilr{.code = "ILR", .address = 15605, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 50, .name = "High-frequency alignment: current", .source = provenance::inferred};
inline constexpr reg<percent> sir{.code = "SIR", .address = 15606, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 100, .name = "IPM alignment: boost", .source = provenance::inferred};
inline constexpr reg<percent> mcr{.code = "MCR", .address = 15607, .mode = access::configuration, .min = {0}, .max = {300}, .name = "PSI alignment: maximum current", .source = provenance::inferred};
inline constexpr reg<percent> pec{.code = "PEC", .address = 15608, .mode = access::configuration, .min = {0}, .max = {500}, .factory = 0, .name = "Rotor angle error compensation", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// The motor and its control.
struct motor_control
    : parameter_list<bfr, sft, sfr, tfr, bsp, nrd, spg, sit, sfc, ffh, crtf, uns, frs, ncr, nsp, cos, ctt, tun, tus,
                     tul, npr, aut, stun, ppn, tunu, ufr, slp, spgu, rsa, smot, ida, lfa, tra, nsps, ppns, phs, lds,
                     lqs, frss, rsas, tqs, u1, f1, u2, f2, u3, f3, u4, f4, u5, f5, svl, sop, fli, flu, boa, ast, vbr,
                     hfi, hir, spb, ilr, sir, mcr, pec> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
