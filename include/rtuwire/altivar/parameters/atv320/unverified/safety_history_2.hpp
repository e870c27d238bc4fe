// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: registers of which too little is known to write them: no access, no limits, or values that no public list
// explains. They are read-only here, and doubtful.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
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
inline constexpr reg<count16> srf1{.code = "SRF1", .address = 7471, .mode = access::read_only, .name = "Safety register SF05, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> srf2{.code = "SRF2", .address = 7472, .mode = access::read_only, .name = "Safety register SF05, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> srf3{.code = "SRF3", .address = 7473, .mode = access::read_only, .name = "Safety register SF05, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> srf4{.code = "SRF4", .address = 7474, .mode = access::read_only, .name = "Safety register SF05, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> srf5{.code = "SRF5", .address = 7475, .mode = access::read_only, .name = "Safety register SF05, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> srf6{.code = "SRF6", .address = 7476, .mode = access::read_only, .name = "Safety register SF05, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> srf7{.code = "SRF7", .address = 7477, .mode = access::read_only, .name = "Safety register SF05, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> srf8{.code = "SRF8", .address = 7478, .mode = access::read_only, .name = "Safety register SF05, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> srg1{.code = "SRG1", .address = 7481, .mode = access::read_only, .name = "Safety register SF06, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> srg2{.code = "SRG2", .address = 7482, .mode = access::read_only, .name = "Safety register SF06, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> srg3{.code = "SRG3", .address = 7483, .mode = access::read_only, .name = "Safety register SF06, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> srg4{.code = "SRG4", .address = 7484, .mode = access::read_only, .name = "Safety register SF06, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> srg5{.code = "SRG5", .address = 7485, .mode = access::read_only, .name = "Safety register SF06, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> srg6{.code = "SRG6", .address = 7486, .mode = access::read_only, .name = "Safety register SF06, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> srg7{.code = "SRG7", .address = 7487, .mode = access::read_only, .name = "Safety register SF06, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> srg8{.code = "SRG8", .address = 7488, .mode = access::read_only, .name = "Safety register SF06, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> srh1{.code = "SRH1", .address = 7491, .mode = access::read_only, .name = "Safety register SF07, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> srh2{.code = "SRH2", .address = 7492, .mode = access::read_only, .name = "Safety register SF07, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> srh3{.code = "SRH3", .address = 7493, .mode = access::read_only, .name = "Safety register SF07, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> srh4{.code = "SRH4", .address = 7494, .mode = access::read_only, .name = "Safety register SF07, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> srh5{.code = "SRH5", .address = 7495, .mode = access::read_only, .name = "Safety register SF07, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> srh6{.code = "SRH6", .address = 7496, .mode = access::read_only, .name = "Safety register SF07, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> srh7{.code = "SRH7", .address = 7497, .mode = access::read_only, .name = "Safety register SF07, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> srh8{.code = "SRH8", .address = 7498, .mode = access::read_only, .name = "Safety register SF07, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> sri1{.code = "SRI1", .address = 7501, .mode = access::read_only, .name = "Safety register SF08, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> sri2{.code = "SRI2", .address = 7502, .mode = access::read_only, .name = "Safety register SF08, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> sri3{.code = "SRI3", .address = 7503, .mode = access::read_only, .name = "Safety register SF08, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> sri4{.code = "SRI4", .address = 7504, .mode = access::read_only, .name = "Safety register SF08, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> sri5{.code = "SRI5", .address = 7505, .mode = access::read_only, .name = "Safety register SF08, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> sri6{.code = "SRI6", .address = 7506, .mode = access::read_only, .name = "Safety register SF08, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> sri7{.code = "SRI7", .address = 7507, .mode = access::read_only, .name = "Safety register SF08, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> sri8{.code = "SRI8", .address = 7508, .mode = access::read_only, .name = "Safety register SF08, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> srj1{.code = "SRJ1", .address = 7511, .mode = access::read_only, .name = "Safety register SF09, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> srj2{.code = "SRJ2", .address = 7512, .mode = access::read_only, .name = "Safety register SF09, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> srj3{.code = "SRJ3", .address = 7513, .mode = access::read_only, .name = "Safety register SF09, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> srj4{.code = "SRJ4", .address = 7514, .mode = access::read_only, .name = "Safety register SF09, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> srj5{.code = "SRJ5", .address = 7515, .mode = access::read_only, .name = "Safety register SF09, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> srj6{.code = "SRJ6", .address = 7516, .mode = access::read_only, .name = "Safety register SF09, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> srj7{.code = "SRJ7", .address = 7517, .mode = access::read_only, .name = "Safety register SF09, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> srj8{.code = "SRJ8", .address = 7518, .mode = access::read_only, .name = "Safety register SF09, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> srk1{.code = "SRK1", .address = 7521, .mode = access::read_only, .name = "Safety register SF10, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> srk2{.code = "SRK2", .address = 7522, .mode = access::read_only, .name = "Safety register SF10, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> srk3{.code = "SRK3", .address = 7523, .mode = access::read_only, .name = "Safety register SF10, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> srk4{.code = "SRK4", .address = 7524, .mode = access::read_only, .name = "Safety register SF10, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> srk5{.code = "SRK5", .address = 7525, .mode = access::read_only, .name = "Safety register SF10, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> srk6{.code = "SRK6", .address = 7526, .mode = access::read_only, .name = "Safety register SF10, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> srk7{.code = "SRK7", .address = 7527, .mode = access::read_only, .name = "Safety register SF10, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> srk8{.code = "SRK8", .address = 7528, .mode = access::read_only, .name = "Safety register SF10, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> srl1{.code = "SRL1", .address = 7531, .mode = access::read_only, .name = "Safety register SF11, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> srl2{.code = "SRL2", .address = 7532, .mode = access::read_only, .name = "Safety register SF11, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> srl3{.code = "SRL3", .address = 7533, .mode = access::read_only, .name = "Safety register SF11, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> srl4{.code = "SRL4", .address = 7534, .mode = access::read_only, .name = "Safety register SF11, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> srl5{.code = "SRL5", .address = 7535, .mode = access::read_only, .name = "Safety register SF11, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> srl6{.code = "SRL6", .address = 7536, .mode = access::read_only, .name = "Safety register SF11, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> srl7{.code = "SRL7", .address = 7537, .mode = access::read_only, .name = "Safety register SF11, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> srl8{.code = "SRL8", .address = 7538, .mode = access::read_only, .name = "Safety register SF11, record 8", .source = provenance::doubtful};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::unverified {

/// Records of the safety functions, second part.
struct history_safety_2
    : parameter_list<srf1, srf2, srf3, srf4, srf5, srf6, srf7, srf8, srg1, srg2, srg3, srg4, srg5, srg6, srg7, srg8,
                     srh1, srh2, srh3, srh4, srh5, srh6, srh7, srh8, sri1, sri2, sri3, sri4, sri5, sri6, sri7, sri8,
                     srj1, srj2, srj3, srj4, srj5, srj6, srj7, srj8, srk1, srk2, srk3, srk4, srk5, srk6, srk7, srk8,
                     srl1, srl2, srl3, srl4, srl5, srl6, srl7, srl8> {};

} // namespace altivar::atv320::unverified
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
