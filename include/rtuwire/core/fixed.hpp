// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Where a class gets a setting from: it holds a copy (`held`), or the program fixes it once and for
// all (`fixed`), which takes no memory and lets the compiler calculate with it. Both are asked by `get`.
#pragma once

#include <type_traits>

#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A setting that is told when the object is made.
template <typename T> class held {
public:
    explicit constexpr held(T const& value) noexcept : value_{value} {}
    [[nodiscard]] constexpr T const& get() const noexcept { return value_; }

private:
    T value_;
};

/// A setting that is a constant of the program.
template <auto const& Value> struct fixed {
    [[nodiscard]] static constexpr auto const& get() noexcept { return Value; }
};

/// Whether a setting takes no memory.
template <typename Setting> inline constexpr bool is_fixed = std::is_empty_v<Setting>;

} // namespace rtuwire
