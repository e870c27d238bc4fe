// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a unit says of itself in its maker's words: functions 07, read exception status (AP 6.7), and 17, report server
// ID (AP 6.13). Serial line only.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/serial_line_rules.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The response to function 07: eight outputs, the lowest bit first.
struct read_exception_status_response {
    static constexpr function_code code = function_code::read_exception_status;
    static constexpr std::size_t max_size = 2;

    std::uint8_t outputs;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(detail::to_u8(code));
        out.u8(outputs);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<read_exception_status_response> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = detail::check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return read_exception_status_response{detail::to_u8(pdu[1])};
    }

    friend constexpr bool operator==(read_exception_status_response const&,
                                     read_exception_status_response const&) = default;
};

/// Reads the eight exception status outputs of one unit, whose meaning its maker gives.
struct read_exception_status : detail::lone_request<read_exception_status> {
    using response = read_exception_status_response;

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank) { bank.exception_status(); };

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>, "a server of function 07 needs a bank with exception_status()");
        pdu.bytes[1] = detail::to_byte(at.bank.exception_status());
        pdu.size = response::max_size;
        return errc::none;
    }
};

/// The response to function 17. Where the identifier ends only its maker tells: the byte behind it is FF in a unit that
/// runs and 00 in one that does not.
struct report_server_id_response {
    static constexpr function_code code = function_code::report_server_id;
    static constexpr std::size_t max_size = max_pdu_size;

    byte_view data; ///< identifier, run indicator, and more; after decoding, a view of the received bytes

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return detail::is_quantity(data.size(), max_size - 2) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + data.size(); }
    constexpr void write(byte_writer& out) const noexcept { detail::write_counted(out, code, data); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity` where it is empty.
    [[nodiscard]] static constexpr result<report_server_id_response> decode(byte_view pdu) noexcept
    {
        auto const bytes = detail::decode_counted(pdu, code);
        return bytes ? detail::checked_pdu(report_server_id_response{*bytes}) : bytes.error();
    }
};

/// Asks one unit what it is, and whether it runs.
struct report_server_id : detail::lone_request<report_server_id> {
    using response = report_server_id_response;

    /// Whether a bank has what this function serves.
    /// Internal.
    template <typename Bank> static constexpr bool is_served_by = requires(Bank bank) { bank.server_id(); };

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory&, Server const& at) noexcept
    {
        static_assert(is_served_by<decltype(at.bank)>, "a server of function 17 needs a bank with server_id()");
        byte_view const data = at.bank.server_id();
        if (data.empty()) {
            return errc::illegal_function; // as function 43 without objects
        }
        at.out.bytes(data);
        return at.out.ok() ? errc::none : errc::server_device_failure;
    }
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
