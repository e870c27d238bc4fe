// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the image of a drive knows of each of its registers: made of the descriptors in its table.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/factory.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// What an image needs to know of one register.
struct register_rule {
    literal code;
    access mode;
    bool is_signed;
    bound min;
    bound max;
    std::uint16_t factory;                 ///< as delivered
    std::uint16_t commissioned;            ///< as set at commissioning
    bool is_order;                         ///< no setting
    std::int32_t steps_per_unit;           ///< 10 where it counts tenths; 1 where it is no quantity
    std::span<std::uint16_t const> listed; ///< the words that mean something, of an enumeration
    count_range gap;                       ///< raw counts that it does not take
};

/// How many steps of a register make one whole unit.
template <auto const& R> [[nodiscard]] constexpr std::int32_t steps_per_unit() noexcept
{
    if constexpr (register_quantity<value_of<R>>) {
        using scale = typename value_of<R>::scale;
        return static_cast<std::int32_t>(scale::den / scale::num);
    } else {
        return 1;
    }
}

/// The value as delivered: from the table, or else from `factory_values`.
template <auto const& R> [[nodiscard]] constexpr std::uint16_t delivered() noexcept
{
    return R.factory ? static_cast<std::uint16_t>(*R.factory) : value_in(factory_values, R.code, 0);
}

/// The rules of a table's registers, in its order.
template <typename Table> struct rules_of;
template <auto const&... Registers> struct rules_of<table<Registers...>> {
    static constexpr std::size_t count = sizeof...(Registers);
    static constexpr std::array<register_rule, count> list{register_rule{
        Registers.code, Registers.mode, lowest<Registers>() < 0, Registers.min, Registers.max, delivered<Registers>(),
        value_in(commissioned_values, Registers.code, delivered<Registers>()), is_order(Registers.code),
        steps_per_unit<Registers>(), listed_words<value_of<Registers>>(), Registers.gap}...};
    static constexpr std::array<literal, count> codes{Registers.code...};
    static constexpr std::array<std::uint16_t, count> addresses{Registers.address...};
};

} // namespace rtuwire::sim
