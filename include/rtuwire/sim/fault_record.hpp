// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The registers that keep a drive's last faults.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/image.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// LFT of a lost serial link, on every Altivar.
inline constexpr std::uint16_t link_fault = 5;

/// Notes a fault by its LFT: as the last one, as the first of the record, and by its CiA 402 code.
template <device_type Device>
constexpr void record_fault(image<Device>& registers, std::uint16_t code) noexcept
{
    constexpr std::size_t nowhere = image<Device>::nowhere;
    constexpr std::size_t dp0 = image<Device>::at("DP0"), dp1 = image<Device>::at("DP1");
    constexpr std::array<std::size_t, 5> record{dp0 == nowhere ? dp1 : dp0, dp1,
                                                image<Device>::at("DP2"), image<Device>::at("DP3"),
                                                image<Device>::at("DP4")};
    constexpr std::uint16_t communication = 0x7510, generic = 0x1000;
    for (std::size_t i = record.size() - 1; i > 0; --i) {
        registers.put(record[i], registers.get(record[i - 1]));
    }
    registers.put(record[0], code);
    registers.put(image<Device>::at("LFT"), code);
    registers.put(image<Device>::at("ERRD"), code == link_fault ? communication : generic);
}

} // namespace rtuwire::sim
