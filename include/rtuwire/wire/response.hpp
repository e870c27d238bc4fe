// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Whether a frame answers a request. RTU frames carry no transaction number, so every field that the response
// repeats is compared with the request that was sent: unit, function, byte count, address, quantity and
// value.
#pragma once

#include <array>
#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/functions.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// How the functions that have codes up to 24 answer, one byte each.
template <typename... Functions>
[[nodiscard]] consteval std::array<answer_rule, length_rules::in_table> answers_of(function_list<Functions...>) noexcept
{
    std::array<answer_rule, length_rules::in_table> answers{};
    ((length_rules::is_in_table<Functions>
          ? static_cast<void>(answers[to_u8(function_row<Functions>::code) % length_rules::in_table] =
                                  function_row<Functions>::rules.answers)
          : static_cast<void>(0)),
     ...);
    return answers;
}
template <typename Functions> inline constexpr auto answer_rules = answers_of(Functions{});

/// How a function answers that is not in the table.
template <typename... Functions>
[[nodiscard]] constexpr answer_rule answer_of_others(function_list<Functions...>, std::uint8_t code) noexcept
{
    answer_rule rule = answer_rule::unknown;
    ((rule = not length_rules::is_in_table<Functions> and code == to_u8(function_row<Functions>::code)
                 ? function_row<Functions>::rules.answers
                 : rule),
     ...);
    return rule;
}

/// How the function with this code answers.
template <typename Functions>
[[nodiscard, gnu::always_inline]] constexpr answer_rule answer_of(std::uint8_t code) noexcept
{
    return code < length_rules::in_table ? answer_rules<Functions>[code] : answer_of_others(Functions{}, code);
}

/// Whether the quantity of a request gives the size of its response.
[[nodiscard]] constexpr bool counts_by_quantity(answer_rule rule) noexcept
{
    return rule == answer_rule::registers or rule == answer_rule::bits;
}

/// The bytes behind the byte count of a response that answers a quantity; 0 for another rule.
[[nodiscard]] constexpr std::size_t answer_bytes(answer_rule rule, std::size_t quantity) noexcept
{
    return rule == answer_rule::registers ? 2 * quantity : rule == answer_rule::bits ? bytes_of_bits(quantity) : 0;
}

/// Of the functions with this code that repeat part of a request: how many bytes of it.
template <typename... Functions>
[[nodiscard]] constexpr std::size_t repeated_by(function_list<Functions...>, std::uint8_t code,
                                                byte_view request_pdu) noexcept
{
    std::size_t found = 0;
    auto const ask = [&]<typename Function>(std::type_identity<Function>) {
        if constexpr (function_row<Function>::rules.answers == answer_rule::partly) {
            found = code == to_u8(function_row<Function>::code) ? function_row<Function>::repeated(request_pdu) : found;
        }
    };
    (ask(std::type_identity<Functions>{}), ...);
    return found;
}

/// The shortest request PDU with which the check of a function's own compares: any, where the format is one's own.
template <typename Function> [[nodiscard]] constexpr std::size_t shortest_checked_by(std::size_t usual) noexcept
{
    constexpr std::size_t most = function_row<Function>::max_size;
    return has_own_format<Function> ? 1 : most < usual ? most : usual;
}

/// The shortest request PDU with which a response may be compared: 4 bytes, or the shortest request of a function that
/// has a check of its own.
template <typename... Functions>
[[nodiscard]] consteval std::size_t shortest_checked(function_list<Functions...>, std::size_t usual) noexcept
{
    std::size_t shortest = usual;
    auto const ask = [&]<typename Function>(std::type_identity<Function>) {
        if constexpr (function_row<Function>::rules.answers == answer_rule::own) {
            shortest = shortest_checked_by<Function>(shortest);
        }
    };
    (ask(std::type_identity<Functions>{}), ...);
    return shortest;
}

