// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 11, get comm event counter; serial line only (AP 6.9).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 11.
struct get_comm_event_counter_response {
    static constexpr function_code code = function_code::get_comm_event_counter;
    static constexpr std::size_t max_size = 5;

    std::uint16_t status; ///< FFFF while a command is still under way, else 0
    std::uint16_t events;

    [[nodiscard]] constexpr bool is_busy() const noexcept { return status != 0; }

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return status == 0 or status == 0xFFFF ? errc::none : errc::malformed;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { write_head(out, code, status, events); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `malformed` for a status other than 0 and FFFF.
    [[nodiscard]] static constexpr result<get_comm_event_counter_response> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return checked_pdu(get_comm_event_counter_response{u16_at(pdu, 1), u16_at(pdu, 3)});
    }

    friend constexpr bool operator==(get_comm_event_counter_response const&,
                                     get_comm_event_counter_response const&) = default;
};

/// Asks one unit how many requests it has executed; exceptions and requests of this function do not count.
struct get_comm_event_counter {
    using response = get_comm_event_counter_response;
    static constexpr function_code code = function_code::get_comm_event_counter;
    static constexpr frame_rules rules{sized(length_rule::fixed, 4), sized(length_rule::fixed, 8),
                                       answer_rule::nothing};
    static constexpr std::size_t max_size = 1;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { out.u8(to_u8(code)); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<get_comm_event_counter> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return get_comm_event_counter{};
    }

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(
            requires { at.line.event_count(); }, "a server of function 11 counts: take serial_diagnostics");
        put_u16(&pdu.bytes[1], 0); // never under way
        put_u16(&pdu.bytes[3], at.line.event_count());
        pdu.size = response::max_size;
        return errc::none;
    }

    friend constexpr bool operator==(get_comm_event_counter const&, get_comm_event_counter const&) = default;
};

} // namespace rtuwire
