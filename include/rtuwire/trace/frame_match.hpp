// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Whether bytes begin with a frame, for somebody who takes no part in the exchange: as a request, as the response to a
// request that passed, or as a response alone. A frame is whole where its length rule is met and the CRC is right.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/traced_frame.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/response.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// What bytes turned out to be.
struct frame_match {
    enum class outcome : std::uint8_t {
        refuted, ///< no frame begins here
        open,    ///< more bytes, or silence, have to tell
        whole,
    };

    outcome is{outcome::refuted};
    std::size_t size{0};
    frame_role role{frame_role::unknown};
    bool is_verified{false}; ///< a response that fits its request in all fields

    [[nodiscard]] constexpr bool is_whole() const noexcept { return is == outcome::whole; }
    [[nodiscard]] constexpr bool is_open() const noexcept { return is == outcome::open; }
};

/// Whether so many bytes are a frame with a right CRC.
[[nodiscard]] constexpr bool has_right_crc(byte_view bytes) noexcept { return check_frame(bytes) == errc::none; }

/// Whether this is a loopback of two bytes (08, sub-function 0), as nearly all are. It may have any size, so it has no
/// rule, and an adapter shows no silence behind it.
[[nodiscard]] constexpr bool is_usual_loopback(byte_view bytes) noexcept
{
    constexpr std::size_t size = 8;
    return bytes.size() >= size and to_u8(bytes[1]) == to_u8(function_code::diagnostics) and u16_at(bytes, 2) == 0 and
           has_right_crc(bytes.first(size));
}

/// What the rule of one direction says of the first bytes; without a rule, only silence tells.
[[nodiscard]] constexpr frame_match match_by_rule(direction way, byte_view bytes) noexcept
{
    frame_match found{frame_match::outcome::open, 0,
                      way == direction::request ? frame_role::request : frame_role::response};
    length_hint const told = is_usual_loopback(bytes) ? length_hint{8, true} : frame_length(way, bytes);
    found.size = told.is_final() ? told.size() : std::size_t{0};
    if (not told.is_final() or told.size() > bytes.size()) {
        return found;
    }
    found.is = has_right_crc(bytes.first(told.size())) ? frame_match::outcome::whole : frame_match::outcome::refuted;
    return found;
}

/// Whether the first two bytes are those of a response to a request.
[[nodiscard]] constexpr bool begins_response(byte_view bytes, byte_view request) noexcept
{
    return bytes.size() >= 2 and request.size() >= 2 and bytes[0] == request[0] and
           (to_u8(bytes[1]) & ~exception_bit & 0xFF) == to_u8(request[1]);
}

/// Whether a frame with a right CRC answers a request, be it by an exception.
[[nodiscard]] constexpr bool answers(byte_view request, byte_view bytes) noexcept
{
    if (request.size() < min_adu_size or not begins_response(bytes, request)) {
        return false;
    }
    errc const found = check_response(request, adu{bytes});
    // Of functions whose response repeats the request, it looks like an echo.
    return found == errc::none or is_exception(found);
}

/// The same bytes as a response to a request.
[[nodiscard]] constexpr frame_match match_response(byte_view bytes, byte_view request) noexcept
{
    if (not begins_response(bytes, request)) {
        return {};
    }
    frame_match found = match_by_rule(direction::response, bytes);
    found.is_verified = found.is_whole() and answers(request, bytes.first(found.size));
    return found;
}

/// Whether a response that is not whole yet has the size that its request asked for, or the size of an exception.
[[nodiscard]] constexpr bool has_size_asked_for(frame_match const& response, byte_view request) noexcept
{
    length_hint const expected = longest_response(request);
    return response.size == 0 or response.size == expected.size() or not expected.is_final() or
           response.size == exception_adu_size;
}

