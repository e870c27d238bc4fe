// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: preset speeds, jogging and other references.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
#include <rtuwire/altivar/parameters/atv320/values/drive.hpp>
#include <rtuwire/altivar/parameters/atv320/values/functions.hpp>
#include <rtuwire/altivar/parameters/atv320/values/known.hpp>
#include <rtuwire/altivar/parameters/family_words.hpp>
#include <rtuwire/altivar/parameters/parameter_list.hpp>
#include <rtuwire/altivar/parameters/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv320 {

// clang-format off
inline constexpr reg<logic_input> spm{.code = "SPM", .address = 8491, .mode = access::configuration, .factory = 0, .name = "Input that stores the reference", .source = provenance::inferred};
inline constexpr reg<logic_input> jog{.code = "JOG", .address = 11110, .mode = access::configuration, .name = "Input for jogging", .source = provenance::inferred};
inline constexpr reg<decihertz> jgf{.code = "JGF", .address = 11111, .min = {0}, .max = {100}, .factory = 100, .name = "Jog frequency", .source = provenance::inferred};
inline constexpr reg<deciseconds> jgt{.code = "JGT", .address = 11112, .min = {0}, .max = {20}, .factory = 5, .name = "Delay between two jogs", .source = provenance::inferred};
inline constexpr reg<decihertz> jpf{.code = "JPF", .address = 11301, .min = {0}, .max = {5990}, .factory = 0, .name = "Skip frequency", .source = provenance::inferred};
inline constexpr reg<decihertz> jf2{.code = "JF2", .address = 11302, .min = {0}, .max = {5990}, .factory = 0, .name = "Skip frequency 2", .source = provenance::inferred};
inline constexpr reg<decihertz> jf3{.code = "JF3", .address = 11303, .min = {0}, .max = {5990}, .factory = 0, .name = "Skip frequency 3", .source = provenance::inferred};
inline constexpr reg<decihertz> jfh{.code = "JFH", .address = 11311, .min = {1}, .max = {100}, .factory = 10, .name = "Width of the skip frequency bands", .source = provenance::inferred};
inline constexpr reg<logic_input> ps2{.code = "PS2", .address = 11401, .mode = access::configuration, .name = "Input for 2 preset speeds", .source = provenance::inferred};
inline constexpr reg<logic_input> ps4{.code = "PS4", .address = 11402, .mode = access::configuration, .name = "Input for 4 preset speeds", .source = provenance::inferred};
inline constexpr reg<logic_input> ps8{.code = "PS8", .address = 11403, .mode = access::configuration, .name = "Input for 8 preset speeds", .source = provenance::inferred};
inline constexpr reg<logic_input> ps16{.code = "PS16", .address = 11404, .mode = access::configuration, .factory = 0, .name = "Input for 16 preset speeds", .source = provenance::inferred};
inline constexpr reg<decihertz> sp2{.code = "SP2", .address = 11410, .min = {0}, .max = {5990}, .factory = 100, .name = "Preset speed 2", .source = provenance::inferred};
inline constexpr reg<decihertz> sp3{.code = "SP3", .address = 11411, .min = {0}, .max = {5990}, .factory = 150, .name = "Preset speed 3", .source = provenance::inferred};
inline constexpr reg<decihertz> sp4{.code = "SP4", .address = 11412, .min = {0}, .max = {5990}, .factory = 200, .name = "Preset speed 4", .source = provenance::inferred};
inline constexpr reg<decihertz> sp5{.code = "SP5", .address = 11413, .min = {0}, .max = {5990}, .factory = 250, .name = "Preset speed 5", .source = provenance::inferred};
inline constexpr reg<decihertz> sp6{.code = "SP6", .address = 11414, .min = {0}, .max = {5990}, .factory = 300, .name = "Preset speed 6", .source = provenance::inferred};
inline constexpr reg<decihertz> sp7{.code = "SP7", .address = 11415, .min = {0}, .max = {5990}, .factory = 350, .name = "Preset speed 7", .source = provenance::inferred};
inline constexpr reg<decihertz> sp8{.code = "SP8", .address = 11416, .min = {0}, .max = {5990}, .factory = 400, .name = "Preset speed 8", .source = provenance::inferred};
inline constexpr reg<decihertz> sp9{.code = "SP9", .address = 11417, .min = {0}, .max = {5990}, .factory = 450, .name = "Preset speed 9", .source = provenance::inferred};
inline constexpr reg<decihertz> sp10{.code = "SP10", .address = 11418, .min = {0}, .max = {5990}, .factory = 500, .name = "Preset speed 10", .source = provenance::inferred};
inline constexpr reg<decihertz> sp11{.code = "SP11", .address = 11419, .min = {0}, .max = {5990}, .factory = 550, .name = "Preset speed 11", .source = provenance::inferred};
inline constexpr reg<decihertz> sp12{.code = "SP12", .address = 11420, .min = {0}, .max = {5990}, .factory = 600, .name = "Preset speed 12", .source = provenance::inferred};
inline constexpr reg<decihertz> sp13{.code = "SP13", .address = 11421, .min = {0}, .max = {5990}, .factory = 700, .name = "Preset speed 13", .source = provenance::inferred};
inline constexpr reg<decihertz> sp14{.code = "SP14", .address = 11422, .min = {0}, .max = {5990}, .factory = 800, .name = "Preset speed 14", .source = provenance::inferred};
inline constexpr reg<decihertz> sp15{.code = "SP15", .address = 11423, .min = {0}, .max = {5990}, .factory = 900, .name = "Preset speed 15", .source = provenance::inferred};
inline constexpr reg<decihertz> sp16{.code = "SP16", .address = 11424, .min = {0}, .max = {5990}, .factory = 1000, .name = "Preset speed 16", .source = provenance::inferred};
inline constexpr reg<logic_input> usp{.code = "USP", .address = 11501, .mode = access::configuration, .factory = 0, .name = "Input for faster", .source = provenance::inferred};
inline constexpr reg<logic_input> dsp{.code = "DSP", .address = 11502, .mode = access::configuration, .factory = 0, .name = "Input for slower", .source = provenance::inferred};
inline constexpr reg<speed_memory> str{.code = "STR", .address = 11503, .mode = access::configuration, .factory = 0, .name = "Where the +/- speed reference is stored", .source = provenance::inferred};
inline constexpr reg<percent> srp{.code = "SRP", .address = 11505, .min = {0}, .max = {50}, .factory = 10, .name = "+/- speed range around the reference", .source = provenance::inferred};
inline constexpr reg<logic_input> usi{.code = "USI", .address = 11520, .mode = access::configuration, .factory = 0, .name = "Input for faster, around the reference", .source = provenance::inferred};
inline constexpr reg<logic_input> dsi{.code = "DSI", .address = 11521, .mode = access::configuration, .factory = 0, .name = "Input for slower, around the reference", .source = provenance::inferred};
inline constexpr reg<deciseconds> tls{.code = "TLS", .address = 11701, .min = {0}, .max = {9999}, .factory = 0, .name = "Longest time at low speed", .source = provenance::inferred};
inline constexpr reg<signal_source> sa2{.code = "SA2", .address = 11801, .mode = access::configuration, .name = "Summing input 2", .source = provenance::inferred};
inline constexpr reg<signal_source> sa3{.code = "SA3", .address = 11802, .mode = access::configuration, .factory = 0, .name = "Summing input 3", .source = provenance::inferred};
inline constexpr reg<signal_source> da2{.code = "DA2", .address = 11811, .mode = access::configuration, .factory = 0, .name = "Subtracted reference 2", .source = provenance::inferred};
inline constexpr reg<signal_source> da3{.code = "DA3", .address = 11812, .mode = access::configuration, .factory = 0, .name = "Subtracted reference 3", .source = provenance::inferred};
inline constexpr reg<signal_source> ma2{.code = "MA2", .address = 11821, .mode = access::configuration, .factory = 0, .name = "Multiplier 2 of the reference", .source = provenance::inferred};
inline constexpr reg<signal_source> ma3{.code = "MA3", .address = 11822, .mode = access::configuration, .factory = 0, .name = "Multiplier 3 of the reference", .source = provenance::inferred};
inline constexpr reg<percent> mfr{.code = "MFR", .address = 11831, .min = {0}, .max = {100}, .name = "Gain of the multiplied reference", .source = provenance::inferred};
inline constexpr reg<logic_input> sh2{.code = "SH2", .address = 15101, .mode = access::configuration, .factory = 0, .name = "Input for 2 high speeds", .source = provenance::inferred};
inline constexpr reg<logic_input> sh4{.code = "SH4", .address = 15102, .mode = access::configuration, .factory = 0, .name = "Input for 4 high speeds", .source = provenance::inferred};
inline constexpr reg<decihertz> hsp2{.code = "HSP2", .address = 15110, .min = {0}, .max = {5990}, .name = "High speed 2", .source = provenance::inferred};
inline constexpr reg<decihertz> hsp3{.code = "HSP3", .address = 15111, .min = {0}, .max = {5990}, .name = "High speed 3", .source = provenance::inferred};
inline constexpr reg<decihertz> hsp4{.code = "HSP4", .address = 15112, .min = {0}, .max = {5990}, .name = "High speed 4", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Preset speeds, jogging and other references.
struct functions_speed
    : parameter_list<spm, jog, jgf, jgt, jpf, jf2, jf3, jfh, ps2, ps4, ps8, ps16, sp2, sp3, sp4, sp5, sp6, sp7, sp8,
                     sp9, sp10, sp11, sp12, sp13, sp14, sp15, sp16, usp, dsp, str, srp, usi, dsi, tls, sa2, sa3, da2,
                     da3, ma2, ma3, mfr, sh2, sh4, hsp2, hsp3, hsp4> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
