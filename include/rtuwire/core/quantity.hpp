// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Numbers with a unit of measure. A quantity counts steps of a fixed size (`Scale`) of one dimension (core/units.hpp), in
// integers only. Conversion to a finer step is implicit, to a coarser one it is `truncated_to`; one dimension
// never converts to another, and a plain number never to or from a quantity unless the unit is named.
// Quantities of one dimension compare, add and subtract by value, whatever their steps and their width; an integer
// multiplies and divides them. The result counts the finer of two steps, in a type that holds every result of 16-bit
// operands. Where 64 bits do not hold it, or the divisor is 0, the result is the end of these 64 bits: it stays there,
// whatever is added, it prints as "out of range", and no register takes it. In a constant expression it does not
// compile.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <ratio>
#include <type_traits>
#include <utility>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Whether every whole number of `From` steps is a whole number of `To` steps.
template <typename From, typename To> inline constexpr bool is_finer = std::ratio_divide<From, To>::den == 1;

/// Whether a `To` holds every `From`, multiplied by a factor.
template <std::integral From, std::integral To> [[nodiscard]] consteval bool holds_all(std::intmax_t factor) noexcept
{
    using from = std::numeric_limits<From>;
    using to = std::numeric_limits<To>;
    bool const has_sign = std::cmp_less((from::min)(), 0);
    return std::cmp_less_equal((from::max)(),
                               static_cast<std::uintmax_t>((to::max)()) / static_cast<std::uintmax_t>(factor)) and
           (not has_sign or std::cmp_less_equal(std::intmax_t{(to::min)()} / factor, (from::min)()));
}

/// How many steps `count` steps that are larger by a factor are, and whether a part of one is left.
template <typename Factor> [[nodiscard]] constexpr std::int64_t whole_steps(std::int64_t count) noexcept
{
    return count * Factor::num / Factor::den;
}
template <typename Factor> [[nodiscard]] constexpr bool has_part_of_a_step(std::int64_t count) noexcept
{
    return count * Factor::num % Factor::den != 0;
}

} // namespace detail

/// Not constexpr, so that in a constant expression the compiler reports one of these names. At run time they do
/// nothing.
inline void this_amount_does_not_fit_the_target() noexcept {}
inline void this_amount_is_not_a_whole_number_of_steps() noexcept {}

