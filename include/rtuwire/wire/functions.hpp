// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The one list of the functions, and the length of a frame from its first bytes: one table, made of the rules of all
// functions (AP 6), or of those that a client's user has chosen. A line here makes a function known to the length
// rules, to the check of responses, to broadcasts, to the tests and to the fuzz targets; all that belongs to it alone
// is in its class. Sizes are of the whole ADU. Knows no CRC and no time.
//
// And what a receiver of requests knows of the exchanges between other stations: after a request to another unit its
// response may come, which the length rules of requests would misread. It is not certain to come: the next frame of that
// unit and function may be a request again. A receiver of responses needs none of this, and it costs nothing there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/bits.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line_rules.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// How many of these functions have the code of the first.
template <typename Function, typename... Functions>
inline constexpr std::size_t times_in_list =
    ((function_row<Functions>::code == function_row<Function>::code ? std::size_t{1} : std::size_t{0}) + ...);

/// Whether a list has each code once that a request of one's own format uses. Most lists have none: nothing is counted.
template <typename... Functions> [[nodiscard]] consteval bool has_own_formats_once() noexcept
{
    if constexpr ((has_own_format<Functions> or ...)) {
        return ((not has_own_format<Functions> or times_in_list<Functions, Functions...> == 1) and ...);
    }
    return true;
}

} // namespace detail

/// Functions, each by the type of its request. A request may have a response of a format of its own, for units that use a code
/// in their own way, public ones too: it then has `static constexpr std::size_t length_of_response(byte_view so_far)`, how many
/// bytes the frame has from the unit to the CRC as soon as those so far tell, else 0; `check_response(request_pdu, response_pdu)`,
/// whether it fits, in place of all that a client else compares but unit and function, also of a `raw_pdu` of that code, which
/// may be shorter than any request of the type; and a `response` with `max_size`.
template <typename... Functions> struct function_list {
    static_assert(detail::has_own_formats_once<Functions...>(),
                  "a list of functions has a code once, where a request of one's own format uses it");
    static constexpr function_set codes{detail::function_row<Functions>::code...};

    /// Whether a function is in the list.
    template <typename Function>
    static constexpr bool contains = ((detail::function_row<Functions>::code == detail::function_row<Function>::code) or
                                      ...);
};

namespace detail {

/// Whether a list has a function with this code.
template <typename... Functions>
[[nodiscard]] constexpr bool is_among(function_list<Functions...>, std::uint8_t code) noexcept
{
    return ((code == to_u8(function_row<Functions>::code)) or ...);
}

} // namespace detail

/// The public functions (AP 6).
using public_functions =
    function_list<read_coils, read_discrete_inputs, read_holding_registers, read_input_registers, write_single_coil,
                  write_single_register, read_exception_status, diagnostics<>, get_comm_event_counter,
                  get_comm_event_log, write_multiple_coils<>, write_multiple_registers<>, report_server_id,
                  read_file_record<>, write_file_record<>, mask_write_register, read_write_multiple_registers<>,
                  read_fifo_queue, read_device_identification>;

namespace detail {

template <typename... Lists> struct joined_functions;
template <typename List> struct joined_functions<List> {
    using type = List;
};
template <typename... Left, typename... Right, typename... Others>
struct joined_functions<function_list<Left...>, function_list<Right...>, Others...> {
    using type = typename joined_functions<function_list<Left..., Right...>, Others...>::type;
};

/// A function, unless one of the list takes its place.
template <typename Function, typename List>
using unless_among = std::conditional_t<List::template contains<Function>, function_list<>, function_list<Function>>;

template <typename... Functions, typename... Own>
typename joined_functions<unless_among<Functions, function_list<Own...>>..., function_list<Own...>>::type
    append(function_list<Functions...>, function_list<Own...>);

} // namespace detail

/// The same with requests of one's own, for `client_needs`: one of a public function takes its place.
template <typename... Own>
using public_functions_and = decltype(detail::append(public_functions{}, function_list<Own...>{}));

/// Their codes.
inline constexpr function_set all_functions = public_functions::codes;

