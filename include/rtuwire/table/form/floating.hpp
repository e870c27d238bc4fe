// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Floating point numbers of 32 and 64 bits in registers: `reg<float32<kilowatt_hours, word_order::low_first>>`.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <ratio>
#include <type_traits>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/real.hpp>
#include <rtuwire/table/form/word_order.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

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
