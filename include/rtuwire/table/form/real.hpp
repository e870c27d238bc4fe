// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Amounts in floating point, as many meters have them, with their unit. Only registers of such numbers bring them into
// a program; everything else counts in integers.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <ratio>
#include <type_traits>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

template <detail::any_quantity Unit, std::floating_point Float> class real;

namespace detail {

/// Internal.
template <typename T> inline constexpr bool is_real_type = false;
template <typename Unit, typename Float> inline constexpr bool is_real_type<real<Unit, Float>> = true;

template <typename T>
concept any_real = is_real_type<T>;

/// Whatever counts steps of something.
template <typename T>
concept any_amount = any_quantity<T> or any_real<T>;

/// Whether two amounts are of one dimension.
template <any_amount Left, any_amount Right>
inline constexpr bool are_of_one_dimension = std::same_as<typename Left::dimension, typename Right::dimension>;

/// A number times a fraction. A double holds 53 bits, so that all that fits into them is exact where the fraction is a
/// whole number.
template <typename Ratio> [[nodiscard]] constexpr double scaled_by_ratio(double count) noexcept
{
    double const product = Ratio::num == 1 ? count : count * static_cast<double>(Ratio::num);
    return Ratio::den == 1 ? product : product / static_cast<double>(Ratio::den);
}

/// A count of a quantity; infinite where it stands for an amount that is out of range.
template <std::integral Rep> [[nodiscard]] constexpr double count_or_infinity(Rep count) noexcept
{
    if constexpr (sizeof(Rep) == sizeof(std::int64_t)) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        if (is_out_of_range(count)) {
            return count < 0 ? -infinity : infinity;
        }
    }
    return static_cast<double>(count);
}

/// A number from the bits of IEEE 754 that is neither infinite nor "not a number". Compares nothing, so that a program
/// that only passes numbers on has no code for them.
[[nodiscard]] constexpr bool is_finite(std::uint32_t bits) noexcept { return (~bits & 0x7F80'0000U) != 0; }
[[nodiscard]] constexpr bool is_finite(std::uint64_t bits) noexcept { return (~bits & 0x7FF0'0000'0000'0000U) != 0; }

} // namespace detail

/// `count` steps of a unit, as a floating point number: `real<kilowatt_hours>`. Compares with quantities and other reals
/// of its dimension, by value: in double, which is exact where both counts have up to 53 bits. Sums and multiples are
/// rounded as floating point is.
template <detail::any_quantity Unit, std::floating_point Float = float> class real {
public:
    using dimension = typename Unit::dimension;
    using scale = typename Unit::scale;
    using rep = Float;

    constexpr real() noexcept = default;

    /// `count` steps of the unit.
    explicit constexpr real(Float count) noexcept : count_{count} {}

    /// The nearest to a quantity: `real<kilowatt_hours> least = 2.5_kWh`. One that is out of range is infinite.
    template <detail::any_quantity Amount>
        requires(std::same_as<typename Amount::dimension, dimension>)
    constexpr real(Amount measured) noexcept
        : count_{static_cast<Float>(detail::scaled_by_ratio<std::ratio_divide<typename Amount::scale, scale>>(
              detail::count_or_infinity(measured.count())))}
    {}

    [[nodiscard]] constexpr Float count() const noexcept { return count_; }

    /// The nearest whole number of steps of a quantity, halves away from zero. `value_too_high`, `value_too_low` where
    /// the quantity cannot hold it, `value_without_meaning` where it is not a number.
    template <detail::any_quantity Target> [[nodiscard]] constexpr result<Target> rounded_to() const noexcept
    {
        static_assert(std::same_as<typename Target::dimension, dimension>,
                      "these two measure different things: name a quantity of the same");
        using limits = std::numeric_limits<typename Target::rep>;
        double const steps = detail::scaled_by_ratio<std::ratio_divide<scale, typename Target::scale>>(count_);
        if (not(steps >= 0) and not(steps < 0)) {
            return errc::value_without_meaning;
        }
        constexpr double half = 0.5;
        // Half a step beyond the ends rounds to them; where 53 bits do not tell, the ends themselves are refused.
        if (steps >= static_cast<double>((limits::max)()) + half) {
            return errc::value_too_high;
        }
        if (steps <= static_cast<double>((limits::min)()) - half) {
            return errc::value_too_low;
        }
        auto const whole = static_cast<std::int64_t>(steps);
        double const rest = steps - static_cast<double>(whole);
        std::int64_t const nearest = whole + (rest >= half ? 1 : rest <= -half ? -1 : 0);
        return Target{static_cast<typename Target::rep>(nearest)};
    }

    friend constexpr real operator-(real amount) noexcept { return real{-amount.count_}; }
    friend constexpr real operator+(real left, real right) noexcept { return real{left.count_ + right.count_}; }
    friend constexpr real operator-(real left, real right) noexcept { return real{left.count_ - right.count_}; }
    friend constexpr real operator*(real amount, Float times) noexcept { return real{amount.count_ * times}; }
    friend constexpr real operator*(Float times, real amount) noexcept { return real{amount.count_ * times}; }
    friend constexpr real operator/(real amount, Float divisor) noexcept { return real{amount.count_ / divisor}; }

private:
    Float count_{};
};

/// Compared by value; not a number is neither less nor equal nor greater.
template <detail::any_amount Left, detail::any_amount Right>
    requires(detail::any_real<Left> or detail::any_real<Right>)
[[nodiscard]] constexpr std::partial_ordering operator<=>(Left left, Right right) noexcept
{
    static_assert(detail::are_of_one_dimension<Left, Right>, "these two measure different things, and do not compare");
    // Whole factors on both sides: a division would round.
    using steps = std::ratio_divide<typename Left::scale, typename Right::scale>;
    return detail::scaled_by_ratio<std::ratio<steps::num>>(static_cast<double>(left.count())) <=>
           detail::scaled_by_ratio<std::ratio<steps::den>>(static_cast<double>(right.count()));
}
template <detail::any_amount Left, detail::any_amount Right>
    requires(detail::any_real<Left> or detail::any_real<Right>)
[[nodiscard]] constexpr bool operator==(Left left, Right right) noexcept { return (left <=> right) == 0; }

/// What has no unit does not compare.
template <detail::any_real Amount, detail::plain_number Number>
constexpr std::partial_ordering operator<=>(Amount, Number) noexcept
{
    static_assert(detail::has_unit<Number>, "a plain number is no amount: give it a unit, as in 50_Hz");
    return std::partial_ordering::unordered;
}
template <detail::any_real Amount, detail::plain_number Number> constexpr bool operator==(Amount, Number) noexcept
{
    static_assert(detail::has_unit<Number>, "a plain number is no amount: give it a unit, as in 50_Hz");
    return false;
}

/// Does not compile: core/result.hpp says why.
template <detail::any_quantity Unit, std::floating_point Float>
void operator<<(detail::include_rtuwire_print_hpp_to_show_this, real<Unit, Float>);

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
