// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Amounts as people read them: "-5.2 Hz", with the digits of their step, in a buffer of the right size. Nothing of it
// divides, allocates or knows floating point.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ratio>
#include <type_traits>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/quantity.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Up to `Capacity` characters, stored in place, without a terminating zero. It is written from its end to its start,
/// as the digits of a number are found. What is too much is left out.
template <std::size_t Capacity> class short_text {
public:
    [[nodiscard]] constexpr std::size_t size() const noexcept { return Capacity - first_; }
    [[nodiscard]] constexpr char const* begin() const noexcept { return characters_.data() + first_; }
    [[nodiscard]] constexpr char const* end() const noexcept { return characters_.data() + Capacity; }

    /// As a std::string_view, valid as long as this text.
    template <character_view View> constexpr operator View() const& noexcept { return View(begin(), size()); }
    /// A temporary text gives no view; it makes a std::string, and goes to a stream.
    template <character_view View> constexpr operator View() const&& noexcept
    {
        static_assert(not character_view<View>,
                      "a text that ends with its expression gives no view: give it a name first");
        return View();
    }

    friend constexpr bool operator==(short_text const& left, literal right) noexcept
    {
        bool is_same = left.size() == right.size();
        for (std::size_t i = 0; is_same and i < right.size(); ++i) {
            is_same = left.begin()[i] == right[i];
        }
        return is_same;
    }

    /// Sets characters before those that are there.
    constexpr void precede(char const* characters, std::size_t size) noexcept
    {
        for (; size > 0; --size) {
            precede(characters[size - 1]);
        }
    }
    constexpr void precede(literal characters) noexcept { precede(characters.begin(), characters.size()); }
    constexpr void precede(char character) noexcept
    {
        if (first_ > 0) {
            characters_[--first_] = character;
        }
    }

private:
    std::size_t first_{Capacity};
    std::array<char, Capacity> characters_{};
};

/// A tenth, the remainder cut off: by shifts, because a Cortex-M0+ would need 300 bytes for a division.
template <std::unsigned_integral Size> [[nodiscard]] constexpr Size tenth_of(Size size) noexcept
{
    Size tenth = static_cast<Size>((size >> 1U) + (size >> 2U));
    tenth += tenth >> 4U;
    tenth += tenth >> 8U;
    tenth += tenth >> 16U;
    if constexpr (sizeof(Size) == 8) {
        tenth += tenth >> 32U;
    }
    tenth >>= 3U;
    return static_cast<Size>(size - tenth * 10U) > 9U ? static_cast<Size>(tenth + 1U) : tenth;
}

/// Sets a number before a text, with `decimals` digits behind its point.
template <std::size_t Capacity, std::unsigned_integral Size>
constexpr void precede_by_number(short_text<Capacity>& text, Size size, unsigned decimals = 0) noexcept
{
    for (unsigned at = 0; at <= decimals or size != 0; ++at) {
        if (at == decimals and at != 0) {
            text.precede('.');
        }
        Size const tenth = tenth_of(size);
        text.precede(static_cast<char>('0' + static_cast<char>(size - tenth * 10U)));
        size = tenth;
    }
}

/// How a step is written: it counts `factor` in the last of `decimals` digits, followed by `zeros`.
struct step_form {
    unsigned decimals{0};
    unsigned zeros{0};
    std::intmax_t factor{1};
};

template <typename Scale> [[nodiscard]] consteval step_form form_of() noexcept
{
    step_form form{.factor = Scale::num};
    std::intmax_t den = Scale::den;
    for (; form.decimals < 18 and form.factor % den != 0; ++form.decimals) {
        form.factor *= den % 10 == 0 ? 1 : 10;
        den = den % 10 == 0 ? den / 10 : den;
    }
    form.factor = form.factor % den == 0 ? form.factor / den : 0;
    for (; form.decimals == 0 and form.factor % 10 == 0 and form.factor != 0; ++form.zeros) {
        form.factor /= 10;
    }
    return form;
}

/// The digits of the largest number of a type, and more than enough for a factor.
template <typename Amount> [[nodiscard]] consteval std::size_t longest_text() noexcept
{
    constexpr step_form form = form_of<typename Amount::scale>();
    constexpr std::size_t digits = (sizeof(typename Amount::rep) * 5 + 1) / 2 + 1 + (form.factor > 1 ? 10 : 0);
    constexpr std::size_t shown = digits > form.decimals ? digits : form.decimals + 1;
    return 1 + shown + 1 + form.zeros + 1 + sizeof(Amount::dimension::symbol) - 1;
}

} // namespace detail

/// A text is its own; so a text can be shown where any value can.
template <std::same_as<literal> Text> [[nodiscard]] constexpr literal text_of(Text text) noexcept { return text; }
template <std::size_t Capacity>
[[nodiscard]] constexpr detail::short_text<Capacity> text_of(detail::short_text<Capacity> const& text) noexcept
{
    return text;
}

/// An amount with its unit: "-5.2 Hz", "0.05 A", "1500 rpm". It becomes a std::string_view of the characters in it,
/// and has `begin()`, `end()` and `size()`.
template <typename Dimension, typename Rep, typename Scale>
[[nodiscard]] constexpr auto text_of(quantity<Dimension, Rep, Scale> amount) noexcept
{
    using shown = quantity<Dimension, Rep, Scale>;
    constexpr detail::step_form form = detail::form_of<typename shown::scale>();
    static_assert(form.factor != 0, "this step is no decimal fraction: it has no digits");
    using number = std::conditional_t<sizeof(Rep) <= 4 and form.factor == 1, std::uint32_t, std::uint64_t>;
    detail::short_text<detail::longest_text<shown>()> text;
    literal const symbol{Dimension::symbol};
    std::int64_t const count = detail::bounded_product(amount.count(), form.factor);
    if (sizeof(Rep) == 8 and detail::is_out_of_range(count)) {
        text.precede("out of range");
        return text;
    }
    if constexpr (sizeof(Dimension::symbol) > 1) {
        text.precede(symbol);
        text.precede(' ');
    }
    for (unsigned i = 0; i < form.zeros and count != 0; ++i) {
        text.precede('0');
    }
    detail::precede_by_number(text, static_cast<number>(detail::magnitude(count)), form.decimals);
    if (count < 0) {
        text.precede('-');
    }
    return text;
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
