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

namespace rtuwire::inline RTUWIRE_BUILD {

/// Never defined for two registers: their names are the message, their arguments the registers in conflict.
template <auto const& A, auto const& B> struct these_registers_overlap;
template <auto const& A, auto const& B> struct these_registers_have_one_code;
template <auto const& A> struct these_registers_overlap<A, A> {};
template <auto const& A> struct these_registers_have_one_code<A, A> {};

/// The register at a place in a list of registers.
/// Internal.
template <std::size_t Index, auto const& First, auto const&... Rest>
[[nodiscard]] constexpr auto const& register_at() noexcept
{
    if constexpr (Index == 0) {
        return First;
    } else {
        return register_at<Index - 1, Rest...>();
    }
}

/// A device's registers. Each address and each mnemonic occurs once.
template <auto const&... Registers> class table {
    static constexpr std::array<void const*, sizeof...(Registers)> places{&Registers...};

public:
    static constexpr std::size_t size = sizeof...(Registers);

    /// The addresses, in the table's order.
    static constexpr std::array<std::uint16_t, size> addresses{Registers.address...};

private:
    static constexpr key_index<std::uint16_t, size> by_address{addresses};

public:
    /// Whether there is a register at an address.
    [[nodiscard]] static constexpr bool has_address(std::uint16_t address) noexcept
    {
        return by_address.find(address) < size;
    }

    /// Whether a register is one of this device's, or one of them counted in other steps.
    template <auto const& R>
    static constexpr bool contains = has_address(R.address) and (places[by_address.find(R.address)] == &R or
                                                                 places[by_address.find(R.address)] == R.counted_as);

    /// Calls `visit.template operator()<R>()` for each register.
    template <typename Visit> static constexpr void for_each(Visit&& visit)
    {
        (visit.template operator()<Registers>(), ...);
    }

private:
    static constexpr std::array<literal, size> codes{Registers.code...};
    static constexpr index_pair overlap = by_address.duplicate();
    static constexpr index_pair namesake = first_duplicate(codes);

    // In the class itself: GCC prints a line for each function between the table and its message.
    static_assert(sizeof(these_registers_overlap<register_at<overlap.first, Registers...>(),
                                                 register_at<overlap.second, Registers...>()>) > 0);
    static_assert(sizeof(these_registers_have_one_code<register_at<namesake.first, Registers...>(),
                                                       register_at<namesake.second, Registers...>()>) > 0);
};

} // namespace rtuwire
