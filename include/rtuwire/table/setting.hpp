// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A value that is proven to fit its register: a literal at compile time, a run-time value through `checked`
// or `clamped`. Limits that depend on other registers are checked where their values are known.
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <ratio>
#include <type_traits>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Never defined: reached only in a constant expression, so that the compiler prints the name.
void value_is_above_the_register_maximum();
void value_is_below_the_register_minimum();
void value_is_not_a_whole_number_of_register_steps();
void value_has_no_meaning_in_this_register();
void value_is_never_written_to_this_register();

/// The smallest raw count of a register, as far as it does not depend on another.
template <auto const& R> [[nodiscard]] constexpr std::int32_t lowest() noexcept
{
    if (R.min.is_number()) {
        return R.min.raw();
    }
    if constexpr (register_quantity<value_of<R>>) {
        return (std::numeric_limits<typename value_of<R>::rep>::min)();
    } else {
        return 0;
    }
}

/// The largest raw count of a register, as far as it does not depend on another.
template <auto const& R> [[nodiscard]] constexpr std::int32_t highest() noexcept
{
    if (R.max.is_number()) {
        return R.max.raw();
    }
    if constexpr (register_quantity<value_of<R>>) {
        return (std::numeric_limits<typename value_of<R>::rep>::max)();
    } else {
        return 0xFFFF;
    }
}

/// Whether a type is a quantity, of any dimension and width.
/// Internal.
template <typename T>
concept any_quantity = requires
{
    typename T::dimension;
    typename T::scale;
};

/// Whether a quantity measures what a register holds.
/// Internal.
template <typename Value, typename Amount> inline constexpr bool measures_the_same = false;
template <any_quantity Value, any_quantity Amount>
inline constexpr bool measures_the_same<Value, Amount> =
    std::same_as<typename Value::dimension, typename Amount::dimension>;

/// A value within the limits of register `R`.
template <auto const& R> class setting {
public:
    using value_type = value_of<R>;

    /// A value known at compile time and within the limits: a quantity that is a whole number of this register's
    /// steps, an enumerator or a bit field. One constructor that calls no other before it refuses: GCC prints a line
    /// for each call above the sentence. A plain number and another dimension are taken in order to be refused in
    /// plain words.
    template <typename Value>
        requires std::same_as<Value, value_type> or any_quantity<Value> or std::is_arithmetic_v<Value>
    consteval setting(Value value) noexcept : word_{static_cast<std::uint16_t>(numerator(value) / denominator<Value>)}
    {
        static_assert(not std::is_arithmetic_v<Value>,
                      "a plain number is no setting: give it a unit (3_s), or name an enumerator or bits");
        static_assert(not any_quantity<Value> or measures_the_same<value_type, Value>,
                      "this value measures something else than the register");
        std::int64_t const raw = numerator(value) / denominator<Value>;
        if (numerator(value) % denominator<Value> != 0) {
            value_is_not_a_whole_number_of_register_steps();
        }
        if (raw > highest<R>()) {
            value_is_above_the_register_maximum();
        }
        if (raw < lowest<R>()) {
            value_is_below_the_register_minimum();
        }
        if (raw >= R.gap.first and raw <= R.gap.last) {
            value_is_never_written_to_this_register();
        }
        if (not has_meaning(listed_words<value_type>(), word_)) {
            value_has_no_meaning_in_this_register();
        }
    }

    /// A value known only at run time; `illegal_data_value` outside the limits, and for an enumerator that
    /// does not exist.
    [[nodiscard]] static constexpr result<setting> checked(value_type value) noexcept
    {
        std::int32_t const raw = raw_count<value_type>(to_word(value));
        bool const is_inside = raw >= lowest<R>() and raw <= highest<R>() and not R.gap.contains(raw);
        if (not is_inside or not has_meaning(listed_words<value_type>(), to_word(value))) {
            return errc::illegal_data_value;
        }
        return setting{proven{}, to_word(value)};
    }

    /// A value known only at run time, with the limits that depend on other registers, in raw counts.
    [[nodiscard]] static constexpr result<setting> checked(value_type value, std::int32_t min_now,
                                                           std::int32_t max_now) noexcept
    {
        std::int32_t const raw = raw_count<value_type>(to_word(value));
        if (raw < min_now or raw > max_now) {
            return errc::illegal_data_value;
        }
        return checked(value);
    }

    /// The nearest value within the limits; the lower end of a gap where it lies in one.
    [[nodiscard]] static constexpr setting clamped(value_type value) noexcept requires register_quantity<value_type>
    {
        std::int32_t raw = raw_count<value_type>(to_word(value));
        if (raw < lowest<R>()) {
            raw = lowest<R>();
        }
        if (raw > highest<R>()) {
            raw = highest<R>();
        }
        if (R.gap.contains(raw)) {
            raw = R.gap.first - 1;
        }
        return setting{proven{}, static_cast<std::uint16_t>(raw)};
    }

    /// The word that stands on the wire.
    [[nodiscard]] constexpr std::uint16_t word() const noexcept { return word_; }

    [[nodiscard]] constexpr value_type value() const noexcept { return from_word<value_type>(word_); }

private:
    struct proven {};
    constexpr setting(proven, std::uint16_t word) noexcept : word_{word} {}

    /// How many of a value's units make one step of the register, as a fraction; 1 where either counts none.
    template <typename Value, bool = measures_the_same<value_type, Value>> struct ratio_of : std::ratio<1> {};
    template <typename Value>
    struct ratio_of<Value, true> : std::ratio_divide<typename Value::scale, typename value_type::scale> {};
    template <typename Value> static constexpr std::int64_t denominator = ratio_of<Value>::den;

    /// A value in raw counts, times the denominator.
    template <typename Value> static constexpr std::int64_t numerator(Value value) noexcept
    {
        if constexpr (any_quantity<Value>) {
            return std::int64_t{value.count()} * ratio_of<Value>::num;
        } else if constexpr (std::is_arithmetic_v<Value>) {
            return 0;
        } else {
            return raw_count<Value>(to_word(value));
        }
    }

    std::uint16_t word_;
};

} // namespace rtuwire
