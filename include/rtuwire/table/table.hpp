// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The registers of a device, as a type. Two registers with one address or one mnemonic do not compile,
// and the compiler names them. A key is found in a list in a few steps whatever the list's length: the compiler searches a
// table of a hundred registers some thousand times. Questions about a whole list of template arguments are no fold
// expressions: these nest, and Clang takes at most 256 of them.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>

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

/// Facts, as a type.
template <bool... Facts> struct fact_list;

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

/// Never defined for two registers: their names are the message, their arguments the registers in conflict.
template <auto const& One, auto const& Other> struct these_registers_overlap;
template <auto const& One, auto const& Other> struct these_registers_have_one_code;
template <auto const& One> struct these_registers_overlap<One, One> {};
template <auto const& One> struct these_registers_have_one_code<One, One> {};

namespace detail {

/// The register at a place in a list of registers.
template <std::size_t Index, auto const& First, auto const&... Rest>
[[nodiscard]] constexpr auto const& register_at() noexcept
{
    if constexpr (Index == 0) {
        return First;
    } else {
        return register_at<Index - 1, Rest...>();
    }
}

/// The same far behind in a long list: a template calls itself only some hundred times.
template <std::size_t Index, auto const& R1, auto const& R2, auto const& R3, auto const& R4, auto const& R5,
          auto const& R6, auto const& R7, auto const& R8, auto const&... Rest>
    requires(Index >= 8)
[[nodiscard]] constexpr auto const& register_at() noexcept { return register_at<Index - 8, Rest...>(); }

/// An address in its space, as one number.
[[nodiscard]] constexpr std::uint32_t key_of(register_space space, std::uint16_t address) noexcept
{
    return std::uint32_t{static_cast<std::uint8_t>(space)} << 16U | address;
}

/// All addresses of some registers, wide ones with every word, in their order; and whose address each is.
template <auto const&... Registers> class address_list {
    static constexpr std::size_t count = sizeof...(Registers);
    static_assert(are_all<(std::uint32_t{Registers.address} + Registers.word_count <= 0x1'0000U)...>,
                  "a register ends at address 65535 or before");

public:
    static constexpr std::size_t size = sum_of<Registers.word_count...>();

    constexpr address_list() noexcept
    {
        constexpr std::array<std::uint32_t, count> first{key_of(Registers.space, Registers.address)...};
        constexpr std::array<std::uint16_t, count> words{Registers.word_count...};
        std::size_t at = 0;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::uint16_t word = 0; word < words[i]; ++word) {
                keys[at] = first[i] + word;
                owners[at++] = static_cast<std::uint16_t>(i);
            }
        }
    }

    [[nodiscard]] static constexpr std::uint32_t key(register_space space, std::uint16_t address) noexcept
    {
        return key_of(space, address);
    }
    [[nodiscard]] constexpr std::size_t owner(std::size_t place) const noexcept { return owners[place]; }

    std::array<std::uint32_t, size> keys{};
    std::array<std::uint16_t, size> owners{};
};

/// The same where each is a holding register of one word, as those of drives are: half the work for the compiler.
template <auto const&... Registers>
    requires(are_all<Registers.is_plain...>)
class address_list<Registers...> {
    /// Of another kind than all registers.
    static constexpr std::uint32_t no_key = 0xFFFF'FFFFU;

public:
    static constexpr std::size_t size = sizeof...(Registers);

    [[nodiscard]] static constexpr std::uint32_t key(register_space space, std::uint16_t address) noexcept
    {
        return space == register_space::holding ? address : no_key;
    }
    [[nodiscard]] static constexpr std::size_t owner(std::size_t place) noexcept { return place; }

    std::array<std::uint32_t, size> keys{Registers.address...};
};

/// A register that a table is asked for: where it is, and which object it is.
struct asked_register {
    std::uint16_t address;
    register_space space;
    void const* itself;
    void const* counted_as;
    bool is_restepped;
};

} // namespace detail

