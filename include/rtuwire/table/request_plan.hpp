// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How to cover a set of addresses with the fewest requests: among the plans with the fewest, the one that
// reads or writes the fewest registers. Knows addresses and a limit, no device and no frame.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// One request: `count` registers from `start` on.
struct address_block {
    std::uint16_t start{0};
    std::uint16_t count{0};

    [[nodiscard]] constexpr bool contains(std::uint16_t address) const noexcept
    {
        return address >= start and address - start < count;
    }

    friend constexpr bool operator==(address_block const&, address_block const&) noexcept = default;
};

/// The blocks of a plan for at most `Most` addresses.
template <std::size_t Most> struct block_list {
    std::array<address_block, Most> blocks{};
    std::size_t count{0};

    [[nodiscard]] constexpr std::span<address_block const> view() const noexcept
    {
        return std::span{blocks}.first(count);
    }
};

/// What a plan costs.
struct plan_cost {
    std::uint32_t requests{0};
    std::uint32_t registers{0};

    [[nodiscard]] constexpr bool is_below(plan_cost other) const noexcept
    {
        return requests != other.requests ? requests < other.requests : registers < other.registers;
    }
};

/// Sorts a short list in place.
template <typename Addresses> constexpr void sort_addresses(Addresses& addresses) noexcept
{
    for (std::size_t i = 1; i < addresses.size(); ++i) {
        for (std::size_t k = i; k > 0 and addresses[k] < addresses[k - 1]; --k) {
            auto const moved = addresses[k];
            addresses[k] = addresses[k - 1];
            addresses[k - 1] = moved;
        }
    }
}

/// Every address may be the first of a block.
struct none_is_joined {
    constexpr bool operator()(std::size_t) const noexcept { return false; }
};

/// The best plan for addresses that rise, none twice. A block has at most `limit` registers (at least
/// 1), and spans the gap between two neighbours only where `may_cross(lower, upper)`. No block starts at an address
/// for whose index `is_joined`: it goes with the one before. Where no plan can be, it has no block.
template <std::size_t Most, typename MayCross, typename IsJoined = none_is_joined>
[[nodiscard]] constexpr block_list<Most> plan_blocks(std::span<std::uint16_t const> rising, std::uint32_t limit,
                                                     MayCross may_cross, IsJoined is_joined = {})
{
    constexpr std::uint32_t impossible = 0xFFFF'FFFF;
    // best[i]: the cheapest way to cover the first i addresses; from[i]: where its last block starts.
    std::array<plan_cost, Most + 1> best{};
    std::array<std::size_t, Most + 1> from{};
    for (std::size_t end = 1; end <= rising.size(); ++end) {
        best[end] = {impossible, 0};
        for (std::size_t first = end; first-- > 0;) {
            std::uint32_t const span = std::uint32_t{rising[end - 1]} - rising[first] + 1;
            if (span > limit) {
                break;
            }
            bool const may_start = best[first].requests != impossible and not is_joined(first);
            plan_cost const cost{best[first].requests + 1, best[first].registers + span};
            if (may_start and cost.is_below(best[end])) {
                best[end] = cost;
                from[end] = first;
            }
            if (first > 0 and not may_cross(rising[first - 1], rising[first])) {
                break;
            }
        }
    }
    block_list<Most> plan;
    if (best[rising.size()].requests == impossible) {
        return plan;
    }
    plan.count = best[rising.size()].requests;
    std::size_t end = rising.size();
    for (std::size_t place = plan.count; place-- > 0;) {
        std::size_t const first = from[end];
        plan.blocks[place] = {rising[first], static_cast<std::uint16_t>(rising[end - 1] - rising[first] + 1)};
        end = first;
    }
    return plan;
}

} // namespace rtuwire
