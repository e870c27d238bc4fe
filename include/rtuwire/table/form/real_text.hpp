// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Floating point numbers as people read them: "12.5 kWh", right to the last digit shown. They are taken apart bit by
// bit, in place: no heap, no floating point arithmetic, no printf. Apart from the numbers, because it is longer than they
// are, and firmware that shows none does not read it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/floating.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// What IEEE 754 makes of a number's bits.
template <typename Float> struct float_layout {
    static constexpr bool is_single = sizeof(Float) == 4;
    using bits = std::conditional_t<is_single, std::uint32_t, std::uint64_t>;
    static constexpr unsigned fraction_bits = is_single ? 23 : 52;
    static constexpr unsigned largest_exponent = is_single ? 0xFF : 0x7FF;
    static constexpr std::size_t words_before_point = is_single ? 4 : 32; ///< of 32 bits
    static constexpr std::size_t words_behind_point = is_single ? 5 : 34;
    static constexpr std::size_t places_before_point = is_single ? 39 : 309; ///< of a decimal number
    static constexpr unsigned digits = is_single ? 7 : 15;                   ///< shown, zeros at the end left out
};

/// The whole of a finite number as a binary one with a fixed point, from which the decimal digits are taken.
template <typename Float> class fixed_point {
    using layout = float_layout<Float>;
    static constexpr std::size_t behind = layout::words_behind_point;
    static constexpr std::size_t size = behind + layout::words_before_point;

public:
    explicit constexpr fixed_point(typename layout::bits its_bits) noexcept
    {
        constexpr typename layout::bits one = 1;
        typename layout::bits const fraction = its_bits & ((one << layout::fraction_bits) - 1U);
        auto const exponent = static_cast<unsigned>((its_bits >> layout::fraction_bits) & layout::largest_exponent);
        // The lowest bit of the smallest number stands one place lower than in an exponent of 1, which 0 stands for.
        unsigned const place = static_cast<unsigned>(32U * behind) - lowest_place + (exponent == 0 ? 0 : exponent - 1U);
        put(fraction | (exponent == 0 ? 0 : one << layout::fraction_bits), place);
    }

    /// Divides what is before the point by ten; returns the remainder, its last digit.
    constexpr std::uint8_t take_digit_before() noexcept
    {
        std::uint64_t rest = 0;
        for (std::size_t i = size; i-- > behind;) {
            std::uint64_t const part = rest << 32U | words_[i];
            words_[i] = static_cast<std::uint32_t>(part / 10U);
            rest = part % 10U;
        }
        return static_cast<std::uint8_t>(rest);
    }

    /// Multiplies what is behind the point by ten; returns its first digit.
    constexpr std::uint8_t take_digit_behind() noexcept
    {
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < behind; ++i) {
            std::uint64_t const part = std::uint64_t{words_[i]} * 10U + carry;
            words_[i] = static_cast<std::uint32_t>(part & 0xFFFF'FFFFU);
            carry = part >> 32U;
        }
        return static_cast<std::uint8_t>(carry);
    }

    [[nodiscard]] constexpr bool is_any_before() const noexcept { return is_any(behind, size); }
    [[nodiscard]] constexpr bool is_any_behind() const noexcept { return is_any(0, behind); }

private:
    /// Where the lowest bit of the smallest number stands behind the point.
    static constexpr unsigned lowest_place = layout::is_single ? 149 : 1074;

    constexpr void put(std::uint64_t bits, unsigned place) noexcept
    {
        for (; bits != 0; bits >>= 1U, ++place) {
            if ((bits & 1U) != 0) {
                words_[place / 32U] |= std::uint32_t{1} << (place % 32U);
            }
        }
    }

    [[nodiscard]] constexpr bool is_any(std::size_t first, std::size_t end) const noexcept
    {
        bool found = false;
        for (std::size_t i = first; i < end; ++i) {
            found = found or words_[i] != 0;
        }
        return found;
    }

    std::array<std::uint32_t, size> words_{}; ///< the lowest first
};

/// Decimal digits, the first one not 0, and the power of ten that it counts.
struct decimal_digits {
    static constexpr int most = 15;
    std::array<std::uint8_t, most> digits{};
    int count{0};
    int exponent{0};

    /// One more in the last place; 99 becomes 10 with a higher exponent.
    constexpr void round_up() noexcept
    {
        int at = count - 1;
        while (at >= 0 and digits[static_cast<std::size_t>(at)] == 9) {
            digits[static_cast<std::size_t>(at--)] = 0;
        }
        if (at < 0) {
            digits[0] = 1;
            ++exponent;
        } else {
            ++digits[static_cast<std::size_t>(at)];
        }
    }

