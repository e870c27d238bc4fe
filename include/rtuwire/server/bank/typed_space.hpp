// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The typed registers of one kind in a bank, in the order of their addresses: words with their rules, and bits.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/bank/register_rules.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/key_index.hpp>
#include <rtuwire/table/request_plan.hpp>
#include <rtuwire/wire/bit_view.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The registers of one kind among those of a bank: their rules, rising by address, and their words as delivered.
template <register_space Space, auto const&... Registers> struct bank_space {
private:
    static constexpr std::size_t all = sizeof...(Registers);
    static constexpr std::array<bool, all> are_of_kind{(Registers.space == Space)...};
    static constexpr bool is_plain =
        Space == register_space::holding and are_all<(Registers.is_plain or Registers.space != Space)...>;
    using rule =
        std::conditional_t<is_space_of_bits(Space), bit_rule, std::conditional_t<is_plain, word_rule, value_rule>>;

public:
    static constexpr std::size_t size = sum_of<(Registers.space == Space ? 1U : 0U)...>();
    static constexpr std::size_t word_count = sum_of<(Registers.space == Space ? Registers.word_count : 0U)...>();

    // What a loop reads often is captured, as a copy: see `key_index`. And without a capture GCC makes a conversion to a
    // pointer, for which it calls the lambda once more.

private:
    /// The places of its registers in the bank's list, rising by address.
    static constexpr auto order = [addresses = std::array<std::uint16_t, all>{Registers.address...},
                                   are_of_it = are_of_kind] {
        std::array<std::uint32_t, size> keys{};
        for (std::uint32_t i = 0, at = 0; i < are_of_it.size(); ++i) {
            if (are_of_it[i]) {
                keys[at++] = std::uint32_t{addresses[i]} << 16U | i;
            }
        }
        sort_addresses(keys);
        std::array<std::uint16_t, size> places{};
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[i] = static_cast<std::uint16_t>(keys[i] & 0xFFFFU);
        }
        return places;
    }();

public:
    static constexpr auto rules = [listed = std::array<rule, all>{rule::of(Registers)...}, places = order] {
        std::array<rule, size> rising{};
        std::size_t word_place = 0;
        for (std::size_t i = 0; i < rising.size(); ++i) {
            rising[i] = listed[places[i]];
            rising[i].put_at(word_place);
            word_place += rising[i].word_count;
        }
        return rising;
    }();

    static constexpr auto delivered = [places = order, rising = rules, are_of_it = are_of_kind] {
        std::array<std::uint16_t, all> starts{};
        for (std::size_t i = 0; i < rising.size(); ++i) {
            starts[places[i]] = static_cast<std::uint16_t>(rising[i].first_word(i));
        }
        std::array<std::uint16_t, word_count> all_words{};
        std::size_t at = 0;
        auto const put = [&](auto const& of) {
            if (are_of_it[at]) {
                std::size_t word_place = starts[at];
                for (std::uint16_t const each : factory_words(of)) {
                    all_words[word_place++] = each;
                }
            }
            return ++at;
        };
        [[maybe_unused]] std::array<std::size_t, all> const done{put(Registers)...};
        return all_words;
    }();

    /// The place of the first register at an address or above it: `size` where there is none. A short list is gone
    /// through, which is smaller.
    [[nodiscard]] static constexpr std::size_t place_from(std::uint32_t address) noexcept
    {
        std::size_t low = 0;
        if constexpr (size <= 8) {
            while (low < size and rules[low].address < address) {
                ++low;
            }
            return low;
        }
        for (std::size_t end = size; low < end;) {
            std::size_t const middle = (low + end) / 2;
            if (rules[middle].address < address) {
                low = middle + 1;
            } else {
                end = middle;
            }
        }
        return low;
    }

    /// Whether registers, from this place on, fill these addresses, none of them cut, and all writable where that is
    /// asked.
    [[nodiscard]] static constexpr bool fills(std::size_t place, std::uint16_t start, std::size_t count,
                                              bool is_to_write) noexcept
    {
        for (std::size_t i = 0; i < count; ++place) {
            if (place == size or rules[place].address != start + i or rules[place].word_count > count - i or
                (is_to_write and not rules[place].is_writable)) {
                return false;
            }
            i += rules[place].word_count;
        }
        return true;
    }
};