/// `count` steps of `Scale` of a dimension: quantity<frequency, uint16, 1/10> counts tenths of a hertz.
template <typename Dimension, std::integral Rep, typename Scale = std::ratio<1>> class quantity {
    static_assert(detail::holds_all<Rep, std::int64_t>(1),
                  "a quantity counts in at most 64 bits, one of them the sign");

public:
    using dimension = Dimension;
    using rep = Rep;
    using scale = typename Scale::type;

    /// Zero.
    constexpr quantity() noexcept = default;

    /// `count` steps.
    template <std::same_as<Rep> Count> explicit constexpr quantity(Count count) noexcept : count_{count} {}

    /// The same, from another type whose every number fits.
    template <std::integral Count>
        requires(detail::holds_all<Count, Rep>(1) and not std::same_as<Count, Rep>)
    explicit constexpr quantity(Count count) noexcept : count_{static_cast<Rep>(count)} {}

    /// The same, from a type that holds more: only a constant that fits. A number known only at run time is counted in a
    /// type that holds it: `n * 0.1_s`, which `checked` then holds against a register. (Clang 14, which fails on such
    /// constructors, takes it, and the nearest amount.)
    template <std::integral Count>
        requires(not detail::holds_all<Count, Rep>(1))
#if defined(__clang__) && __clang_major__ < 15
    explicit constexpr quantity(Count count) noexcept : count_ { nearest(count) }
#else
    explicit consteval quantity(Count count) noexcept : count_{nearest(count)}
#endif
    {
        if (not std::in_range<Rep>(count)) {
            this_amount_does_not_fit_the_target();
        }
    }

    /// The same amount in finer steps, of a type that can hold all of them.
    template <std::integral OtherRep, typename OtherScale>
        requires(detail::is_finer<OtherScale, Scale>and detail::holds_all<OtherRep, Rep>(
            std::ratio_divide<OtherScale, Scale>::num))
    constexpr quantity(quantity<Dimension, OtherRep, OtherScale> other) noexcept
        : count_{static_cast<Rep>(static_cast<Rep>(other.count()) *
                                  static_cast<Rep>(std::ratio_divide<OtherScale, Scale>::num))}
    {}

    /// The same amount, of a literal: `decihertz top = 50_Hz`. Only a constant that is a whole number of these steps, and
    /// that fits.
    template <typename OtherScale>
        requires(not detail::is_finer<OtherScale, Scale> or
                 not detail::holds_all<std::int64_t, Rep>(std::ratio_divide<OtherScale, Scale>::num))
    consteval quantity(quantity<Dimension, std::int64_t, OtherScale> another) noexcept
        RTUWIRE_REFUSES(this_amount_is_not_a_whole_number_of_steps,
                        detail::has_part_of_a_step<std::ratio_divide<OtherScale, Scale>>(another.count()))
            RTUWIRE_REFUSES(
                this_amount_does_not_fit_the_target,
                not std::in_range<Rep>(detail::whole_steps<std::ratio_divide<OtherScale, Scale>>(another.count())))
        : count_{static_cast<Rep>(detail::whole_steps<std::ratio_divide<OtherScale, Scale>>(another.count()))}
    {
        using factor = std::ratio_divide<OtherScale, Scale>;
        if (detail::has_part_of_a_step<factor>(another.count())) {
            this_amount_is_not_a_whole_number_of_steps();
        }
        if (not std::in_range<Rep>(detail::whole_steps<factor>(another.count()))) {
            this_amount_does_not_fit_the_target();
        }
    }

    /// How many steps of `Scale` this is.
    [[nodiscard]] constexpr Rep count() const noexcept { return count_; }

    /// The amount as a floating point number, in the unit that `text_of` shows, or in that of a quantity: 50.5 for
    /// `decihertz{505}.as<double>()`, 0.0505 for `.as<double, quantity<frequency, std::uint16_t, std::kilo>>()`. One that is
    /// out of range is infinite.
    template <std::floating_point Number, typename Unit = quantity<Dimension, Rep>>
    [[nodiscard]] constexpr Number as() const noexcept
    {
        static_assert(std::same_as<typename Unit::dimension, Dimension>,
                      "these two measure different things: name a unit of the same");
        using factor = std::ratio_divide<scale, typename Unit::scale>;
        using limits = std::numeric_limits<Rep>;
        if constexpr (sizeof(Rep) == sizeof(std::int64_t)) { // whose ends are out of range
            constexpr Number infinity = std::numeric_limits<Number>::infinity();
            if (count_ == (limits::max)() or count_ == (limits::min)()) {
                return count_ < 0 ? -infinity : infinity;
            }
        }
        return static_cast<Number>(count_) * static_cast<Number>(factor::num) / static_cast<Number>(factor::den);
    }

    friend constexpr bool operator==(quantity, quantity) noexcept = default;
    friend constexpr auto operator<=>(quantity, quantity) noexcept = default;

private:
    template <std::integral Count> static constexpr Rep nearest(Count count) noexcept
    {
        using to = std::numeric_limits<Rep>;
        return std::cmp_less(count, (to::min)())      ? (to::min)()
               : std::cmp_greater(count, (to::max)()) ? (to::max)()
                                                      : static_cast<Rep>(count);
    }

    Rep count_{};
};

namespace detail {

template <typename T> inline constexpr bool is_quantity_type = false;
template <typename Dimension, typename Rep, typename Scale>
inline constexpr bool is_quantity_type<quantity<Dimension, Rep, Scale>> = true;

/// Whether a type is a quantity, of any dimension and width.
template <typename T>
concept any_quantity = is_quantity_type<T>;

/// Whether two types are quantities that measure the same.
template <typename Left, typename Right> inline constexpr bool measures_the_same = false;
template <any_quantity Left, any_quantity Right>
inline constexpr bool measures_the_same<Left, Right> =
    std::same_as<typename Left::dimension, typename Right::dimension>;

inline constexpr int no_power_of_ten = -1'000;

/// The power of ten that a step is; `no_power_of_ten` where it is none.
template <typename Scale> [[nodiscard]] consteval int power_of_ten() noexcept
{
    std::intmax_t rest = Scale::num > Scale::den ? Scale::num : Scale::den;
    int power = 0;
    for (; rest % 10 == 0; rest /= 10) {
        ++power;
    }
    bool const is_one = rest == 1 and (Scale::num == 1 or Scale::den == 1);
    return not is_one ? no_power_of_ten : Scale::num > 1 ? power : -power;
}

} // namespace detail

