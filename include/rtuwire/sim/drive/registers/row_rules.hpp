// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The same of a drive with all its parameters: made of their rows, in one loop over plain data. A template for each of
// a thousand registers would keep the compiler busy for seconds. Knows of a row only what it can be asked for, not its
// class, so that the simulation does not include the lists of all parameters.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/factory.hpp>
#include <rtuwire/sim/drive/registers/menu_order.hpp>
#include <rtuwire/sim/drive/registers/register_rule.hpp>
#include <rtuwire/sim/drive/registers/speed_limits.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// Registers that can be walked as rows: those in the groups of all parameters.
template <typename Table>
concept table_of_rows = requires
{
    Table::for_each_row([](auto const&) {});
};

/// Whether a device has all its parameters.
template <typename Device> inline constexpr bool is_whole = table_of_rows<typename Device::registers>;

/// The count nearest to 0 that a row takes, as far as its limits are numbers; of an enumeration the lowest one.
template <typename Row> [[nodiscard]] constexpr std::uint16_t nearest_to_zero(Row const& row) noexcept
{
    if (not row.type->listed.empty()) {
        std::uint16_t lowest = 0xFFFF;
        for (std::uint16_t const each : row.type->listed) {
            lowest = each < lowest ? each : lowest;
        }
        return lowest;
    }
    std::int64_t const least = row.min.is_number() and row.min.raw() > 0 ? row.min.raw() : 0;
    std::int64_t const most = row.max.is_number() and row.max.raw() < 0 ? row.max.raw() : least;
    return static_cast<std::uint16_t>(most);
}

/// The value as delivered: from the row; or that of `factory_values`, where the row takes it; or the nearest to 0.
template <typename Row> [[nodiscard]] constexpr std::uint16_t delivered_by(Row const& row) noexcept
{
    if (row.factory) {
        return static_cast<std::uint16_t>(*row.factory);
    }
    std::uint16_t const nearest = nearest_to_zero(row);
    std::uint16_t const usual = value_in(factory_values, row.code, nearest);
    return row.takes(row.count_of(usual)) ? usual : nearest;
}

/// How many steps of a row make one whole unit.
template <typename Row> [[nodiscard]] constexpr std::int32_t steps_per_unit_of(Row const& row) noexcept
{
    return row.type->step_denominator / row.type->step_numerator;
}

/// A row as a rule. The limits that TFR, HSP and LSP are to each other are left open: `speed_limits` holds these three
/// for a whole request.
template <typename Row> [[nodiscard]] constexpr register_rule rule_of_row(Row const& row) noexcept
{
    bool const has_signed_type = row.count_of(0xFFFF) < 0;
    bool const is_never_negative = row.min.is_number() and row.min.raw() >= 0;
    bool const is_limit = is_speed_limit(row.code);
    std::uint16_t const factory = delivered_by(row);
    return {row.code,
            row.mode,
            has_signed_type and not is_never_negative,
            is_limit and not row.min.is_number() ? open_bound : row.min,
            is_limit and not row.max.is_number() ? open_bound : row.max,
            factory,
            value_in(commissioned_values, row.code, factory),
            is_order_in_menu(row.code),
            steps_per_unit_of(row),
            row.type->listed,
            no_gap};
}

/// The rules of all parameters, group by group.
template <table_of_rows Table> struct rules_of<Table> {
    static constexpr std::size_t count = Table::size;
    static constexpr auto list = [] {
        std::array<register_rule, count> rules{};
        std::size_t next = 0;
        Table::for_each_row([&](auto const& row) { rules[next++] = rule_of_row(row); });
        return rules;
    }();
    static constexpr auto codes = [] {
        std::array<literal, count> all{};
        std::size_t next = 0;
        Table::for_each_row([&](auto const& row) { all[next++] = row.code; });
        return all;
    }();
    static constexpr auto addresses = [] {
        std::array<std::uint16_t, count> all{};
        std::size_t next = 0;
        Table::for_each_row([&](auto const& row) { all[next++] = row.address; });
        return all;
    }();
};

} // namespace rtuwire::sim
