// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: registers of which too little is known to write them: no access, no limits, or values that no public list
// explains. They are read-only here, and doubtful.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
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
inline constexpr reg<no_yes> aof1{.code = "AOF1", .address = 4293, .mode = access::read_only, .name = "AO1 fallback", .source = provenance::doubtful};
inline constexpr reg<signed_count16> ai1i{.code = "AI1I", .address = 5222, .mode = access::read_only, .name = "AI1 at the terminal, in steps", .source = provenance::doubtful};
inline constexpr reg<signed_count16> ai2i{.code = "AI2I", .address = 5223, .mode = access::read_only, .name = "AI2 at the terminal, in steps", .source = provenance::doubtful};
inline constexpr reg<signed_count16> ai3i{.code = "AI3I", .address = 5224, .mode = access::read_only, .name = "AI3 at the terminal, in steps", .source = provenance::doubtful};
inline constexpr reg<signed_count16> ai1r{.code = "AI1R", .address = 5232, .mode = access::read_only, .name = "AI1, standardised value", .source = provenance::doubtful};
inline constexpr reg<signed_count16> ai2r{.code = "AI2R", .address = 5233, .mode = access::read_only, .name = "AI2, standardised value", .source = provenance::doubtful};
inline constexpr reg<signed_count16> ai3r{.code = "AI3R", .address = 5234, .mode = access::read_only, .name = "AI3, standardised value", .source = provenance::doubtful};
inline constexpr reg<signed_millivolts> ai1c{.code = "AI1C", .address = 5242, .mode = access::read_only, .name = "AI1, physical value", .source = provenance::doubtful};
inline constexpr reg<signed_millivolts> ai2c{.code = "AI2C", .address = 5243, .mode = access::read_only, .name = "AI2, physical value", .source = provenance::doubtful};
inline constexpr reg<signed_microamperes> ai3c{.code = "AI3C", .address = 5244, .mode = access::read_only, .name = "AI3, physical value", .source = provenance::doubtful};
inline constexpr reg<signed_count16> ao1i{.code = "AO1I", .address = 5251, .mode = access::read_only, .name = "AO1 at the terminal, in steps", .source = provenance::doubtful};
inline constexpr reg<signed_count16> ao1r{.code = "AO1R", .address = 5261, .mode = access::read_only, .name = "AO1, standardised value", .source = provenance::doubtful};
inline constexpr reg<signed_count16> ao1c{.code = "AO1C", .address = 5271, .mode = access::read_only, .name = "AO1, physical value", .source = provenance::doubtful};
inline constexpr reg<signed_millivolts> sai1{.code = "SAI1", .address = 5291, .mode = access::read_only, .name = "AI1, physical value, unfiltered", .source = provenance::doubtful};
inline constexpr reg<signed_millivolts> sai2{.code = "SAI2", .address = 5292, .mode = access::read_only, .name = "AI2, physical value, unfiltered", .source = provenance::doubtful};
inline constexpr reg<signed_microamperes> sai3{.code = "SAI3", .address = 5293, .mode = access::read_only, .name = "AI3, physical value, unfiltered", .source = provenance::doubtful};
inline constexpr reg<signed_count16> sao1{.code = "SAO1", .address = 5295, .mode = access::read_only, .name = "AO1, physical value, unfiltered", .source = provenance::doubtful};
inline constexpr reg<no_yes> r1f{.code = "R1F", .address = 4290, .mode = access::read_only, .name = "Relay R1 fallback", .source = provenance::doubtful};
inline constexpr reg<no_yes> r2f{.code = "R2F", .address = 4291, .mode = access::read_only, .name = "Relay R2 fallback", .source = provenance::doubtful};
inline constexpr reg<no_yes> lo1f{.code = "LO1F", .address = 4292, .mode = access::read_only, .name = "Output LO1 fallback", .source = provenance::doubtful};
inline constexpr reg<count16> il1i{.code = "IL1I", .address = 5201, .mode = access::read_only, .name = "Logic inputs at the terminals", .source = provenance::doubtful};
inline constexpr reg<count16> pgi{.code = "PGI", .address = 5604, .mode = access::read_only, .name = "Encoder pulses per turn", .source = provenance::doubtful};
inline constexpr reg<encoder_use> enu{.code = "ENU", .address = 5606, .mode = access::read_only, .name = "Encoder use", .source = provenance::doubtful};
inline constexpr reg<encoder_signals> ens{.code = "ENS", .address = 5608, .mode = access::read_only, .name = "Encoder signals", .source = provenance::doubtful};
inline constexpr reg<count16> puc{.code = "PUC", .address = 5611, .mode = access::read_only, .name = "Encoder pulse count", .source = provenance::doubtful};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::unverified {

/// Analog inputs and outputs.
struct analog_io : parameter_list<aof1, ai1i, ai2i, ai3i, ai1r, ai2r, ai3r, ai1c, ai2c, ai3c, ao1i, ao1r, ao1c, sai1,
                                  sai2, sai3, sao1> {};

/// Logic inputs and outputs, and relays.
struct logic_io : parameter_list<r1f, r2f, lo1f, il1i, pgi, enu, ens, puc> {};

} // namespace altivar::atv320::unverified
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
