// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: stopping and DC injection.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
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
inline constexpr reg<auto_injection> adc{.code = "ADC", .address = 10401, .name = "Automatic DC injection", .source = provenance::inferred};
inline constexpr reg<deciseconds> tdc1{.code = "TDC1", .address = 10402, .min = {1}, .max = {300}, .factory = 5, .name = "Automatic DC injection: first time", .source = provenance::inferred};
inline constexpr reg<deciseconds> tdc2{.code = "TDC2", .address = 10404, .min = {0}, .max = {300}, .factory = 0, .name = "Automatic DC injection: second time", .source = provenance::inferred};
inline constexpr reg<logic_input> nst{.code = "NST", .address = 11202, .mode = access::configuration, .factory = 0, .name = "Input for freewheel stop", .source = provenance::inferred};
inline constexpr reg<logic_input> dci{.code = "DCI", .address = 11203, .mode = access::configuration, .factory = 0, .name = "Input for DC injection", .source = provenance::inferred};
inline constexpr reg<logic_input> fst{.code = "FST", .address = 11204, .mode = access::configuration, .factory = 0, .name = "Input for fast stop", .source = provenance::inferred};
inline constexpr reg<deciseconds> tdc{.code = "TDC", .address = 11211, .min = {1}, .max = {300}, .factory = 5, .name = "DC injection: time of the second current", .source = provenance::inferred};
inline constexpr reg<deciseconds> tdi{.code = "TDI", .address = 11213, .min = {1}, .max = {300}, .factory = 5, .name = "DC injection: time of the first current", .source = provenance::inferred};
inline constexpr reg<decihertz> fft{.code = "FFT", .address = 11220, .min = {2}, .max = {5990}, .name = "Frequency below which the motor freewheels", .source = provenance::inferred};
inline constexpr reg<count16> dcf{.code = "DCF", .address = 11230, .min = {0}, .max = {10}, .factory = 4, .name = "Fast stop: ramp divider", .source = provenance::inferred};
inline constexpr reg<logic_input> saf{.code = "SAF", .address = 12501, .mode = access::configuration, .factory = 0, .name = "Input of the forward stop switch", .source = provenance::inferred};
inline constexpr reg<logic_input> sar{.code = "SAR", .address = 12502, .mode = access::configuration, .factory = 0, .name = "Input of the reverse stop switch", .source = provenance::inferred};
inline constexpr reg<logic_input> daf{.code = "DAF", .address = 12503, .mode = access::configuration, .factory = 0, .name = "Input of the forward slowdown switch", .source = provenance::inferred};
inline constexpr reg<logic_input> dar{.code = "DAR", .address = 12504, .mode = access::configuration, .factory = 0, .name = "Input of the reverse slowdown switch", .source = provenance::inferred};
inline constexpr reg<slowdown_type> dsf{.code = "DSF", .address = 12505, .mode = access::configuration, .factory = 0, .name = "Deceleration after a slowdown switch", .source = provenance::inferred};
inline constexpr reg<stop_mode> pas{.code = "PAS", .address = 12506, .mode = access::configuration, .factory = 0, .name = "How a limit switch stops", .source = provenance::inferred};
inline constexpr reg<logic_input> cls{.code = "CLS", .address = 12507, .mode = access::configuration, .factory = 0, .name = "Input that disables the limit switches", .source = provenance::inferred};
inline constexpr reg<input_level> sal{.code = "SAL", .address = 12508, .mode = access::configuration, .factory = 0, .name = "Active level of the stop switches", .source = provenance::inferred};
inline constexpr reg<input_level> dal{.code = "DAL", .address = 12509, .mode = access::configuration, .factory = 0, .name = "Active level of the slowdown switches", .source = provenance::inferred};
inline constexpr reg<centimetres_per_second> nls{.code = "NLS", .address = 12511, .mode = access::configuration, .min = {20}, .max = {500}, .factory = 100, .name = "Rated linear speed", .source = provenance::inferred};
inline constexpr reg<centimetres> std{.code = "STD", .address = 12521, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 0, .name = "Stop distance", .source = provenance::inferred};
inline constexpr reg<percent> sfd{.code = "SFD", .address = 12522, .mode = access::configuration, .min = {50}, .max = {200}, .factory = 100, .name = "Stop distance correction", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Stopping and DC injection.
struct functions_stop : parameter_list<adc, tdc1, tdc2, stt, nst, dci, fst, tdc, tdi, fft, dcf, saf, sar, daf, dar, dsf,
                                       pas, cls, sal, dal, nls, std, sfd> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
