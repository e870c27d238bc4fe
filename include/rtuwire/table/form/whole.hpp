// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Whole numbers of 32 and 64 bits in registers: `reg<unsigned32<watt_hours>>` holds quantities that count in 32 bits.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/word_order.hpp>
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

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
