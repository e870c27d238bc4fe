// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The echo of a transmission on a line that gives back what is sent.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Compares the received bytes with the bytes of one transmission, in their order.
class line_echo {
public:
    /// A transmission begins.
    constexpr void begin() noexcept { next_ = 1; }

    /// Expects no echo from here on.
    constexpr void end() noexcept { next_ = 0; }

    /// Whether the next byte may belong to the echo.
    [[nodiscard]] constexpr bool is_open() const noexcept { return next_ != 0; }

    /// Whether half of `size` bytes have come, and more are to come.
    [[nodiscard]] constexpr bool is_half(std::size_t size) const noexcept { return next_ > size / 2; }

    /// How many bytes have come, while more are to come.
    [[nodiscard]] constexpr std::size_t taken() const noexcept { return is_open() ? next_ - 1U : 0U; }

    /// Takes a byte while the echo is open. Returns whether it equals the byte that was sent; after one that differs,
    /// and after the last one, the echo is over.
    constexpr bool take(std::byte byte, byte_view sent) noexcept
    {
        bool const is_same = byte == sent[next_ - 1U];
        bool const is_last = next_ == sent.size();
        next_ = is_same and not is_last ? static_cast<std::uint16_t>(next_ + 1) : std::uint16_t{0};
        return is_same;
    }

private:
    std::uint16_t next_{0}; ///< the next byte's number, from 1; 0 where none is expected
};

} // namespace rtuwire
