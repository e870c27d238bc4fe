// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Questions about a whole list of template arguments. Not fold expressions: these nest, and Clang takes at most 256 of
// them, while a table has a thousand registers.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Facts, as a type.
template <bool... Facts> struct fact_list;

/// Whether all of them hold; true of none. A list whose facts are all true is the same, moved by one.
template <bool... Facts>
inline constexpr bool are_all = std::is_same_v<fact_list<true, Facts...>, fact_list<Facts..., true>>;

/// Whether one of them holds.
template <bool... Facts> inline constexpr bool is_any = not are_all<not Facts...>;

/// Their sum; 0 of none.
template <std::size_t... Numbers> [[nodiscard]] consteval std::size_t sum_of() noexcept
{
    std::size_t sum = 0;
    for (std::size_t const each : std::array<std::size_t, sizeof...(Numbers)>{Numbers...}) {
        sum += each;
    }
    return sum;
}

} // namespace rtuwire
