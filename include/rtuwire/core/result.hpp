// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A value or the reason why there is none, with the member names of std::expected. Knows of errc
// only that its zero is no error; what the codes mean is written in wire/errc.hpp.
#pragma once

#include <cstdint>
#include <type_traits>

namespace rtuwire {

enum class errc : std::uint8_t;

/// A value, or an errc. The value may be read only where `has_value()`; reading it elsewhere does not
/// compile in a constant expression.
template <typename T> class [[nodiscard]] result {
    static_assert(std::is_trivially_copyable_v<T> and std::is_trivially_destructible_v<T>,
                  "a result holds trivially copyable values only");

public:
    using value_type = T;

    constexpr result(T const& value) noexcept : value_{value} {}
    constexpr result(errc error) noexcept : nothing_{}, error_{error} {}

    [[nodiscard]] constexpr bool has_value() const noexcept { return error_ == errc{}; }
    explicit constexpr operator bool() const noexcept { return has_value(); }

    [[nodiscard]] constexpr T const& operator*() const noexcept { return value_; }
    [[nodiscard]] constexpr T const* operator->() const noexcept { return &value_; }

    /// Why there is no value; zero when there is one.
    [[nodiscard]] constexpr errc error() const noexcept { return error_; }

    [[nodiscard]] constexpr T value_or(T const& other) const noexcept
    {
        return has_value() ? value_ : other;
    }

    /// Calls `next` with the value, or passes the error on. `next` returns a result.
    template <typename F>
    constexpr auto and_then(F&& next) const -> std::invoke_result_t<F, T const&>
    {
        if (not has_value()) {
            return error_;
        }
        return next(value_);
    }

    /// Equal when both hold equal values or the same error.
    friend constexpr bool operator==(result const& left, result const& right)
    {
        return left.error_ == right.error_ and (not left.has_value() or *left == *right);
    }

    /// Equal to a value when it holds one that is.
    template <typename U>
        requires(not std::is_same_v<U, errc>)
    friend constexpr bool operator==(result const& left, U const& right)
    {
        return left.has_value() and *left == right;
    }

    /// Equal to an error when it holds that one.
    friend constexpr bool operator==(result const& left, errc right) noexcept
    {
        return not left.has_value() and left.error_ == right;
    }

private:
    struct nothing {};
    union {
        nothing nothing_;
        T value_;
    };
    errc error_{};
};

/// Success, or an errc.
template <> class [[nodiscard]] result<void> {
public:
    using value_type = void;

    constexpr result() noexcept = default;
    constexpr result(errc error) noexcept : error_{error} {}

    [[nodiscard]] constexpr bool has_value() const noexcept { return error_ == errc{}; }
    explicit constexpr operator bool() const noexcept { return has_value(); }
    [[nodiscard]] constexpr errc error() const noexcept { return error_; }

    friend constexpr bool operator==(result left, errc right) noexcept
    {
        return left.error_ == right and right != errc{};
    }

private:
    errc error_{};
};

} // namespace rtuwire
