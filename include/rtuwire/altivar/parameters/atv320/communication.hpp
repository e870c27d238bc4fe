// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: lines and networks.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320/values/assignments.hpp>
#include <rtuwire/altivar/parameters/atv320/values/communication.hpp>
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
inline constexpr reg<count16> adco{.code = "ADCO", .address = 6051, .mode = access::configuration, .min = {0}, .max = {127}, .factory = 0, .name = "CANopen address", .source = provenance::inferred};
inline constexpr reg<can_rate> bdco{.code = "BDCO", .address = 6053, .mode = access::configuration, .factory = 60, .name = "CANopen bit rate", .source = provenance::inferred};
inline constexpr reg<count16> adrc{.code = "ADRC", .address = 6601, .mode = access::configuration, .min = {0}, .max = {65535}, .name = "Communication card address", .source = provenance::inferred};
inline constexpr reg<serial_rate> bdr{.code = "BDR", .address = 6603, .mode = access::configuration, .name = "Communication card bit rate", .source = provenance::inferred};
inline constexpr reg<no_yes> prc{.code = "PRC", .address = 6606, .mode = access::configuration, .factory = 0, .name = "Node number for peer-cop", .source = provenance::inferred};
inline constexpr reg<count16> glb{.code = "GLB", .address = 6607, .mode = access::configuration, .min = {0}, .max = {32}, .factory = 0, .name = "Peer-cop global transmission", .source = provenance::inferred};
inline constexpr reg<count16> amoc{.code = "AMOC", .address = 6651, .mode = access::configuration, .min = {0}, .max = {247}, .factory = 0, .name = "Modbus address of the communication card", .source = provenance::inferred};
inline constexpr reg<serial_rate> bdru{.code = "BDRU", .address = 6660, .mode = access::read_only, .factory = 4, .name = "Communication card bit rate in use", .source = provenance::inferred};
inline constexpr reg<profibus_profile> prfl{.code = "PRFL", .address = 6665, .mode = access::read_only, .factory = 100, .name = "PROFIBUS profile in use", .source = provenance::inferred};
inline constexpr reg<profibus_master> dpma{.code = "DPMA", .address = 6666, .mode = access::read_only, .factory = 1, .name = "PROFIBUS active master", .source = provenance::inferred};
inline constexpr reg<io_assembly> cioa{.code = "CIOA", .address = 6667, .mode = access::read_only, .factory = 1, .name = "I/O assembly in use", .source = provenance::inferred};
inline constexpr reg<io_assembly> cio2{.code = "CIO2", .address = 6668, .mode = access::read_only, .factory = 1, .name = "Second I/O assembly in use", .source = provenance::inferred};
inline constexpr reg<off_on> btua{.code = "BTUA", .address = 6670, .mode = access::configuration, .factory = 0, .name = "Bluetooth on", .source = provenance::inferred};
inline constexpr reg<logic_input> btuc{.code = "BTUC", .address = 6671, .mode = access::configuration, .factory = 0, .name = "Bluetooth visibility", .source = provenance::inferred};
inline constexpr reg<count16> btpi{.code = "BTPI", .address = 6673, .mode = access::configuration, .min = {0}, .max = {9999}, .factory = 0, .name = "Bluetooth PIN", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Lines and networks.
struct communication : parameter_list<add, tbr, tfo, tto, adco, bdco, adrc, bdr, prc, glb, amoc, bdru, prfl, dpma, cioa,
                                      cio2, btua, btuc, btpi> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
