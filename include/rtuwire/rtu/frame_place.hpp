// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Where a frame begins in the framer's memory.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// At the start. `Longest` is the size of the longest frame, 256 at most.
template <std::size_t Front, std::size_t Longest = max_adu_size> class frame_place {
public:
    static constexpr bool has_front = false;
    static constexpr std::size_t memory = Longest;
    [[nodiscard]] static constexpr std::uint16_t begin() noexcept { return 0; }
};

/// Behind other bytes at the front, up to 256: the frame begins at `Front`, or behind those bytes where they
/// are more. A frame has `Longest` bytes less what exceeds `Front`.
template <std::size_t Front, std::size_t Longest>
    requires(Front > 0)
class frame_place<Front, Longest> {
public:
    static constexpr bool has_front = true;
    static constexpr std::size_t memory = Longest + Front;
    [[nodiscard]] constexpr std::uint16_t begin() const noexcept { return begin_; }
    constexpr void leave_room_for(std::size_t size) noexcept
    {
        begin_ = static_cast<std::uint16_t>(size < Front ? Front : size);
    }

private:
    std::uint16_t begin_{0};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
