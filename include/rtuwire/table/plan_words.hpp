// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The words that a plan reads: those of wide registers and of their scales too, by space and address, and which of them
// one request has to read. So no value is ever put together from two moments.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/key_range.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/request_plan.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Some registers, as a type.
template <auto const&... Registers> struct register_list {
    static constexpr std::size_t size = sizeof...(Registers);
    static constexpr bool is_plain = (Registers.is_plain and ...);
};

/// Registers that a plan reads by one request; see `together`.
template <auto const&... Registers> struct kept_together : register_list<Registers...> {
    static_assert(sizeof...(Registers) > 1, "together names at least two registers");
};

/// The registers that an argument of a plan names.
template <auto const& Item, typename Kind = std::remove_cvref_t<decltype(Item)>> struct registers_named {
    using type = register_list<Item>;
    static constexpr bool is_group = false;
};
template <auto const& Item, auto const&... Registers> struct registers_named<Item, kept_together<Registers...>> {
    using type = register_list<Registers...>;
    static constexpr bool is_group = true;
};

/// Lists one behind the other.
template <typename... Lists> struct joined_lists;
template <auto const&... Registers> struct joined_lists<register_list<Registers...>> {
    using type = register_list<Registers...>;
};
template <auto const&... First, auto const&... Second, typename... Others>
struct joined_lists<register_list<First...>, register_list<Second...>, Others...>
    : joined_lists<register_list<First..., Second...>, Others...> {};

/// All registers that a plan's arguments name. Named in one list where none of them is a group.
template <bool IsAnyGroup, auto const&... Items> struct all_named {
    using type = register_list<Items...>;
};
template <auto const&... Items> struct all_named<true, Items...> {
    using type = typename joined_lists<register_list<>, typename registers_named<Items>::type...>::type;
};

/// What a plan has to know of all its registers.
template <typename List> struct facts_of;
template <auto const&... Registers> struct facts_of<register_list<Registers...>> {
    template <typename Device> static constexpr bool are_of = (has_register<Device, Registers> and ...);
    template <typename Device> static constexpr bool have_scales = (has_scale<Device, Registers> and ...);
    static constexpr bool have_readable_steps = (has_readable_steps<Registers> and ...);
    static constexpr bool are_different =
        first_duplicate(std::array{key_of(Registers.space, Registers.address)...}).second == 0;
    template <auto const& R> static constexpr bool contain = (is_same_register<R, Registers> or ...);

    /// Whether one of them is called so.
    static constexpr bool has_code(literal code) noexcept
    {
        constexpr std::array<literal, sizeof...(Registers)> codes{Registers.code...};
        for (literal const each : codes) {
            if (each == code) {
                return true;
            }
        }
        return false;
    }

    /// What `raw.template operator()<R>()` gives for the one that is called so; 0 for no mnemonic.
    template <typename Raw> static constexpr std::int32_t raw_of(literal code, Raw const& raw) noexcept
    {
        std::int32_t found = 0;
        ((found = Registers.code == code ? raw.template operator()<Registers>() : found), ...);
        return found;
    }
};

/// Of all registers of a list.
template <auto const& First, auto const&... Rest>
[[nodiscard]] constexpr key_range range_of(register_list<First, Rest...>) noexcept
{
    key_range range = range_of<First>();
    ((range = range.with(range_of<Rest>())), ...);
    return range;
}

/// The addresses of some registers, rising.
template <auto const&... Registers> [[nodiscard]] constexpr auto rising_addresses() noexcept
{
    std::array<std::uint16_t, sizeof...(Registers)> addresses{Registers.address...};
    sort_addresses(addresses);
    return addresses;
}

/// How many words a register's value takes, that of its scale included.
template <auto const& R>
inline constexpr std::size_t words_with_scale = std::size_t{R.word_count} + (has_scale_register<R> ? 1U : 0U);

/// Adds the words of a register to a list.
template <auto const& R, std::size_t Most>
constexpr std::size_t add_words(std::array<std::uint32_t, Most>& keys, std::size_t at) noexcept
{
    for (std::uint32_t word = 0; word < R.word_count; ++word) {
        keys[at++] = key_of(R.space, R.address) + word;
    }
    if constexpr (has_scale_register<R>) {
        at = add_words<std::remove_cvref_t<decltype(R)>::form::scale_register>(keys, at);
    }
    return at;
}

/// The words of some registers as keys, rising, each once, at the front; and how many there are.
template <std::size_t Most> struct rising_keys {
    std::array<std::uint32_t, Most> keys{};
    std::size_t count{0};
};
template <auto const&... Registers> [[nodiscard]] constexpr auto rising_words() noexcept
{
    rising_keys<(words_with_scale<Registers> + ...)> all;
    std::size_t size = 0;
    ((size = add_words<Registers>(all.keys, size)), ...);
    sort_addresses(all.keys);
    for (std::uint32_t const key : all.keys) {
        if (all.count == 0 or all.keys[all.count - 1] != key) {
            all.keys[all.count++] = key;
        }
    }
    return all;
}

/// What a plan reads, and by which requests.
template <std::size_t Words> struct read_requests {
    std::array<std::uint16_t, Words> addresses{}; ///< of each word, by space and rising
    std::array<register_space, Words> spaces{};   ///< of each word
    block_list<Words> blocks{};                   ///< no block where no plan can be
    std::array<register_space, Words> block_spaces{};
};

/// Plans the words of several spaces, of which ranges must not be cut.
template <typename Device, std::size_t Words, std::size_t Most, std::size_t Ranges>
[[nodiscard]] constexpr read_requests<Words> plan_spaces(rising_keys<Most> const& of,
                                                         std::array<key_range, Ranges> const& ranges) noexcept
{
    read_requests<Words> plan;
    for (std::size_t i = 0; i < Words; ++i) {
        plan.addresses[i] = static_cast<std::uint16_t>(of.keys[i] & 0xFFFFU);
        plan.spaces[i] = static_cast<register_space>(of.keys[i] >> 16U);
    }
    for (std::size_t first = 0, end = 0; first < Words; first = end) {
        register_space const space = plan.spaces[first];
        while (end < Words and plan.spaces[end] == space) {
            ++end;
        }
        auto const is_joined = [&](std::size_t index) {
            bool is = false;
            for (key_range const range : ranges) {
                is = is or (of.keys[first + index] > range.first and of.keys[first + index] <= range.last);
            }
            return is;
        };
        auto const part = plan_blocks<Words>(
            std::span{plan.addresses}.subspan(first, end - first),
            is_space_of_bits(space) ? max_bit_quantity : Device::limits.read,
            [&](std::uint16_t lower, std::uint16_t upper) { return is_readable_across<Device>(lower, upper, space); },
            is_joined);
        if (part.count == 0) {
            plan.blocks.count = 0;
            return plan;
        }
        for (address_block const& block : part.view()) {
            plan.block_spaces[plan.blocks.count] = space;
            plan.blocks.blocks[plan.blocks.count++] = block;
        }
    }
    return plan;
}

} // namespace rtuwire
