// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 06, write single register (AP 6.6). Request and response are the same bytes.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Writes one register of one unit or of all; the response repeats it.
struct write_single_register {
    using response = write_single_register;
    static constexpr function_code code = function_code::write_single_register;
    static constexpr frame_rules rules{sized(length_rule::fixed, 8), sized(length_rule::fixed, 8), answer_rule::head};
    static constexpr std::size_t max_size = 5;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t address;
    std::uint16_t value;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { write_head(out, code, address, value); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<write_single_register> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return write_single_register{u16_at(pdu, 1), u16_at(pdu, 3)};
    }

    friend constexpr bool operator==(write_single_register const&, write_single_register const&) = default;
};

} // namespace rtuwire
