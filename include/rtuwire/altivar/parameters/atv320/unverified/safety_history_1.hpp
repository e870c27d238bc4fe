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
inline constexpr reg<count16> sr11{.code = "SR11", .address = 7401, .mode = access::read_only, .name = "Safety register SAF1, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> sr12{.code = "SR12", .address = 7402, .mode = access::read_only, .name = "Safety register SAF1, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> sr13{.code = "SR13", .address = 7403, .mode = access::read_only, .name = "Safety register SAF1, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> sr14{.code = "SR14", .address = 7404, .mode = access::read_only, .name = "Safety register SAF1, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> sr15{.code = "SR15", .address = 7405, .mode = access::read_only, .name = "Safety register SAF1, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> sr16{.code = "SR16", .address = 7406, .mode = access::read_only, .name = "Safety register SAF1, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> sr17{.code = "SR17", .address = 7407, .mode = access::read_only, .name = "Safety register SAF1, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> sr18{.code = "SR18", .address = 7408, .mode = access::read_only, .name = "Safety register SAF1, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> sr21{.code = "SR21", .address = 7411, .mode = access::read_only, .name = "Safety register SAF2, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> sr22{.code = "SR22", .address = 7412, .mode = access::read_only, .name = "Safety register SAF2, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> sr23{.code = "SR23", .address = 7413, .mode = access::read_only, .name = "Safety register SAF2, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> sr24{.code = "SR24", .address = 7414, .mode = access::read_only, .name = "Safety register SAF2, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> sr25{.code = "SR25", .address = 7415, .mode = access::read_only, .name = "Safety register SAF2, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> sr26{.code = "SR26", .address = 7416, .mode = access::read_only, .name = "Safety register SAF2, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> sr27{.code = "SR27", .address = 7417, .mode = access::read_only, .name = "Safety register SAF2, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> sr28{.code = "SR28", .address = 7418, .mode = access::read_only, .name = "Safety register SAF2, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> sra1{.code = "SRA1", .address = 7421, .mode = access::read_only, .name = "Safety register SF00, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> sra2{.code = "SRA2", .address = 7422, .mode = access::read_only, .name = "Safety register SF00, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> sra3{.code = "SRA3", .address = 7423, .mode = access::read_only, .name = "Safety register SF00, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> sra4{.code = "SRA4", .address = 7424, .mode = access::read_only, .name = "Safety register SF00, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> sra5{.code = "SRA5", .address = 7425, .mode = access::read_only, .name = "Safety register SF00, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> sra6{.code = "SRA6", .address = 7426, .mode = access::read_only, .name = "Safety register SF00, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> sra7{.code = "SRA7", .address = 7427, .mode = access::read_only, .name = "Safety register SF00, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> sra8{.code = "SRA8", .address = 7428, .mode = access::read_only, .name = "Safety register SF00, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> srb1{.code = "SRB1", .address = 7431, .mode = access::read_only, .name = "Safety register SF01, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> srb2{.code = "SRB2", .address = 7432, .mode = access::read_only, .name = "Safety register SF01, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> srb3{.code = "SRB3", .address = 7433, .mode = access::read_only, .name = "Safety register SF01, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> srb4{.code = "SRB4", .address = 7434, .mode = access::read_only, .name = "Safety register SF01, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> srb5{.code = "SRB5", .address = 7435, .mode = access::read_only, .name = "Safety register SF01, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> srb6{.code = "SRB6", .address = 7436, .mode = access::read_only, .name = "Safety register SF01, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> srb7{.code = "SRB7", .address = 7437, .mode = access::read_only, .name = "Safety register SF01, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> srb8{.code = "SRB8", .address = 7438, .mode = access::read_only, .name = "Safety register SF01, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> src1{.code = "SRC1", .address = 7441, .mode = access::read_only, .name = "Safety register SF02, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> src2{.code = "SRC2", .address = 7442, .mode = access::read_only, .name = "Safety register SF02, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> src3{.code = "SRC3", .address = 7443, .mode = access::read_only, .name = "Safety register SF02, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> src4{.code = "SRC4", .address = 7444, .mode = access::read_only, .name = "Safety register SF02, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> src5{.code = "SRC5", .address = 7445, .mode = access::read_only, .name = "Safety register SF02, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> src6{.code = "SRC6", .address = 7446, .mode = access::read_only, .name = "Safety register SF02, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> src7{.code = "SRC7", .address = 7447, .mode = access::read_only, .name = "Safety register SF02, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> src8{.code = "SRC8", .address = 7448, .mode = access::read_only, .name = "Safety register SF02, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> srd1{.code = "SRD1", .address = 7451, .mode = access::read_only, .name = "Safety register SF03, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> srd2{.code = "SRD2", .address = 7452, .mode = access::read_only, .name = "Safety register SF03, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> srd3{.code = "SRD3", .address = 7453, .mode = access::read_only, .name = "Safety register SF03, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> srd4{.code = "SRD4", .address = 7454, .mode = access::read_only, .name = "Safety register SF03, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> srd5{.code = "SRD5", .address = 7455, .mode = access::read_only, .name = "Safety register SF03, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> srd6{.code = "SRD6", .address = 7456, .mode = access::read_only, .name = "Safety register SF03, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> srd7{.code = "SRD7", .address = 7457, .mode = access::read_only, .name = "Safety register SF03, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> srd8{.code = "SRD8", .address = 7458, .mode = access::read_only, .name = "Safety register SF03, record 8", .source = provenance::doubtful};
inline constexpr reg<count16> sre1{.code = "SRE1", .address = 7461, .mode = access::read_only, .name = "Safety register SF04, record 1", .source = provenance::doubtful};
inline constexpr reg<count16> sre2{.code = "SRE2", .address = 7462, .mode = access::read_only, .name = "Safety register SF04, record 2", .source = provenance::doubtful};
inline constexpr reg<count16> sre3{.code = "SRE3", .address = 7463, .mode = access::read_only, .name = "Safety register SF04, record 3", .source = provenance::doubtful};
inline constexpr reg<count16> sre4{.code = "SRE4", .address = 7464, .mode = access::read_only, .name = "Safety register SF04, record 4", .source = provenance::doubtful};
inline constexpr reg<count16> sre5{.code = "SRE5", .address = 7465, .mode = access::read_only, .name = "Safety register SF04, record 5", .source = provenance::doubtful};
inline constexpr reg<count16> sre6{.code = "SRE6", .address = 7466, .mode = access::read_only, .name = "Safety register SF04, record 6", .source = provenance::doubtful};
inline constexpr reg<count16> sre7{.code = "SRE7", .address = 7467, .mode = access::read_only, .name = "Safety register SF04, record 7", .source = provenance::doubtful};
inline constexpr reg<count16> sre8{.code = "SRE8", .address = 7468, .mode = access::read_only, .name = "Safety register SF04, record 8", .source = provenance::doubtful};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::unverified {

/// Records of the safety functions, first part.
struct history_safety_1
    : parameter_list<sr11, sr12, sr13, sr14, sr15, sr16, sr17, sr18, sr21, sr22, sr23, sr24, sr25, sr26, sr27, sr28,
                     sra1, sra2, sra3, sra4, sra5, sra6, sra7, sra8, srb1, srb2, srb3, srb4, srb5, srb6, srb7, srb8,
                     src1, src2, src3, src4, src5, src6, src7, src8, srd1, srd2, srd3, srd4, srd5, srd6, srd7, srd8,
                     sre1, sre2, sre3, sre4, sre5, sre6, sre7, sre8> {};

} // namespace altivar::atv320::unverified
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
