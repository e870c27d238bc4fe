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
    constexpr void expect(std::size_t size) noexcept { left_ = static_cast<std::uint16_t>(size); }

    /// Takes nothing from here on.
    constexpr void forget() noexcept { left_ = 0; }

    /// Whether the next octet belongs to the echo.
    [[nodiscard]] constexpr bool is_due() const noexcept { return left_ != 0; }

    /// Takes an octet of the echo. Whether it is the one that was sent; after one that is not, none is
    /// due.
    constexpr bool take(std::byte octet, byte_view sent) noexcept
    {
        bool const is_same = octet == sent[sent.size() - left_];
        left_ = is_same ? static_cast<std::uint16_t>(left_ - 1) : std::uint16_t{0};
        return is_same;
    }

private:
    std::uint16_t left_{0};
};

} // namespace rtuwire
