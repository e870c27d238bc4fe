// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Whole numbers in registers: of 32 and 64 bits, `reg<unsigned32<watt_hours>>`, and amounts whose decimal scale another
// register holds, as SunSpec has them: `count` times ten to the power of that register. Exact: no floating point.
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ratio>
#include <type_traits>
#include <utility>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A whole number of `Wire` bits in as many registers; counts steps of `Unit`, whose own width does not matter. An
/// amount counts in 64 bits at most, one of them the sign, and their two ends stand for "out of range". So a number of
/// 64 bits beyond them is refused on reading, by `value_too_high` or `value_too_low`.
template <std::integral Wire, any_quantity Unit, word_order Order> struct whole_form {
    static constexpr bool is_wide = sizeof(Wire) == 8;
    using count_type = std::conditional_t<is_wide, std::int64_t, Wire>;
    using value_type = quantity<typename Unit::dimension, count_type, typename Unit::scale>;
    static constexpr std::uint16_t word_count = sizeof(Wire) / 2;
    static constexpr word_order order = Order;
    static constexpr bool is_total = not is_wide;
    using words = std::array<std::uint16_t, word_count>;

    /// The ends of what such registers can hold, in raw counts.
    static constexpr std::int64_t lowest =
        is_wide ? (std::is_signed_v<Wire> ? below_all + 1 : 0) : std::int64_t{(std::numeric_limits<count_type>::min)()};
    static constexpr std::int64_t highest =
        is_wide ? above_all - 1 : std::int64_t{(std::numeric_limits<count_type>::max)()};

    [[nodiscard]] static constexpr result<value_type> from_words(words const& from) noexcept
    {
        auto const bits = joined<Order>(from);
        if constexpr (is_wide) {
            bool const is_below = std::is_signed_v<Wire> and bits == static_cast<std::uint64_t>(below_all);
            if (is_below or (std::is_unsigned_v<Wire> and bits > static_cast<std::uint64_t>(highest)) or
                bits == static_cast<std::uint64_t>(above_all)) {
                return is_below ? errc::value_too_low : errc::value_too_high;
            }
        }
        return value_type{static_cast<count_type>(bits)};
    }

    [[nodiscard]] static constexpr words to_words(value_type value) noexcept
    {
        return separated<Order, word_count>(static_cast<bits_of<word_count>>(value.count()));
    }

    /// Whether a value may be given for one of this form.
    template <typename Value> static constexpr bool takes = measures_the_same<value_type, Value>;

    /// A value of any unit of what the register measures; an error where it does not fit.
    template <typename Value> [[nodiscard]] static constexpr result<value_type> convert(Value const& value) noexcept
    {
        auto const raw = whole_steps<value_type>(value);
        if (not raw) {
            return raw.error();
        }
        if (*raw > highest or *raw < lowest) {
            return *raw < lowest ? errc::value_too_low : errc::value_too_high;
        }
        return value_type{static_cast<count_type>(*raw)};
    }

    /// Why a value is not written within limits in raw counts; `none` where it may be.
    [[nodiscard]] static constexpr errc refusal(value_type value, bound const& min, bound const& max,
                                                count_range gap) noexcept
    {
        std::int64_t const raw{value.count()};
        if (raw > (max.is_number() ? max.raw() : highest)) {
            return errc::value_too_high;
        }
        if (raw < (min.is_number() ? min.raw() : lowest)) {
            return errc::value_too_low;
        }
        return raw >= gap.first and raw <= gap.last ? errc::value_never_written : errc::none;
    }
};

} // namespace detail

/// What a register of such numbers counts; plain numbers where no unit is named.
template <typename Unit = count16, word_order Order = word_order::high_first>
using unsigned32 = detail::whole_form<std::uint32_t, Unit, Order>;
template <typename Unit = count16, word_order Order = word_order::high_first>
using signed32 = detail::whole_form<std::int32_t, Unit, Order>;
template <typename Unit = count16, word_order Order = word_order::high_first>
using unsigned64 = detail::whole_form<std::uint64_t, Unit, Order>;
template <typename Unit = count16, word_order Order = word_order::high_first>
using signed64 = detail::whole_form<std::int64_t, Unit, Order>;

