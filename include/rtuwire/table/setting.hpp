// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A value that is proven to fit its register: a literal at compile time, a run-time value through `checked`
// or `clamped`. Limits that depend on other registers are checked where their values are known. And registers whose steps
// another register sets, counted in steps that the program names: a step has the width of its register; that of a count with
// a scale has its sign and the order of its words, too.
#pragma once

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

namespace detail {

/// Whether a step counts numbers with a sign.
template <typename Step> [[nodiscard]] consteval bool is_signed_step() noexcept
{
    if constexpr (requires { typename Step::count_type; }) {
        return std::is_signed_v<typename Step::count_type>;
    } else {
        return std::is_signed_v<typename Step::rep>;
    }
}

/// Whether the words of a step stand in an order; a step of one word has its high byte first.
template <typename Step> [[nodiscard]] consteval bool is_in_order(word_order order) noexcept
{
    if constexpr (requires { Step::order; }) {
        return Step::order == order;
    } else {
        return not swaps_bytes(order);
    }
}

/// The address of a register that is counted in other steps; these have as many words.
template <typename Step, auto const& R> [[nodiscard]] consteval std::uint16_t restepped_address() noexcept
{
    static_assert(held_by<Step>::words == R.word_count, "a step is as wide as its register: name one of so many bits");
    if constexpr (has_scale_register<R>) {
        using form = typename std::remove_cvref_t<decltype(R)>::form;
        static_assert(is_signed_step<Step>() == std::is_signed_v<typename form::count_type>,
                      "a step has a sign where its register has one");
        static_assert(is_in_order<Step>(form::order), "a step has the word order of its register");
    }
    return R.address;
}

/// A limit of a register in other steps. What means "not implemented" in a count with a scale is never written.
template <auto const& R> [[nodiscard]] consteval bound restepped_limit(bound limit, bool is_highest) noexcept
{
    if constexpr (has_scale_register<R>) {
        using form = typename std::remove_cvref_t<decltype(R)>::form;
        std::int64_t const end = is_highest ? form::highest : form::lowest;
        bool const is_beyond = limit.is_number() and (is_highest ? limit.raw() > end : limit.raw() < end);
        return limit.is_open() or is_beyond ? bound{end} : limit;
    }
    return limit;
}

} // namespace detail

/// A register whose steps another register sets, counted in steps that the caller knows. It can be named
/// wherever the register can.
template <typename Step, auto const& R>
inline constexpr typename std::remove_cvref_t<decltype(R)>::template in_steps<Step> restepped{
    reg<Step, std::remove_cvref_t<decltype(R)>::space>{.code = R.code,
                                                       .address = detail::restepped_address<Step, R>(),
                                                       .mode = R.mode,
                                                       .min = detail::restepped_limit<R>(R.min, false),
                                                       .max = detail::restepped_limit<R>(R.max, true),
                                                       .factory = R.factory,
                                                       .name = R.name,
                                                       .source = R.source,
                                                       .gap = R.gap,
                                                       .counted_as = &R,
                                                       .is_restepped = true}};

/// Never defined: reached only in a constant expression, so that the compiler prints the name.
void value_is_above_the_register_maximum();
void value_is_below_the_register_minimum();
void value_is_not_a_whole_number_of_register_steps();
void value_has_no_meaning_in_this_register();
void value_is_never_written_to_this_register();

namespace detail {

/// The smallest raw count of a register of one word, as far as its limit is a number.
template <register_value T> [[nodiscard]] constexpr std::int32_t lowest_count(bound const& min) noexcept
{
    if (min.is_number()) {
        return static_cast<std::int32_t>(min.raw());
    }
    if constexpr (register_quantity<T>) {
        return (std::numeric_limits<typename T::rep>::min)();
    } else {
        return 0;
    }
}

/// The largest raw count of a register of one word, as far as its limit is a number.
template <register_value T> [[nodiscard]] constexpr std::int32_t highest_count(bound const& max) noexcept
{
    if (max.is_number()) {
        return static_cast<std::int32_t>(max.raw());
    }
    if constexpr (register_quantity<T>) {
        return (std::numeric_limits<typename T::rep>::max)();
    } else {
        return 0xFFFF;
    }
}

} // namespace detail