/// The amount in steps of `Target`, the remainder cut off. What does not fit does not compile in a constant
/// expression; at run time it becomes the nearest amount that fits.
template <typename Target, std::integral Rep, typename Scale>
[[nodiscard]] constexpr Target truncated_to(quantity<typename Target::dimension, Rep, Scale> amount) noexcept
{
    using factor = std::ratio_divide<Scale, typename Target::scale>;
    using target_rep = typename Target::rep;
    using to = std::numeric_limits<target_rep>;
    using wide = std::numeric_limits<std::int64_t>;
    std::int64_t const count = amount.count();
    // The ends of 64 bits are out of range, and stay so.
    constexpr bool has_ends = sizeof(Rep) == sizeof(std::int64_t);
    bool const is_above = count > (wide::max)() / factor::num or (has_ends and count == (wide::max)());
    bool const is_below = count < (wide::min)() / factor::num or (has_ends and count == (wide::min)());
    std::int64_t const steps = is_above ? (wide::max)() : is_below ? (wide::min)() : count * factor::num / factor::den;
    if (is_above or std::cmp_greater(steps, (to::max)())) {
        this_amount_does_not_fit_the_target();
        return Target{(to::max)()};
    }
    if (is_below or std::cmp_less(steps, (to::min)())) {
        this_amount_does_not_fit_the_target();
        return Target{(to::min)()};
    }
    return Target{static_cast<target_rep>(steps)};
}

/// Does not compile: core/result.hpp says why.
template <typename Dimension, std::integral Rep, typename Scale>
void operator<<(detail::include_rtuwire_print_hpp_to_show_this, quantity<Dimension, Rep, Scale>);

/// Not constexpr, so that in a constant expression the compiler reports one of these names. At run time they do
/// nothing.
inline void this_amount_does_not_fit_64_bits() noexcept {}
inline void this_amount_is_divided_by_zero_here() noexcept {}