namespace detail {

/// A count times ten to the power of a number; an end of 64 bits where these do not hold it.
[[nodiscard]] constexpr std::int64_t times_power_of_ten(std::int64_t count, int power) noexcept
{
    constexpr int most = 19; // beyond the largest count
    for (int i = 0; i < power and i < most; ++i) {
        count = bounded_product(count, 10);
    }
    return count;
}

/// Two counts, each times ten to the power of its own number, compared exactly: only one is multiplied, and what 64
/// bits do not hold of it is beyond the other.
[[nodiscard]] constexpr std::strong_ordering compared_decimals(std::int64_t left, int left_power, std::int64_t right,
                                                               int right_power) noexcept
{
    return times_power_of_ten(left, left_power - right_power) <=> times_power_of_ten(right, right_power - left_power);
}

} // namespace detail

/// A count of `Unit`'s steps, times ten to the power of `exponent()`. Compares with quantities of its dimension, by
/// value.
template <detail::any_quantity Unit> class scaled {
public:
    using unit = Unit;
    using dimension = typename Unit::dimension;
    static constexpr int power_of_unit = detail::power_of_ten<typename Unit::scale>();
    static_assert(power_of_unit > detail::no_power_of_ten,
                  "this step is no power of ten: name a unit of which it is one");

    /// Zero.
    constexpr scaled() noexcept = default;
    /// `count` times ten to the power of `exponent`, in steps of `Unit`.
    constexpr scaled(typename Unit::rep count, int exponent) noexcept
        : count_{count}, exponent_{static_cast<std::int8_t>(exponent)}
    {}

    /// As it stands in its register, and in the register of its scale.
    [[nodiscard]] constexpr typename Unit::rep count() const noexcept { return count_; }
    [[nodiscard]] constexpr int exponent() const noexcept { return exponent_; }

    /// As a floating point number, in the unit that `text_of` shows, or in that of a quantity: see `quantity`.
    template <std::floating_point Number, typename Other = quantity<dimension, std::uint16_t>>
    [[nodiscard]] constexpr Number as() const noexcept
    {
        Number const one = Unit{count_}.template as<Number, Other>();
        Number factor = 1;
        for (int i = 0; i < (exponent_ < 0 ? -exponent_ : exponent_); ++i) {
            factor *= 10;
        }
        return exponent_ < 0 ? one / factor : one * factor;
    }

    /// The nearest whole number of steps of a quantity, halves away from zero; `value_too_high` or `value_too_low` where
    /// it cannot hold them.
    template <detail::any_quantity Target> [[nodiscard]] constexpr result<Target> rounded_to() const noexcept
    {
        static_assert(std::same_as<typename Target::dimension, dimension>,
                      "these two measure different things: name a quantity of the same");
        constexpr int target_power = detail::power_of_ten<typename Target::scale>();
        static_assert(target_power > detail::no_power_of_ten,
                      "this step is no power of ten: name a unit of which it is one");
        int const power = exponent_ + power_of_unit - target_power;
        std::int64_t const divisor = detail::times_power_of_ten(1, -power);
        std::int64_t const all = detail::times_power_of_ten(count_, power);
        std::int64_t const rest = all % divisor;
        std::int64_t const up = detail::magnitude(rest) >= static_cast<std::uint64_t>(divisor - divisor / 2) ? 1 : 0;
        std::int64_t const steps = all / divisor + (all < 0 ? -up : up);
        using limits = std::numeric_limits<typename Target::rep>;
        if (std::cmp_greater(steps, (limits::max)()) or steps == detail::above_all) {
            return errc::value_too_high;
        }
        if (std::cmp_less(steps, (limits::min)()) or steps == detail::below_all) {
            return errc::value_too_low;
        }
        return Target{static_cast<typename Target::rep>(steps)};
    }

    template <detail::any_quantity Amount>
    [[nodiscard]] friend constexpr std::strong_ordering operator<=>(scaled left, Amount right) noexcept
    {
        static_assert(std::same_as<typename Amount::dimension, dimension>,
                      "these two measure different things, and do not compare");
        return detail::compared_decimals(left.count_, left.exponent_ + power_of_unit, right.count(),
                                         detail::power_of_ten<typename Amount::scale>());
    }
    template <detail::any_quantity Amount>
    [[nodiscard]] friend constexpr bool operator==(scaled left, Amount right) noexcept
    {
        return (left <=> right) == 0;
    }
    /// By value: 2300 with the exponent -1 is 230.
    [[nodiscard]] friend constexpr std::strong_ordering operator<=>(scaled left, scaled right) noexcept
    {
        return detail::compared_decimals(left.count_, left.exponent_, right.count_, right.exponent_);
    }
    [[nodiscard]] friend constexpr bool operator==(scaled left, scaled right) noexcept { return (left <=> right) == 0; }

private:
    typename Unit::rep count_{0};
    std::int8_t exponent_{0};
};

