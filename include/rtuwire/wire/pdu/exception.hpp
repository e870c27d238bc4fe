// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The exception response (AP 7): a server's refusal, with its code.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A refusal of `function`; 0 is allowed, since a server refuses that one like any other. `code` is any
/// number, listed in errc.hpp or not.
struct exception_response {
    static constexpr std::size_t max_size = 2;

    function_code function;
    std::uint8_t code;

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return to_u8(function) >= exception_bit ? errc::invalid_function : errc::none;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(std::uint32_t{to_u8(function)} | exception_bit);
        out.u8(code);
    }

    /// The code as an error; `unlisted_exception` where it is 0 or from 7F.
    [[nodiscard]] constexpr errc error() const noexcept { return exception_error(code); }

    /// Reads a PDU. Errors: `wrong_function` where the exception bit is not set, `wrong_length`.
    [[nodiscard]] static constexpr result<exception_response> decode(byte_view pdu) noexcept
    {
        if (pdu.empty() or (to_u8(pdu[0]) & exception_bit) == 0) {
            return errc::wrong_function;
        }
        if (pdu.size() != max_size) {
            return errc::wrong_length;
        }
        return exception_response{static_cast<function_code>(to_u8(pdu[0]) & 0x7FU), to_u8(pdu[1])};
    }

    friend constexpr bool operator==(exception_response const&, exception_response const&) = default;
};

} // namespace rtuwire
