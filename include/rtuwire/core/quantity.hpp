// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Numbers with a unit of measure. A quantity counts steps of a fixed size (`Scale`) of one dimension, in
// integers only. Conversion to a finer step is implicit, to a coarser one it is `truncated_to`; one dimension
// never converts to another, and a plain number never to or from a quantity unless the unit is named.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <ratio>
#include <utility>

#include <rtuwire/core/unshown.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// What is measured. Each is a type without values.
struct frequency {
    static constexpr char symbol[] = "Hz";
};
struct rotation {
    static constexpr char symbol[] = "rpm";
};
struct current {
    static constexpr char symbol[] = "A";
};
struct voltage {
    static constexpr char symbol[] = "V";
};
struct proportion {
    static constexpr char symbol[] = "%";
};
struct time_span {
    static constexpr bool is_time = true;
    static constexpr char symbol[] = "s";
};
struct operating_time {
    static constexpr char symbol[] = "h";
};
struct torque {
    static constexpr char symbol[] = "Nm";
};
struct power {
    static constexpr char symbol[] = "W";
};
struct electrical_energy {
    static constexpr char symbol[] = "kWh";
};
struct temperature {
    static constexpr char symbol[] = "°C";
};
/// From absolute zero, or a difference of two temperatures.
struct absolute_temperature {
    static constexpr char symbol[] = "K";
};
struct apparent_power {
    static constexpr char symbol[] = "VA";
};
struct reactive_power {
    static constexpr char symbol[] = "var";
};
struct apparent_energy {
    static constexpr char symbol[] = "kVAh";
};
struct reactive_energy {
    static constexpr char symbol[] = "kvarh";
};
struct pressure {
    static constexpr char symbol[] = "bar";
};
struct volume {
    static constexpr char symbol[] = "m3";
};
struct hourly_flow {
    static constexpr char symbol[] = "m3/h";
};
/// 60 l/min are 3.6 m3/h: a step that has no digits of the other, so that each is measured by itself.
struct flow_by_minute {
    static constexpr char symbol[] = "l/min";
};
struct rate {
    static constexpr char symbol[] = "1/s";
};
/// Plain numbers: addresses, counters, gains.
struct dimensionless {
    static constexpr char symbol[] = "";
};

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

/// Internal.
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

/// Does not compile: core/unshown.hpp says why.
template <typename Dimension, std::integral Rep, typename Scale>
void operator<<(detail::include_rtuwire_print_hpp_to_show_this, quantity<Dimension, Rep, Scale>);

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
