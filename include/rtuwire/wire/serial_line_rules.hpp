// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the length rules and the check of responses know of the functions of wire/serial_line/: their rows of the table in
// wire/functions.hpp, without the classes of their requests, which only a program reads that uses them. The table and those
// classes take the rows from here.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

class file_runs;
// A compiler shows the line, and with it the header to include.
struct read_exception_status;                                       // <rtuwire/serial_line.hpp>
template <typename Words = register_view> struct diagnostics;       // <rtuwire/serial_line.hpp>
struct get_comm_event_counter;                                      // <rtuwire/serial_line.hpp>
struct get_comm_event_log;                                          // <rtuwire/serial_line.hpp>
struct report_server_id;                                            // <rtuwire/serial_line.hpp>
template <typename Runs = file_runs> struct read_file_record;       // <rtuwire/serial_line.hpp>
template <typename Words = register_view> struct write_file_record; // <rtuwire/serial_line.hpp>
struct read_fifo_queue;                                             // <rtuwire/serial_line.hpp>
struct read_device_identification;                                  // <rtuwire/serial_line.hpp>

namespace detail {

template <typename Request> struct own_row;

/// Whether a request says how long its response is: it is a format of its own, whatever function it uses.
template <typename Request>
concept tells_length_of_response = requires(byte_view bytes)
{
    {
        Request::length_of_response(bytes)
        } -> std::same_as<std::size_t>;
};

/// Where a function's row stands: in the class of its request, in `own_row`, or here. A class whose row stands here may
/// be known later, and is not looked into.
template <typename Function> struct function_row_of {
    using type = std::conditional_t<tells_length_of_response<Function>, own_row<Function>, Function>;
};
template <typename Function> using function_row = typename function_row_of<Function>::type;

/// A request whose response has a format of its own: see `function_list`.
template <typename Request>
inline constexpr bool has_own_format = std::same_as<function_row<Request>, own_row<Request>>;

/// The row of such a request.
template <typename Request> struct own_row {
    static_assert(has_response_check<Request>,
                  "a request with length_of_response has a check_response, too: static errc "
                  "(byte_view request_pdu, byte_view response_pdu)");
    static_assert(Request::response::max_size <= max_pdu_size,
                  "a response has at most 253 bytes without unit and CRC: its max_size");
    static constexpr function_code code = Request::code;
    static constexpr frame_rules rules{sized(length_rule::none), sized(length_rule::own), answer_rule::own};
    static constexpr std::size_t max_size = Request::max_size;

    [[nodiscard]] static constexpr raw_length length(direction, byte_view adu) noexcept
    {
        std::size_t const size = Request::length_of_response(adu);
        return size == 0 ? raw_length{adu.size() + 1, false} : raw_length{size, true};
    }
    [[nodiscard]] static constexpr bool tells_end(byte_view) noexcept { return true; }
    [[nodiscard]] static constexpr std::size_t longest_response(byte_view) noexcept
    {
        return Request::response::max_size + adu_overhead;
    }
    [[nodiscard]] static constexpr errc check_response(byte_view request_pdu, byte_view response_pdu) noexcept
    {
        return Request::check_response(request_pdu, response_pdu);
    }
};
/// The code and the rules of a function.
template <function_code Code, std::uint8_t Request, std::uint8_t Response, answer_rule Answers> struct plain_row {
    static constexpr function_code code = Code;
    static constexpr frame_rules rules{Request, Response, Answers};
};

/// What the requests have in common that are their function alone: they have no members.
template <typename Request> struct lone_request {
    static constexpr function_code code = function_row<Request>::code;
    static constexpr frame_rules rules = function_row<Request>::rules;
    static constexpr std::size_t max_size = 1;

    [[nodiscard]] static constexpr errc check() noexcept { return errc::none; }
    [[nodiscard]] static constexpr std::size_t size() noexcept { return max_size; }
    static constexpr void write(byte_writer& out) noexcept { out.u8(to_u8(code)); }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<Request> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return Request{};
    }

    friend constexpr bool operator==(Request const&, Request const&) noexcept { return true; }
};

