// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Responses that several functions have in one form: registers that were read, and a run that was written. Each function
// has a type of its own of them.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A response to function 03, 04 or 23: 1 to 125 registers behind a byte count.
template <function_code Function> struct registers_response {
    static constexpr function_code code = Function;
    static constexpr std::size_t max_size = 2U + 2U * max_read_quantity;

    /// In wire order; after decoding, a view of the received bytes.
    register_view registers;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(registers.size(), max_read_quantity) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + registers.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept { write_counted(out, code, registers.bytes()); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<registers_response> decode(byte_view pdu) noexcept
    {
        return decode_registers<registers_response>(pdu, code);
    }
};

/// A response to function 15 or 16: what was written where, without the values; at most `Most`.
template <function_code Function, std::uint16_t Most> struct written_run_response {
    static constexpr function_code code = Function;
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..Most

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(count, Most) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<written_run_response> decode(byte_view pdu) noexcept
    {
        return decode_run<written_run_response>(pdu, Most);
    }

    friend constexpr bool operator==(written_run_response const&, written_run_response const&) = default;
};

static_assert(max_exchange_read_quantity == max_read_quantity, "functions 03 and 23 read as many registers");

} // namespace rtuwire
