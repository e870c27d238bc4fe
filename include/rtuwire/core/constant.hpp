// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Where a class gets a setting from: a copy in the object (`stored`), or a constant of the program
// (`constant`), which takes no memory and lets the compiler calculate with it. Both are read by `get`.
#pragma once

#include <type_traits>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A setting that is given when the object is constructed.
template <typename T> class stored {
public:
    explicit constexpr stored(T const& its_value) noexcept : value_{its_value} {}
    [[nodiscard]] constexpr T const& get() const noexcept { return value_; }

private:
    T value_;
};

/// A setting that is a constant of the program.
template <auto const& Value> struct constant {
    [[nodiscard]] static constexpr auto const& get() noexcept { return Value; }
};

/// Whether a setting takes no memory.
template <typename Setting> inline constexpr bool is_constant = std::is_empty_v<Setting>;

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
