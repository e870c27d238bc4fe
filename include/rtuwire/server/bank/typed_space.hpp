// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The typed registers of one kind in a bank: words with their rules, and bits.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/form_setting.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/wire/bit_view.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The words of a register as delivered; 0 where its factory value is not known.
template <auto const& R> [[nodiscard]] constexpr auto factory_words() noexcept
{
    using form = register_form_of<R>;
    if constexpr (register_value<value_of<R>>) {
        return std::array{static_cast<std::uint16_t>(R.factory.value_or(0))};
    } else if constexpr (requires { typename form::count_type; }) {
        return form::to_words(value_of<R>{static_cast<typename form::count_type>(R.factory.value_or(0))});
    } else if constexpr (std::same_as<value_of<R>, bool>) {
        return form::to_words(R.factory.value_or(0) != 0);
    } else {
        return form::to_words(value_of<R>{});
    }
}

/// What holds for a holding register of one word.
struct word_rule {
    std::uint16_t address;
    bool is_writable;
    bool is_signed;
    std::int32_t lowest;
    std::int32_t highest;
    std::span<std::uint16_t const> listed;
    count_range gap;

    static constexpr std::size_t word_count = 1;
    [[nodiscard]] static constexpr std::size_t first_word(std::size_t place) noexcept { return place; }
    [[nodiscard]] constexpr bool takes(register_view values, std::size_t at) const noexcept
    {
        std::uint16_t const word = values[at];
        std::int32_t const raw = is_signed ? std::int32_t{static_cast<std::int16_t>(word)} : std::int32_t{word};
        return raw >= lowest and raw <= highest and not gap.contains(raw) and has_meaning(listed, word);
    }
};

/// Whether a register takes the words of a request, from the one at `at` on.
template <auto const& R> [[nodiscard]] constexpr bool takes_words(register_view values, std::size_t at) noexcept
{
    using form = register_form_of<R>;
    std::array<std::uint16_t, R.word_count> words{};
    for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = values[at + i];
    }
    auto const value = form::from_words(words);
    if (not value) {
        return false;
    }
    if constexpr (register_value<value_of<R>>) {
        return setting<R>::checked(*value).has_value();
    } else {
        return form::refusal(*value, R.min, R.max, R.gap) == errc::none;
    }
}

/// What holds for any register of words.
struct value_rule {
    std::uint16_t address;
    std::uint16_t word_count;
    std::uint16_t first; ///< where its first word is stored
    bool is_writable;
    bool (*takes)(register_view, std::size_t);

    [[nodiscard]] constexpr std::size_t first_word(std::size_t) const noexcept { return first; }
};

/// The rules of some registers, in their order.
template <auto const&... Registers> [[nodiscard]] consteval auto rules_of() noexcept
{
    if constexpr ((Registers.is_plain and ...)) {
        return std::array<word_rule, sizeof...(Registers)>{word_rule{
            Registers.address, Registers.mode != access::read_only, lowest<Registers>() < 0, lowest<Registers>(),
            highest<Registers>(), listed_words<value_of<Registers>>(), Registers.gap}...};
    } else {
        std::uint16_t next = 0;
        auto const take = [&next](std::uint16_t its_words) {
            std::uint16_t const its_first = next;
            next = static_cast<std::uint16_t>(next + its_words);
            return its_first;
        };
        return std::array<value_rule, sizeof...(Registers)>{
            value_rule{Registers.address, Registers.word_count, take(Registers.word_count),
                       Registers.mode != access::read_only, takes_words<Registers>}...};
    }
}