template <> struct function_row_of<read_exception_status> {
    using type = plain_row<function_code::read_exception_status, sized(length_rule::fixed, 4),
                           sized(length_rule::fixed, 5), answer_rule::nothing>;
};
template <> struct function_row_of<get_comm_event_counter> {
    using type = plain_row<function_code::get_comm_event_counter, sized(length_rule::fixed, 4),
                           sized(length_rule::fixed, 8), answer_rule::nothing>;
};
template <> struct function_row_of<get_comm_event_log> {
    using type = plain_row<function_code::get_comm_event_log, sized(length_rule::fixed, 4),
                           sized(length_rule::byte_count, 5), answer_rule::nothing>;
};
template <> struct function_row_of<report_server_id> {
    using type = plain_row<function_code::report_server_id, sized(length_rule::fixed, 4),
                           sized(length_rule::byte_count, 5), answer_rule::nothing>;
};
template <typename Words> struct function_row_of<write_file_record<Words>> {
    using type = plain_row<function_code::write_file_record, sized(length_rule::byte_count, 5),
                           sized(length_rule::byte_count, 5), answer_rule::whole>;
};

} // namespace detail

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

namespace detail {

/// Whether the data of a normal response are those of its request (AP 6.8.1); the others count or report.
[[nodiscard]] constexpr bool repeats_data(subfunction what) noexcept
{
    return what == subfunction::return_query_data or what == subfunction::restart_communications or
           what == subfunction::change_ascii_delimiter or what == subfunction::clear_counters or
           what == subfunction::clear_overrun_counter;
}

/// Function 08.
struct diagnostics_row : plain_row<function_code::diagnostics, sized(length_rule::subfunction, 8),
                                   sized(length_rule::subfunction, 8), answer_rule::partly> {
    /// How many bytes of a request of 4 or more its response repeats.
    [[nodiscard]] static constexpr std::size_t repeated(byte_view request_pdu) noexcept
    {
        return repeats_data(static_cast<subfunction>(u16_at(request_pdu, 1))) ? request_pdu.size() : 3;
    }
};
template <typename Words> struct function_row_of<diagnostics<Words>> {
    using type = diagnostics_row;
};

/// The byte in front of each run of records of a file, and a run's head: reference, file, record, count.
inline constexpr std::uint8_t file_reference = 6;
inline constexpr std::size_t file_run_size = 7;

/// Function 20.
struct file_read_row : plain_row<function_code::read_file_record, sized(length_rule::byte_count, 5),
                                 sized(length_rule::byte_count, 5), answer_rule::nothing> {
    /// The size of the longest response to a request, both ADUs: known of one run.
    [[nodiscard]] static constexpr std::size_t longest_response(byte_view request_adu) noexcept
    {
        constexpr std::size_t with_one_run = 12, count_at = 8, most = 121;
        std::size_t const count = request_adu.size() == with_one_run ? u16_at(request_adu, count_at) : most + 1;
        return count <= most ? 7 + 2 * count : max_adu_size;
    }

    /// Whether a response has the records of each run of its request.
    [[nodiscard]] static constexpr errc check_response(byte_view request_pdu, byte_view response_pdu) noexcept
    {
        std::size_t at = 2;
        for (std::size_t i = 2; i + file_run_size <= request_pdu.size(); i += file_run_size) {
            std::size_t const size = 1U + std::size_t{2} * u16_at(request_pdu, i + 5);
            if (response_pdu.size() < at + 1 + size or to_u8(response_pdu[at]) != size or
                to_u8(response_pdu[at + 1]) != file_reference) {
                return errc::response_mismatch;
            }
            at += 1 + size;
        }
        return response_pdu.size() == at and at == 2U + to_u8(response_pdu[1]) ? errc::none : errc::wrong_length;
    }
};
template <typename Runs> struct function_row_of<read_file_record<Runs>> {
    using type = file_read_row;
};

/// Function 24.
struct fifo_queue_row : plain_row<function_code::read_fifo_queue, sized(length_rule::fixed, 6),
                                  sized(length_rule::word_count, 6), answer_rule::nothing> {
    static constexpr std::size_t head = 5, most = 31;

    /// Whether a response's byte count and queue count agree with its size, and no more than 31 registers came.
    [[nodiscard]] static constexpr errc check_response(byte_view, byte_view response_pdu) noexcept
    {
        std::size_t const size = response_pdu.size();
        bool const agrees = is_pdu_of(response_pdu, code) and size >= head and size == 3U + u16_at(response_pdu, 1) and
                            size == head + std::size_t{2} * u16_at(response_pdu, 3) and size <= head + 2 * most;
        return agrees ? errc::none : errc::wrong_length;
    }
};
template <> struct function_row_of<read_fifo_queue> {
    using type = fifo_queue_row;
};

/// The type byte of read device identification within function 43.
inline constexpr std::uint8_t identification_mei_type = 0x0E;

/// How many objects (number, length and text of each) these bytes hold; 0 where the last one is incomplete or
/// the numbers do not rise.
[[nodiscard]] constexpr std::size_t objects_in(byte_view bytes) noexcept
{
    std::byte const* at = bytes.data();
    std::size_t left = bytes.size();
    std::size_t count = 0;
    int last = -1;
    while (left > 0) {
        if (left < 2 or left - 2 < to_u8(at[1]) or to_u8(at[0]) <= last) {
            return 0;
        }
        last = to_u8(at[0]);
        left -= 2U + to_u8(at[1]);
        at += 2U + to_u8(at[1]);
        ++count;
    }
    return count;
}

/// Function 43, of type 14.
struct identification_row : plain_row<function_code::encapsulated_interface, sized(length_rule::own),
                                      sized(length_rule::own), answer_rule::own> {
    static constexpr std::size_t max_size = 4;           ///< of a request
    static constexpr std::size_t count_at = 6, head = 7; ///< of a page
    static constexpr std::uint8_t single_access = 4;

    /// The size of an ADU: a request is fixed, a response is walked object by object; known for type 14 only.
    [[nodiscard, gnu::always_inline]] static constexpr raw_length length(direction dir, byte_view adu) noexcept
    {
        constexpr std::size_t mei_at = 2;
        constexpr std::size_t count_in_adu = count_at + 1;
        if (adu.size() <= mei_at) {
            return {mei_at + 1, false};
        }
        if (to_u8(adu[mei_at]) != identification_mei_type) {
            return {};
        }
        if (dir == direction::request) {
            return {7, true};
        }
        if (adu.size() <= count_in_adu) {
            return {count_in_adu + 1, false};
        }
        std::size_t left = to_u8(adu[count_in_adu]);
        std::size_t end = count_in_adu + 1;
        while (left > 0 and end + 2 <= adu.size()) {
            end += 2U + to_u8(adu[end + 1]);
            --left;
        }
        // Two bytes follow: the CRC, or the head of the next object.
        return {end + 2, left == 0};
    }

    /// Whether the response to a request of 4 bytes or more, an ADU, tells its own size.
    [[nodiscard]] static constexpr bool tells_end(byte_view request_adu) noexcept
    {
        return to_u8(request_adu[2]) == identification_mei_type;
    }

    /// Whether a PDU is a page: see `device_identification::check_page`.
    [[nodiscard]] static constexpr errc check_page(byte_view pdu) noexcept
    {
        if (not is_pdu_of(pdu, code)) {
            return errc::wrong_function;
        }
        if (pdu.size() < head) {
            return errc::wrong_length;
        }
        std::uint8_t const more = to_u8(pdu[4]);
        std::size_t const count = objects_in(pdu.subspan(head));
        bool const is_legal = to_u8(pdu[1]) == identification_mei_type and (more == 0x00 or more == 0xFF) and
                              count > 0 and count == to_u8(pdu[count_at]);
        return is_legal ? errc::none : errc::malformed;
    }

    /// Compares a page with its request of 4 bytes or more.
    [[nodiscard]] static constexpr errc check_response(byte_view request_pdu, byte_view response_pdu) noexcept
    {
        if (to_u8(request_pdu[1]) != identification_mei_type) {
            return errc::none;
        }
        if (errc const wrong = check_page(response_pdu); wrong != errc::none) {
            return wrong;
        }
        // A stream may start at another object than the one requested; a single object is the one requested.
        bool const is_single = to_u8(request_pdu[2]) == single_access;
        bool const is_other =
            request_pdu[2] != response_pdu[2] or
            (is_single and (to_u8(response_pdu[count_at]) != 1 or response_pdu[head] != request_pdu[3]));
        return is_other ? errc::response_mismatch : errc::none;
    }
};
template <> struct function_row_of<read_device_identification> {
    using type = identification_row;
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