namespace detail {

/// Whether a frame can be a request of one of these functions; of all public functions also one of one's own. Errors:
/// `frame_too_short`, `frame_too_long`, `invalid_function`.
template <typename Functions> [[nodiscard, gnu::always_inline]] constexpr errc check_request(byte_view frame) noexcept
{
    if (frame.size() < min_adu_size) {
        return errc::frame_too_short;
    }
    if (frame.size() > max_adu_size) {
        return errc::frame_too_long;
    }
    if constexpr (not std::is_same_v<Functions, public_functions>) {
        return is_among(Functions{}, to_u8(frame[1])) ? errc::none : errc::invalid_function;
    }
    return errc::none;
}

/// What a function with this code says of a response, where it knows more of it than the client compares.
template <typename... Functions>
[[nodiscard]] constexpr errc check_beside_client(function_list<Functions...>, byte_view request_pdu,
                                                 byte_view response_pdu) noexcept
{
    errc found = errc::none;
    auto const ask = [&]<typename Function>(std::type_identity<Function>) {
        if constexpr (checks_response<function_row<Function>>) {
            if (is_pdu_of(request_pdu, function_row<Function>::code)) {
                found = function_row<Function>::check_response(request_pdu, response_pdu);
            }
        }
    };
    (ask(std::type_identity<Functions>{}), ...);
    return found;
}

/// What the bytes so far tell: the frame is `size` bytes long, or more is known when `size` are there, or
/// (`size` 0) only silence ends it.
class length_hint {
public:
    constexpr length_hint() noexcept = default;
    constexpr length_hint(std::size_t size, bool is_final) noexcept
        : hint_{static_cast<std::uint16_t>(size << 1U | (is_final ? 1U : 0U))}
    {}

    [[nodiscard]] constexpr std::size_t size() const noexcept { return hint_ >> 1U; }
    [[nodiscard]] constexpr bool is_final() const noexcept { return (hint_ & 1U) != 0; }

