// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What ATV12, ATV310 and ATV320 have in common beside registers: their functions, limits and line.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What each device of the family inherits, unless it says otherwise.
struct family_device {
    static constexpr function_set functions{function_code::read_holding_registers, function_code::write_single_register,
                                            function_code::write_multiple_registers,
                                            function_code::read_write_multiple_registers,
                                            function_code::encapsulated_interface};
    static constexpr device_limits limits{63, 61, 4, 4};
    static constexpr unit_range units{1, 247};
    static constexpr std::array<address_range, 0> readable{}; ///< nothing is known beyond the table
    static constexpr character_format formats[]{character_format::odd_8_1, character_format::even_8_1,
                                                character_format::none_8_1, character_format::none_8_2};
    static constexpr std::uint32_t rates[]{4'800, 9'600, 19'200, 38'400};
    static constexpr link_timeout silence{milliseconds(10'000), milliseconds(30'000)};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