/// A device's registers. Each address of a space and each mnemonic occurs once.
template <auto const&... Registers> class table {
public:
    static constexpr std::size_t size = sizeof...(Registers);

private:
    using address_list_type = detail::address_list<Registers...>;

    /// All that a search reads, in one object.
    struct register_index {
        address_list_type all{};
        detail::key_index<std::uint32_t, address_list_type::size> by_address{all.keys};
        std::array<void const*, size> places{&Registers...};
        std::array<bool, size> are_restepped{Registers.is_restepped...};

        [[nodiscard]] constexpr bool holds(detail::asked_register const& asked) const noexcept
        {
            std::size_t const place = by_address.find(address_list_type::key(asked.space, asked.address));
            if (place == address_list_type::size) {
                return false;
            }
            std::size_t const owner = all.owner(place);
            return places[owner] == (asked.is_restepped and not are_restepped[owner] ? asked.counted_as : asked.itself);
        }
    };
    static constexpr register_index index{};

public:
    /// The first address of each register, in the table's order.
    static constexpr std::array<std::uint16_t, size> addresses{Registers.address...};

    /// Whether there is a register at an address.
    [[nodiscard]] static constexpr bool has_address(std::uint16_t address,
                                                    register_space space = register_space::holding) noexcept
    {
        return index.by_address.find(address_list_type::key(space, address)) < address_list_type::size;
    }

    /// Whether all of some registers are this device's. Not one by one: see `key_index`.
    /// Internal.
    template <auto const&... Asked> [[nodiscard]] static constexpr bool holds_all() noexcept
    {
        auto const copy = index;
        for (detail::asked_register const& asked :
             {detail::asked_register{Asked.address, Asked.space, &Asked, Asked.counted_as, Asked.is_restepped}...}) {
            if (not copy.holds(asked)) {
                return false;
            }
        }
        return true;
    }

    /// Whether a register is one of this device's, or one of them counted in other steps.
    template <auto const& R>
    static constexpr bool contains = index.holds({R.address, R.space, &R, R.counted_as, R.is_restepped});

    /// All of them, and more, as the arguments of a template.
    template <template <auto const&...> typename List, auto const&... More> using with = List<Registers..., More...>;

    /// Calls `visit.template operator()<R>()` for each register.
    template <typename Visit> static constexpr void for_each(Visit&& visit)
    {
        [[maybe_unused]] bool const done[]{true, (static_cast<void>(visit.template operator()<Registers>()), true)...};
    }

private:
    static constexpr std::array<literal, size> codes{Registers.code...};
    static constexpr detail::index_pair overlap = index.by_address.duplicate();
    static constexpr detail::index_pair namesake = detail::first_duplicate(codes);

    // In the class itself: GCC prints a line for each function between the table and its message.
    static_assert(
        sizeof(these_registers_overlap<detail::register_at<index.all.owner(overlap.first), Registers...>(),
                                       detail::register_at<index.all.owner(overlap.second), Registers...>()>) > 0);
    static_assert(sizeof(these_registers_have_one_code<detail::register_at<namesake.first, Registers...>(),
                                                       detail::register_at<namesake.second, Registers...>()>) > 0);
};

/// No register: the objects of a device that has only rows.
template <> class table<> {
public:
    static constexpr std::size_t size = 0;

    [[nodiscard]] static constexpr bool has_address(std::uint16_t, register_space = register_space::holding) noexcept
    {
        return false;
    }
    template <auto const&> static constexpr bool contains = false;
    template <template <auto const&...> typename List, auto const&... More> using with = List<More...>;
    template <auto const&...> [[nodiscard]] static constexpr bool holds_all() noexcept { return false; }
    template <typename Visit> static constexpr void for_each(Visit&&) noexcept {}
};

namespace detail {

/// All registers of a table, as the arguments of a template: `with<bank>`. Rows are made registers: table/row_table.hpp.
template <typename Table> struct all_registers {
    template <template <auto const&...> typename List> using with = typename Table::template with<List>;
};

/// The first and the last of the words that one request has to read, in one space.
struct key_range {
    std::uint32_t first;
    std::uint32_t last;

    [[nodiscard]] constexpr key_range with(key_range other) const noexcept
    {
        return {other.first < first ? other.first : first, other.last > last ? other.last : last};
    }
    [[nodiscard]] constexpr bool is_of_one_space() const noexcept { return first >> 16U == last >> 16U; }
};

/// Of one register, its scale included.
template <auto const& R> [[nodiscard]] constexpr key_range range_of() noexcept
{
    std::uint32_t const first = key_of(R.space, R.address);
    key_range range{first, first + R.word_count - 1U};
    if constexpr (has_scale_register<R>) {
        range = range.with(range_of<std::remove_cvref_t<decltype(R)>::form::scale_register>());
    }
    return range;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
