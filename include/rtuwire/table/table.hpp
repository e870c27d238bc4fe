// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The registers of a device, as a type. Two registers with one address or one mnemonic do not compile,
// and the compiler names them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/key_index.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Never defined for two registers: their names are the message, their arguments the registers in conflict.
template <auto const& A, auto const& B> struct these_registers_overlap;
template <auto const& A, auto const& B> struct these_registers_have_one_code;
template <auto const& A> struct these_registers_overlap<A, A> {};
template <auto const& A> struct these_registers_have_one_code<A, A> {};

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
template <std::size_t Index, auto const& A, auto const& B, auto const& C, auto const& D, auto const& E, auto const& F,
          auto const& G, auto const& H, auto const&... Rest>
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
    template <std::size_t Count>
    [[nodiscard]] static constexpr bool holds_all(std::array<detail::asked_register, Count> const& all_asked) noexcept
    {
        auto const copy = index;
        for (detail::asked_register const& asked : all_asked) {
            if (not copy.holds(asked)) {
                return false;
            }
        }
        return true;
    }

    /// Whether a register is one of this device's, or one of them counted in other steps.
    template <auto const& R>
    static constexpr bool contains = index.holds({R.address, R.space, &R, R.counted_as, R.is_restepped});

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

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
