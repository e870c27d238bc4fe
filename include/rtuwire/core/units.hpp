// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Numbers with a unit of measure. A quantity counts steps of a fixed size (`Scale`) of one dimension, in
// integers only. Conversion to a finer step is implicit, to a coarser one it is `truncated_to`; one dimension
// never converts to another, and a plain number never to or from a quantity unless the unit is named.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ratio>
#include <utility>

#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

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
struct temperature {
    static constexpr char symbol[] = "°C";
};
struct rate {
    static constexpr char symbol[] = "1/s";
};
/// Plain numbers: addresses, counters, gains.
struct dimensionless {
    static constexpr char symbol[] = "";
};

/// Whether every whole number of `From` steps is a whole number of `To` steps.
/// Internal.
template <typename From, typename To> inline constexpr bool is_finer = std::ratio_divide<From, To>::den == 1;

/// Whether a `To` holds every `From`, multiplied by a factor.
/// Internal.
template <std::integral From, std::integral To> [[nodiscard]] consteval bool holds_all(std::intmax_t factor) noexcept
{
    using from = std::numeric_limits<From>;
    using to = std::numeric_limits<To>;
    bool const has_sign = std::cmp_less((from::min)(), 0);
    return std::cmp_less_equal((from::max)(), std::intmax_t{(to::max)()} / factor) and
           (not has_sign or std::cmp_less_equal(std::intmax_t{(to::min)()} / factor, (from::min)()));
}

/// Not constexpr, so that in a constant expression the compiler reports this name. At run time it does
/// nothing.
inline void this_amount_does_not_fit_the_target() noexcept {}

/// `count` steps of `Scale` of a dimension: quantity<frequency, uint16, 1/10> counts tenths of a hertz.
template <typename Dimension, std::integral Rep, typename Scale = std::ratio<1>> class quantity {
public:
    using dimension = Dimension;
    using rep = Rep;
    using scale = typename Scale::type;

    constexpr quantity() noexcept = default;

    /// `count` steps.
    explicit constexpr quantity(Rep count) noexcept : count_{count} {}

    /// The same, from another type whose every number fits.
    template <std::integral Count>
        requires(holds_all<Count, Rep>(1) and not std::same_as<Count, Rep>)
    explicit constexpr quantity(Count count) noexcept : count_{static_cast<Rep>(count)} {}

    /// The same, from a type that holds more. What does not fit does not compile in a constant expression; at run time
    /// it becomes the nearest amount that fits, as in `truncated_to`. (Not consteval: Clang 14 crashes on literals of
    /// a class that has such a constructor.)
    template <std::integral Count>
        requires(not holds_all<Count, Rep>(1))
    explicit constexpr quantity(Count count) noexcept : count_{nearest(count)} {}

    /// The same amount in finer steps, of a type that can hold all of them.
    template <std::integral OtherRep, typename OtherScale>
        requires(is_finer<OtherScale, Scale>and holds_all<OtherRep, Rep>(std::ratio_divide<OtherScale, Scale>::num))
    constexpr quantity(quantity<Dimension, OtherRep, OtherScale> other) noexcept
        : count_{static_cast<Rep>(static_cast<Rep>(other.count()) *
                                  static_cast<Rep>(std::ratio_divide<OtherScale, Scale>::num))}
    {}

    /// How many steps of `Scale` this is.
    [[nodiscard]] constexpr Rep count() const noexcept { return count_; }

    friend constexpr bool operator==(quantity, quantity) noexcept = default;
    friend constexpr auto operator<=>(quantity, quantity) noexcept = default;

private:
    template <std::integral Count> static constexpr Rep nearest(Count count) noexcept
    {
        using limits = std::numeric_limits<Rep>;
        bool const is_below = std::cmp_less(count, (limits::min)());
        if (is_below or std::cmp_greater(count, (limits::max)())) {
            this_amount_does_not_fit_the_target();
            return is_below ? (limits::min)() : (limits::max)();
        }
        return static_cast<Rep>(count);
    }

    Rep count_{};
};

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
    bool const is_above = count > (wide::max)() / factor::num;
    bool const is_below = count < (wide::min)() / factor::num;
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

