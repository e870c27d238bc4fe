// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: logic inputs and outputs, and relays.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
#include <rtuwire/altivar/parameters/atv320/values/io.hpp>
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
inline constexpr reg<units::milliseconds> l1d{.code = "L1D", .address = 4001, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 0, .name = "LI1 switch-on delay", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> l2d{.code = "L2D", .address = 4002, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 0, .name = "LI2 switch-on delay", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> l3d{.code = "L3D", .address = 4003, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 0, .name = "LI3 switch-on delay", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> l4d{.code = "L4D", .address = 4004, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 0, .name = "LI4 switch-on delay", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> l5d{.code = "L5D", .address = 4005, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 0, .name = "LI5 switch-on delay", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> l6d{.code = "L6D", .address = 4006, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 0, .name = "LI6 switch-on delay", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> la1d{.code = "LA1D", .address = 4021, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 0, .name = "LA1 switch-on delay", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> la2d{.code = "LA2D", .address = 4022, .mode = access::configuration, .min = {0}, .max = {200}, .factory = 0, .name = "LA2 switch-on delay", .source = provenance::inferred};
inline constexpr reg<output_level> r1s{.code = "R1S", .address = 4201, .mode = access::configuration, .factory = 0, .name = "Relay R1 active level", .source = provenance::inferred};
inline constexpr reg<output_level> r2s{.code = "R2S", .address = 4202, .mode = access::configuration, .factory = 0, .name = "Relay R2 active level", .source = provenance::inferred};
inline constexpr reg<output_level> lo1s{.code = "LO1S", .address = 4209, .mode = access::configuration, .factory = 0, .name = "Output LO1 active level", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> r1h{.code = "R1H", .address = 4221, .mode = access::configuration, .min = {0}, .max = {9999}, .factory = 0, .name = "Relay R1 holding time", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> r2h{.code = "R2H", .address = 4222, .mode = access::configuration, .min = {0}, .max = {9999}, .factory = 0, .name = "Relay R2 holding time", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> lo1h{.code = "LO1H", .address = 4229, .mode = access::configuration, .min = {0}, .max = {9999}, .factory = 0, .name = "Output LO1 holding time", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> r1d{.code = "R1D", .address = 4241, .mode = access::configuration, .min = {0}, .max = {60000}, .factory = 0, .name = "Relay R1 delay", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> r2d{.code = "R2D", .address = 4242, .mode = access::configuration, .min = {0}, .max = {60000}, .factory = 0, .name = "Relay R2 delay", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> lo1d{.code = "LO1D", .address = 4249, .mode = access::configuration, .min = {0}, .max = {60000}, .factory = 0, .name = "Output LO1 delay", .source = provenance::inferred};
inline constexpr reg<output_level> do1s{.code = "DO1S", .address = 4261, .mode = access::configuration, .factory = 0, .name = "Output DO1 active level", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> do1h{.code = "DO1H", .address = 4271, .mode = access::configuration, .min = {0}, .max = {9999}, .factory = 0, .name = "Output DO1 holding time", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> do1d{.code = "DO1D", .address = 4281, .mode = access::configuration, .min = {0}, .max = {60000}, .factory = 0, .name = "Output DO1 delay", .source = provenance::inferred};
inline constexpr reg<logic_source> r1{.code = "R1", .address = 5001, .mode = access::configuration, .factory = 1, .name = "Relay R1 function", .source = provenance::inferred};
inline constexpr reg<logic_source> r2{.code = "R2", .address = 5002, .mode = access::configuration, .name = "Relay R2 function", .source = provenance::inferred};
inline constexpr reg<logic_source> lo1{.code = "LO1", .address = 5009, .mode = access::configuration, .factory = 0, .name = "Output LO1 function", .source = provenance::inferred};
inline constexpr reg<logic_source> do1{.code = "DO1", .address = 5031, .mode = access::configuration, .factory = 0, .name = "Output DO1 function", .source = provenance::inferred};
inline constexpr reg<output_image> ol1r{.code = "OL1R", .address = 5212, .name = "Logic outputs", .source = provenance::inferred};
inline constexpr reg<decahertz> pil{.code = "PIL", .address = 13302, .mode = access::configuration, .min = {0}, .max = {2000}, .factory = 0, .name = "Pulse input: minimum frequency", .source = provenance::inferred};
inline constexpr reg<decahertz> pfr{.code = "PFR", .address = 13303, .mode = access::configuration, .min = {0}, .max = {2000}, .factory = 2000, .name = "Pulse input: maximum frequency", .source = provenance::inferred};
inline constexpr reg<units::milliseconds> pfi{.code = "PFI", .address = 13304, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 0, .name = "Pulse input: filter", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Logic inputs and outputs, and relays.
struct logic_io : parameter_list<l1d, l2d, l3d, l4d, l5d, l6d, la1d, la2d, r1s, r2s, lo1s, r1h, r2h, lo1h, r1d, r2d,
                                 lo1d, do1s, do1h, do1d, r1, r2, lo1, do1, il1r, ol1r, pil, pfr, pfi> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
