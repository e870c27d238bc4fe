// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which registers a device's cycle reads and writes in each period.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/scanner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The words that a device's cycle reads and writes. Scanner slots 1 and 2 hold, as delivered, ETA and RFRD as
/// inputs, CMD and LFRD as outputs.
template <device_type Device> struct cycle_layout {
    static constexpr bool has_scanner = Device::layout.scanner_words > 0;
    static constexpr bool is_long = Device::limits.exchange_read < Device::layout.scanner_words;
    static constexpr std::uint16_t inputs = not has_scanner ? 7 : is_long ? 8 : 4;
    static constexpr std::uint16_t outputs = not has_scanner ? 2 : is_long ? 8 : 4;
    /// Without a scanner: writes CMD and LFR, and reads the seven words that end with ETA.
    static constexpr std::uint16_t read_from =
        has_scanner ? scanner_input_words : static_cast<std::uint16_t>(Device::layout.eta - inputs + 1);
    static constexpr std::uint16_t write_to = has_scanner ? scanner_output_words : Device::layout.cmd;
    static constexpr std::size_t status_at = has_scanner ? 0 : inputs - 1U;
    static constexpr std::size_t speed_at = has_scanner ? 1 : 0;
    static constexpr bool fits_function_23 =
        inputs <= Device::limits.exchange_read and outputs <= Device::limits.exchange_write;

    static constexpr auto const& reference = []() -> auto const&
    {
        if constexpr (has_scanner) {
            return Device::speed_reference;
        } else {
            return Device::frequency_reference;
        }
    }
    ();
};

} // namespace rtuwire::altivar
