// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Any other function: a code and octets that mean nothing here.
#pragma once

#include <rtuwire/wire/adu.hpp>

namespace rtuwire {

/// A request or response of a function that rtuwire does not know. It goes to one unit, because only
/// its sender knows whether it asks a question.
struct raw_pdu {
    using response = raw_pdu;
    static constexpr std::size_t max_size = max_pdu_size;

    function_code function; ///< 1..127
    byte_view data;         ///< up to 252 octets, owned by somebody else

    [[nodiscard]] constexpr errc check() const noexcept
    {
        if (to_u8(function) == 0 or to_u8(function) >= exception_bit) {
            return errc::invalid_function;
        }
        return size() > max_pdu_size ? errc::frame_too_long : errc::none;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return 1 + data.size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(to_u8(function));
        out.bytes(data);
    }

    /// Reads a PDU. Errors: `wrong_length` when empty, `invalid_function` outside 1..127.
    [[nodiscard]] static constexpr result<raw_pdu> decode(byte_view pdu) noexcept
    {
        if (pdu.empty()) {
            return errc::wrong_length;
        }
        raw_pdu const read{static_cast<function_code>(to_u8(pdu[0])), pdu.subspan(1)};
        if (errc const wrong = read.check(); wrong != errc::none) {
            return wrong;
        }
        return read;
    }

    friend constexpr bool operator==(raw_pdu const& left, raw_pdu const& right) noexcept
    {
        return left.function == right.function and same_bytes(left.data, right.data);
    }
};

} // namespace rtuwire
