// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: load monitoring.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/drive.hpp>
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
inline constexpr reg<seconds> ult{.code = "ULT", .address = 14411, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "Underload detection delay", .source = provenance::inferred};
inline constexpr reg<fault_reaction> udl{.code = "UDL", .address = 14412, .mode = access::configuration, .factory = 1, .name = "Reaction to an underload", .source = provenance::inferred};
inline constexpr reg<decihertz> rmud{.code = "RMUD", .address = 14414, .min = {0}, .max = {5990}, .factory = 0, .name = "Underload detection: lowest frequency", .source = provenance::inferred};
inline constexpr reg<percent> lul{.code = "LUL", .address = 14415, .min = {0}, .max = {100}, .factory = 0, .name = "Underload threshold at zero speed", .source = provenance::inferred};
inline constexpr reg<percent> lun{.code = "LUN", .address = 14416, .min = {20}, .max = {100}, .factory = 60, .name = "Underload threshold at rated speed", .source = provenance::inferred};
inline constexpr reg<seconds> tol{.code = "TOL", .address = 14421, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "Overload detection delay", .source = provenance::inferred};
inline constexpr reg<fault_reaction> odl{.code = "ODL", .address = 14422, .mode = access::configuration, .factory = 1, .name = "Reaction to an overload", .source = provenance::inferred};
inline constexpr reg<no_yes> fqf{.code = "FQF", .address = 14601, .mode = access::configuration, .factory = 0, .name = "Frequency meter on the pulse input", .source = provenance::inferred};
inline constexpr reg<count16_tenths> fqc{.code = "FQC", .address = 14602, .min = {10}, .max = {1000}, .factory = 10, .name = "Pulse scale divider", .source = provenance::inferred};
inline constexpr reg<hertz> fqa{.code = "FQA", .address = 14604, .mode = access::configuration, .min = {0}, .max = {20000}, .factory = 0, .name = "Pulse overspeed threshold", .source = provenance::inferred};
inline constexpr reg<deciseconds> tds{.code = "TDS", .address = 14605, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "Delay of the pulse overspeed", .source = provenance::inferred};
inline constexpr reg<decihertz> fdt{.code = "FDT", .address = 14606, .mode = access::configuration, .min = {0}, .max = {5990}, .factory = 0, .name = "Pulse supervision lowest frequency", .source = provenance::inferred};
inline constexpr reg<hertz> fqt{.code = "FQT", .address = 14607, .mode = access::configuration, .min = {0}, .max = {1000}, .factory = 0, .name = "Pulse threshold without run order", .source = provenance::inferred};
inline constexpr reg<deciseconds> tqb{.code = "TQB", .address = 14608, .mode = access::configuration, .min = {0}, .max = {100}, .factory = 0, .name = "Pulse delay without run order", .source = provenance::inferred};
inline constexpr reg<hertz> fql{.code = "FQL", .address = 14609, .mode = access::configuration, .min = {0}, .max = {20000}, .factory = 0, .name = "Pulse supervision: warning level", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Load monitoring.
struct process_monitoring : parameter_list<ult, udl, rmud, lul, lun, tol, odl, fqf, fqc, fqa, tds, fdt, fqt, tqb, fql> {
};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
