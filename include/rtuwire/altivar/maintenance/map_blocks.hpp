// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The rows of a parameter map in the order of their addresses, by blocks without a hole. Each look goes through the map,
// so that nothing is kept of it.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/request_plan.hpp>
#include <rtuwire/wire/function.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// A row and the group that it is in; null where there is none.
struct placed_row {
    parameter_group const* group{nullptr};
    parameter const* row{nullptr};
};

/// The row at an address.
[[nodiscard]] constexpr placed_row row_at(parameter_map const& map, std::uint16_t address) noexcept
{
    for (parameter_group const& group : map.groups()) {
        for (parameter const& each : group.rows) {
            if (each.address == address) {
                return {&group, &each};
            }
        }
    }
    return {};
}

/// One above the highest address: no row from there on.
inline constexpr std::uint32_t no_address = 0x1'0000;

/// The lowest address, from one on, of a row that passes `filter`; `no_address` where there is none. The filter is asked
/// only of rows that could be it.
template <typename Filter>
[[nodiscard]] constexpr std::uint32_t lowest_address(parameter_map const& map, std::uint32_t from,
                                                     Filter const& filter) noexcept
{
    std::uint32_t lowest = no_address;
    map.for_each([&](parameter const& each, parameter_group const&) {
        if (each.address >= from and each.address < lowest and filter(each)) {
            lowest = each.address;
        }
    });
    return lowest;
}

/// The block that begins with the lowest address from one on, without a hole, of at most `limit` registers; empty where
/// there is none.
template <typename Filter>
[[nodiscard]] constexpr detail::address_block block_from(parameter_map const& map, std::uint32_t from,
                                                         std::uint16_t limit, Filter const& filter) noexcept
{
    std::uint32_t const start = lowest_address(map, from, filter);
    if (start == no_address) {
        return {};
    }
    std::array<bool, max_read_quantity> is_there{};
    std::size_t const most = limit < is_there.size() ? limit : is_there.size();
    map.for_each([&](parameter const& each, parameter_group const&) {
        if (each.address >= start and each.address - start < most and not is_there[each.address - start]) {
            is_there[each.address - start] = filter(each);
        }
    });
    std::uint16_t count = 1;
    while (count < most and is_there[count]) {
        ++count;
    }
    return {static_cast<std::uint16_t>(start), count};
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