    friend constexpr bool operator==(length_hint, length_hint) noexcept = default;

private:
    std::uint16_t hint_{0}; ///< in one register, which small processors return best
};

/// The rules of the functions that have codes up to 24, one byte each, and of the others.
namespace length_rules {

inline constexpr std::size_t in_table = 25;

template <typename Function> inline constexpr bool is_in_table = to_u8(function_row<Function>::code) < in_table;

template <typename... Functions>
[[nodiscard]] consteval std::array<std::uint8_t, in_table> table_of(function_list<Functions...>,
                                                                    std::uint8_t frame_rules::*way) noexcept
{
    std::array<std::uint8_t, in_table> rules{};
    auto const put = [&](function_code code, frame_rules const& of) {
        if (to_u8(code) < in_table) {
            rules[to_u8(code)] = of.*way;
        }
    };
    (put(function_row<Functions>::code, function_row<Functions>::rules), ...);
    return rules;
}

template <typename Functions> inline constexpr auto requests = table_of(Functions{}, &frame_rules::request);
template <typename Functions> inline constexpr auto responses = table_of(Functions{}, &frame_rules::response);

/// The rule of a function that is not in the table; an exception has one as a response.
template <typename... Functions>
[[nodiscard, gnu::always_inline]] constexpr std::uint8_t of_others(function_list<Functions...>, bool asks,
                                                                   std::uint8_t wire_code) noexcept
{
    bool const is_exception = (wire_code & exception_bit) != 0;
    std::uint8_t rule = is_exception and not asks ? sized(length_rule::fixed, exception_adu_size) : std::uint8_t{0};
    ((rule = not is_in_table<Functions> and wire_code == to_u8(function_row<Functions>::code)
                 ? (asks ? function_row<Functions>::rules.request : function_row<Functions>::rules.response)
                 : rule),
     ...);
    return rule;
}

/// Whether a request of one of these functions may be the function alone: the response may begin with all of it.
template <typename... Functions> [[nodiscard]] constexpr bool may_be_alone(function_list<Functions...>) noexcept
{
    return ((not is_in_table<Functions> or
             function_row<Functions>::rules.request == sized(length_rule::fixed, min_adu_size)) or
            ...);
}

/// The rule of one function in one direction; `wire_code` is the byte behind the unit address.
template <typename Functions> [[nodiscard]] constexpr std::uint8_t of(direction dir, std::uint8_t wire_code) noexcept
{
    bool const asks = dir == direction::request;
    if (wire_code >= in_table) {
        return of_others(Functions{}, asks, wire_code);
    }
    return asks ? requests<Functions>[wire_code] : responses<Functions>[wire_code];
}

template <typename Function>
inline constexpr bool
    has_own = static_cast<length_rule>(function_row<Function>::rules.response& length_rule_bits) == length_rule::own;

/// What the one function says of its size that has a rule of its own; of several, the one with this code. By its packs: a
/// list of the functions left would be a class of its own for each.
template <typename First, typename... Others>
[[nodiscard, gnu::always_inline]] constexpr raw_length own_of(direction dir, byte_view adu) noexcept
{
    if constexpr (has_own<First>) {
        bool const is_only = not(has_own<Others> or ...);
        if (is_only or function_row<First>::code == static_cast<function_code>(to_u8(adu[1]))) {
            return function_row<First>::length(dir, adu);
        }
    }
    if constexpr (sizeof...(Others) > 0) {
        return own_of<Others...>(dir, adu);
    } else {
        return {};
    }
}
template <typename... Functions>
[[nodiscard, gnu::always_inline]] constexpr raw_length own(function_list<Functions...>, direction dir,
                                                           byte_view adu) noexcept
{
    return own_of<Functions...>(dir, adu);
}

} // namespace length_rules

/// What the first bytes of an ADU say by their rule in the table.
template <typename Functions>
[[nodiscard, gnu::always_inline]] constexpr raw_length length_by_rule(direction dir, byte_view adu) noexcept
{
    if (adu.size() < 2) {
        return {2, false};
    }
    std::uint8_t const rule = length_rules::of<Functions>(dir, to_u8(adu[1]));
    auto const counts = static_cast<length_rule>(rule & length_rule_bits);
    std::size_t const size = size_in(rule);
    if (counts == length_rule::none) {
        return {};
    }
    if (counts == length_rule::fixed) {
        return {size, true};
    }
    if (counts == length_rule::own) {
        return length_rules::own(Functions{}, dir, adu);
    }
    // The bytes before the CRC.
    std::size_t const counted = counts == length_rule::subfunction ? 4 : size - 2;
    if (adu.size() < counted) {
        return {counted, false};
    }
    if (counts == length_rule::byte_count) {
        return {size + to_u8(adu[counted - 1]), true};
    }
    std::size_t const word = u16_at(adu, counted - 2);
    if (counts == length_rule::word_count) {
        // Where a size has 16 bits, the sum would wrap; such a frame is refused anyway.
        bool const may_wrap = sizeof(std::size_t) < sizeof(std::uint32_t) and word > max_adu_size;
        return {may_wrap ? word : size + word, true};
    }
    return word == 0 ? raw_length{} : raw_length{size, true};
}

/// Whether a request PDU, of one byte at least, has the size that its function's rule tells. A function whose rule does
/// not tell it checks that itself.
[[nodiscard]] constexpr bool has_size_of_rule(byte_view pdu) noexcept
{
    std::uint8_t const rule = length_rules::of<public_functions>(direction::request, to_u8(pdu[0]));
    auto const counts = static_cast<length_rule>(rule & length_rule_bits);
    std::size_t size = size_in(rule) - adu_overhead;
    if (counts == length_rule::byte_count) {
        size += pdu.size() < size ? 0U : to_u8(pdu[size - 1]);
    } else if (counts != length_rule::fixed) {
        return true;
    }
    return pdu.size() == size;
}

/// What the first bytes of an ADU tell about its size. A size above 256 is never returned: such a frame ends
/// by silence and is refused; so does that of a function that is not among `Functions`.
template <typename Functions = public_functions>
[[nodiscard]] constexpr length_hint frame_length(direction dir, byte_view adu) noexcept
{
    raw_length const hint = length_by_rule<Functions>(dir, adu);
    return hint.size > max_adu_size ? length_hint{} : length_hint{hint.size, hint.is_final};
}

/// The size alone, for a caller that checks whether so many bytes are there. A size above 256 is returned as
/// 1, which no frame has: such a frame ends by silence and is refused. Force-inlined: the direction is
/// constant at each call, so half of it is dropped (60 to 80 bytes).
template <typename Functions = public_functions>
[[nodiscard, gnu::always_inline]] constexpr std::size_t size_hint(direction dir, byte_view adu) noexcept
{
    std::size_t const size = length_by_rule<Functions>(dir, adu).size;
    return size > max_adu_size ? 1 : size;
}

/// What the length rules say of a frame with these bytes.
struct end_hint {
    std::size_t next;         ///< the size to apply them again at; 0 where only silence ends it
    bool is_here;             ///< whether it ends here, if its CRC is right
    bool is_response = false; ///< ... by the rule of responses
    bool is_open = false;     ///< ... and the size by the other rule is one byte more
};

/// Which rules a frame is under. For a receiver of responses to these functions: always one.
template <direction Way, typename Functions = public_functions> class foreign_exchange {
public:
    [[gnu::always_inline]] static constexpr end_hint apply(byte_view so_far) noexcept
    {
        std::size_t const size = size_hint<Functions>(Way, so_far);
        return {size, size == so_far.size()};
    }
    static constexpr bool is_expected(byte_view) noexcept { return false; }
    static constexpr void begin_frame() noexcept {}
    static constexpr void end_frame(bool) noexcept {}
    static constexpr bool takes(std::byte) noexcept { return false; }
};

/// For a receiver of requests, to others of any function.
template <typename Functions> class foreign_exchange<direction::request, Functions> {
public:
    /// A request to another unit passed; a function of 80 or above expects no response.
    constexpr void expect(std::uint8_t unit, std::uint8_t function) noexcept
    {
        unit_ = unit;
        function_ = function;
    }

    /// Whether the first bytes of a frame, two at least, may be those of the response.
    [[nodiscard]] constexpr bool is_expected(byte_view so_far) const noexcept
    {
        return to_u8(so_far[0]) == unit_ and (to_u8(so_far[1]) & ~exception_bit) == function_;
    }

    /// Applies the rule of requests, and where the response may have begun, that of responses as well.
    [[nodiscard, gnu::always_inline]] constexpr end_hint apply(byte_view so_far) const noexcept
    {
        std::size_t const size = so_far.size();
        std::size_t const request = rule_size(direction::request, so_far);
        if (not is_expected(so_far)) {
            return {request, request == size};
        }
        std::size_t const response = rule_size(direction::response, so_far);
        bool const may = may_be_request(so_far);
        bool const is_request = may and request == size;
        // A size already passed, or 0, wraps to a large distance.
        std::size_t const next = request - size - 1U < response - size - 1U ? request : response;
        return {next, is_request or response == size, not is_request, may and next == size + 1U};
    }

    /// The size by the rule of one direction; 0 where it gives none.
    static constexpr std::size_t rule_size(direction dir, byte_view so_far) noexcept { return size_hint(dir, so_far); }

    /// Whether a frame with these first bytes may be a request. One response in 65 536 has a right CRC where
    /// a request would have it; few of these hold a quantity that functions 01 to 04 allow.
    [[nodiscard]] constexpr bool may_be_request(byte_view so_far) const noexcept
    {
        constexpr std::uint8_t last_read = 4, last_bit_read = 2;
        constexpr std::size_t quantity_at = 4;
        constexpr std::uint8_t most_of_bits = 7, most = 0; // high bytes of 2000 and 125
        return function_ > last_read or so_far.size() <= quantity_at or
               to_u8(so_far[quantity_at]) <= (function_ > last_bit_read ? most : most_of_bits);
    }

    /// A frame begins.
    constexpr void begin_frame() noexcept { end_frame(false); }

    /// A frame ended at the size of a response, or at that of a request.
    constexpr void end_frame(bool is_response) noexcept { is_response_ = is_response; }

    /// Whether this byte, which follows at once, belongs to the frame: the CRC stays right with 00 only.
    constexpr bool takes(std::byte next) noexcept
    {
        bool const is_part = next == std::byte{0};
        is_response_ = is_response_ != is_part;
        return is_part;
    }

    /// Whether the last frame was the response.
    [[nodiscard]] constexpr bool is_response() const noexcept { return is_response_; }

private:
    std::uint8_t unit_{0};
    std::uint8_t function_{exception_bit};
    bool is_response_{false};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