/// Register types, named by the step they count.
using hertz = quantity<frequency, std::uint16_t>;
using decihertz = quantity<frequency, std::uint16_t, std::deci>;
using signed_decihertz = quantity<frequency, std::int16_t, std::deci>;
using hectohertz = quantity<frequency, std::uint16_t, std::hecto>;
using rpm = quantity<rotation, std::uint16_t>;
using signed_rpm = quantity<rotation, std::int16_t>;
using deciamperes = quantity<current, std::uint16_t, std::deci>;
using centiamperes = quantity<current, std::uint16_t, std::centi>;
using microamperes = quantity<current, std::uint16_t, std::micro>;
using tenth_milliamperes = quantity<current, std::uint16_t, std::ratio<1, 10'000>>;
using volts = quantity<voltage, std::uint16_t>;
using decivolts = quantity<voltage, std::uint16_t, std::deci>;
using millivolts = quantity<voltage, std::uint16_t, std::milli>;
using percent = quantity<proportion, std::uint16_t>;
using signed_percent = quantity<proportion, std::int16_t>;
using tenth_percent = quantity<proportion, std::uint16_t, std::deci>;
using signed_tenth_percent = quantity<proportion, std::int16_t, std::deci>;
using seconds = quantity<time_span, std::uint16_t>;
using deciseconds = quantity<time_span, std::uint16_t, std::deci>;
using centiseconds = quantity<time_span, std::uint16_t, std::centi>;
namespace units {
using milliseconds = quantity<time_span, std::uint16_t, std::milli>;
}
using hours = quantity<operating_time, std::uint16_t>;
using centihours = quantity<operating_time, std::uint16_t, std::centi>;
using newton_metres = quantity<torque, std::int16_t>;
using watts = quantity<power, std::uint16_t>;
using hectowatts = quantity<power, std::uint16_t, std::hecto>;
using celsius = quantity<temperature, std::int16_t>;
using centi_per_second = quantity<rate, std::uint16_t, std::centi>;
using count16 = quantity<dimensionless, std::uint16_t>;
using signed_count16 = quantity<dimensionless, std::int16_t>;
using count16_tenths = quantity<dimensionless, std::uint16_t, std::deci>;
using count16_hundredths = quantity<dimensionless, std::uint16_t, std::centi>;

/// A decimal literal, read digit by digit: 1.30 is 130 hundredths.
template <char... Digits> struct decimal {
    static consteval std::int64_t count() noexcept
    {
        std::int64_t value = 0;
        ((value = Digits >= '0' and Digits <= '9' ? value * 10 + (Digits - '0') : value), ...);
        return value;
    }

    static consteval std::intmax_t steps_per_one() noexcept
    {
        bool after_point = false;
        std::intmax_t steps = 1;
        auto const read = [&](char digit) {
            after_point = after_point or digit == '.';
            steps *= after_point and digit != '.' and digit != '\'' ? 10 : 1;
        };
        (read(Digits), ...);
        return steps;
    }

    static consteval bool is_plain() noexcept
    {
        return ((Digits == '.' or Digits == '\'' or (Digits >= '0' and Digits <= '9')) and ...);
    }
};

/// The quantity that a literal spells, in steps of its last digit.
template <typename Dimension, typename Unit, char... Digits> [[nodiscard]] consteval auto spelled() noexcept
{
    using number = decimal<Digits...>;
    static_assert(number::is_plain(), "a quantity is written in decimal digits, as 50 or 1.3");
    using scale = std::ratio_multiply<Unit, std::ratio<1, number::steps_per_one()>>;
    return quantity<Dimension, std::int64_t, scale>{number::count()};
}

inline namespace literals {

template <char... Digits> consteval auto operator""_Hz() noexcept
{
    return spelled<frequency, std::ratio<1>, Digits...>();
}
template <char... Digits> consteval auto operator""_kHz() noexcept
{
    return spelled<frequency, std::kilo, Digits...>();
}
template <char... Digits> consteval auto operator""_rpm() noexcept
{
    return spelled<rotation, std::ratio<1>, Digits...>();
}
template <char... Digits> consteval auto operator""_A() noexcept
{
    return spelled<current, std::ratio<1>, Digits...>();
}
template <char... Digits> consteval auto operator""_mA() noexcept { return spelled<current, std::milli, Digits...>(); }
template <char... Digits> consteval auto operator""_V() noexcept
{
    return spelled<voltage, std::ratio<1>, Digits...>();
}
template <char... Digits> consteval auto operator""_percent() noexcept
{
    return spelled<proportion, std::ratio<1>, Digits...>();
}
template <char... Digits> consteval auto operator""_s() noexcept
{
    return spelled<time_span, std::ratio<1>, Digits...>();
}
template <char... Digits> consteval auto operator""_h() noexcept
{
    return spelled<operating_time, std::ratio<1>, Digits...>();
}
template <char... Digits> consteval auto operator""_Nm() noexcept
{
    return spelled<torque, std::ratio<1>, Digits...>();
}
template <char... Digits> consteval auto operator""_W() noexcept { return spelled<power, std::ratio<1>, Digits...>(); }
template <char... Digits> consteval auto operator""_celsius() noexcept
{
    return spelled<temperature, std::ratio<1>, Digits...>();
}
/// A plain number for a register without a unit.
template <char... Digits> consteval auto operator""_raw() noexcept
{
    return spelled<dimensionless, std::ratio<1>, Digits...>();
}

} // namespace literals

/// The opposite of a literal: -1500_rpm.
template <typename Dimension, std::signed_integral Rep, typename Scale>
[[nodiscard]] constexpr quantity<Dimension, Rep, Scale> operator-(quantity<Dimension, Rep, Scale> amount) noexcept
{
    return quantity<Dimension, Rep, Scale>{static_cast<Rep>(-amount.count())};
}

} // namespace rtuwire