    constexpr void drop_zeros() noexcept
    {
        while (count > 1 and digits[static_cast<std::size_t>(count - 1)] == 0) {
            --count;
        }
    }
};

/// The digits of a finite number above zero, times a power of ten: at least so many as its type has, all before the
/// point where these are up to 15, rounded to the nearest, halves to the even one.
template <typename Float>
[[nodiscard]] constexpr decimal_digits digits_of(typename float_layout<Float>::bits bits, int shift) noexcept
{
    using layout = float_layout<Float>;
    fixed_point<Float> number{bits};
    std::array<std::uint8_t, layout::places_before_point> before{};
    int places = 0;
    for (; number.is_any_before(); ++places) {
        before[static_cast<std::size_t>(places)] = number.take_digit_before();
    }
    decimal_digits found{.exponent = places - 1 + shift};
    auto wanted = static_cast<int>(layout::digits);
    wanted = found.exponent < decimal_digits::most and found.exponent + 1 > wanted ? found.exponent + 1 : wanted;
    auto const take = [&] {
        return places > 0 ? before[static_cast<std::size_t>(--places)] : number.take_digit_behind();
    };
    while (found.count < wanted) {
        std::uint8_t const digit = take();
        if (found.count == 0 and digit == 0) {
            --found.exponent;
        } else {
            found.digits[static_cast<std::size_t>(found.count++)] = digit;
        }
    }
    std::uint8_t const next = take();
    bool is_more = number.is_any_behind();
    while (places > 0) {
        is_more = take() != 0 or is_more;
    }
    bool const is_odd = found.digits[static_cast<std::size_t>(found.count - 1)] % 2U != 0;
    if (next > 5 or (next == 5 and (is_more or is_odd))) {
        found.round_up();
    }
    found.drop_zeros();
    return found;
}

/// Sets digits before a text: plain from 0.00001 up to 15 digits before the point, else as "1.5e-7".
template <std::size_t Capacity>
constexpr void precede_by_digits(short_text<Capacity>& text, decimal_digits const& number) noexcept
{
    bool const is_plain = number.exponent >= -5 and number.exponent < decimal_digits::most;
    int const point = is_plain ? number.exponent : 0; // the power of ten of the digit before the point
    if (not is_plain) {
        bool const is_negative = number.exponent < 0;
        precede_by_number(text, static_cast<std::uint32_t>(is_negative ? -number.exponent : number.exponent));
        text.precede(is_negative ? literal{"e-"} : literal{"e"});
    }
    int const last = point - number.count + 1; // the power of ten of the last digit
    for (int power = last < 0 ? last : 0; power <= point or power <= 0; ++power) {
        if (power == 0 and last < 0) {
            text.precede('.');
        }
        int const at = point - power;
        bool const is_digit = at >= 0 and at < number.count;
        text.precede(static_cast<char>('0' + (is_digit ? number.digits[static_cast<std::size_t>(at)] : 0)));
    }
}

} // namespace detail

/// An amount with its unit: "12.5 kWh", "0.001 A", "1.5e21 W". Seven digits of a float, 15 of a double, rounded to the
/// nearest, zeros at the end left out; all that stand before the point, where they are up to 15.
template <typename Unit, typename Float> [[nodiscard]] constexpr auto text_of(real<Unit, Float> amount) noexcept
{
    using layout = detail::float_layout<Float>;
    constexpr int shift = detail::power_of_ten<typename Unit::scale>();
    static_assert(shift > detail::no_power_of_ten, "this step is no power of ten: it has no digits");
    constexpr std::size_t longest = 1 + 2 + 4 + detail::decimal_digits::most + 5;
    detail::short_text<longest + sizeof(Unit::dimension::symbol)> text;
    auto const bits = std::bit_cast<typename layout::bits>(amount.count());
    constexpr auto sign = static_cast<typename layout::bits>(typename layout::bits{1} << (8U * sizeof(Float) - 1U));
    if constexpr (sizeof(Unit::dimension::symbol) > 1) {
        text.precede(literal{Unit::dimension::symbol});
        text.precede(' ');
    }
    auto const size = static_cast<typename layout::bits>(bits & ~sign);
    if (not detail::is_finite(bits)) {
        text = {};
        text.precede((size << (sizeof(Float) * 8U - layout::fraction_bits)) != 0 ? literal{"not a number"}
                                                                                 : literal{"infinite"});
        return text;
    }
    if (size == 0) {
        text.precede('0');
        return text;
    }
    detail::precede_by_digits(text, detail::digits_of<Float>(size, shift));
    if (size != bits) {
        text.precede('-');
    }
    return text;
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
