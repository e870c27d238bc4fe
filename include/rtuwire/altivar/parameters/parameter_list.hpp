// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Some registers of a drive as one list, of which the compiler makes both outputs: rows to walk, and the registers of a
// device for typed access.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Registers of one group.
template <auto const&... Registers> struct parameter_list {
    static constexpr std::size_t size = sizeof...(Registers);
    using registers = table<Registers...>;

    /// The same as rows.
    static constexpr std::array<parameter, size> rows{parameter_of(Registers)...};
};

/// The registers of some lists as those of a device. Not one table of a thousand registers: the compiler then makes what
/// it asks for only, and a register's name in a message stays short. That no register is in two lists, a test sees to.
template <typename... Lists> class grouped_table {
public:
    static constexpr std::size_t size = (Lists::size + ... + 0);

    /// Whether there is a register at an address.
    [[nodiscard]] static constexpr bool has_address(std::uint16_t address,
                                                    register_space space = register_space::holding) noexcept
    {
        return (Lists::registers::has_address(address, space) or ...);
    }

    /// Whether all of some registers are this device's.
    template <std::size_t Count>
    [[nodiscard]] static constexpr bool holds_all(std::array<asked_register, Count> const& all_asked) noexcept
    {
        for (asked_register const& asked : all_asked) {
            if (not(Lists::registers::holds_all(std::array{asked}) or ...)) {
                return false;
            }
        }
        return true;
    }

    /// Whether a register is one of this device's, or one of them counted in other steps.
    template <auto const& R> static constexpr bool contains = (Lists::registers::template contains<R> or ...);

    /// Calls `visit.template operator()<R>()` for each register.
    template <typename Visit> static constexpr void for_each(Visit&& visit)
    {
        (Lists::registers::for_each(visit), ...);
    }
};

} // namespace rtuwire::altivar
