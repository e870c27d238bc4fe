// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 08, diagnostics (AP 6.8). Request and response have one form: a sub-function and data words.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The sub-functions of AP 6.8.1.
enum class subfunction : std::uint16_t {
    return_query_data = 0x00,
    restart_communications = 0x01,
    return_diagnostic_register = 0x02,
    change_ascii_delimiter = 0x03,
    force_listen_only = 0x04,
    clear_counters = 0x0A,
    bus_message_count = 0x0B,
    bus_communication_error_count = 0x0C,
    bus_exception_error_count = 0x0D,
    server_message_count = 0x0E,
    server_no_response_count = 0x0F,
    server_nak_count = 0x10,
    server_busy_count = 0x11,
    bus_character_overrun_count = 0x12,
    clear_overrun_counter = 0x14,
};

/// Whether the data of a normal response are those of its request (AP 6.8.1); the others count or report.
/// Internal.
[[nodiscard]] constexpr bool repeats_data(subfunction what) noexcept
{
    return what == subfunction::return_query_data or what == subfunction::restart_communications or
           what == subfunction::change_ascii_delimiter or what == subfunction::clear_counters or
           what == subfunction::clear_overrun_counter;
}

/// A diagnostics request or its response. Made of a block, it owns that block; made of a view, its words are
/// stored elsewhere.
template <typename Words = register_view> struct diagnostics {
    using response = diagnostics<>;
    static constexpr function_code code = function_code::diagnostics;
    static constexpr frame_rules rules{sized(length_rule::subfunction, 8), sized(length_rule::subfunction, 8),
                                       answer_rule::partly};
    static constexpr std::size_t max_words = 125;
    static constexpr std::size_t max_size = 3U + bytes_at_most<Words, max_words>;

    subfunction what;
    /// One word for every sub-function but `return_query_data`, which takes 1..125 and has them
    /// returned; after decoding, a view of the received bytes.
    Words data;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        std::size_t const most = what == subfunction::return_query_data ? max_words : 1;
        return is_quantity(data.size(), most) ? errc::none : errc::invalid_quantity;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 3 + data.bytes().size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(to_u8(function_code::diagnostics));
        out.u16(static_cast<std::uint32_t>(what));
        out.bytes(data.bytes());
    }

    /// How many bytes of a request of 4 or more its response repeats.
    /// Internal.
    [[nodiscard]] static constexpr std::size_t repeated(byte_view request_pdu) noexcept
    {
        return repeats_data(static_cast<subfunction>(u16_at(request_pdu, 1))) ? request_pdu.size() : 3;
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`, `invalid_quantity`.
    [[nodiscard]] static constexpr result<diagnostics<>> decode(byte_view pdu) noexcept
    {
        constexpr std::size_t head = 3;
        if (not is_pdu_of(pdu, function_code::diagnostics)) {
            return errc::wrong_function;
        }
        if (pdu.size() < head or (pdu.size() - head) % 2 != 0) {
            return errc::wrong_length;
        }
        diagnostics<> const read{static_cast<subfunction>(u16_at(pdu, 1)), register_view{pdu.subspan(head)}};
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
    return left.what == right.what and same_bytes(left.data.bytes(), right.data.bytes());
}

} // namespace rtuwire
