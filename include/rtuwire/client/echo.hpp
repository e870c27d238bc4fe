// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The echo of a transmission on a line that gives back what is sent.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>

namespace rtuwire {

/// Takes the octets of one transmission out of what is received.
class echo_check {
public:
    /// So many octets are sent.
    constexpr void expect(std::size_t size) noexcept
    {
        left_ = static_cast<std::uint16_t>(size);
        is_wrong_ = false;
    }

    /// Takes nothing from here on.
    constexpr void forget() noexcept { left_ = 0; }

    /// Whether an octet belongs to the echo; compares it with what was sent. None does after one that
    /// differs.
    constexpr bool take(std::byte octet, byte_view sent) noexcept
    {
        if (left_ == 0) {
            return false;
        }
        is_wrong_ = octet != sent[sent.size() - left_];
        left_ = is_wrong_ ? std::uint16_t{0} : static_cast<std::uint16_t>(left_ - 1);
        return true;
    }

    /// Whether an octet came back as another one.
    [[nodiscard]] constexpr bool is_wrong() const noexcept { return is_wrong_; }

private:
    std::uint16_t left_{0};
    bool is_wrong_{false};
};

} // namespace rtuwire
