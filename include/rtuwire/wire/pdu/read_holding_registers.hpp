// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 03, read holding registers (AP 6.3).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>
#include <rtuwire/wire/parts/shared_responses.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 03: as many `registers` as were requested.
using read_holding_registers_response = registers_response<function_code::read_holding_registers>;

/// Reads `count` registers of one unit from address `start`.
struct read_holding_registers {
    using response = read_holding_registers_response;
    static constexpr function_code code = function_code::read_holding_registers;
    static constexpr frame_rules rules{sized(length_rule::fixed, 8), sized(length_rule::byte_count, 5),
                                       answer_rule::registers};
    static constexpr std::size_t max_size = 5;

    std::uint16_t start;
    std::uint16_t count; ///< 1..125

    [[nodiscard]] constexpr errc check() const noexcept { return check_run(start, count, max_read_quantity); }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { write_head(out, code, start, count); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<read_holding_registers> decode(byte_view pdu) noexcept
    {
        return decode_run<read_holding_registers>(pdu, max_read_quantity);
    }

    friend constexpr bool operator==(read_holding_registers const&, read_holding_registers const&) = default;
};

} // namespace rtuwire
