// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 05, write single coil (AP 6.5). Request and response are the same bytes.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>
#include <rtuwire/wire/parts/serving.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Switches one coil of one unit or of all; the response repeats it.
struct write_single_coil {
    using response = write_single_coil;
    static constexpr function_code code = function_code::write_single_coil;
    static constexpr frame_rules rules{sized(length_rule::fixed, 8), sized(length_rule::fixed, 8), answer_rule::head};
    static constexpr std::size_t max_size = 5;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t address;
    bool value;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { write_head(out, code, address, value ? on : 0U); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `malformed` for a value other than FF00 and 0000.
    [[nodiscard]] static constexpr result<write_single_coil> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        std::uint16_t const value = u16_at(pdu, 3);
        if (not is_value(value)) {
            return errc::malformed;
        }
        return write_single_coil{u16_at(pdu, 1), value == on};
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank) { bank.coils(); };

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>, "a server of function 05 needs a bank with coils()");
        constexpr std::size_t value_at = 3;
        std::uint16_t const value = u16_at(pdu.bytes, value_at);
        if (not is_value(value)) {
            return errc::illegal_data_value;
        }
        // The first bit of FF or of 00.
        return write_bits_into(at.bank.coils(), pdu, value_at, 1);
    }

    friend constexpr bool operator==(write_single_coil const&, write_single_coil const&) = default;

private:
    static constexpr std::uint16_t on = 0xFF00;

    static constexpr bool is_value(std::uint16_t value) noexcept { return value == on or value == 0; }
};

} // namespace rtuwire
