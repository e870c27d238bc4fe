// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Types that tests and fuzz targets go through, one after the other.
#pragma once

#include <type_traits>

namespace rtuwire::test {

template <typename... Ts> struct type_list {
    template <typename T> static constexpr bool contains = (std::is_same_v<T, Ts> or ...);

    /// Calls `visit.operator()<T>()` for each.
    template <typename F> static constexpr void for_each(F const& visit) { (visit.template operator()<Ts>(), ...); }

    /// Whether `holds.operator()<T>()` is true of each.
    template <typename F> static constexpr bool all_of(F const& holds)
    {
        return (holds.template operator()<Ts>() and ...);
    }
};

} // namespace rtuwire::test
