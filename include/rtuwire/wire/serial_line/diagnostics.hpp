// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a line and a unit on it have counted: functions 08, diagnostics (AP 6.8), whose request and response have one
// form, a sub-function and data words; 11, get comm event counter (AP 6.9); 12, get comm event log (AP 6.10). Serial
// line only.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/serial_line_rules.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// A diagnostics request or its response. Made of a block, it owns that block; made of a view, its words are
/// stored elsewhere.
template <typename Words> struct diagnostics {
    using response = diagnostics<>;
    static constexpr function_code code = detail::function_row<diagnostics<>>::code;
    static constexpr detail::frame_rules rules = detail::function_row<diagnostics<>>::rules;
    static constexpr std::size_t max_words = 125;
    static constexpr std::size_t max_size = 3U + detail::bytes_at_most<Words, max_words>;

    subfunction what;
    /// One word for every sub-function but `return_query_data`, which takes 1..125 and has them
    /// returned; after decoding, a view of the received bytes.
    Words data;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        std::size_t const most = what == subfunction::return_query_data ? max_words : 1;
        return detail::is_quantity(data.size(), most) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 3 + data.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(detail::to_u8(function_code::diagnostics));
        out.u16(static_cast<std::uint32_t>(what));
        out.bytes(data.bytes());
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<diagnostics<>> decode(byte_view pdu) noexcept
    {
        constexpr std::size_t head = 3;
        if (not detail::is_pdu_of(pdu, function_code::diagnostics)) {
            return errc::wrong_function;
        }
        if (pdu.size() < head or (pdu.size() - head) % 2 != 0) {
            return errc::wrong_length;
        }
        diagnostics<> const read{static_cast<subfunction>(detail::u16_at(pdu, 1)), register_view{pdu.subspan(head)}};
        if (errc const wrong = read.check(); wrong != errc::none) {
            return wrong;
        }
        return read;
    }
};

diagnostics(subfunction, register_view)->diagnostics<>;
template <std::size_t Count> diagnostics(subfunction, register_block<Count>) -> diagnostics<register_block<Count>>;

template <typename Left, typename Right>
constexpr bool operator==(diagnostics<Left> const& left, diagnostics<Right> const& right) noexcept
{
    return left.what == right.what and detail::same_bytes(left.data.bytes(), right.data.bytes());
}

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
    constexpr void write(byte_writer& out) const noexcept { detail::write_head(out, code, status, events); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `malformed` for a status other than 0 and FFFF.
    [[nodiscard]] static constexpr result<get_comm_event_counter_response> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = detail::check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return detail::checked_pdu(get_comm_event_counter_response{detail::u16_at(pdu, 1), detail::u16_at(pdu, 3)});
    }

    friend constexpr bool operator==(get_comm_event_counter_response const&,
                                     get_comm_event_counter_response const&) = default;
};

/// Asks one unit how many requests it has executed; exceptions and requests of this function do not count.
struct get_comm_event_counter : detail::lone_request<get_comm_event_counter> {
    using response = get_comm_event_counter_response;

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        static_assert(
            requires { at.line.event_count(); }, "a server of function 11 counts: take counting_server::with<...>");
        detail::put_u16(&pdu.bytes[1], 0); // never under way
        detail::put_u16(&pdu.bytes[3], at.line.event_count());
        pdu.size = response::max_size;
        return errc::none;
    }
};

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
            at[0] = detail::to_byte(detail::to_u8(code));
            at[1] = detail::to_byte(static_cast<std::uint32_t>(6 + log.size()));
            detail::put_u16(at + 2, status);
            detail::put_u16(at + 4, events);
            detail::put_u16(at + 6, messages);
        }
        out.bytes(log);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity` for more than 64 events, `malformed`
    /// for a status other than 0 and FFFF.
    [[nodiscard]] static constexpr result<get_comm_event_log_response> decode(byte_view pdu) noexcept
    {
        constexpr std::size_t head = 6;
        auto const bytes = detail::decode_counted(pdu, code);
        if (not bytes) {
            return bytes.error();
        }
        if (bytes->size() < head) {
            return errc::wrong_length;
        }
        return detail::checked_pdu(get_comm_event_log_response{detail::u16_at(*bytes, 0), detail::u16_at(*bytes, 2),
                                                               detail::u16_at(*bytes, 4), bytes->subspan(head)});
    }
};

/// Asks one unit for its counters and the log of what happened on its line.
struct get_comm_event_log : detail::lone_request<get_comm_event_log> {
    using response = get_comm_event_log_response;

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory&, Server const& at) noexcept
    {
        static_assert(
            requires { at.line.event_count(); }, "a server of function 12 counts: take counting_server::with<...>");
        at.out.u16(0); // never under way
        at.out.u16(at.line.event_count());
        at.out.u16(at.line.message_count());
        return errc::none;
    }
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