/// Whether nothing in the first bytes of a request contradicts a quantity that the specification allows.
[[nodiscard]] constexpr bool is_plausible_request(byte_view bytes) noexcept
{
    constexpr std::size_t counted = 7;
    constexpr std::size_t counted_exchange = 11;
    auto const allows = [&](std::size_t most) { return bytes.size() < 6 or is_quantity(u16_at(bytes, 4), most); };
    auto const counts = [&](std::size_t size, std::size_t bits) {
        return bytes.size() < size or to_u8(bytes[size - 1]) == bytes_of_bits(bits * u16_at(bytes, size - 3));
    };
    constexpr std::size_t bits_of_register = 16;
    switch (to_u8(bytes[1])) {
    case to_u8(function_code::read_coils):
    case to_u8(function_code::read_discrete_inputs): return allows(max_bit_quantity);
    case to_u8(function_code::read_holding_registers):
    case to_u8(function_code::read_input_registers): return allows(max_read_quantity);
    case to_u8(function_code::write_multiple_coils): return counts(counted, 1);
    case to_u8(function_code::write_multiple_registers): return counts(counted, bits_of_register);
    case to_u8(function_code::read_write_multiple_registers):
        return allows(max_exchange_read_quantity) and counts(counted_exchange, bits_of_register);
    default: return true;
    }
}

/// A whole response, or the request that it may be if one more byte, 00, belongs to it: a CRC that ends with 00 is right
/// one byte before its end, too. Behind a response, that 00 is the address of a broadcast.
[[nodiscard]] constexpr frame_match response_or_longer(byte_view bytes, frame_match const& response,
                                                       frame_match const& request, bool is_over) noexcept
{
    if (request.size != response.size + 1 or not is_plausible_request(bytes)) {
        return response;
    }
    if (request.is_open()) {
        return is_over ? response : request;
    }
    if (not request.is_whole()) {
        return response;
    }
    frame_match const broadcast = match_by_rule(direction::request, bytes.subspan(response.size));
    bool const has_rule = frame_length(direction::request, bytes.subspan(response.size)).size() != 0;
    if (broadcast.is_open() and has_rule and not is_over) {
        return broadcast;
    }
    return broadcast.is_whole() ? response : request;
}

/// The bytes as a request.
[[nodiscard]] constexpr frame_match match_request(byte_view bytes) noexcept
{
    return (to_u8(bytes[1]) & exception_bit) == 0 ? match_by_rule(direction::request, bytes) : frame_match{};
}

/// What begins here, where `pending` is the request that waits for its response, or empty; `is_over`: no byte will
/// follow these.
[[nodiscard]] constexpr frame_match match_frame(byte_view bytes, byte_view pending, bool is_over) noexcept
{
    if (bytes.size() < 2) {
        return {frame_match::outcome::open};
    }
    frame_match const response = match_response(bytes, pending);
    frame_match const request = match_request(bytes);
    if (response.is_verified) {
        return response_or_longer(bytes, response, request, is_over);
    }
    if (response.is_open() and has_size_asked_for(response, pending)) {
        return response;
    }
    if (request.is_whole()) {
        return request;
    }
    // The first bytes of a request may have the CRC of a response: 16 and 8 bytes of its head.
    frame_match const alone = match_by_rule(direction::response, bytes);
    bool const must_wait = not is_over and request.is_open() and is_plausible_request(bytes);
    return (alone.is_whole() and not must_wait) or not request.is_open() ? alone : request;
}

/// Whether a frame may be the response to a damaged request: of its unit and function, or the same but for two bytes, or
/// where only the end of the request was heard, with the same end.
[[nodiscard]] constexpr bool resembles(byte_view frame, byte_view damaged) noexcept
{
    constexpr std::size_t most_different = 2;
    if (damaged.size() < min_adu_size or to_u8(frame[0]) == 0) {
        return false;
    }
    if (damaged[0] == frame[0] and damaged[1] == frame[1]) {
        return true;
    }
    if (damaged.size() > frame.size()) {
        return false;
    }
    byte_view const end = frame.last(damaged.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < end.size(); ++i) {
        different += damaged[i] == end[i] ? 0U : 1U;
    }
    return different == 0 or (different <= most_different and damaged.size() == frame.size());
}

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