/// The smallest raw count of a register of one word, as far as it does not depend on another.
template <auto const& R> [[nodiscard]] constexpr std::int32_t lowest() noexcept
{
    return detail::lowest_count<value_of<R>>(R.min);
}

/// The largest raw count of a register of one word, as far as it does not depend on another.
template <auto const& R> [[nodiscard]] constexpr std::int32_t highest() noexcept
{
    return detail::highest_count<value_of<R>>(R.max);
}

namespace detail {

/// How many units of `Value` make one step of `Target`, as a fraction; 1 where either counts none.
template <typename Target, typename Value, bool = measures_the_same<Target, Value>>
struct step_ratio : std::ratio<1> {};
template <typename Target, typename Value>
struct step_ratio<Target, Value, true> : std::ratio_divide<typename Value::scale, typename Target::scale> {};

/// An amount in steps of `Target`; `value_between_steps` where it is no whole number of them, an end of 64 bits where
/// these do not hold it.
template <typename Target, any_quantity Value>
[[nodiscard]] constexpr result<std::int64_t> whole_steps(Value value) noexcept
{
    using ratio = step_ratio<Target, Value>;
    std::int64_t const parts = bounded_product(value.count(), ratio::num);
    if (is_out_of_range(parts)) {
        return parts;
    }
    if (parts % ratio::den != 0) {
        return errc::value_between_steps;
    }
    return parts / ratio::den;
}

/// Whether a value is a floating point amount for a register that counts whole steps of the same.
template <typename Target, typename Value> inline constexpr bool is_unrounded = any_quantity<Target>and requires
{
    requires std::floating_point<typename Value::rep>;
    requires std::same_as<typename Value::dimension, typename Target::dimension>;
};

} // namespace detail

