// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A frame as a listener gives it: when it began, and for a response the request that it answers. Knows no line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/traced_frame.hpp>
#include <rtuwire/wire/function.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// What a listener heard: a frame, or bytes that are none, or (`is_unanswered`, and then no bytes) that a request got
/// no response. Its views are valid until the listener is called again.
struct heard_frame {
    /// Its bytes, the time of its last byte, role and verdict. A request and a response that fit each other are `good`;
    /// a response after the time-out is `late`; an undamaged response without its request, and up to 3 bytes of noise,
    /// are `stray`; all else is `damaged`.
    traced_frame frame;
    /// When its first byte had arrived.
    instant first_byte{0};
    /// The request that this answers, or that was not answered: address to CRC. Empty otherwise. Damaged bytes that
    /// came in the place of a response have it, too.
    byte_view request{};
    /// From the end of that request to the start of the response; or until it was given up, in time or at the end of
    /// the next frame.
    duration response_time{};
    /// Whether the request got no undamaged response in time, or before the next request.
    bool is_unanswered{false};

    /// The request's bytes, be it the frame itself or the one that it answers; empty where it is not known.
    [[nodiscard]] constexpr byte_view asked() const noexcept
    {
        return frame.role == frame_role::request and not is_unanswered ? frame.bytes : request;
    }

    /// Which unit, 0 in a broadcast: of the request, or where that is not known, the first byte; 0 where there is none.
    [[nodiscard]] constexpr std::uint8_t unit() const noexcept { return head(0); }

    /// The function, exception bit removed; 0 where there is none.
    [[nodiscard]] constexpr function_code function() const noexcept
    {
        return static_cast<function_code>(head(1) & ~exception_bit & 0xFF);
    }

    /// Whether it is an undamaged refusal.
    [[nodiscard]] constexpr bool is_exception() const noexcept
    {
        return frame.role == frame_role::response and frame.verdict != frame_verdict::damaged and
               (to_u8(frame.bytes[1]) & exception_bit) != 0;
    }

    /// The first register, coil or input that the request names; of function 23, the first to be read.
    [[nodiscard]] constexpr std::optional<std::uint16_t> start() const noexcept
    {
        return quantity() ? std::optional{u16_at(asked(), 2)} : std::nullopt;
    }

    /// How many the request names: those whose values the response holds, or that it says are written. Empty for
    /// functions that name none.
    [[nodiscard]] constexpr std::optional<std::uint16_t> quantity() const noexcept
    {
        constexpr std::size_t shortest = 8;
        if (asked().size() < shortest) {
            return std::nullopt;
        }
        constexpr function_code with_quantity[] = {function_code::read_coils,
                                                   function_code::read_discrete_inputs,
                                                   function_code::read_holding_registers,
                                                   function_code::read_input_registers,
                                                   function_code::write_multiple_coils,
                                                   function_code::write_multiple_registers,
                                                   function_code::read_write_multiple_registers};
        constexpr function_code of_one[] = {function_code::write_single_coil, function_code::write_single_register,
                                            function_code::mask_write_register};
        for (function_code const each : with_quantity) {
            if (function() == each) {
                return u16_at(asked(), 4);
            }
        }
        for (function_code const each : of_one) {
            if (function() == each) {
                return std::uint16_t{1};
            }
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] constexpr std::uint8_t head(std::size_t at) const noexcept
    {
        byte_view const from = asked().empty() ? frame.bytes : asked();
        return at < from.size() ? to_u8(from[at]) : std::uint8_t{0};
    }
};

} // namespace rtuwire
