// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A value that is proven to fit its register: a literal at compile time, a run-time value through `checked`
// or `clamped`. Limits that depend on other registers are checked where their values are known.
#pragma once

#include <cstdint>
#include <limits>
#include <ratio>

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
        return std::numeric_limits<typename value_of<R>::rep>::min();
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
        return std::numeric_limits<typename value_of<R>::rep>::max();
    } else {
        return 0xFFFF;
    }
}

/// Whether a register's values are quantities of a dimension.
template <typename Value, typename Dimension> inline constexpr bool measures_dimension = false;
template <register_quantity Value, typename Dimension>
inline constexpr bool measures_dimension<Value, Dimension> = std::same_as<typename Value::dimension, Dimension>;

/// A value within the limits of register `R`.
template <auto const& R> class setting {
public:
    using value_type = value_of<R>;

    /// A quantity known at compile time, a whole number of this register's steps and within its limits.
    template <typename Dimension, std::integral Rep, typename Scale>
        requires measures_dimension<value_type, Dimension>
    consteval setting(quantity<Dimension, Rep, Scale> amount) noexcept : word_{word_of(amount)} {}

    /// Refused: a quantity of another dimension than this register holds.
    template <typename Dimension, std::integral Rep, typename Scale>
        requires(not measures_dimension<value_type, Dimension>)
    consteval setting(quantity<Dimension, Rep, Scale>) noexcept : word_{0}
    {
        static_assert(measures_dimension<value_type, Dimension>,
                      "this value measures something else than the register");
    }

    /// An enumerator or bit field known at compile time.
    consteval setting(value_type value) noexcept requires(not register_quantity<value_type>) : word_{to_word(value)}
    {
        refuse_outside(raw_count<value_type>(word_));
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

    static constexpr void refuse_outside(std::int64_t raw) noexcept
    {
        if (raw > highest<R>()) {
            value_is_above_the_register_maximum();
        }
        if (raw < lowest<R>()) {
            value_is_below_the_register_minimum();
        }
        if (raw >= R.gap.first and raw <= R.gap.last) {
            value_is_never_written_to_this_register();
        }
    }

    template <typename Amount> static constexpr std::uint16_t word_of(Amount amount) noexcept
    {
        using factor = std::ratio_divide<typename Amount::scale, typename value_type::scale>;
        std::int64_t const scaled = std::int64_t{amount.count()} * factor::num;
        if (scaled % factor::den != 0) {
            value_is_not_a_whole_number_of_register_steps();
        }
        refuse_outside(scaled / factor::den);
        return static_cast<std::uint16_t>(scaled / factor::den);
    }

    std::uint16_t word_;
};

} // namespace rtuwire
