// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// An array of equal values, for types without a default value.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// `Size` times `value`.
template <std::size_t Size, typename T> [[nodiscard]] constexpr std::array<T, Size> filled(T const& value) noexcept
{
    return [&]<std::size_t... I>(std::index_sequence<I...>)
    {
        return std::array<T, Size>{(static_cast<void>(I), value)...};
    }
    (std::make_index_sequence<Size>{});
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
