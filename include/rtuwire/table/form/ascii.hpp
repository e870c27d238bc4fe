// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Texts in registers, two characters in each: names, serial numbers, versions.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Up to `Capacity` characters from registers, stored in place, without a terminating zero.
template <std::size_t Capacity> class ascii_text {
public:
    /// An empty text.
    constexpr ascii_text() noexcept = default;

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr char operator[](std::size_t index) const noexcept { return characters_[index]; }
    [[nodiscard]] constexpr char const* begin() const noexcept { return characters_.data(); }
    [[nodiscard]] constexpr char const* end() const noexcept { return characters_.data() + size_; }

    /// As a std::string_view, valid as long as this text.
    template <detail::character_view View> constexpr operator View() const& noexcept { return View(begin(), size()); }
    /// A temporary text gives no view; it makes a std::string, and goes to a stream.
    template <detail::character_view View> constexpr operator View() const&& noexcept
    {
        static_assert(not detail::character_view<View>,
                      "a text that ends with its expression gives no view: give it a name first");
        return View();
    }

    /// Appends a character; where there is no room it is left out.
    /// Internal.
    constexpr void append(char character) noexcept
    {
        if (size_ < Capacity) {
            characters_[size_++] = character;
        }
    }

    friend constexpr bool operator==(ascii_text const&, ascii_text const&) noexcept = default;
    friend constexpr bool operator==(ascii_text const& left, literal right) noexcept
    {
        bool is_same = left.size() == right.size();
        for (std::size_t i = 0; is_same and i < right.size(); ++i) {
            is_same = left[i] == right[i];
        }
        return is_same;
    }

private:
    std::array<char, Capacity> characters_{};
    std::size_t size_{0};
};

/// A text is its own.
template <std::size_t Capacity>
[[nodiscard]] constexpr detail::short_text<Capacity> text_of(ascii_text<Capacity> const& text) noexcept
{
    detail::short_text<Capacity> shown;
    shown.precede(text.begin(), text.size());
    return shown;
}

/// `Size` characters in half as many registers, the first in the high byte unless the order swaps bytes. A text ends
/// before its first zero; what is behind it is zero when written. Blanks at its end are cut off on reading: many devices
/// fill up with them. A byte that is no ASCII is passed on as it is.
template <std::size_t Size, word_order Order = word_order::high_first> struct ascii {
    static_assert(Size > 0 and Size % 2 == 0, "a register holds two characters: name an even number of them");
    static_assert(not detail::is_low_first(Order),
                  "the registers of a text follow one another: only the bytes may be swapped");

    using value_type = ascii_text<Size>;
    static constexpr std::uint16_t word_count = Size / 2;
    static constexpr bool is_total = true;
    using words = std::array<std::uint16_t, word_count>;

    [[nodiscard]] static constexpr result<value_type> from_words(words const& from) noexcept
    {
        std::size_t size = 0;
        for (std::size_t i = 0; i < Size and at(from, i) != '\0'; ++i) {
            size = at(from, i) == ' ' ? size : i + 1;
        }
        value_type text;
        for (std::size_t i = 0; i < size; ++i) {
            text.append(at(from, i));
        }
        return text;
    }

    [[nodiscard]] static constexpr words to_words(value_type const& text) noexcept
    {
        words all{};
        for (std::size_t i = 0; i < Size; ++i) {
            std::uint32_t const character = i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
            all[i / 2] = static_cast<std::uint16_t>(std::uint32_t{all[i / 2]} << 8U | character);
        }
        for (std::uint16_t& each : all) {
            each = detail::swapped_for<Order>(each);
        }
        return all;
    }

    /// A string literal, or whatever has a size and characters: std::string, std::string_view, another text.
    template <typename Value> static constexpr bool takes = requires(Value const& value)
    {
        {
            literal{value}.size()
            } -> std::same_as<std::size_t>;
    }
    or requires(Value const& value)
    {
        {
            value.size()
            } -> std::convertible_to<std::size_t>;
        {
            value[0]
            } -> std::convertible_to<char>;
    };

    /// The same characters up to the first zero; `value_too_high` where there are too many of them.
    template <typename Value> [[nodiscard]] static constexpr result<value_type> convert(Value const& value) noexcept
    {
        if constexpr (requires { literal{value}; } and not std::same_as<Value, literal>) {
            return convert(literal{value});
        } else {
            value_type text;
            std::size_t at = 0;
            for (; at < value.size() and value[at] != '\0'; ++at) {
                if (at == Size) {
                    return errc::value_too_high;
                }
                text.append(value[at]);
            }
            return text;
        }
    }

    [[nodiscard]] static constexpr errc refusal(value_type const&, bound const&, bound const&,
                                                detail::count_range) noexcept
    {
        return errc::none;
    }

private:
    static constexpr char at(words const& from, std::size_t index) noexcept
    {
        std::uint32_t const word = detail::swapped_for<Order>(from[index / 2]);
        return static_cast<char>(static_cast<unsigned char>((index % 2 == 0 ? word >> 8U : word) & 0xFFU));
    }
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
