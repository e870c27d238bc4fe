// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 65, which nobody has: it doubles a number.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The response to function 65.
struct double_number_response {
    static constexpr function_code code = static_cast<function_code>(65);
    static constexpr std::size_t max_size = 3;

    std::uint16_t doubled; ///< modulo 65536

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(detail::to_u8(code));
        out.u16(doubled);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<double_number_response> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = detail::check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return double_number_response{detail::u16_at(pdu, 1)};
    }
};

/// Has a number doubled by one unit.
struct double_number {
    using response = double_number_response;
    static constexpr function_code code = response::code;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::fixed, 6),
                                               detail::sized(detail::length_rule::fixed, 6), detail::answer_rule::own};
    static constexpr std::size_t max_size = 3;

    std::uint16_t number;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(detail::to_u8(code));
        out.u16(number);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<double_number> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = detail::check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return double_number{detail::u16_at(pdu, 1)};
    }

    /// Whether the number is the double of the one that was sent.
    /// Internal.
    [[nodiscard]] static constexpr errc check_response(byte_view request_pdu, byte_view response_pdu) noexcept
    {
        auto const told = response::decode(response_pdu);
        if (not told) {
            return told.error();
        }
        return told->doubled == twice(detail::u16_at(request_pdu, 1)) ? errc::none : errc::response_mismatch;
    }

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const&) noexcept
    {
        auto const asked = decode(pdu.view());
        if (not asked) {
            return errc::illegal_data_value;
        }
        detail::put_u16(&pdu.bytes[1], twice(asked->number));
        return errc::none;
    }

private:
    static constexpr std::uint16_t twice(std::uint16_t number) noexcept
    {
        return static_cast<std::uint16_t>(2U * number);
    }
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
