// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Finds the index of a key in a list, in a few steps whatever the list's length: the compiler searches a
// table of a hundred registers some thousand times. And questions about a whole list of template arguments, which are no
// fold expressions: these nest, and Clang takes at most 256 of them.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Two places in a list; none when both are 0.
struct index_pair {
    std::size_t first{0};
    std::size_t second{0};
};

/// Spreads addresses over a power of two of slots.
[[nodiscard]] constexpr std::uint32_t hash_of(std::uint16_t address) noexcept { return address * 40'503U >> 3U; }

/// The same for addresses with their space.
[[nodiscard]] constexpr std::uint32_t hash_of(std::uint32_t key) noexcept { return key * 40'503U >> 3U; }

/// Spreads mnemonics over a power of two of slots.
[[nodiscard]] constexpr std::uint32_t hash_of(literal code) noexcept
{
    std::uint32_t hash = 0;
    for (char const letter : code) {
        hash = hash * 31U + static_cast<unsigned char>(letter);
    }
    return hash;
}

/// The places of the keys of a list, for `find`; and the first key that occurs twice. Whoever searches it for many keys
/// searches a copy of its own: for each read of a constant of a class that lists a thousand registers, GCC looks through
/// the list.
template <typename Key, std::size_t Size> class key_index {
public:
    explicit constexpr key_index(std::array<Key, Size> const& keys) noexcept : keys_{keys}
    {
        for (std::size_t i = 0; i < Size; ++i) {
            std::size_t const slot = slot_of(keys_[i]);
            if (places_[slot] != 0 and duplicate_.second == 0) {
                duplicate_ = {places_[slot] - 1U, i};
            }
            places_[slot] = static_cast<std::uint16_t>(i + 1);
        }
    }

    /// The place of a key; `Size` where it is not in the list.
    [[nodiscard]] constexpr std::size_t find(Key const& key) const noexcept
    {
        std::size_t const place = places_[slot_of(key)];
        return place == 0 ? Size : place - 1;
    }

    /// The first two equal keys.
    [[nodiscard]] constexpr index_pair duplicate() const noexcept { return duplicate_; }

private:
    static constexpr std::size_t slot_count = std::bit_ceil(2 * Size + 1);

    /// The slot that holds the key, or the empty one where it would be.
    [[nodiscard]] constexpr std::size_t slot_of(Key const& key) const noexcept
    {
        std::size_t slot = hash_of(key) % slot_count;
        while (places_[slot] != 0 and not(keys_[places_[slot] - 1U] == key)) {
            slot = (slot + 1) % slot_count;
        }
        return slot;
    }

    std::array<Key, Size> keys_;
    std::array<std::uint16_t, slot_count> places_{}; ///< one more than the place; 0 where empty
    index_pair duplicate_{};
};

/// The first two equal elements of a list.
template <typename Key, std::size_t Size>
[[nodiscard]] constexpr index_pair first_duplicate(std::array<Key, Size> const& list) noexcept
{
    return key_index{list}.duplicate();
}

} // namespace detail

/// Facts, as a type.
template <bool... Facts> struct fact_list;

namespace detail {

/// Whether all of them hold; true of none. A list whose facts are all true is the same, moved by one.
template <bool... Facts>
inline constexpr bool are_all = std::is_same_v<fact_list<true, Facts...>, fact_list<Facts..., true>>;

/// Whether one of them holds.
template <bool... Facts> inline constexpr bool is_any = not are_all<not Facts...>;

/// Their sum; 0 of none.
template <std::size_t... Numbers> [[nodiscard]] consteval std::size_t sum_of() noexcept
{
    std::size_t sum = 0;
    for (std::size_t const each : std::array<std::size_t, sizeof...(Numbers)>{Numbers...}) {
        sum += each;
    }
    return sum;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
