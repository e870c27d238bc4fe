// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The registers that keep a drive's last faults, and those that show the present one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/image.hpp>
#include <rtuwire/sim/drive/registers/register_index.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// LFT of a lost serial link, on every Altivar.
inline constexpr std::uint16_t link_fault = 5;

/// One fault: its LFT, its number in the drive profile (ERRD), its bit in DF1 or DF2 where a
/// drive has them.
/// Internal.
struct fault_form {
    std::uint16_t code;
    std::uint16_t profile;
    std::uint16_t df1;
    std::uint16_t df2;
};

/// As the bulletin of the drive with ERRD lists them; SCF and tnF have no number of their own there.
/// Internal.
inline constexpr std::array<fault_form, 13> fault_forms{{
    {1, 0x6100, 0x0001, 0x0000},
    {2, 0x5520, 0x0008, 0x0000},
    {5, 0x7510, 0x0100, 0x0000},
    {9, 0x2310, 0x0000, 0x0008},
    {16, 0x4210, 0x0000, 0x0080},
    {17, 0x1000, 0x0000, 0x0100},
    {18, 0x3310, 0x0000, 0x0400},
    {19, 0x3110, 0x0000, 0x0800},
    {20, 0x3310, 0x0000, 0x1000},
    {21, 0x3130, 0x0000, 0x2000},
    {22, 0x3120, 0x0000, 0x4000},
    {23, 0x1000, 0x2000, 0x0000},
    {25, 0x1000, 0x0000, 0x0000},
}};

/// The entry for a fault by its LFT: a generic error for one that the list does not have, an empty one for 0.
/// Internal.
[[nodiscard]] constexpr fault_form form_of(std::uint16_t code) noexcept
{
    for (fault_form const& each : fault_forms) {
        if (each.code == code) {
            return each;
        }
    }
    constexpr std::uint16_t generic = 0x1000;
    return {code, code == 0 ? std::uint16_t{0} : generic, 0, 0};
}

/// Records a fault by its LFT: as the last one, as the first of the record, and by its CiA 402 code.
/// Internal.
template <device_type Device> constexpr void record_fault(image<Device>& registers, std::uint16_t code) noexcept
{
    constexpr std::size_t nowhere = image<Device>::nowhere;
    constexpr std::size_t dp0 = image<Device>::at("DP0"), dp1 = image<Device>::at("DP1");
    constexpr std::array<std::size_t, 5> record{dp0 == nowhere ? dp1 : dp0, dp1, image<Device>::at("DP2"),
                                                image<Device>::at("DP3"), image<Device>::at("DP4")};
    for (std::size_t i = record.size() - 1; i > 0; --i) {
        registers.put(record[i], registers.get(record[i - 1]));
    }
    registers.put(record[0], code);
    registers.put(register_index<Device>{}.lft, code);
    registers.put(image<Device>::at("ERRD"), form_of(code).profile);
}

/// Shows the present fault; 0 for none.
/// Internal.
template <device_type Device> constexpr void show_active_fault(image<Device>& registers, std::uint16_t code) noexcept
{
    fault_form const form = form_of(code);
    registers.put(image<Device>::at("DF1"), form.df1);
    registers.put(image<Device>::at("DF2"), form.df2);
}

} // namespace rtuwire::sim
