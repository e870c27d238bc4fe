// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 03, read holding registers (AP 6.3).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 03: as many registers as were requested.
struct read_holding_registers_response {
    static constexpr std::size_t max_size = 2U + 2U * max_read_quantity;

    /// In wire order; after decoding, a view of the received bytes.
    register_view registers;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(registers.size(), max_read_quantity) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + registers.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(to_u8(function_code::read_holding_registers));
        out.u8(static_cast<std::uint32_t>(registers.bytes().size()));
        out.bytes(registers.bytes());
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_holding_registers_response> decode(byte_view pdu) noexcept
    {
        return decode_registers<read_holding_registers_response>(pdu, function_code::read_holding_registers);
    }
};

/// Reads `count` registers of one unit from address `start`.
struct read_holding_registers {
    using response = read_holding_registers_response;
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..125

    [[nodiscard]] constexpr errc check() const noexcept
    {
        if (not is_quantity(count, max_read_quantity)) {
            return errc::invalid_quantity;
        }
        return is_address_range(start, count) ? errc::none : errc::invalid_address_range;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        write_head(out, function_code::read_holding_registers, start, count);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_holding_registers> decode(byte_view pdu) noexcept
    {
        if (not is_pdu_of(pdu, function_code::read_holding_registers)) {
            return errc::wrong_function;
        }
        if (pdu.size() != max_size) {
            return errc::wrong_length;
        }
        std::uint16_t const count = u16_at(pdu, 3);
        if (not is_quantity(count, max_read_quantity)) {
            return errc::invalid_quantity;
        }
        return read_holding_registers{u16_at(pdu, 1), count};
    }

    friend constexpr bool operator==(read_holding_registers const&, read_holding_registers const&) = default;
};

} // namespace rtuwire