namespace detail {

/// The ends of 64 bits: amounts that are out of range.
inline constexpr std::int64_t above_all = (std::numeric_limits<std::int64_t>::max)();
inline constexpr std::int64_t below_all = (std::numeric_limits<std::int64_t>::min)();

/// Whether a count of 64 bits stands for an amount that they do not hold.
[[nodiscard]] constexpr bool is_out_of_range(std::int64_t count) noexcept
{
    return count == above_all or count == below_all;
}

[[nodiscard]] constexpr std::int64_t out_of_range(bool is_negative) noexcept
{
    return is_negative ? below_all : above_all;
}

/// The size of a number without its sign.
[[nodiscard]] constexpr std::uint64_t magnitude(std::int64_t count) noexcept
{
    auto const bits = static_cast<std::uint64_t>(count);
    return count < 0 ? 0U - bits : bits;
}

/// The opposite; of one end, the other.
[[nodiscard]] constexpr std::int64_t opposite(std::int64_t count) noexcept
{
    return is_out_of_range(count) ? out_of_range(count > 0) : -count;
}

/// The product, or an end where 64 bits do not hold it. By halves: 32-bit machines have no product of 128 bits.
[[nodiscard]] constexpr std::int64_t bounded_product(std::int64_t left, std::int64_t right) noexcept
{
    bool const is_negative = (left < 0) != (right < 0);
    if (is_out_of_range(left)) {
        return out_of_range(is_negative);
    }
    constexpr std::uint64_t low = 0xFFFF'FFFFU;
    std::uint64_t const a = magnitude(left);
    std::uint64_t const b = magnitude(right);
    if ((a >> 32U) != 0 and (b >> 32U) != 0) {
        return out_of_range(is_negative);
    }
    std::uint64_t const upper = (a >> 32U) * (b & low) + (a & low) * (b >> 32U);
    std::uint64_t const lower = (a & low) * (b & low);
    constexpr auto end = static_cast<std::uint64_t>(above_all);
    if (upper > (end >> 32U) or lower > end - (upper << 32U)) {
        return out_of_range(is_negative);
    }
    auto const product = static_cast<std::int64_t>((upper << 32U) + lower);
    return is_negative ? -product : product;
}

/// The product; what does not fit is refused in a constant expression.
[[nodiscard]] constexpr std::int64_t product_of_counts(std::int64_t count, std::int64_t factor) noexcept
{
    std::int64_t const product = bounded_product(count, factor);
    if (is_out_of_range(product)) {
        this_amount_does_not_fit_64_bits();
    }
    return product;
}

/// The sum; an end stays one.
[[nodiscard]] constexpr std::int64_t sum_of_counts(std::int64_t left, std::int64_t right) noexcept
{
    std::int64_t sum = 0;
    if (is_out_of_range(left)) {
        return left;
    }
    if (is_out_of_range(right)) {
        return right;
    }
    if (__builtin_add_overflow(left, right, &sum) or is_out_of_range(sum)) {
        this_amount_does_not_fit_64_bits();
        return out_of_range(left < 0);
    }
    return sum;
}

/// The quotient, its remainder cut off; an end where the divisor is 0.
[[nodiscard]] constexpr std::int64_t quotient_of_counts(std::int64_t count, std::int64_t divisor) noexcept
{
    if (divisor == 0) {
        this_amount_is_divided_by_zero_here();
        return out_of_range(count < 0);
    }
    return is_out_of_range(count) ? out_of_range((count < 0) != (divisor < 0)) : count / divisor;
}

/// The largest size of a type's numbers.
template <std::integral Rep>
inline constexpr std::uint64_t largest_size = static_cast<std::uint64_t>((std::numeric_limits<Rep>::max)()) +
                                              (std::is_signed_v<Rep> ? 1U : 0U);

/// Whether every multiple of a type's numbers stays below a limit.
template <std::integral Rep, std::intmax_t Factor, std::uint64_t Limit>
inline constexpr bool stays_below = largest_size<Rep> <= (Limit - 1) / static_cast<std::uint64_t>(Factor);

/// The type for a result whose operands are 16 bits wide and below half of 32 bits; for all others 64 bits.
template <bool IsNarrow> using result_rep = std::conditional_t<IsNarrow, std::int32_t, std::int64_t>;

/// The greatest common divisor of two positive numbers.
[[nodiscard]] consteval std::intmax_t common_divisor(std::intmax_t left, std::intmax_t right) noexcept
{
    while (right != 0) {
        std::intmax_t const rest = left % right;
        left = right;
        right = rest;
    }
    return left;
}

/// What two quantities have in common: the coarsest step of which both are whole multiples, and how many of it make
/// one step of each.
template <any_quantity Left, any_quantity Right> struct common_steps {
    using left = typename Left::scale;
    using right = typename Right::scale;
    using scale = typename std::ratio<common_divisor(left::num, right::num),
                                      left::den / common_divisor(left::den, right::den) * right::den>::type;
    static constexpr std::intmax_t of_left = std::ratio_divide<left, scale>::num;
    static constexpr std::intmax_t of_right = std::ratio_divide<right, scale>::num;

    /// Whether each is below half of a limit, so that their sum is below it.
    template <std::uint64_t Limit>
    static constexpr bool stay_below =
        stays_below<typename Left::rep, of_left, Limit / 2>and stays_below<typename Right::rep, of_right, Limit / 2>;

    static constexpr bool are_narrow = stay_below<std::uint64_t{1} << 31U>;
    static constexpr bool are_bounded = stay_below<std::uint64_t{1} << 63U>;
    using rep = result_rep<are_narrow>;
    using sum = quantity<typename Left::dimension, rep, scale>;
};

template <any_quantity Left, any_quantity Right>
[[nodiscard]] constexpr std::strong_ordering compared(Left left, Right right) noexcept
{
    using steps = common_steps<Left, Right>;
    if constexpr (steps::are_bounded) {
        using rep = typename steps::rep;
        return static_cast<rep>(static_cast<rep>(left.count()) * static_cast<rep>(steps::of_left)) <=>
               static_cast<rep>(static_cast<rep>(right.count()) * static_cast<rep>(steps::of_right));
    } else {
        static_assert(steps::of_left == 1 or steps::of_right == 1 or
                          stays_below<typename Left::rep, steps::of_left, above_all> or
                          stays_below<typename Right::rep, steps::of_right, above_all>,
                      "amounts of 64 bits compare where one step is a whole number of the other");
        return bounded_product(left.count(), steps::of_left) <=> bounded_product(right.count(), steps::of_right);
    }
}

template <bool IsDifference, any_quantity Left, any_quantity Right>
[[nodiscard]] constexpr auto combined(Left left, Right right) noexcept
{
    using steps = common_steps<Left, Right>;
    using rep = typename steps::rep;
    using sum = typename steps::sum;
    if constexpr (steps::are_bounded) {
        auto const first = static_cast<rep>(static_cast<rep>(left.count()) * static_cast<rep>(steps::of_left));
        auto const second = static_cast<rep>(static_cast<rep>(right.count()) * static_cast<rep>(steps::of_right));
        return sum{static_cast<rep>(IsDifference ? first - second : first + second)};
    } else {
        std::int64_t const first = product_of_counts(left.count(), steps::of_left);
        std::int64_t const second = product_of_counts(right.count(), steps::of_right);
        return sum{sum_of_counts(first, IsDifference ? opposite(second) : second)};
    }
}

} // namespace detail

