// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 08 of a server (Application Protocol 6.8): the loopback alone, or with the counters of the serial line
// and the listen-only mode.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/pdu_buffer.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The counting functions of a server without counters.
/// Internal.
struct no_counts {
    static constexpr void note_message() noexcept {}
    static constexpr void note_error() noexcept {}
    static constexpr void note_overrun() noexcept {}
    static constexpr void note_request() noexcept {}
    static constexpr void count_no_response() noexcept {}
    static constexpr void note_end(function_code, errc) noexcept {}
    [[nodiscard]] static constexpr bool is_listen_only() noexcept { return false; }
};

/// A server without function 08: exception 01.
/// Internal.
struct no_diagnostics : no_counts {
    [[nodiscard]] static constexpr errc response(pdu_buffer&) noexcept { return errc::illegal_function; }
};

/// A server without counters: sub-function 00 returns its own data of 1 to 125 words, exception 03 for other sizes;
/// any other sub-function is exception 01.
struct loopback_only : no_counts {
    [[nodiscard]] static constexpr errc response(pdu_buffer& pdu) noexcept
    {
        byte_view const request_pdu = pdu.view();
        if (request_pdu.size() >= 3 and u16_at(request_pdu, 1) != 0) {
            return errc::illegal_function;
        }
        if (not diagnostics<>::decode(request_pdu)) {
            return errc::illegal_data_value;
        }
        return errc::none;
    }
};

/// Counters of a server, each modulo 65 536, and the listen-only mode. With the server's phases
/// (server.hpp) each counts at this moment:
///
/// | sub | counts | when |
/// |-----|--------|------|
/// | 02  | nothing: the diagnostic register is 0 | |
/// | 0B  | good frames, of and to any unit | when they end |
/// | 0C  | frames with a wrong CRC, a damaged byte, below 4 or above 256 bytes | at the silence that ends them |
/// | 0D  | exceptions, those to broadcasts too; a broadcast that is no write is one | in `serve` |
/// | 0E  | requests to this unit or everyone | in `serve`, where they are executed or refused |
/// | 0F  | requests of 0E that get no response: broadcasts, those in listen-only mode, 08/04 | in `serve` |
/// |     | responses that were dropped before they left | when dropped |
/// | 10  | exceptions 07 among those of 0D | in `serve` |
/// | 11  | exceptions 06 among those of 0D | in `serve` |
/// | 12  | calls of `receive_overrun`, in any phase | at once |
///
/// A request that is dropped before `serve` counts in 0B only. Damaged bytes count in 0C with their frame, and not at
/// all after a request or while a response is sent. A response to 0B..12 counts its own request in 0B and 0E.
/// Sub-functions 01 (data 0000 or FF00) and 0A (0000) set all counters to 0, after their own request was counted; 14
/// (0000) sets 12 to 0. 04 (0000) begins the listen-only mode: it gets no response, and after it only a sub-function
/// 01 with allowed data to this unit is executed, also without a response (0F is 1 after it). In listen-only mode
/// nothing is an exception.
/// Internal.
class serial_diagnostics {
public:
    /// Replaces a request of function 08 by its response: 00: its own data; 02 and 0B to 12: a word; 01, 03, 0A and
    /// 14: the request. Exceptions, in this order: 01 for the sub-functions 05 to 09, 13, 15 and above; 03 for data
    /// that is not one word (00: 1 to 125 words), and for another word than 0000 (01: 0000 or FF00; 03: any with a
    /// low byte of 00). In listen-only mode, and to 04, the size is 0: no response.
    [[nodiscard]] constexpr errc response(pdu_buffer& pdu) noexcept
    {
        byte_view const request_pdu = pdu.view();
        auto const asked = diagnostics<>::decode(request_pdu);
        if (is_listen_only_) {
            if (asked and asked->what == subfunction::restart_communications and is_legal(*asked)) {
                clear();
            }
            pdu.size = 0;
            return errc::none;
        }
        if (request_pdu.size() >= 3 and not is_known(u16_at(request_pdu, 1))) {
            return errc::illegal_function;
        }
        if (not asked or not is_legal(*asked)) {
            return errc::illegal_data_value;
        }
        if (std::uint16_t const* const count = count_of(asked->what); count != nullptr) {
            constexpr std::size_t data_at = 3;
            put_u16(pdu.bytes.data() + data_at, *count);
        }
        act(asked->what);
        pdu.size = is_listen_only_ ? 0 : pdu.size;
        return errc::none;
    }

