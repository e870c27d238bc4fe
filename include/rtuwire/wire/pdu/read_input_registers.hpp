// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 04, read input registers (AP 6.4).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>
#include <rtuwire/wire/parts/shared_responses.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 04: as many `registers` as were requested.
using read_input_registers_response = registers_response<function_code::read_input_registers>;

/// Reads `count` input registers of one unit from address `start`.
struct read_input_registers {
    using response = read_input_registers_response;
    static constexpr function_code code = function_code::read_input_registers;
    static constexpr frame_rules rules{sized(length_rule::fixed, 8), sized(length_rule::byte_count, 5),
                                       answer_rule::registers};
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..125

    [[nodiscard]] constexpr errc check() const noexcept { return check_run(start, count, max_read_quantity); }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_input_registers> decode(byte_view pdu) noexcept
    {
        return decode_run<read_input_registers>(pdu, max_read_quantity);
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank) { bank.input_registers(); };

    friend constexpr bool operator==(read_input_registers const&, read_input_registers const&) = default;
};

} // namespace rtuwire