/// Holding registers or input registers. A register of several words is read and written whole or not at all: half of it
/// is exception 02.
template <auto const&... Registers> class typed_words {
    static constexpr std::size_t none = sizeof...(Registers);
    static constexpr auto rules = rules_of<Registers...>();

public:
    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        for (std::size_t i = 0; i < count;) {
            std::size_t const place = place_after(start, i);
            if (place == none or rules[place].word_count > count - i) {
                return errc::illegal_data_address;
            }
            i += rules[place].word_count;
        }
        return errc::none;
    }

    [[nodiscard]] constexpr errc check_write(std::uint16_t start, register_view values) const noexcept
    {
        if (errc const wrong = check_read(start, values.size()); wrong != errc::none) {
            return wrong;
        }
        for (std::size_t i = 0; i < values.size();) {
            std::size_t const place = place_after(start, i);
            if (not rules[place].is_writable) {
                return errc::illegal_data_address;
            }
            i += rules[place].word_count;
        }
        for (std::size_t i = 0; i < values.size();) {
            std::size_t const place = place_after(start, i);
            if (not rules[place].takes(values, i)) {
                return errc::illegal_data_value;
            }
            i += rules[place].word_count;
        }
        return errc::none;
    }

    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        for (std::size_t i = 0; i < count;) {
            std::size_t const place = place_after(start, i);
            for (std::size_t word = 0; word < rules[place].word_count; ++word, ++i) {
                out.u16(words_[rules[place].first_word(place) + word]);
            }
        }
        return errc::none;
    }

    constexpr errc write(std::uint16_t start, register_view values) noexcept
    {
        for (std::size_t i = 0; i < values.size();) {
            std::size_t const place = place_after(start, i);
            is_written_[place] = true;
            for (std::size_t word = 0; word < rules[place].word_count; ++word, ++i) {
                words_[rules[place].first_word(place) + word] = values[i];
            }
        }
        return errc::none;
    }

    /// The value of a register, or a result where its words may be none.
    template <auto const& R> [[nodiscard]] constexpr auto value() const noexcept
    {
        constexpr std::size_t place = place_of(R.address);
        if constexpr (R.is_plain) {
            return from_word<value_of<R>>(words_[rules[place].first_word(place)]);
        } else if constexpr (is_always_a_value<R>) {
            return *value_in<R>(words_, rules[place].first_word(place), 0);
        } else {
            return value_in<R>(words_, rules[place].first_word(place), 0);
        }
    }

    template <auto const& R> constexpr void set_value(value_of<R> value) noexcept
    {
        constexpr std::size_t place = place_of(R.address);
        auto const words = register_form_of<R>::to_words(value);
        for (std::size_t i = 0; i < words.size(); ++i) {
            words_[rules[place].first_word(place) + i] = words[i];
        }
    }

    template <auto const& R> constexpr bool& written() noexcept { return is_written_[place_of(R.address)]; }

private:
    static constexpr std::size_t place_of(std::uint32_t address) noexcept
    {
        std::size_t place = 0;
        while (place < none and rules[place].address != address) {
            ++place;
        }
        return place;
    }

    static constexpr std::size_t place_after(std::uint16_t start, std::size_t offset) noexcept
    {
        return place_of(std::uint32_t{start} + static_cast<std::uint32_t>(offset));
    }

    static constexpr auto delivered() noexcept
    {
        std::array<std::uint16_t, (std::size_t{Registers.word_count} + ... + 0U)> words{};
        [[maybe_unused]] std::size_t at = 0;
        [[maybe_unused]] auto const put = [&](auto const& several) {
            for (std::uint16_t const each : several) {
                words[at++] = each;
            }
        };
        (put(factory_words<Registers>()), ...);
        return words;
    }

    std::array<std::uint16_t, (std::size_t{Registers.word_count} + ... + 0U)> words_{delivered()};
    std::array<bool, none> is_written_{};
};

/// Coils or discrete inputs.
template <auto const&... Registers> class typed_bits {
    static constexpr std::size_t none = sizeof...(Registers);
    static constexpr std::array<std::uint16_t, none> addresses{Registers.address...};
    static constexpr std::array<bool, none> are_writable{(Registers.mode != access::read_only)...};

public:
    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        for (std::size_t i = 0; i < count; ++i) {
            if (place_after(start, i) == none) {
                return errc::illegal_data_address;
            }
        }
        return errc::none;
    }

    [[nodiscard]] constexpr errc check_write(std::uint16_t start, bit_view values) const noexcept
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::size_t const place = place_after(start, i);
            if (place == none or not are_writable[place]) {
                return errc::illegal_data_address;
            }
        }
        return errc::none;
    }

    constexpr errc read(std::uint16_t start, std::size_t count, byte_span out) noexcept
    {
        for (std::size_t i = 0; i < count; ++i) {
            put_bit(out, i, bits_[place_after(start, i)]);
        }
        return errc::none;
    }

    constexpr errc write(std::uint16_t start, bit_view values) noexcept
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::size_t const place = place_after(start, i);
            bits_[place] = values[i];
            is_written_[place] = true;
        }
        return errc::none;
    }

    template <auto const& R> [[nodiscard]] constexpr bool value() const noexcept { return bits_[place_of(R.address)]; }
    template <auto const& R> constexpr void set_value(bool value) noexcept { bits_[place_of(R.address)] = value; }
    template <auto const& R> constexpr bool& written() noexcept { return is_written_[place_of(R.address)]; }

private:
    static constexpr std::size_t place_of(std::uint32_t address) noexcept
    {
        std::size_t place = 0;
        while (place < none and addresses[place] != address) {
            ++place;
        }
        return place;
    }

    static constexpr std::size_t place_after(std::uint16_t start, std::size_t offset) noexcept
    {
        return place_of(std::uint32_t{start} + static_cast<std::uint32_t>(offset));
    }

    std::array<bool, none> bits_{Registers.factory.value_or(0) != 0 ...};
    std::array<bool, none> is_written_{};
};

} // namespace rtuwire
