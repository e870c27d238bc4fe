// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The sizes and quantities of the specifications, each with the clause it comes from. AP is Modbus
// Application Protocol V1.1b3, SL is Modbus over Serial Line V1.02.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

inline constexpr std::size_t min_adu_size = 4;   ///< unit, function, CRC (SL 2.5.1.1)
inline constexpr std::size_t max_adu_size = 256; ///< SL 2.5.1.1
inline constexpr std::size_t max_pdu_size = 253; ///< AP 4.1

namespace detail {

/// Internal.
inline constexpr std::size_t adu_overhead = 3;       ///< unit in front, two bytes of CRC behind
inline constexpr std::size_t exception_adu_size = 5; ///< AP 7

} // namespace detail

inline constexpr std::uint16_t max_bit_quantity = 2000;           ///< AP 6.1, 6.2
inline constexpr std::uint16_t max_bit_write_quantity = 1968;     ///< AP 6.11
inline constexpr std::uint16_t max_read_quantity = 125;           ///< AP 6.3
inline constexpr std::uint16_t max_write_quantity = 123;          ///< AP 6.12
inline constexpr std::uint16_t max_exchange_read_quantity = 125;  ///< AP 6.17
inline constexpr std::uint16_t max_exchange_write_quantity = 121; ///< AP 6.17

/// How many registers a device accepts in one request, by direction; the specification's limits unless its
/// manual says less. Zero means that the device lacks the function.
struct device_limits {
    std::uint16_t read{max_read_quantity};                     ///< function 03
    std::uint16_t write{max_write_quantity};                   ///< function 16
    std::uint16_t exchange_read{max_exchange_read_quantity};   ///< function 23, read half
    std::uint16_t exchange_write{max_exchange_write_quantity}; ///< function 23, write half

    friend constexpr bool operator==(device_limits const&, device_limits const&) = default;
};

namespace detail {

/// Whether a quantity lies in 1..limit.
[[nodiscard]] constexpr bool is_quantity(std::size_t quantity, std::size_t limit) noexcept
{
    return quantity - 1U < limit; // 0 wraps: one comparison
}

/// Whether `quantity` registers from `start` end at 65535 or before; computed in 32 bits, so that
/// no sum wraps.
[[nodiscard]] constexpr bool is_address_range(std::uint16_t start, std::size_t quantity) noexcept
{
    return quantity <= 0x1'0000U - std::uint32_t{start};
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
