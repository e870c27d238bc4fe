// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The echo of a transmission on a line that gives back what is sent.
#pragma once

#include <cstddef>

#include <rtuwire/core/bytes.hpp>

namespace rtuwire {

/// Takes the octets of one transmission out of what is received.
class echo_check {
public:
    /// What was sent; it outlives the check.
    constexpr void expect(byte_view sent) noexcept
    {
        rest_ = sent;
        is_wrong_ = false;
    }

    /// Takes nothing from here on.
    constexpr void forget() noexcept { rest_ = {}; }

    /// Compares; how many of the octets belong to the echo. Nothing more after one that differs.
    constexpr std::size_t take(byte_view octets) noexcept
    {
        std::size_t count = 0;
        while (count < octets.size() and not rest_.empty()) {
            is_wrong_ = octets[count] != rest_[0];
            rest_ = is_wrong_ ? byte_view{} : rest_.subspan(1);
            ++count;
        }
        return count;
    }

    /// Whether an octet came back as another one.
    [[nodiscard]] constexpr bool is_wrong() const noexcept { return is_wrong_; }

private:
    byte_view rest_{};
    bool is_wrong_{false};
};

} // namespace rtuwire
