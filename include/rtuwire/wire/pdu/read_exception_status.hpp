// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 07, read exception status; serial line only (AP 6.7).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 07: eight outputs, the lowest bit first.
struct read_exception_status_response {
    static constexpr function_code code = function_code::read_exception_status;
    static constexpr std::size_t max_size = 2;

    std::uint8_t outputs;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(to_u8(code));
        out.u8(outputs);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<read_exception_status_response> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return read_exception_status_response{to_u8(pdu[1])};
    }

    friend constexpr bool operator==(read_exception_status_response const&,
                                     read_exception_status_response const&) = default;
};

/// Reads the eight exception status outputs of one unit, whose meaning its maker gives.
struct read_exception_status {
    using response = read_exception_status_response;
    static constexpr function_code code = function_code::read_exception_status;
    static constexpr frame_rules rules{sized(length_rule::fixed, 4), sized(length_rule::fixed, 5),
                                       answer_rule::nothing};
    static constexpr std::size_t max_size = 1;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { out.u8(to_u8(code)); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<read_exception_status> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return read_exception_status{};
    }

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank) { bank.exception_status(); };

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>, "a server of function 07 needs a bank with exception_status()");
        pdu.bytes[1] = to_byte(at.bank.exception_status());
        pdu.size = response::max_size;
        return errc::none;
    }

    friend constexpr bool operator==(read_exception_status const&, read_exception_status const&) = default;
};

} // namespace rtuwire