/// Equal by value: 50_Hz is decihertz{500}.
template <detail::any_quantity Left, detail::any_quantity Right>
    requires(not std::same_as<Left, Right>)
[[nodiscard]] constexpr bool operator==(Left left, Right right) noexcept
{
    static_assert(detail::measures_the_same<Left, Right>, "these two measure different things, and are never equal");
    return detail::compared(left, right) == 0;
}

/// Compared by value, signed with unsigned, tenths with hundredths.
template <detail::any_quantity Left, detail::any_quantity Right>
    requires(not std::same_as<Left, Right>)
[[nodiscard]] constexpr std::strong_ordering operator<=>(Left left, Right right) noexcept
{
    static_assert(detail::measures_the_same<Left, Right>, "these two measure different things, and do not compare");
    return detail::compared(left, right);
}

/// The exact sum, in the finer of both steps.
template <detail::any_quantity Left, detail::any_quantity Right>
[[nodiscard]] constexpr auto operator+(Left left, Right right) noexcept
{
    static_assert(detail::measures_the_same<Left, Right>, "these two measure different things, and have no sum");
    return detail::combined<false>(left, right);
}

/// The exact difference, in the finer of both steps; it may be below zero.
template <detail::any_quantity Left, detail::any_quantity Right>
[[nodiscard]] constexpr auto operator-(Left left, Right right) noexcept
{
    static_assert(detail::measures_the_same<Left, Right>, "these two measure different things, and have no difference");
    return detail::combined<true>(left, right);
}

/// The opposite: -1500_rpm.
template <detail::any_quantity Amount> [[nodiscard]] constexpr auto operator-(Amount amount) noexcept
{
    constexpr bool is_narrow = detail::stays_below<typename Amount::rep, 1, (std::uint64_t{1} << 31U)>;
    using rep = detail::result_rep<is_narrow>;
    using opposed = quantity<typename Amount::dimension, rep, typename Amount::scale>;
    if constexpr (is_narrow) {
        return opposed{-rep{amount.count()}};
    } else {
        return opposed{detail::opposite(amount.count())};
    }
}

namespace detail {

/// What has no unit neither compares with a quantity nor is added to it; taken in order to be refused in plain words.
template <typename T>
concept plain_number = std::is_arithmetic_v<T>;
template <plain_number> inline constexpr bool has_unit = false;

} // namespace detail

