// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV320: measurements at past faults.
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
inline constexpr reg<signed_deciamperes> lcp0{.code = "LCP0", .address = 7240, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor current at the most recent fault", .source = provenance::inferred};
inline constexpr reg<signed_deciamperes> lcp1{.code = "LCP1", .address = 7241, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor current at fault 1 back", .source = provenance::inferred};
inline constexpr reg<signed_deciamperes> lcp2{.code = "LCP2", .address = 7242, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor current at fault 2 back", .source = provenance::inferred};
inline constexpr reg<signed_deciamperes> lcp3{.code = "LCP3", .address = 7243, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor current at fault 3 back", .source = provenance::inferred};
inline constexpr reg<signed_deciamperes> lcp4{.code = "LCP4", .address = 7244, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor current at fault 4 back", .source = provenance::inferred};
inline constexpr reg<signed_deciamperes> lcp5{.code = "LCP5", .address = 7245, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor current at fault 5 back", .source = provenance::inferred};
inline constexpr reg<signed_deciamperes> lcp6{.code = "LCP6", .address = 7246, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor current at fault 6 back", .source = provenance::inferred};
inline constexpr reg<signed_deciamperes> lcp7{.code = "LCP7", .address = 7247, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor current at fault 7 back", .source = provenance::inferred};
inline constexpr reg<signed_deciamperes> lcp8{.code = "LCP8", .address = 7248, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor current at fault 8 back", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> rfp0{.code = "RFP0", .address = 7250, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Output frequency at the most recent fault", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> rfp1{.code = "RFP1", .address = 7251, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Output frequency at fault 1 back", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> rfp2{.code = "RFP2", .address = 7252, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Output frequency at fault 2 back", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> rfp3{.code = "RFP3", .address = 7253, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Output frequency at fault 3 back", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> rfp4{.code = "RFP4", .address = 7254, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Output frequency at fault 4 back", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> rfp5{.code = "RFP5", .address = 7255, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Output frequency at fault 5 back", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> rfp6{.code = "RFP6", .address = 7256, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Output frequency at fault 6 back", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> rfp7{.code = "RFP7", .address = 7257, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Output frequency at fault 7 back", .source = provenance::inferred};
inline constexpr reg<signed_decihertz> rfp8{.code = "RFP8", .address = 7258, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Output frequency at fault 8 back", .source = provenance::inferred};
inline constexpr reg<hours> rtp0{.code = "RTP0", .address = 7260, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor running time at the most recent fault", .source = provenance::inferred};
inline constexpr reg<hours> rtp1{.code = "RTP1", .address = 7261, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor running time at fault 1 back", .source = provenance::inferred};
inline constexpr reg<hours> rtp2{.code = "RTP2", .address = 7262, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor running time at fault 2 back", .source = provenance::inferred};
inline constexpr reg<hours> rtp3{.code = "RTP3", .address = 7263, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor running time at fault 3 back", .source = provenance::inferred};
inline constexpr reg<hours> rtp4{.code = "RTP4", .address = 7264, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor running time at fault 4 back", .source = provenance::inferred};
inline constexpr reg<hours> rtp5{.code = "RTP5", .address = 7265, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor running time at fault 5 back", .source = provenance::inferred};
inline constexpr reg<hours> rtp6{.code = "RTP6", .address = 7266, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor running time at fault 6 back", .source = provenance::inferred};
inline constexpr reg<hours> rtp7{.code = "RTP7", .address = 7267, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor running time at fault 7 back", .source = provenance::inferred};
inline constexpr reg<hours> rtp8{.code = "RTP8", .address = 7268, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor running time at fault 8 back", .source = provenance::inferred};
inline constexpr reg<decivolts> ulp0{.code = "ULP0", .address = 7270, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Mains voltage at the most recent fault", .source = provenance::inferred};
inline constexpr reg<decivolts> ulp1{.code = "ULP1", .address = 7271, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Mains voltage at fault 1 back", .source = provenance::inferred};
inline constexpr reg<decivolts> ulp2{.code = "ULP2", .address = 7272, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Mains voltage at fault 2 back", .source = provenance::inferred};
inline constexpr reg<decivolts> ulp3{.code = "ULP3", .address = 7273, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Mains voltage at fault 3 back", .source = provenance::inferred};
inline constexpr reg<decivolts> ulp4{.code = "ULP4", .address = 7274, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Mains voltage at fault 4 back", .source = provenance::inferred};
inline constexpr reg<decivolts> ulp5{.code = "ULP5", .address = 7275, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Mains voltage at fault 5 back", .source = provenance::inferred};
inline constexpr reg<decivolts> ulp6{.code = "ULP6", .address = 7276, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Mains voltage at fault 6 back", .source = provenance::inferred};
inline constexpr reg<decivolts> ulp7{.code = "ULP7", .address = 7277, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Mains voltage at fault 7 back", .source = provenance::inferred};
inline constexpr reg<decivolts> ulp8{.code = "ULP8", .address = 7278, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Mains voltage at fault 8 back", .source = provenance::inferred};
inline constexpr reg<percent> thp0{.code = "THP0", .address = 7280, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor thermal state at the most recent fault", .source = provenance::inferred};
inline constexpr reg<percent> thp1{.code = "THP1", .address = 7281, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor thermal state at fault 1 back", .source = provenance::inferred};
inline constexpr reg<percent> thp2{.code = "THP2", .address = 7282, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor thermal state at fault 2 back", .source = provenance::inferred};
inline constexpr reg<percent> thp3{.code = "THP3", .address = 7283, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor thermal state at fault 3 back", .source = provenance::inferred};
inline constexpr reg<percent> thp4{.code = "THP4", .address = 7284, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor thermal state at fault 4 back", .source = provenance::inferred};
inline constexpr reg<percent> thp5{.code = "THP5", .address = 7285, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor thermal state at fault 5 back", .source = provenance::inferred};
inline constexpr reg<percent> thp6{.code = "THP6", .address = 7286, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor thermal state at fault 6 back", .source = provenance::inferred};
inline constexpr reg<percent> thp7{.code = "THP7", .address = 7287, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor thermal state at fault 7 back", .source = provenance::inferred};
inline constexpr reg<percent> thp8{.code = "THP8", .address = 7288, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Motor thermal state at fault 8 back", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> otp0{.code = "OTP0", .address = 7330, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor torque at the most recent fault", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> otp1{.code = "OTP1", .address = 7331, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor torque at fault 1 back", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> otp2{.code = "OTP2", .address = 7332, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor torque at fault 2 back", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> otp3{.code = "OTP3", .address = 7333, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor torque at fault 3 back", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> otp4{.code = "OTP4", .address = 7334, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor torque at fault 4 back", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> otp5{.code = "OTP5", .address = 7335, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor torque at fault 5 back", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> otp6{.code = "OTP6", .address = 7336, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor torque at fault 6 back", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> otp7{.code = "OTP7", .address = 7337, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor torque at fault 7 back", .source = provenance::inferred};
inline constexpr reg<signed_tenth_percent> otp8{.code = "OTP8", .address = 7338, .mode = access::read_only, .min = {-32767}, .max = {32767}, .name = "Motor torque at fault 8 back", .source = provenance::inferred};
inline constexpr reg<percent> tdp0{.code = "TDP0", .address = 7340, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Drive thermal state at the most recent fault", .source = provenance::inferred};
inline constexpr reg<percent> tdp1{.code = "TDP1", .address = 7341, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Drive thermal state at fault 1 back", .source = provenance::inferred};
inline constexpr reg<percent> tdp2{.code = "TDP2", .address = 7342, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Drive thermal state at fault 2 back", .source = provenance::inferred};
inline constexpr reg<percent> tdp3{.code = "TDP3", .address = 7343, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Drive thermal state at fault 3 back", .source = provenance::inferred};
inline constexpr reg<percent> tdp4{.code = "TDP4", .address = 7344, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Drive thermal state at fault 4 back", .source = provenance::inferred};
inline constexpr reg<percent> tdp5{.code = "TDP5", .address = 7345, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Drive thermal state at fault 5 back", .source = provenance::inferred};
inline constexpr reg<percent> tdp6{.code = "TDP6", .address = 7346, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Drive thermal state at fault 6 back", .source = provenance::inferred};
inline constexpr reg<percent> tdp7{.code = "TDP7", .address = 7347, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Drive thermal state at fault 7 back", .source = provenance::inferred};
inline constexpr reg<percent> tdp8{.code = "TDP8", .address = 7348, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Drive thermal state at fault 8 back", .source = provenance::inferred};
inline constexpr reg<whole_celsius> tjp0{.code = "TJP0", .address = 7350, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Transistor temperature at the most recent fault", .source = provenance::inferred};
inline constexpr reg<whole_celsius> tjp1{.code = "TJP1", .address = 7351, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Transistor temperature at fault 1 back", .source = provenance::inferred};
inline constexpr reg<whole_celsius> tjp2{.code = "TJP2", .address = 7352, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Transistor temperature at fault 2 back", .source = provenance::inferred};
inline constexpr reg<whole_celsius> tjp3{.code = "TJP3", .address = 7353, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Transistor temperature at fault 3 back", .source = provenance::inferred};
inline constexpr reg<whole_celsius> tjp4{.code = "TJP4", .address = 7354, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Transistor temperature at fault 4 back", .source = provenance::inferred};
inline constexpr reg<whole_celsius> tjp5{.code = "TJP5", .address = 7355, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Transistor temperature at fault 5 back", .source = provenance::inferred};
inline constexpr reg<whole_celsius> tjp6{.code = "TJP6", .address = 7356, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Transistor temperature at fault 6 back", .source = provenance::inferred};
inline constexpr reg<whole_celsius> tjp7{.code = "TJP7", .address = 7357, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Transistor temperature at fault 7 back", .source = provenance::inferred};
inline constexpr reg<whole_celsius> tjp8{.code = "TJP8", .address = 7358, .mode = access::read_only, .min = {0}, .max = {255}, .name = "Transistor temperature at fault 8 back", .source = provenance::inferred};
inline constexpr reg<hertz> sfp0{.code = "SFP0", .address = 7360, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Switching frequency at the most recent fault", .source = provenance::inferred};
inline constexpr reg<hertz> sfp1{.code = "SFP1", .address = 7361, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Switching frequency at fault 1 back", .source = provenance::inferred};
inline constexpr reg<hertz> sfp2{.code = "SFP2", .address = 7362, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Switching frequency at fault 2 back", .source = provenance::inferred};
inline constexpr reg<hertz> sfp3{.code = "SFP3", .address = 7363, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Switching frequency at fault 3 back", .source = provenance::inferred};
inline constexpr reg<hertz> sfp4{.code = "SFP4", .address = 7364, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Switching frequency at fault 4 back", .source = provenance::inferred};
inline constexpr reg<hertz> sfp5{.code = "SFP5", .address = 7365, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Switching frequency at fault 5 back", .source = provenance::inferred};
inline constexpr reg<hertz> sfp6{.code = "SFP6", .address = 7366, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Switching frequency at fault 6 back", .source = provenance::inferred};
inline constexpr reg<hertz> sfp7{.code = "SFP7", .address = 7367, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Switching frequency at fault 7 back", .source = provenance::inferred};
inline constexpr reg<hertz> sfp8{.code = "SFP8", .address = 7368, .mode = access::read_only, .min = {0}, .max = {65535}, .name = "Switching frequency at fault 8 back", .source = provenance::inferred};
// clang-format on

} // namespace altivar::atv320

namespace altivar::atv320::groups {

/// Measurements at past faults.
struct history_values
    : parameter_list<lcp0, lcp1, lcp2, lcp3, lcp4, lcp5, lcp6, lcp7, lcp8, rfp0, rfp1, rfp2, rfp3, rfp4, rfp5, rfp6,
                     rfp7, rfp8, rtp0, rtp1, rtp2, rtp3, rtp4, rtp5, rtp6, rtp7, rtp8, ulp0, ulp1, ulp2, ulp3, ulp4,
                     ulp5, ulp6, ulp7, ulp8, thp0, thp1, thp2, thp3, thp4, thp5, thp6, thp7, thp8, otp0, otp1, otp2,
                     otp3, otp4, otp5, otp6, otp7, otp8, tdp0, tdp1, tdp2, tdp3, tdp4, tdp5, tdp6, tdp7, tdp8, tjp0,
                     tjp1, tjp2, tjp3, tjp4, tjp5, tjp6, tjp7, tjp8, sfp0, sfp1, sfp2, sfp3, sfp4, sfp5, sfp6, sfp7,
                     sfp8> {};

} // namespace altivar::atv320::groups
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
