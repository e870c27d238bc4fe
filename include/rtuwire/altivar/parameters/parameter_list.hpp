// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Some registers of a drive as one list, of which the compiler makes both outputs: rows to walk, and the registers of a
// device for typed access.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Registers of one group; a group is a class of its own that derives from its list, for the sake of short names.
template <auto const&... Registers> struct parameter_list {
    static_assert(detail::are_all<Registers.is_plain...>, "a parameter is a holding register of one word");

    static constexpr std::size_t size = sizeof...(Registers);
    static constexpr std::array<std::uint16_t, size> addresses{Registers.address...};

    /// The same as rows.
    [[nodiscard]] static consteval std::array<parameter, size> made_rows() noexcept
    {
        return {parameter_of(Registers)...};
    }

    [[nodiscard]] static constexpr bool has_address(std::uint16_t address) noexcept
    {
        for (std::uint16_t const each : addresses) {
            if (each == address) {
                return true;
            }
        }
        return false;
    }

    /// Whether an object is one of these registers. Only those of its address are compared: GCC with
    /// -fsanitize=undefined does not compare the addresses of two objects in a constant expression.
    [[nodiscard]] static constexpr bool holds(std::uint16_t address, void const* object) noexcept
    {
        if (not has_address(address)) {
            return false;
        }
        std::array<void const*, size> const objects{&Registers...};
        bool is_held = false;
        for (std::size_t i = 0; i < size; ++i) {
            is_held = is_held or (addresses[i] == address and objects[i] == object);
        }
        return is_held;
    }

    /// Calls `visit.template operator()<R>()` for each.
    template <typename Visit> static constexpr void for_each(Visit&& visit)
    {
        (visit.template operator()<Registers>(), ...);
    }
};

/// The rows of a group.
/// Internal.
template <typename Group> inline constexpr auto rows_of = Group::made_rows();

/// The registers of some groups as those of a device. Not a `table` of a thousand registers, which costs the compiler a
/// second: a message names the groups, and that no register is in two of them, a test sees to.
template <typename... Groups> class grouped_table {
public:
    static constexpr std::size_t size = (Groups::size + ... + 0);

    /// Whether there is a register at an address.
    [[nodiscard]] static constexpr bool has_address(std::uint16_t address,
                                                    register_space space = register_space::holding) noexcept
    {
        return space == register_space::holding and (Groups::has_address(address) or ...);
    }

    /// Whether a register is this device's.
    [[nodiscard]] static constexpr bool holds(detail::asked_register const& asked) noexcept
    {
        void const* const object = asked.is_restepped ? asked.counted_as : asked.itself;
        return asked.space == register_space::holding and (Groups::holds(asked.address, object) or ...);
    }

    /// Whether all of some registers are this device's.
    template <std::size_t Count>
    [[nodiscard]] static constexpr bool holds_all(std::array<detail::asked_register, Count> const& all_asked) noexcept
    {
        for (detail::asked_register const& asked : all_asked) {
            if (not holds(asked)) {
                return false;
            }
        }
        return true;
    }

    /// Whether a register is one of this device's, or one of them counted in other steps. Asked of a function: a constant
    /// of each group would be one more template for each register and group.
    template <auto const& R>
    static constexpr bool contains = holds({R.address, R.space, &R, R.counted_as, R.is_restepped});

    /// Calls `visit.template operator()<R>()` for each register.
    template <typename Visit> static constexpr void for_each(Visit&& visit) { (Groups::for_each(visit), ...); }

    /// Calls `visit(row)` for the row of each, group by group.
    template <typename Visit> static constexpr void for_each_row(Visit&& visit) { (walk(rows_of<Groups>, visit), ...); }

private:
    template <typename Rows, typename Visit> static constexpr void walk(Rows const& rows, Visit&& visit)
    {
        for (parameter const& each : rows) {
            visit(each);
        }
    }
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