/// With its unit: "230.4 V", with the digits that its scale says.
template <typename Unit> [[nodiscard]] constexpr auto text_of(scaled<Unit> amount) noexcept
{
    constexpr std::size_t digits = sizeof(typename Unit::rep) * 5 / 2 + 1;
    constexpr std::size_t most_zeros = 28; // 18 of the unit and 10 of the exponent
    detail::short_text<1 + digits + most_zeros + 2 + sizeof(Unit::dimension::symbol)> text;
    if constexpr (sizeof(Unit::dimension::symbol) > 1) {
        text.precede(literal{Unit::dimension::symbol});
        text.precede(' ');
    }
    int const power = amount.exponent() + scaled<Unit>::power_of_unit;
    std::int64_t const count{amount.count()};
    for (int i = 0; i < power and count != 0; ++i) {
        text.precede('0');
    }
    detail::precede_by_number(text, detail::magnitude(count), power < 0 ? static_cast<unsigned>(-power) : 0U);
    if (count < 0) {
        text.precede('-');
    }
    return text;
}

/// A register of counts whose scale `Scale` holds, a register of `signed_count16`: `reg<scaled_by<volts, v_sf>>`. The
/// count is as wide and as signed as that of `Unit`, 16 or 32 bits. Both are read by one request. As SunSpec has it, the
/// smallest signed and the largest unsigned number mean "not implemented", and a scale lies between -10 and 10: anything
/// else is `value_without_meaning`. Such a register is written in steps that the program names: `write_with_step`.
template <detail::any_quantity Unit, auto const& Scale, word_order Order = word_order::high_first> struct scaled_by {
    using count_type = typename Unit::rep;
    static_assert(sizeof(count_type) == 2 or sizeof(count_type) == 4, "a scaled count has 16 or 32 bits");
    static_assert(std::same_as<value_of<Scale>, signed_count16>, "the scale is a register of signed_count16");
    static constexpr auto const& scale_register = Scale;
    static constexpr count_type most_of = (std::numeric_limits<count_type>::max)();

    using value_type = scaled<Unit>;
    static constexpr std::uint16_t word_count = sizeof(count_type) / 2;
    static constexpr word_order order = Order;
    /// The ends of the counts that mean something; the one beyond means "not implemented".
    static constexpr std::int64_t lowest = std::is_signed_v<count_type> ? -std::int64_t{most_of} : 0;
    static constexpr std::int64_t highest = std::int64_t{most_of} - (std::is_signed_v<count_type> ? 0 : 1);
    using words = std::array<std::uint16_t, word_count>;

    /// No value is written without a step.
    template <typename> static constexpr bool takes = false;

    [[nodiscard]] static constexpr result<value_type> from_words(words const& from, std::uint16_t scale) noexcept
    {
        constexpr int most = 10;
        int const exponent = detail::from_word<signed_count16>(scale).count();
        count_type const count = count_in(from);
        using limits = std::numeric_limits<count_type>;
        bool const is_missing = count == (std::is_signed_v<count_type> ? (limits::min)() : (limits::max)());
        if (is_missing or exponent < -most or exponent > most) {
            return errc::value_without_meaning;
        }
        return value_type{count, exponent};
    }

private:
    static constexpr count_type count_in(words const& from) noexcept
    {
        if constexpr (word_count == 1) {
            return static_cast<count_type>(detail::swapped_for<Order>(from[0]));
        } else {
            return static_cast<count_type>(detail::joined<Order>(from));
        }
    }
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