/// A value within the limits of register `R`. table/form/form_setting.hpp has the same for forms of several words.
template <auto const& R> class setting {
public:
    using value_type = value_of<R>;

    /// A value known at compile time and within the limits: a quantity that is a whole number of this register's
    /// steps, an enumerator or a bit field. One constructor that calls no other before it refuses: GCC prints a line
    /// for each call above the sentence. A plain number and another dimension are taken in order to be refused in
    /// plain words.
    template <typename Value>
        requires std::same_as<Value, value_type> or detail::any_quantity<Value> or std::is_arithmetic_v<Value>
    consteval setting(Value value) noexcept : word_{static_cast<std::uint16_t>(numerator(value) / denominator<Value>)}
    {
        static_assert(not std::is_arithmetic_v<Value>,
                      "a plain number is no setting: give it a unit (3_s), or name an enumerator or bits");
        static_assert(not detail::any_quantity<Value> or detail::measures_the_same<value_type, Value>,
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
        if (not detail::has_meaning(detail::listed_words<value_type>(), word_)) {
            value_has_no_meaning_in_this_register();
        }
    }

    /// A value known only at run time, in any unit of what the register measures. What does not fit is refused with the
    /// reason: `value_too_high`, `value_too_low`, `value_between_steps`, `value_never_written`, `value_without_meaning`.
    /// Limits that depend on other registers are given in raw counts.
    template <typename Value>
    [[nodiscard]] static constexpr result<setting> checked(Value value, std::int32_t min_now = lowest<R>(),
                                                           std::int32_t max_now = highest<R>()) noexcept
    {
        static_assert(not std::is_arithmetic_v<Value>,
                      "a plain number is no setting: give it a unit (n * 0.1_s), or name an enumerator or bits");
        static_assert(not detail::is_unrounded<value_type, Value>,
                      "this register counts whole steps: rounded_to first");
        static_assert(std::is_arithmetic_v<Value> or std::same_as<Value, value_type> or
                          detail::is_unrounded<value_type, Value> or detail::measures_the_same<value_type, Value>,
                      "this value measures something else than the register");
        auto const raw = raw_of(value);
        errc const why = not raw ? raw.error() : refusal(*raw, min_now, max_now);
        if (why != errc::none) {
            return why;
        }
        return setting{proven{}, static_cast<std::uint16_t>(*raw)};
    }

    /// The nearest value within the limits; the lower end of a gap where it lies in one.
    [[nodiscard]] static constexpr setting
    clamped(value_type value) noexcept requires detail::register_quantity<value_type>
    {
        std::int32_t raw = detail::raw_count<value_type>(detail::to_word(value));
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

    [[nodiscard]] constexpr value_type value() const noexcept { return detail::from_word<value_type>(word_); }

private:
    struct proven {};
    constexpr setting(proven, std::uint16_t word) noexcept : word_{word} {}

    /// Why a raw count is not written; `none` where it may be.
    static constexpr errc refusal(std::int32_t raw, std::int32_t min_now, std::int32_t max_now) noexcept
    {
        if (raw > max_now or raw > highest<R>()) {
            return errc::value_too_high;
        }
        if (raw < min_now or raw < lowest<R>()) {
            return errc::value_too_low;
        }
        if (R.gap.contains(raw)) {
            return errc::value_never_written;
        }
        return detail::has_meaning(detail::listed_words<value_type>(), static_cast<std::uint16_t>(raw))
                   ? errc::none
                   : errc::value_without_meaning;
    }

    /// A value in raw counts; an error where it is no whole number of them, or far outside of any register.
    template <typename Value> static constexpr result<std::int32_t> raw_of(Value value) noexcept
    {
        if constexpr (std::same_as<Value, value_type>) {
            return detail::raw_count<value_type>(detail::to_word(value));
        } else if constexpr (detail::any_quantity<Value>) {
            auto const raw = detail::whole_steps<value_type>(value);
            if (not raw) {
                return raw.error();
            }
            using limits = std::numeric_limits<std::int32_t>;
            if (*raw > (limits::max)()) {
                return errc::value_too_high;
            }
            if (*raw < (limits::min)()) {
                return errc::value_too_low;
            }
            return static_cast<std::int32_t>(*raw);
        } else {
            return errc::value_without_meaning;
        }
    }

    template <typename Value> using ratio_of = detail::step_ratio<value_type, Value>;
    template <typename Value> static constexpr std::int64_t denominator = ratio_of<Value>::den;

    /// A value in raw counts, times the denominator.
    template <typename Value> static constexpr std::int64_t numerator(Value value) noexcept
    {
        if constexpr (detail::any_quantity<Value>) {
            return std::int64_t{value.count()} * ratio_of<Value>::num;
        } else if constexpr (std::is_arithmetic_v<Value>) {
            return 0;
        } else {
            return detail::raw_count<Value>(detail::to_word(value));
        }
    }

    std::uint16_t word_;
};

namespace detail {

/// Whether a type is a setting of some register.
template <typename T> inline constexpr bool is_setting = false;
template <auto const& R> inline constexpr bool is_setting<setting<R>> = true;

/// A value known only at run time, on its way to a register: becomes a setting of it, or the reason why not.
template <typename Value> class value_to_check {
public:
    explicit constexpr value_to_check(Value its_value) noexcept : value_{its_value} {}

    template <typename Setting>
        requires(is_setting<Setting>)
    constexpr operator result<Setting>() const noexcept { return Setting::checked(value_); }

private:
    Value value_;
};

} // namespace detail

/// A value known only at run time, where a setting is written: `write<atv12::acc>(drive, checked(n * 0.1_s))`. A value
/// that the register does not take is not sent; the outcome says why.
template <typename Value> [[nodiscard]] constexpr detail::value_to_check<Value> checked(Value value) noexcept
{
    static_assert(not std::is_arithmetic_v<Value>,
                  "a plain number is no setting: give it a unit (n * 0.1_s), or name an enumerator or bits");
    return detail::value_to_check<Value>{value};
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
