// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Numbers of a capture file, in the byte order of the machine that wrote it, and the options of its blocks.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/trace.hpp>

namespace tool {

/// Reads numbers of a file. The caller has checked that they lie inside.
struct file_order {
    bool has_high_first{false};

    [[nodiscard]] constexpr std::uint16_t u16(rtuwire::byte_view bytes, std::size_t at) const noexcept
    {
        auto const first = std::to_integer<unsigned>(bytes[at]);
        auto const second = std::to_integer<unsigned>(bytes[at + 1]);
        return static_cast<std::uint16_t>(has_high_first ? first << 8U | second : second << 8U | first);
    }
    [[nodiscard]] constexpr std::uint32_t u32(rtuwire::byte_view bytes, std::size_t at) const noexcept
    {
        std::uint32_t const first = u16(bytes, at);
        std::uint32_t const second = u16(bytes, at + 2);
        return has_high_first ? first << 16U | second : second << 16U | first;
    }
    [[nodiscard]] constexpr std::uint64_t u64(rtuwire::byte_view bytes, std::size_t at) const noexcept
    {
        std::uint64_t const first = u32(bytes, at);
        std::uint64_t const second = u32(bytes, at + 4);
        return has_high_first ? first << 32U | second : second << 32U | first;
    }
};

/// The order of what a network carries, whatever the file's is.
inline constexpr file_order network_order{true};

/// The next multiple of four.
[[nodiscard]] constexpr std::size_t padded(std::size_t size) noexcept { return size + (0U - size) % 4U; }

/// Calls `take(code, value)` for each option; `take` says whether it is as it should be. False where one is not, or is
/// longer than the bytes. Options may end without the one that says so.
template <typename Take>
[[nodiscard]] constexpr bool for_each_option(file_order order, rtuwire::byte_view bytes, Take take) noexcept
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

} // namespace tool
