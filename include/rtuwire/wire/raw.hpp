// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// PDUs of no one function: the exception response (AP 7), a server's refusal with its code; and any other function, a
// code and bytes that are not interpreted.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/functions.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// A refusal of `function`; 0 is allowed, since a server refuses that one like any other. `code` is any
/// number, listed in errc.hpp or not.
struct exception_response {
    static constexpr std::size_t max_size = 2;

    function_code function;
    std::uint8_t code;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return detail::to_u8(function) >= detail::exception_bit ? errc::invalid_function : errc::none;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(std::uint32_t{detail::to_u8(function)} | detail::exception_bit);
        out.u8(code);
    }

    /// The code as an error; `unlisted_exception` where it is 0 or from 7F.
    [[nodiscard]] constexpr errc error() const noexcept { return detail::exception_error(code); }

    /// Reads a PDU. Errors: `wrong_function` where the exception bit is not set, `wrong_length`.
    [[nodiscard]] static constexpr result<exception_response> decode(byte_view pdu) noexcept
    {
        if (pdu.empty() or (detail::to_u8(pdu[0]) & detail::exception_bit) == 0) {
            return errc::wrong_function;
        }
        if (pdu.size() != max_size) {
            return errc::wrong_length;
        }
        return exception_response{static_cast<function_code>(detail::to_u8(pdu[0]) & 0x7FU), detail::to_u8(pdu[1])};
    }

    friend constexpr bool operator==(exception_response const&, exception_response const&) = default;
};

namespace detail {

/// The most data bytes that a raw PDU can have.
template <typename Bytes> inline constexpr std::size_t raw_bytes_at_most = max_pdu_size - 1U;
template <std::size_t Size>
inline constexpr std::size_t raw_bytes_at_most<std::array<std::byte, Size>> =
    Size < max_pdu_size - 1U ? Size : max_pdu_size - 1U;

} // namespace detail

/// A request or response of a function that rtuwire does not know. It goes to one unit, because only the
/// caller knows whether it needs a response. Made of an array, it owns that array; made of a view, its bytes
/// are stored elsewhere.
template <typename Bytes = byte_view> struct raw_pdu {
    using response = raw_pdu<>;
    static constexpr std::size_t max_size = 1U + detail::raw_bytes_at_most<Bytes>;

    function_code function; ///< 1..127
    Bytes data;             ///< up to 252

    /// A function code and the bytes behind it.
    constexpr raw_pdu(function_code its_code, Bytes const& its_bytes) noexcept : function{its_code}, data{its_bytes} {}

    /// Not a view of a temporary, whose bytes are gone after the expression.
    template <std::size_t Size>
    raw_pdu(function_code code,
            std::array<std::byte, Size> const&& temporary) requires(std::same_as<Bytes, byte_view>) = delete;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        if (detail::to_u8(function) == 0 or detail::to_u8(function) >= detail::exception_bit) {
            return errc::invalid_function;
        }
        return size() > max_pdu_size ? errc::frame_too_long : errc::none;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 1 + data.size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(detail::to_u8(function));
        out.bytes(data);
    }

    /// Whether a response to function 20 has the runs of its request, and one to 24 as many registers as it counts: of
    /// other functions a client compares all that there is.
    /// Internal.
    [[nodiscard]] static constexpr errc check_response(byte_view request_pdu, byte_view response_pdu) noexcept
    {
        return detail::check_beside_client(public_functions{}, request_pdu, response_pdu);
    }

    /// Reads a PDU. Errors: `wrong_length` when empty, `invalid_function` outside 1..127.
    [[nodiscard]] static constexpr result<raw_pdu<>> decode(byte_view pdu) noexcept
    {
        if (pdu.empty()) {
            return errc::wrong_length;
        }
        return detail::checked_pdu(raw_pdu<>{static_cast<function_code>(detail::to_u8(pdu[0])), pdu.subspan(1)});
    }
};

raw_pdu(function_code, byte_view)->raw_pdu<>;
template <std::size_t Size> raw_pdu(function_code, std::array<std::byte, Size>) -> raw_pdu<std::array<std::byte, Size>>;

template <typename Left, typename Right>
constexpr bool operator==(raw_pdu<Left> const& left, raw_pdu<Right> const& right) noexcept
{
    return left.function == right.function and detail::same_bytes(left.data, right.data);
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