    /// A frame with a good CRC was received, of or to any unit.
    constexpr void note_message() noexcept { ++messages_; }
    /// A frame was damaged.
    constexpr void note_error() noexcept { ++errors_; }
    /// The receiver lost a byte.
    constexpr void note_overrun() noexcept { ++overruns_; }
    /// A request to this server, or a broadcast.
    constexpr void note_request() noexcept { ++requests_; }
    /// That request gets no response.
    constexpr void count_no_response() noexcept { ++silences_; }
    /// That request was executed, or refused. The event counter of functions 11 and 12 counts what was executed, but
    /// function 11.
    constexpr void note_end(function_code function, errc wrong) noexcept
    {
        bool const is_refused = wrong != errc::none;
        bool const is_event = not is_refused and not is_cleared_ and function != function_code::get_comm_event_counter;
        is_cleared_ = false;
        events_ = static_cast<std::uint16_t>(events_ + (is_event ? 1 : 0));
        exceptions_ = static_cast<std::uint16_t>(exceptions_ + (is_refused ? 1 : 0));
        naks_ = static_cast<std::uint16_t>(naks_ + (wrong == errc::negative_acknowledge ? 1 : 0));
        busy_ = static_cast<std::uint16_t>(busy_ + (wrong == errc::server_device_busy ? 1 : 0));
    }
    [[nodiscard]] constexpr std::uint16_t event_count() const noexcept { return events_; }
    [[nodiscard]] constexpr std::uint16_t message_count() const noexcept { return messages_; }

    /// Whether it is in listen-only mode: it neither acts nor responds until it is restarted.
    [[nodiscard]] constexpr bool is_listen_only() const noexcept { return is_listen_only_; }

private:
    static constexpr bool is_known(std::uint16_t number) noexcept
    {
        constexpr std::uint16_t last_of_first = 0x04, first_count = 0x0A, last_count = 0x12, clear_overrun = 0x14;
        return number <= last_of_first or (number >= first_count and number <= last_count) or number == clear_overrun;
    }

    static constexpr bool is_legal(diagnostics<> const& asked) noexcept
    {
        constexpr std::uint16_t clear_log = 0xFF00, low_byte = 0x00FF;
        std::uint16_t const data = asked.data[0];
        switch (asked.what) {
        case subfunction::return_query_data: return true;
        case subfunction::restart_communications: return data == 0 or data == clear_log;
        case subfunction::change_ascii_delimiter: return (data & low_byte) == 0;
        case subfunction::return_diagnostic_register:
        case subfunction::force_listen_only:
        case subfunction::clear_counters:
        case subfunction::bus_message_count:
        case subfunction::bus_communication_error_count:
        case subfunction::bus_exception_error_count:
        case subfunction::server_message_count:
        case subfunction::server_no_response_count:
        case subfunction::server_nak_count:
        case subfunction::server_busy_count:
        case subfunction::bus_character_overrun_count:
        case subfunction::clear_overrun_counter: break;
        }
        return data == 0;
    }

    /// The counter that a sub-function returns; null where it returns its data.
    constexpr std::uint16_t const* count_of(subfunction what) const noexcept
    {
        switch (what) {
        case subfunction::return_diagnostic_register: return &register_;
        case subfunction::bus_message_count: return &messages_;
        case subfunction::bus_communication_error_count: return &errors_;
        case subfunction::bus_exception_error_count: return &exceptions_;
        case subfunction::server_message_count: return &requests_;
        case subfunction::server_no_response_count: return &silences_;
        case subfunction::server_nak_count: return &naks_;
        case subfunction::server_busy_count: return &busy_;
        case subfunction::bus_character_overrun_count: return &overruns_;
        case subfunction::return_query_data:
        case subfunction::restart_communications:
        case subfunction::change_ascii_delimiter:
        case subfunction::force_listen_only:
        case subfunction::clear_counters:
        case subfunction::clear_overrun_counter: break;
        }
        return nullptr;
    }

    constexpr void clear() noexcept
    {
        *this = {};
        is_cleared_ = true;
    }

    constexpr void act(subfunction what) noexcept
    {
        if (what == subfunction::restart_communications or what == subfunction::clear_counters) {
            clear();
        } else if (what == subfunction::force_listen_only) {
            is_listen_only_ = true;
        } else if (what == subfunction::clear_overrun_counter) {
            overruns_ = 0;
        }
    }

    std::uint16_t register_{0}; ///< the diagnostic register
    std::uint16_t messages_{0};
    std::uint16_t errors_{0};
    std::uint16_t exceptions_{0};
    std::uint16_t requests_{0};
    std::uint16_t silences_{0};
    std::uint16_t naks_{0};
    std::uint16_t busy_{0};
    std::uint16_t overruns_{0};
    std::uint16_t events_{0};
    bool is_listen_only_{false};
    bool is_cleared_{false}; ///< by the request that is executed, which is no event then
};

} // namespace rtuwire