template <detail::any_quantity Amount, detail::plain_number Number> constexpr bool operator==(Amount, Number) noexcept
{
    static_assert(detail::has_unit<Number>, "a plain number is no amount: give it a unit, as in 50_Hz");
    return false;
}
template <detail::any_quantity Amount, detail::plain_number Number>
constexpr std::strong_ordering operator<=>(Amount, Number) noexcept
{
    static_assert(detail::has_unit<Number>, "a plain number is no amount: give it a unit, as in 50_Hz");
    return std::strong_ordering::equal;
}
template <detail::any_quantity Amount, detail::plain_number Number>
constexpr Amount operator+(Amount amount, Number) noexcept
{
    static_assert(detail::has_unit<Number>, "a plain number is no amount: give it a unit, as in 50_Hz");
    return amount;
}
template <detail::any_quantity Amount, detail::plain_number Number>
constexpr Amount operator-(Amount amount, Number) noexcept
{
    static_assert(detail::has_unit<Number>, "a plain number is no amount: give it a unit, as in 50_Hz");
    return amount;
}

namespace detail {

/// A plain number that may scale a quantity.
template <typename T>
concept plain_integer = std::integral<T> and not std::same_as<std::remove_cv_t<T>, bool>;

/// A plain number as the ends of 64 bits allow.
template <plain_integer Integer> [[nodiscard]] constexpr std::int64_t as_factor(Integer integer) noexcept
{
    return std::in_range<std::int64_t>(integer) ? static_cast<std::int64_t>(integer) : above_all;
}

} // namespace detail

/// The multiple; of a literal, what a number known at run time amounts to: `n * 0.1_s`.
template <detail::any_quantity Amount, detail::plain_integer Integer>
[[nodiscard]] constexpr auto operator*(Amount amount, Integer times) noexcept
{
    constexpr bool is_narrow =
        detail::largest_size<typename Amount::rep> <= 0xFFFFU and detail::largest_size<Integer> <= 0x7FFFU;
    using rep = detail::result_rep<is_narrow>;
    using multiple = quantity<typename Amount::dimension, rep, typename Amount::scale>;
    if constexpr (is_narrow) {
        return multiple{static_cast<rep>(rep{amount.count()} * rep{times})};
    } else {
        // Of -1 times an end for a number above 64 bits, the product would fit.
        bool const is_beyond = not std::in_range<std::int64_t>(times) and amount.count() < 0;
        return multiple{
            detail::product_of_counts(is_beyond ? detail::below_all : amount.count(), detail::as_factor(times))};
    }
}
template <detail::any_quantity Amount, detail::plain_integer Integer>
[[nodiscard]] constexpr auto operator*(Integer times, Amount amount) noexcept
{
    return amount * times;
}

/// No fraction of an amount: integers count its steps.
template <detail::any_quantity Amount, std::floating_point Number>
constexpr Amount operator*(Amount amount, Number) noexcept
{
    static_assert(detail::has_unit<Number>, "an amount is multiplied by integers only: 3 * speed / 2");
    return amount;
}
template <detail::any_quantity Amount, std::floating_point Number>
constexpr Amount operator*(Number, Amount amount) noexcept
{
    static_assert(detail::has_unit<Number>, "an amount is multiplied by integers only: 3 * speed / 2");
    return amount;
}

/// The part in the same steps, the remainder cut off; in 64 bits, which tell a division by 0.
template <detail::any_quantity Amount, detail::plain_integer Integer>
[[nodiscard]] constexpr auto operator/(Amount amount, Integer divisor) noexcept
{
    using part = quantity<typename Amount::dimension, std::int64_t, typename Amount::scale>;
    // In 32 bits where they do: a division of 64 bits is 500 bytes of a Cortex-M0+.
    if constexpr (detail::holds_all<typename Amount::rep, std::int32_t>(1) and
                  detail::holds_all<Integer, std::int32_t>(1)) {
        std::int32_t const by{divisor};
        if (by == -1) {
            return part{-std::int64_t{amount.count()}};
        }
        if (by != 0) {
            return part{std::int64_t{std::int32_t{amount.count()} / by}};
        }
    }
    bool const is_none = not std::in_range<std::int64_t>(divisor) and not detail::is_out_of_range(amount.count());
    return part{is_none ? 0 : detail::quotient_of_counts(amount.count(), detail::as_factor(divisor))};
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
