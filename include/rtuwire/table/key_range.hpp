// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which words one request has to read for the value of a register: its own, and that of its scale.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The first and the last of the words that one request has to read, in one space.
struct key_range {
    std::uint32_t first;
    std::uint32_t last;

    [[nodiscard]] constexpr key_range with(key_range other) const noexcept
    {
        return {other.first < first ? other.first : first, other.last > last ? other.last : last};
    }
    [[nodiscard]] constexpr bool is_of_one_space() const noexcept { return first >> 16U == last >> 16U; }
};

/// Of one register, its scale included.
template <auto const& R> [[nodiscard]] constexpr key_range range_of() noexcept
{
    std::uint32_t const first = key_of(R.space, R.address);
    key_range range{first, first + R.word_count - 1U};
    if constexpr (has_scale_register<R>) {
        range = range.with(range_of<std::remove_cvref_t<decltype(R)>::form::scale_register>());
    }
    return range;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