/// What the function with this code finds that has a check of its own.
template <typename... Functions>
[[nodiscard]] constexpr errc check_by_own(function_list<Functions...>, std::uint8_t code, byte_view request_pdu,
                                          byte_view response_pdu) noexcept
{
    errc found = errc::none;
    constexpr std::size_t usual = 4;
    constexpr bool is_usual = shortest_checked(function_list<Functions...>{}, usual) == usual;
    auto const ask = [&]<typename Function>(std::type_identity<Function>) {
        if constexpr (function_row<Function>::rules.answers == answer_rule::own) {
            constexpr std::size_t least = shortest_checked_by<Function>(usual);
            if (code == to_u8(function_row<Function>::code) and (is_usual or request_pdu.size() >= least)) {
                found = function_row<Function>::check_response(request_pdu, response_pdu);
            }
        }
    };
    (ask(std::type_identity<Functions>{}), ...);
    return found;
}

/// Whether the response to a request tells its own end, of the functions that have a length of their own.
template <typename... Functions>
[[nodiscard]] constexpr bool tells_end_by_own(function_list<Functions...>, byte_view request_adu) noexcept
{
    bool tells = false;
    auto const ask = [&]<typename Function>(std::type_identity<Function>) {
        if constexpr (length_rules::has_own<Function>) {
            bool const is_only = (int{length_rules::has_own<Functions>} + ...) == 1;
            bool const is_it = is_only or to_u8(request_adu[1]) == to_u8(function_row<Function>::code);
            tells = is_it ? function_row<Function>::tells_end(request_adu) : tells;
        }
    };
    (ask(std::type_identity<Functions>{}), ...);
    return tells;
}

/// Of the functions with this code that tell the size of the response to a request: that size, or the largest possible.
template <typename... Functions>
[[nodiscard]] constexpr std::size_t longest_by_own(function_list<Functions...>, std::uint8_t code,
                                                   byte_view request_adu) noexcept
{
    std::size_t size = max_adu_size;
    auto const ask = [&]<typename Function>(std::type_identity<Function>) {
        if constexpr (requires { function_row<Function>::longest_response(request_adu); }) {
            size = code == to_u8(function_row<Function>::code) ? function_row<Function>::longest_response(request_adu)
                                                               : size;
        }
    };
    (ask(std::type_identity<Functions>{}), ...);
    return size;
}

/// Whether a function that has a length of its own tells the size of its longest response.
template <typename... Functions> [[nodiscard]] consteval bool tells_longest_by_own(function_list<Functions...>) noexcept
{
    return (has_own_format<Functions> or ...);
}

/// The size of the longest response to a request, an ADU; final where the response's bytes tell its end, so
/// that no silence need follow. Where the request does not tell the size it is the largest possible.
template <typename Functions = public_functions>
[[nodiscard]] constexpr length_hint longest_response(byte_view request_adu) noexcept
{
    std::uint8_t const code = to_u8(request_adu[1]);
    std::uint8_t const rule = length_rules::of<Functions>(direction::response, code);
    auto const kind = static_cast<length_rule>(rule & length_rule_bits);
    std::size_t size = max_adu_size;
    bool tells_end = kind != length_rule::none;
    if (kind == length_rule::fixed) {
        size = size_in(rule);
    } else if (kind == length_rule::subfunction) {
        size = request_adu.size();
        tells_end = u16_at(request_adu, 2) != 0;
    } else if (kind == length_rule::own) {
        tells_end = tells_end_by_own(Functions{}, request_adu);
        if constexpr (tells_longest_by_own(Functions{})) {
            size = longest_by_own(Functions{}, code, request_adu);
        }
    } else if (request_adu.size() >= 8) {
        constexpr std::size_t most = 250; // 125 registers, 2000 bits
        answer_rule const counts = answer_of<Functions>(code);
        if (counts == answer_rule::whole) {
            size = request_adu.size();
        } else if (counts_by_quantity(counts)) {
            std::size_t const bytes = answer_bytes(counts, u16_at(request_adu, 4));
            size = bytes <= most ? 5U + bytes : max_adu_size;
        } else {
            size = longest_by_own(Functions{}, code, request_adu);
        }
    }
    return {size, tells_end};
}

/// The size alone.
template <typename Functions = public_functions>
[[nodiscard]] constexpr std::size_t response_size(byte_view request_adu) noexcept
{
    return longest_response<Functions>(request_adu).size();
}