/// Holding registers or input registers. A register of several words is read and written whole or not at all: half of it
/// is exception 02.
template <typename Space> class typed_words {
    static constexpr auto& rules = Space::rules;

public:
    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        return Space::fills(Space::place_from(start), start, count, false) ? errc::none : errc::illegal_data_address;
    }

    [[nodiscard]] constexpr errc check_write(std::uint16_t start, register_view values) const noexcept
    {
        std::size_t place = Space::place_from(start);
        if (not Space::fills(place, start, values.size(), true)) {
            return errc::illegal_data_address;
        }
        for (std::size_t i = 0; i < values.size(); ++place) {
            if (not rules[place].takes(values, i)) {
                return errc::illegal_data_value;
            }
            i += rules[place].word_count;
        }
        return errc::none;
    }

    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        if (std::byte* const to = out.take(2 * count); to != nullptr and count > 0) {
            std::size_t const place = Space::place_from(start);
            std::size_t const first = rules[place].first_word(place);
            for (std::size_t i = 0; i < count; ++i) {
                put_u16(to + 2 * i, words_[first + i]);
            }
        }
        return errc::none;
    }

    constexpr errc write(std::uint16_t start, register_view values) noexcept
    {
        std::size_t place = Space::place_from(start);
        for (std::size_t i = 0; i < values.size(); ++place) {
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
        constexpr std::size_t first = first_word<R>();
        if constexpr (R.is_plain) {
            return from_word<value_of<R>>(words_[first]);
        } else if constexpr (is_always_a_value<R>) {
            return *value_in<R>(words_, first, 0);
        } else {
            return value_in<R>(words_, first, 0);
        }
    }

    template <auto const& R> constexpr void set_value(value_of<R> value) noexcept
    {
        constexpr std::size_t first = first_word<R>();
        auto const words = register_form_of<R>::to_words(value);
        for (std::size_t i = 0; i < words.size(); ++i) {
            words_[first + i] = words[i];
        }
    }

    template <auto const& R> constexpr bool& written() noexcept
    {
        constexpr std::size_t place = Space::place_from(R.address);
        return is_written_[place];
    }

private:
    template <auto const& R> static constexpr std::size_t first_word() noexcept
    {
        std::size_t const place = Space::place_from(R.address);
        return rules[place].first_word(place);
    }

    std::array<std::uint16_t, Space::word_count> words_{Space::delivered};
    std::array<bool, Space::size> is_written_{};
};

/// Coils or discrete inputs.
template <typename Space> class typed_bits {
public:
    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        return Space::fills(Space::place_from(start), start, count, false) ? errc::none : errc::illegal_data_address;
    }

    [[nodiscard]] constexpr errc check_write(std::uint16_t start, bit_view values) const noexcept
    {
        return Space::fills(Space::place_from(start), start, values.size(), true) ? errc::none
                                                                                  : errc::illegal_data_address;
    }

    constexpr errc read(std::uint16_t start, std::size_t count, byte_span out) noexcept
    {
        std::size_t const place = Space::place_from(start);
        for (std::size_t i = 0; i < count; ++i) {
            put_bit(out, i, bits_[place + i]);
        }
        return errc::none;
    }

    constexpr errc write(std::uint16_t start, bit_view values) noexcept
    {
        std::size_t const place = Space::place_from(start);
        for (std::size_t i = 0; i < values.size(); ++i) {
            bits_[place + i] = values[i];
            is_written_[place + i] = true;
        }
        return errc::none;
    }

    template <auto const& R> [[nodiscard]] constexpr bool value() const noexcept { return bits_[place_of<R>()]; }
    template <auto const& R> constexpr void set_value(bool value) noexcept { bits_[place_of<R>()] = value; }
    template <auto const& R> constexpr bool& written() noexcept { return is_written_[place_of<R>()]; }

private:
    template <auto const& R> static constexpr std::size_t place_of() noexcept
    {
        constexpr std::size_t place = Space::place_from(R.address);
        return place;
    }

    static constexpr auto delivered() noexcept
    {
        std::array<bool, Space::size> bits{};
        for (std::size_t i = 0; i < bits.size(); ++i) {
            bits[i] = Space::delivered[i] != 0;
        }
        return bits;
    }

    std::array<bool, Space::size> bits_{delivered()};
    std::array<bool, Space::size> is_written_{};
};

} // namespace rtuwire
