// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a receiver of requests knows of the exchanges between others: after a request to another unit
// its answer may come, which the length rules of requests would misread. A receiver of answers knows
// nothing of the kind, and pays nothing for it.
#pragma once

#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/wire/frame_length.hpp>
#include <rtuwire/wire/function.hpp>

namespace rtuwire {

/// For a receiver of answers.
template <direction Way> class exchange_of_others {
public:
    static constexpr bool answers(byte_view) noexcept { return false; }
    static constexpr void begin_frame() noexcept {}
    static constexpr void end_frame(bool) noexcept {}
};

/// For a receiver of requests.
template <> class exchange_of_others<direction::request> {
public:
    /// A request to another unit passed.
    constexpr void expect(std::uint8_t unit, std::uint8_t function) noexcept
    {
        unit_ = unit;
        function_ = function;
        is_open_ = true;
    }

    /// Whether the first octets of a frame, two at least, are those of the answer.
    [[nodiscard]] constexpr bool answers(byte_view so_far) const noexcept
    {
        return is_open_ and to_u8(so_far[0]) == unit_ and
               (to_u8(so_far[1]) & ~exception_bit) == function_;
    }

    /// A frame begins.
    constexpr void begin_frame() noexcept { has_ended_ = false; }

    /// A whole frame ended, which was the answer, or was not.
    constexpr void end_frame(bool is_answer) noexcept
    {
        has_ended_ = is_answer;
        is_open_ = is_open_ and not is_answer;
    }

    /// Whether the frame that ended last was the answer.
    [[nodiscard]] constexpr bool has_ended() const noexcept { return has_ended_; }

private:
    std::uint8_t unit_{0};
    std::uint8_t function_{0};
    bool is_open_{false};
    bool has_ended_{false};
};

} // namespace rtuwire
