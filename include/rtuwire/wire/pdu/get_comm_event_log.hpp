// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 12, get comm event log; serial line only (AP 6.10).
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 12.
struct get_comm_event_log_response {
    static constexpr function_code code = function_code::get_comm_event_log;
    static constexpr std::size_t most_events = 64;
    static constexpr std::size_t max_size = 8 + most_events;

    std::uint16_t status; ///< FFFF while a command is still under way, else 0
    std::uint16_t events;
    std::uint16_t messages;
    byte_view log; ///< up to 64 events, the latest first; after decoding, a view of the received bytes

    [[nodiscard]] constexpr errc check() const noexcept
    {
        if (log.size() > most_events) {
            return errc::invalid_quantity;
        }
        return status == 0 or status == 0xFFFF ? errc::none : errc::malformed;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 8 + log.size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        constexpr std::size_t head = 8;
        if (std::byte* const at = out.take(head); at != nullptr) {
            at[0] = to_byte(to_u8(code));
            at[1] = to_byte(static_cast<std::uint32_t>(6 + log.size()));
            put_u16(at + 2, status);
            put_u16(at + 4, events);
            put_u16(at + 6, messages);
        }
        out.bytes(log);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity` for more than 64 events, `malformed`
    /// for a status other than 0 and FFFF.
    [[nodiscard]] static constexpr result<get_comm_event_log_response> decode(byte_view pdu) noexcept
    {
        constexpr std::size_t head = 6;
        auto const bytes = decode_counted(pdu, code);
        if (not bytes) {
            return bytes.error();
        }
        if (bytes->size() < head) {
            return errc::wrong_length;
        }
        return checked_pdu(
            get_comm_event_log_response{u16_at(*bytes, 0), u16_at(*bytes, 2), u16_at(*bytes, 4), bytes->subspan(head)});
    }
};

/// Asks one unit for its counters and the log of what happened on its line.
struct get_comm_event_log {
    using response = get_comm_event_log_response;
    static constexpr function_code code = function_code::get_comm_event_log;
    static constexpr frame_rules rules{sized(length_rule::fixed, 4), sized(length_rule::byte_count, 5),
                                       answer_rule::nothing};
    static constexpr std::size_t max_size = 1;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept { out.u8(to_u8(code)); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<get_comm_event_log> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return get_comm_event_log{};
    }

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory&, Server const& at) noexcept
    {
        static_assert(
            requires { at.line.event_count(); }, "a server of function 12 counts: take serial_diagnostics");
        at.out.u16(0); // never under way
        at.out.u16(at.line.event_count());
        at.out.u16(at.line.message_count());
        return errc::none;
    }

    friend constexpr bool operator==(get_comm_event_log const&, get_comm_event_log const&) = default;
};

} // namespace rtuwire
