// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which registers a drive's cycle reads and writes in each period, by the data of the drive.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The words that a drive's cycle reads and writes.
template <drive_type Device> struct cycle_layout {
    static constexpr cycle_registers const& words = Device::cycle;
    static constexpr scanner_registers const& scanner = Device::scanner;
    static constexpr bool has_scanner = words.by_scanner;
    static constexpr std::uint16_t inputs = words.reads.size();
    static constexpr std::uint16_t outputs = words.writes.size();
    static constexpr std::uint16_t read_from = has_scanner ? scanner.input_words : words.reads[0];
    static constexpr std::uint16_t write_to = has_scanner ? scanner.output_words : words.writes[0];
    static constexpr std::size_t status_at = words.reads.place_of(Device::layout.eta);
    static constexpr std::size_t speed_at = words.reads.place_of(words.speed);
    static constexpr bool fits_function_23 = words.by == function_code::read_write_multiple_registers;

    /// Whether the reference is a speed in rpm, else a frequency.
    static constexpr bool is_by_speed = words.writes.has(Device::speed_reference.address);
    static constexpr auto const& reference = []() -> auto const&
    {
        if constexpr (is_by_speed) {
            return Device::speed_reference;
        } else {
            return Device::frequency_reference;
        }
    }
    ();
    static constexpr std::size_t command_at = words.writes.place_of(Device::layout.cmd);
    static constexpr std::size_t reference_at = words.writes.place_of(reference.address);

    /// Whether the program may set an output word.
    [[nodiscard]] static constexpr bool is_free(std::size_t slot) noexcept
    {
        return slot < outputs and slot != command_at and slot != reference_at;
    }
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
