// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// ATV310: the menu numbers that its Modbus manuals print. The manual of 2026 has more scanner words than that of 2014,
// and one setting more; no number has another meaning there. Settings whose number only the user manual prints are
// missing. 705.4 to 705.7 stand beside 707.4 to 707.7, too, in the manual of 2026: taken as misprints, for the same
// lines call them 707.4 to 707.7 and the numbers are those of the scanner's addresses.
#pragma once

#include <rtuwire/altivar/parameters/menu_numbers.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv310 {

/// Internal.
inline constexpr menu_number printed_in_2014[]{
    {"308", "TFR"},    {"315", "SFR"},    {"512.0", "LSP"},  {"512.2", "HSP"},  {"611", "SLL"},
    {"701", "ADD"},    {"702", "TBR"},    {"703", "TFO"},    {"704", "TTO"},    {"705.0", "NMA1"},
    {"705.1", "NMA2"}, {"705.2", "NMA3"}, {"705.3", "NMA4"}, {"706.0", "NCA1"}, {"706.1", "NCA2"},
    {"706.2", "NCA3"}, {"706.3", "NCA4"}, {"707.0", "NM1"},  {"707.1", "NM2"},  {"707.2", "NM3"},
    {"707.3", "NM4"},  {"708.0", "NC1"},  {"708.1", "NC2"},  {"708.2", "NC3"},  {"708.3", "NC4"},
};

/// Internal.
inline constexpr menu_number printed_in_2026[]{
    {"308", "TFR"},    {"315", "SFR"},    {"502.0", "STT"},  {"512.0", "LSP"},  {"512.2", "HSP"},  {"611", "SLL"},
    {"701", "ADD"},    {"702", "TBR"},    {"703", "TFO"},    {"704", "TTO"},    {"705.0", "NMA1"}, {"705.1", "NMA2"},
    {"705.2", "NMA3"}, {"705.3", "NMA4"}, {"705.4", "NMA5"}, {"705.5", "NMA6"}, {"705.6", "NMA7"}, {"705.7", "NMA8"},
    {"706.0", "NCA1"}, {"706.1", "NCA2"}, {"706.2", "NCA3"}, {"706.3", "NCA4"}, {"706.4", "NCA5"}, {"706.5", "NCA6"},
    {"706.6", "NCA7"}, {"706.7", "NCA8"}, {"707.0", "NM1"},  {"707.1", "NM2"},  {"707.2", "NM3"},  {"707.3", "NM4"},
    {"707.4", "NM5"},  {"707.5", "NM6"},  {"707.6", "NM7"},  {"707.7", "NM8"},  {"708.0", "NC1"},  {"708.1", "NC2"},
    {"708.2", "NC3"},  {"708.3", "NC4"},  {"708.4", "NC5"},  {"708.5", "NC6"},  {"708.6", "NC7"},  {"708.7", "NC8"},
};

/// Of the drive `device`, by the manual of 2014.
inline constexpr menu_numbers menu_2014{printed_in_2014};

/// Of the drive `device_2026` and of `full_device`, by the manual of 2026.
inline constexpr menu_numbers menu_2026{printed_in_2026};

} // namespace altivar::atv310
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
