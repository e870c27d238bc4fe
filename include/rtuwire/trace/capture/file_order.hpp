// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Numbers of a capture file, in the byte order of the machine that wrote it, and the options of its blocks.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Reads numbers of a file. The caller has checked that they lie inside.
struct file_order {
    bool has_high_first{false};

    [[nodiscard]] constexpr std::uint16_t u16(byte_view bytes, std::size_t at) const noexcept
    {
        return has_high_first ? to_u16(bytes[at], bytes[at + 1]) : to_u16(bytes[at + 1], bytes[at]);
    }
    [[nodiscard]] constexpr std::uint32_t u32(byte_view bytes, std::size_t at) const noexcept
    {
        std::uint32_t const first = u16(bytes, at);
        std::uint32_t const second = u16(bytes, at + 2);
        return has_high_first ? first << 16U | second : second << 16U | first;
    }
    [[nodiscard]] constexpr std::uint64_t u64(byte_view bytes, std::size_t at) const noexcept
    {
        std::uint64_t const first = u32(bytes, at);
        std::uint64_t const second = u32(bytes, at + 4);
        return has_high_first ? first << 32U | second : second << 32U | first;
    }
};

/// The next multiple of four.
[[nodiscard]] constexpr std::size_t padded(std::size_t size) noexcept { return size + (0U - size) % 4U; }

/// Calls `take(code, value)` for each option; `take` says whether it is as it should be. False where one is not, or is
/// longer than the bytes. Options may end without the one that says so.
template <typename Take>
[[nodiscard]] constexpr bool for_each_option(file_order order, byte_view bytes, Take take) noexcept
{
    while (bytes.size() >= 4) {
        std::uint16_t const code = order.u16(bytes, 0);
        std::size_t const size = order.u16(bytes, 2);
        if (code == 0) {
            return true;
        }
        if (padded(size) > bytes.size() - 4 or not take(code, bytes.subspan(4, size))) {
            return false;
        }
        bytes = bytes.subspan(4 + padded(size));
    }
    return true;
}

} // namespace rtuwire
