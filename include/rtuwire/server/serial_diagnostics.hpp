// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 08 of a server (Application Protocol 6.8): the loopback alone, or with the counters of the serial line
// and the listen-only mode.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/decoded_request.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/serial_line/diagnostics.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The counting functions of a server without counters.
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
struct no_diagnostics : no_counts {
    [[nodiscard]] static constexpr errc response(pdu_buffer&) noexcept { return errc::illegal_function; }
};

} // namespace detail

/// A server without counters: sub-function 00 returns its own data of 1 to 125 words, exception 03 for other sizes;
/// any other sub-function is exception 01.
struct loopback_only : detail::no_counts {
    [[nodiscard]] static constexpr errc response(detail::pdu_buffer& pdu) noexcept
    {
        byte_view const request_pdu = pdu.view();
        if (request_pdu.size() >= 3 and detail::u16_at(request_pdu, 1) != 0) {
            return errc::illegal_function;
        }
        if (not diagnostics<>::decode(request_pdu)) {
            return errc::illegal_data_value;
        }
        return errc::none;
    }
};

namespace detail {

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
class serial_diagnostics {
public:
    // Members that are set to 0 as -Weffc++ wants it make a call of memset: 168 bytes of a server of all functions.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"
    constexpr serial_diagnostics() noexcept
    {
        clear();
        is_cleared_ = false;
    }
#pragma GCC diagnostic pop

    /// Replaces a request of function 08 by its response: 00: its own data; 02 and 0B to 12: a word; 01, 03, 0A and
    /// 14: the request. Exceptions, in this order: 01 for the sub-functions 05 to 09, 13, 15 and above; 03 for data
    /// that is not one word (00: 1 to 125 words), and for another word than 0000 (01: 0000 or FF00; 03: any with a
    /// low byte of 00). In listen-only mode, and to 04, the size is 0: no response.
    [[nodiscard]] constexpr errc response(pdu_buffer& pdu) noexcept
    {
        errc const wrong = refusal_of(pdu.view());
        // A refused one does what a loopback does: nothing.
        auto const what = wrong == errc::none ? static_cast<subfunction>(u16_at(pdu.bytes, 1)) : subfunction{};
        if (is_listen_only_) {
            if (what == subfunction::restart_communications) {
                clear();
            }
            pdu.size = 0;
            return errc::none;
        }
        if (is_count(what)) {
            put_u16(&pdu.bytes[data_at], count_of(what));
        } else if (what == subfunction::restart_communications or what == subfunction::clear_counters) {
            clear();
        } else if (what == subfunction::clear_overrun_counter) {
            count_of(subfunction::bus_character_overrun_count) = 0;
        } else if (what == subfunction::force_listen_only) {
            is_listen_only_ = true;
            pdu.size = 0;
        }
        return wrong;
    }

    /// A frame with a good CRC was received, of or to any unit.
    constexpr void note_message() noexcept { ++count_of(subfunction::bus_message_count); }
    /// A frame was damaged.
    constexpr void note_error() noexcept { ++count_of(subfunction::bus_communication_error_count); }
    /// The receiver lost a byte.
    constexpr void note_overrun() noexcept { ++count_of(subfunction::bus_character_overrun_count); }
    /// A request to this server, or a broadcast.
    constexpr void note_request() noexcept { ++count_of(subfunction::server_message_count); }
    /// That request gets no response.
    constexpr void count_no_response() noexcept { ++count_of(subfunction::server_no_response_count); }
    /// That request was executed, or refused. The event counter of functions 11 and 12 counts what was executed, but
    /// function 11.
    constexpr void note_end(function_code function, errc wrong) noexcept
    {
        if (wrong != errc::none) {
            ++count_of(subfunction::bus_exception_error_count);
        } else if (not is_cleared_ and function != function_code::get_comm_event_counter) {
            ++events_;
        }
        if (wrong == errc::negative_acknowledge) {
            ++count_of(subfunction::server_nak_count);
        }
        if (wrong == errc::server_device_busy) {
            ++count_of(subfunction::server_busy_count);
        }
        is_cleared_ = false;
    }
    [[nodiscard]] constexpr std::uint16_t event_count() const noexcept { return events_; }
    [[nodiscard]] constexpr std::uint16_t message_count() const noexcept { return counts_[0]; }

    /// Whether it is in listen-only mode: it neither acts nor responds until it is restarted.
    [[nodiscard]] constexpr bool is_listen_only() const noexcept { return is_listen_only_; }

private:
    static constexpr std::size_t data_at = 3;

    /// The exception to a request, or none.
    static constexpr errc refusal_of(byte_view asked) noexcept
    {
        if (asked.size() < data_at) {
            return errc::illegal_data_value;
        }
        std::uint16_t const number = u16_at(asked, 1);
        auto const what = static_cast<subfunction>(number);
        if (number >= 32 or ((known >> number) & 1U) == 0) {
            return errc::illegal_function;
        }
        std::size_t const size = asked.size() - data_at;
        std::size_t const most = what == subfunction::return_query_data ? diagnostics<>::max_words : 1;
        bool const is_whole = size % 2 == 0 and is_quantity(size / 2, most);
        return is_whole and is_allowed(what, u16_at(asked, data_at)) ? errc::none : errc::illegal_data_value;
    }

    /// Whether a sub-function takes this first word of data.
    static constexpr bool is_allowed(subfunction what, std::uint16_t data) noexcept
    {
        constexpr std::uint16_t clear_log = 0xFF00, low_byte = 0x00FF;
        if (what == subfunction::change_ascii_delimiter) {
            data &= low_byte;
        }
        return data == 0 or what == subfunction::return_query_data or
               (what == subfunction::restart_communications and data == clear_log);
    }

    /// The sub-functions 00 to 04, 0A to 12 and 14.
    static constexpr std::uint32_t known = 0x0017'FC1F;

    static constexpr std::size_t index_of(subfunction what) noexcept
    {
        return static_cast<std::size_t>(what) - static_cast<std::size_t>(subfunction::bus_message_count);
    }
    static constexpr bool is_count(subfunction what) noexcept { return index_of(what) < counted; }
    constexpr std::uint16_t& count_of(subfunction what) noexcept { return counts_[index_of(what)]; }

    constexpr void clear() noexcept
    {
        // One store for each: of a loop, compilers make a call of memset, which has 166 bytes.
        [this]<std::size_t... Index>(std::index_sequence<Index...>) { ((counts_[Index] = 0), ...); }
        (std::make_index_sequence<counted>{});
        events_ = 0;
        is_listen_only_ = false;
        is_cleared_ = true;
    }

    static constexpr std::size_t counted = 8;
    std::array<std::uint16_t, counted> counts_; ///< of the sub-functions 0B to 12
    std::uint16_t events_;
    bool is_listen_only_;
    bool is_cleared_; ///< by the request that is executed, which is no event then
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
