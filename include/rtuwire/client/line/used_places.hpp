// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How many of several places are in use, so that nobody looks at the others.
#pragma once

#include <cstddef>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A count of up to `Size` places. The only place of one counts as used, which takes no memory.
template <std::size_t Size> class used_places {
public:
    [[nodiscard]] constexpr std::size_t count() const noexcept { return count_; }
    constexpr void set(std::size_t count) noexcept { count_ = count; }

private:
    std::size_t count_{0};
};
template <> class used_places<1> {
public:
    [[nodiscard]] static constexpr std::size_t count() noexcept { return 1; }
    static constexpr void set(std::size_t) noexcept {}
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
