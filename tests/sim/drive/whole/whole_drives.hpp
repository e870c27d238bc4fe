// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The drives with all their parameters, what the lists say of each, and a simulated one to ask.
#pragma once

#include "sim/drive/whole/facts.hpp"
#include "support/drive_bench.hpp"
#include "support/drives.hpp"

#include <set>

#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/altivar/atv310_parameters.hpp>
#include <rtuwire/altivar/atv320_parameters.hpp>

namespace rtuwire::test {

using namespace detail;

using whole_drives = drive_list<altivar::atv12::full_device, altivar::atv310::full_device,
                                altivar::atv310::full_device_2014, altivar::atv320::full_device>;

/// Registers of an ATV310 that no list has under this drive: by their addresses.
inline std::map<std::uint16_t, std::string> const beside_the_lists{
    {9012, "AC2"}, {9013, "DE2"}, {7130, "CIC"}, {8601, "CMDD"}, {8603, "ETAD"}};

/// Whether a register is a scanner word that only the later of two manuals has.
inline bool is_later_scanner_word(std::uint16_t address)
{
    bool const is_scanner = address >= 12'701 and address <= 12'768;
    return is_scanner and (address - 12'701) % 20 >= 4;
}

/// What the lists say of a device, in the order of addresses.
template <typename Device> std::vector<fact> facts_about()
{
    using namespace altivar;
    if constexpr (std::is_same_v<Device, atv12::full_device>) {
        return facts_of("atv12");
    } else if constexpr (std::is_same_v<Device, atv320::full_device>) {
        return facts_of("atv320");
    } else {
        auto all = facts_of("atv310");
        if constexpr (std::is_same_v<Device, atv310::full_device_2014>) {
            std::erase_if(all, [](fact const& each) { return is_later_scanner_word(each.address); });
        }
        return all;
    }
}

/// Whether the lists tell so little of a register that the library may only read it.
inline bool tells_little(fact const& of)
{
    bool const has_limits = of.least.has_value() or of.most.has_value();
    return of.access.empty() or (of.is_number() ? not has_limits : of.kind != "enum" or of.values.empty());
}

/// Whether a standing drive takes a word.
template <typename Device>
errc told(detail::simulated_drive<Device> const& drive, std::uint16_t address, std::uint32_t word)
{
    register_block const value{static_cast<std::uint16_t>(word)};
    return drive.check_write(address, value);
}

} // namespace rtuwire::test
