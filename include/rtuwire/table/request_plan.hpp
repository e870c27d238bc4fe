// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How to cover a set of addresses with the fewest requests: among the plans with the fewest, the one that
// reads or writes the fewest registers. Knows addresses and a limit, no device and no frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

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

/// Sorts a list in place, a thousand in a few thousand steps, and in one pass where it rises already, as most tables do.
template <typename Addresses> constexpr void sort_addresses(Addresses& addresses) noexcept
{
    std::size_t rising = 1;
    while (rising < addresses.size() and not(addresses[rising] < addresses[rising - 1])) {
        ++rising;
    }
    if (rising >= addresses.size()) {
        return;
    }
    for (std::size_t step = (addresses.size() + 1) / 2; step > 0; step = step > 2 ? step * 5 / 11 : step - 1) {
        for (std::size_t i = step; i < addresses.size(); ++i) {
            for (std::size_t k = i; k >= step and addresses[k] < addresses[k - step]; k -= step) {
                auto const moved = addresses[k];
                addresses[k] = addresses[k - step];
                addresses[k - step] = moved;
            }
        }
    }
}

/// Every address may be the first of a block.
struct none_is_joined {
    constexpr bool operator()(std::size_t) const noexcept { return false; }
};

/// Where a block may start so that it ends at the address looked at, the cheapest first. While the ends go up, so does
/// the lowest start that one request still reaches, and a start never comes back that a later one has beaten: each is
/// added and removed once.
template <std::size_t Most> class block_starts {
public:
    /// What covers all addresses in front of the start at `index`, and this start in the sum: less of it is better for
    /// any end.
    struct start {
        std::size_t index;
        plan_cost before;
    };

    /// Of two equal ones the later is kept.
    constexpr void add(start one) noexcept
    {
        while (end_ > first_ and not starts_[end_ - 1].before.is_below(one.before)) {
            --end_;
        }
        starts_[end_++] = one;
    }

    /// Drops those in front of an index.
    constexpr void reach_to(std::size_t index) noexcept
    {
        while (first_ < end_ and starts_[first_].index < index) {
            ++first_;
        }
    }

    [[nodiscard]] constexpr bool empty() const noexcept { return first_ == end_; }
    [[nodiscard]] constexpr start cheapest() const noexcept { return starts_[first_]; }

private:
    std::array<start, Most> starts_{};
    std::size_t first_{0};
    std::size_t end_{0};
};

/// The best plan for addresses that rise, none twice. A block has at most `limit` registers (at least
/// 1), and spans the gap between two neighbours only where `may_cross(lower, upper)`, which is asked once a gap, and of
/// no gap that is too long anyway. No block starts at an address for whose index `is_joined`: it goes with the one
/// before. Where no plan can be, it has no block. Of plans that cost the same, the one whose last block starts latest, then
/// the one before it.
template <std::size_t Most, typename MayCross, typename IsJoined = none_is_joined>
[[nodiscard]] constexpr block_list<Most> plan_blocks(std::span<std::uint16_t const> rising, std::uint32_t limit,
                                                     MayCross may_cross, IsJoined is_joined = {})
{
    block_list<Most> plan;
    // The cheapest way to cover the addresses so far, and for each of them where the last block starts.
    plan_cost best{};
    std::array<std::size_t, Most> from{};
    block_starts<Most> starts;
    for (std::size_t last = 0, lowest = 0; last < rising.size(); ++last) {
        std::uint32_t const behind = rising[last] + 1U;
        if (last > 0 and (behind - rising[last - 1] > limit or not may_cross(rising[last - 1], rising[last]))) {
            lowest = last;
        }
        while (behind - rising[lowest] > limit) {
            ++lowest;
        }
        if (not is_joined(last)) {
            starts.add({last, {best.requests, best.registers + 0x1'0000U - rising[last]}});
        }
        starts.reach_to(lowest);
        if (starts.empty()) {
            return plan;
        }
        auto const chosen = starts.cheapest();
        best = {chosen.before.requests + 1, chosen.before.registers + behind - 0x1'0000U};
        from[last] = chosen.index;
    }
    plan.count = best.requests;
    std::size_t end = rising.size();
    for (std::size_t place = plan.count; place-- > 0;) {
        std::size_t const first = from[end - 1];
        plan.blocks[place] = {rising[first], static_cast<std::uint16_t>(rising[end - 1] - rising[first] + 1)};
        end = first;
    }
    return plan;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