/// How many bytes a response should have: what its request gives, else what its own first bytes give; 0 where neither does.
template <typename Functions = public_functions>
[[nodiscard]] constexpr std::size_t due_size(byte_view request_adu, byte_view response_adu) noexcept
{
    length_hint const by_frame = frame_length<Functions>(direction::response, response_adu);
    bool const is_refusal = response_adu.size() > 1 and (to_u8(response_adu[1]) & exception_bit) != 0;
    std::size_t const by_request = is_refusal ? max_adu_size : response_size<Functions>(request_adu);
    return by_request != max_adu_size ? by_request : by_frame.is_final() ? by_frame.size() : 0;
}

/// Compares the fields of a normal response with its request; both PDUs are of one function. Inlined in
/// `check_response`, where it is smaller than a separate function.
template <typename Functions = public_functions>
[[nodiscard, gnu::always_inline]] constexpr errc check_fields(byte_view request_pdu, byte_view response_pdu) noexcept
{
    // A raw request may be shorter than its function allows; then there is nothing to compare with.
    constexpr std::size_t usual = 4;
    constexpr std::size_t shortest = shortest_checked(Functions{}, usual);
    if (request_pdu.size() < shortest) {
        return errc::none;
    }
    std::uint8_t const code = to_u8(request_pdu[0]);
    std::size_t size = 5;    // of the response
    std::size_t same = size; // bytes that are those of the request
    answer_rule const rule = answer_of<Functions>(code);
    if (shortest < usual and rule != answer_rule::own and request_pdu.size() < usual) {
        return errc::none;
    }
    if (counts_by_quantity(rule)) {
        std::size_t const bytes = request_pdu.size() < size ? 0 : answer_bytes(rule, u16_at(request_pdu, 3));
        bool const fits = response_pdu.size() == 2 + bytes and to_u8(response_pdu[1]) == bytes;
        return fits ? errc::none : errc::wrong_length;
    }
    if (rule != answer_rule::head) {
        size = request_pdu.size();
        same = rule == answer_rule::whole ? size : repeated_by(Functions{}, code, request_pdu);
        if (same == 0) {
            return check_by_own(Functions{}, code, request_pdu, response_pdu);
        }
    }
    if (response_pdu.size() != size) {
        return errc::wrong_length;
    }
    return repeats(request_pdu, response_pdu, same) ? errc::none : errc::response_mismatch;
}

} // namespace detail

/// Whether `response`, whose CRC was right, answers the request in `request_adu`, a frame that was encoded
/// here. The error is the exception when the server refused; `line_echo` when the frame is the request
/// itself; `wrong_unit`, `wrong_function`, `wrong_length`, `response_mismatch` or `malformed` when it does
/// not answer the request. Of a request whose function is not among `Functions` nothing but unit and function is compared.
template <typename Functions = public_functions>
[[nodiscard]] constexpr errc check_response(byte_view const& request_adu, adu const& response) noexcept
{
    if (response.unit() != detail::to_u8(request_adu[0])) {
        return errc::wrong_unit;
    }
    byte_view const request_pdu = detail::pdu_of(request_adu);
    byte_view const response_pdu = response.pdu();
    if (detail::to_u8(response.function()) != detail::to_u8(request_pdu[0])) {
        return errc::wrong_function;
    }
    if (response.is_exception()) {
        return response_pdu.size() == 2 ? detail::exception_error(detail::to_u8(response_pdu[1])) : errc::wrong_length;
    }
    errc const wrong = detail::check_fields<Functions>(request_pdu, response_pdu);
    // A request for bits may look like its own response: 01 01 03 00 00 11 begins one of three bytes. Where nothing is
    // compared, any request does.
    bool const is_doubtful =
        wrong != errc::none or detail::answer_of<Functions>(detail::to_u8(request_pdu[0])) >= detail::answer_rule::bits;
    bool const is_own = is_doubtful and detail::same_bytes(request_adu, response.bytes());
    return is_own ? errc::line_echo : wrong;
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
