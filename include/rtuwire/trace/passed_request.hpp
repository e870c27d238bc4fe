// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A request that passed on a line, kept for its response.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::detail {

/// Internal: the bytes of one frame, or none, and when it ended.
class passed_request {
public:
    constexpr void note(byte_view bytes, instant end) noexcept
    {
        size_ = static_cast<std::uint16_t>(bytes.size());
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            bytes_[i] = bytes[i];
        }
        end_ = end;
    }
    constexpr void forget() noexcept { size_ = 0; }

    [[nodiscard]] constexpr bool is_any() const noexcept { return size_ != 0; }
    [[nodiscard]] constexpr byte_view bytes() const noexcept { return byte_view{bytes_}.first(size_); }
    [[nodiscard]] constexpr instant end() const noexcept { return end_; }

private:
    std::array<std::byte, max_adu_size> bytes_{};
    std::uint16_t size_{0};
    instant end_{0};
};

} // namespace rtuwire::detail
