// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Whether a frame answers a request. RTU frames carry no transaction number, so every field that the response
// repeats is compared with the request that was sent: unit, function, byte count, address, quantity and
// value.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/frame_length.hpp>
#include <rtuwire/wire/pdu/device_identification.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Whether the first `size` bytes of the response are those of the request.
/// Internal.
[[nodiscard]] constexpr bool repeats(byte_view request_pdu, byte_view response_pdu, std::size_t size) noexcept
{
    return request_pdu.size() >= size and same_bytes(request_pdu.first(size), response_pdu.first(size));
}

/// The size of the longest response to a request, an ADU; final where the response's bytes tell its end, so
/// that no silence need follow. Where the request does not tell the size it is the largest possible.
/// Internal.
[[nodiscard]] constexpr length_hint longest_response(byte_view request_adu) noexcept
{
    std::uint8_t const code = to_u8(request_adu[1]);
    std::uint8_t const rule = length_rules::of(direction::response, code);
    auto const kind = static_cast<length_rule>(rule & length_rules::kind_bits);
    std::size_t size = max_adu_size;
    bool tells_end = kind != length_rule::none;
    if (kind == length_rule::fixed) {
        size = rule & ~length_rules::kind_bits & 0xFF;
    } else if (kind == length_rule::subfunction) {
        size = request_adu.size();
        tells_end = u16_at(request_adu, 2) != 0;
    } else if (kind == length_rule::mei) {
        tells_end = to_u8(request_adu[2]) == identification_mei_type;
    } else if (request_adu.size() >= 8 and (code == to_u8(function_code::read_holding_registers) or
                                            code == to_u8(function_code::read_write_multiple_registers))) {
        std::size_t const quantity = u16_at(request_adu, 4);
        size = quantity <= max_read_quantity ? 5U + 2U * quantity : max_adu_size;
    }
    return {size, tells_end};
}

/// The size alone.
/// Internal.
[[nodiscard]] constexpr std::size_t response_size(byte_view request_adu) noexcept
{
    return longest_response(request_adu).size();
}

/// Compares a page of identification with its request.
/// Internal.
[[nodiscard]] constexpr errc check_identification(byte_view request_pdu, byte_view response_pdu) noexcept
{
    constexpr std::size_t count_at = 6;
    constexpr std::size_t first_id_at = device_identification::head_size;
    if (errc const wrong = device_identification::check_page(response_pdu); wrong != errc::none) {
        return wrong;
    }
    // A stream may start at another object than the one requested; a single object is the one requested.
    bool const is_single = to_u8(request_pdu[2]) == static_cast<std::uint8_t>(identification_access::single);
    bool const is_other =
        request_pdu[2] != response_pdu[2] or
        (is_single and (to_u8(response_pdu[count_at]) != 1 or response_pdu[first_id_at] != request_pdu[3]));
    return is_other ? errc::response_mismatch : errc::none;
}

/// Compares the fields of a normal response with its request; both PDUs are of one function. Inlined in
/// `check_response`, where it is smaller than a separate function.
/// Internal.
[[nodiscard, gnu::always_inline]] constexpr errc check_fields(byte_view request_pdu, byte_view response_pdu) noexcept
{
    // A raw request may be shorter than its function allows; then there is nothing to compare with.
    if (request_pdu.size() < read_device_identification::max_size) {
        return errc::none;
    }
    std::size_t size = 5;    // of the response
    std::size_t same = size; // bytes that are those of the request
    switch (static_cast<function_code>(to_u8(request_pdu[0]))) {
    case function_code::read_holding_registers:
    case function_code::read_write_multiple_registers: {
        std::uint32_t const bytes = request_pdu.size() < 5 ? 0U : std::uint32_t{2} * u16_at(request_pdu, 3);
        bool const fits = response_pdu.size() == 2 + bytes and to_u8(response_pdu[1]) == bytes;
        return fits ? errc::none : errc::wrong_length;
    }
    case function_code::write_single_register:
    case function_code::write_multiple_registers: break;
    case function_code::diagnostics:
        size = request_pdu.size();
        same = repeats_data(static_cast<subfunction>(u16_at(request_pdu, 1))) ? size : 3;
        break;
    case function_code::encapsulated_interface:
        return to_u8(request_pdu[1]) == identification_mei_type ? check_identification(request_pdu, response_pdu)
                                                                : errc::none;
    default: return errc::none;
    }
    if (response_pdu.size() != size) {
        return errc::wrong_length;
    }
    return repeats(request_pdu, response_pdu, same) ? errc::none : errc::response_mismatch;
}

/// Whether `response`, whose CRC was right, answers the request in `request_adu`, a frame that was encoded
/// here. The error is the exception when the server refused; `line_echo` when the frame is the request
/// itself; `wrong_unit`, `wrong_function`, `wrong_length`, `response_mismatch` or `malformed` when it does
/// not answer the request.
[[nodiscard]] constexpr errc check_response(byte_view const& request_adu, adu const& response) noexcept
{
    if (response.unit() != to_u8(request_adu[0])) {
        return errc::wrong_unit;
    }
    byte_view const request_pdu = pdu_of(request_adu);
    byte_view const response_pdu = response.pdu();
    if (to_u8(response.function()) != to_u8(request_pdu[0])) {
        return errc::wrong_function;
    }
    if (response.is_exception()) {
        return response_pdu.size() == 2 ? exception_error(to_u8(response_pdu[1])) : errc::wrong_length;
    }
    errc const wrong = check_fields(request_pdu, response_pdu);
    bool const is_own = wrong != errc::none and same_bytes(request_adu, response.bytes());
    return is_own ? errc::line_echo : wrong;
}

} // namespace rtuwire
