// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The registers of a device, as a type. Two registers with one address or one mnemonic do not compile,
// and the compiler names them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/text.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {

/// Never defined: their names are the message, their arguments the culprits.
template <auto const& A, auto const& B> struct these_registers_overlap;
template <auto const& A, auto const& B> struct these_registers_have_one_code;

/// Two places in a list; none when both are 0.
struct index_pair {
    std::size_t first{0};
    std::size_t second{0};
};

/// The first two equal elements of a list.
template <typename T, std::size_t Size>
[[nodiscard]] constexpr index_pair first_duplicate(std::array<T, Size> const& list) noexcept
{
    for (std::size_t i = 0; i < Size; ++i) {
        for (std::size_t k = i + 1; k < Size; ++k) {
            if (list[i] == list[k]) {
                return {i, k};
            }
        }
    }
    return {};
}

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

/// A device's registers. Each address and each mnemonic occurs once.
template <auto const&... Registers> class table {
    static constexpr std::array<void const*, sizeof...(Registers)> places{&Registers...};

    static constexpr bool holds(void const* place) noexcept
    {
        for (void const* const each : places) {
            if (each == place) {
                return true;
            }
        }
        return false;
    }

public:
    static constexpr std::size_t size = sizeof...(Registers);

    /// The addresses, in the table's order.
    static constexpr std::array<std::uint16_t, size> addresses{Registers.address...};

    /// Whether a register is one of this device's.
    template <auto const& R> static constexpr bool contains = holds(&R);

    /// Calls `visit.template operator()<R>()` for each register.
    template <typename Visit> static constexpr void for_each(Visit&& visit)
    {
        (visit.template operator()<Registers>(), ...);
    }

private:
    static constexpr std::array<text, size> codes{Registers.code...};
    static constexpr index_pair overlap = first_duplicate(addresses);
    static constexpr index_pair namesake = first_duplicate(codes);

    static consteval bool is_sound() noexcept
    {
        if constexpr (overlap.second != 0) {
            return sizeof(these_registers_overlap<register_at<overlap.first, Registers...>(),
                                                  register_at<overlap.second, Registers...>()>) > 0;
        } else if constexpr (namesake.second != 0) {
            return sizeof(these_registers_have_one_code<
                          register_at<namesake.first, Registers...>(),
                          register_at<namesake.second, Registers...>()>) > 0;
        } else {
            return true;
        }
    }
    static_assert(is_sound());
};

} // namespace rtuwire
