// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Floating point numbers of 32 and 64 bits in registers, `reg<float32<kilowatt_hours, word_order::low_first>>`, as many
// meters have them, and amounts of them with their unit. Only registers of such numbers bring them into a program;
// everything else counts in integers.
#pragma once

#include <array>
#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <ratio>
#include <type_traits>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

template <detail::any_quantity Unit, std::floating_point Float> class real;

namespace detail {

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

    /// Zero.
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

    /// In the unit that `text_of` shows, or in that of a quantity: see `quantity`.
    template <std::floating_point Number, typename Other = quantity<dimension, std::uint16_t>>
    [[nodiscard]] constexpr Number as() const noexcept
    {
        static_assert(std::same_as<typename Other::dimension, dimension>,
                      "these two measure different things: name a unit of the same");
        using factor = std::ratio_divide<scale, typename Other::scale>;
        return static_cast<Number>(count_) * static_cast<Number>(factor::num) / static_cast<Number>(factor::den);
    }

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

namespace detail {

/// A number of so many bits, of IEEE 754. What is infinite or not a number is `value_without_meaning`, read or written.
/// The limits of such a register are whole numbers of its unit.
template <unsigned Bits, any_quantity Unit, word_order Order> struct floating_form {
    using count_type = std::conditional_t<Bits == 32, float, double>;
    static_assert(8 * sizeof(count_type) == Bits and std::numeric_limits<count_type>::is_iec559,
                  "this machine has no floating point of so many bits");

    static_assert(power_of_ten<typename Unit::scale>() % 3 == 0,
                  "a floating point number is of a unit, float32<amperes>, float32<milliamperes>, not of a step: of "
                  "deciamperes, amperes would be read ten times too small");

    using value_type = real<Unit, count_type>;
    static constexpr std::uint16_t word_count = Bits / 16;
    static constexpr word_order order = Order;
    using words = std::array<std::uint16_t, word_count>;

    [[nodiscard]] static constexpr result<value_type> from_words(words const& from) noexcept
    {
        auto const bits = joined<Order>(from);
        if (not is_finite(bits)) {
            return errc::value_without_meaning;
        }
        return value_type{std::bit_cast<count_type>(bits)};
    }

    [[nodiscard]] static constexpr words to_words(value_type value) noexcept
    {
        return separated<Order, word_count>(std::bit_cast<bits_of<word_count>>(value.count()));
    }

    template <typename Value>
    static constexpr bool takes = [] {
        if constexpr (any_amount<Value>) {
            return std::same_as<typename Value::dimension, typename Unit::dimension>;
        }
        return false;
    }();

    /// The nearest number; an error where it is too large for such registers, or no number.
    template <any_amount Value> [[nodiscard]] static constexpr result<value_type> convert(Value value) noexcept
    {
        if constexpr (any_quantity<Value>) {
            if (is_out_of_range(value.count())) {
                return value.count() < 0 ? errc::value_too_low : errc::value_too_high;
            }
        }
        using ratio = std::ratio_divide<typename Value::scale, typename Unit::scale>;
        double const count = scaled_by_ratio<ratio>(static_cast<double>(value.count()));
        if (count > static_cast<double>((std::numeric_limits<count_type>::max)())) {
            return errc::value_too_high;
        }
        if (count < static_cast<double>(std::numeric_limits<count_type>::lowest())) {
            return errc::value_too_low;
        }
        return value_type{static_cast<count_type>(count)};
    }

    /// Why a value is not written within limits in whole units; `none` where it may be.
    [[nodiscard]] static constexpr errc refusal(value_type value, bound const& min, bound const& max,
                                                count_range gap) noexcept
    {
        auto const count = static_cast<double>(value.count());
        if (not is_finite(std::bit_cast<bits_of<word_count>>(value.count()))) {
            return errc::value_without_meaning;
        }
        if (max.is_number() and count > static_cast<double>(max.raw())) {
            return errc::value_too_high;
        }
        if (min.is_number() and count < static_cast<double>(min.raw())) {
            return errc::value_too_low;
        }
        bool const is_in_gap = count >= static_cast<double>(gap.first) and count <= static_cast<double>(gap.last);
        return is_in_gap ? errc::value_never_written : errc::none;
    }
};

} // namespace detail

/// What a register of such numbers measures; plain numbers where no unit is named. The unit is one that people name, of a
/// step that is a power of 1000 (`amperes`, `milliamperes`, `kilowatt_hours`): others are the steps of whole numbers.
template <typename Unit = count16, word_order Order = word_order::high_first>
using float32 = detail::floating_form<32, Unit, Order>;
template <typename Unit = count16, word_order Order = word_order::high_first>
using float64 = detail::floating_form<64, Unit, Order>;

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
