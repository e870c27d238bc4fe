// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 17, report server ID; serial line only (AP 6.13).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 17. Where the identifier ends only its maker tells: the byte behind it is FF in a unit that
/// runs and 00 in one that does not.
struct report_server_id_response {
    static constexpr function_code code = function_code::report_server_id;
    static constexpr std::size_t max_size = max_pdu_size;

    byte_view data; ///< identifier, run indicator, and more; after decoding, a view of the received bytes

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return is_quantity(data.size(), max_size - 2) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 2 + data.size(); }
    constexpr void write(byte_writer& out) const noexcept { write_counted(out, code, data); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity` where it is empty.
    [[nodiscard]] static constexpr result<report_server_id_response> decode(byte_view pdu) noexcept
    {
        auto const bytes = decode_counted(pdu, code);
        return bytes ? checked_pdu(report_server_id_response{*bytes}) : bytes.error();
    }
};

/// Asks one unit what it is, and whether it runs.
struct report_server_id {
    using response = report_server_id_response;
    static constexpr function_code code = function_code::report_server_id;
    static constexpr frame_rules rules{sized(length_rule::fixed, 4), sized(length_rule::byte_count, 5),
                                       answer_rule::nothing};
    static constexpr std::size_t max_size = 1;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { out.u8(to_u8(code)); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<report_server_id> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return report_server_id{};
    }

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

    friend constexpr bool operator==(report_server_id const&, report_server_id const&) = default;
};

} // namespace rtuwire
