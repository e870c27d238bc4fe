// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A value that is proven to fit its register, of a form of several words or of a coil. table/setting.hpp has that for one
// word, and the sentences; most drives have no other, and a program of theirs does not read this.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Never defined: reached only in a constant expression, so that the compiler prints the name.
void this_text_is_longer_than_its_registers();

namespace detail {

/// A plain number where a value with a unit is wanted.
template <auto const& R, typename Value>
inline constexpr bool is_plain_number = std::is_arithmetic_v<Value> and not std::same_as<value_of<R>, bool>;

} // namespace detail

/// A value within the limits of a register of several words, of a coil, or of a discrete input.
template <auto const& R>
    requires(not detail::register_value<value_of<R>>)
class setting<R> {
    static_assert(not detail::has_scale_register<R>,
                  "another register sets this register's steps: name them with write_with_step");
    using form = detail::register_form_of<R>;

public:
    using value_type = value_of<R>;

    /// A value known at compile time and within the limits, in any unit of what the register measures. A plain number
    /// and another dimension are taken in order to be refused in plain words.
    template <typename Value>
        requires(not std::same_as<value_type, bool> and
                 (form::template takes<Value> or detail::any_quantity<Value> or std::is_arithmetic_v<Value>))
    consteval setting(Value const& value) noexcept : value_{as_far_as_it_fits(value)}
    {
        static_assert(not detail::is_plain_number<R, Value>,
                      "a plain number is no setting: give it a unit (3_s), or name an enumerator or bits");
        static_assert(detail::is_plain_number<R, Value> or form::template takes<Value>,
                      "this value measures something else than the register");
        errc const why = why_not(value);
        if (why == errc::value_between_steps) {
            value_is_not_a_whole_number_of_register_steps();
        }
        if (why == errc::value_too_high and is_text) {
            this_text_is_longer_than_its_registers();
        }
        if (why == errc::value_too_high) {
            value_is_above_the_register_maximum();
        }
        if (why == errc::value_too_low) {
            value_is_below_the_register_minimum();
        }
        if (why == errc::value_never_written) {
            value_is_never_written_to_this_register();
        }
        if (why != errc::none) {
            value_has_no_meaning_in_this_register();
        }
    }

    /// A coil is on or off, also where only the running program knows which.
    template <std::same_as<bool> Value>
        requires(std::same_as<value_type, bool>)
    constexpr setting(Value value) noexcept : value_{value} {}

    /// A value known only at run time, in any unit of what the register measures. What does not fit is refused with the
    /// reason: `value_too_high`, `value_too_low`, `value_between_steps`, `value_never_written`, `value_without_meaning`.
    template <typename Value> [[nodiscard]] static constexpr result<setting> checked(Value const& value) noexcept
    {
        static_assert(not detail::is_plain_number<R, Value>,
                      "a plain number is no setting: give it a unit (n * 0.1_s), or name an enumerator or bits");
        static_assert(form::template takes<Value> or not detail::is_unrounded<value_type, Value>,
                      "this register counts whole steps: rounded_to first");
        static_assert(detail::is_plain_number<R, Value> or detail::is_unrounded<value_type, Value> or
                          form::template takes<Value>,
                      "this value measures something else than the register");
        if (errc const why = why_not(value); why != errc::none) {
            return why;
        }
        return setting{proven{}, as_far_as_it_fits(value)};
    }

    /// The words that stand on the wire.
    [[nodiscard]] constexpr auto words() const noexcept { return form::to_words(value_); }

    [[nodiscard]] constexpr value_type value() const noexcept { return value_; }

private:
    static constexpr bool is_text = requires(value_type const& value) { value.size(); };

    struct proven {};
    constexpr setting(proven, value_type value) noexcept : value_{value} {}

    template <typename Value> static constexpr errc why_not(Value const& value) noexcept
    {
        if constexpr (form::template takes<Value>) {
            auto const converted = form::convert(value);
            return converted ? form::refusal(*converted, R.min, R.max, R.gap) : converted.error();
        } else {
            return errc::none; // refused by a sentence
        }
    }

    template <typename Value> static constexpr value_type as_far_as_it_fits(Value const& value) noexcept
    {
        if constexpr (form::template takes<Value>) {
            return form::convert(value).value_or(value_type{});
        } else {
            return value_type{};
        }
    }

    value_type value_;
};

namespace detail {

/// The words of a setting, as they stand on the wire.
template <auto const& R>
[[nodiscard]] constexpr std::array<std::uint16_t, R.word_count> setting_words(setting<R> const& of) noexcept
{
    if constexpr (requires { of.words(); }) {
        return of.words();
    } else {
        return {of.word()};
    }
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
