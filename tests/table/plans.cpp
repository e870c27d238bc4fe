// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Plans: as few requests as brute force finds, every register exactly once, never over the limit.
#include <rtuwire/table/request_plan.hpp>

#include <algorithm>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

using namespace rtuwire;

namespace {

constexpr std::size_t most = 12;

struct problem {
    std::vector<std::uint16_t> rising;
    std::vector<bool> readable;
    std::uint32_t limit;

    bool may_cross(std::uint16_t lower, std::uint16_t upper) const
    {
        for (std::size_t a = lower; a <= upper; ++a) {
            if (not readable[a]) {
                return false;
            }
        }
        return true;
    }
};

problem make(test::random& random)
{
    constexpr std::uint32_t span = 64;
    problem made{{}, std::vector<bool>(span), 1 + random.below(20)};
    std::size_t const count = 1 + random.below(most);
    while (made.rising.size() < count) {
        auto const address = static_cast<std::uint16_t>(random.below(span));
        if (std::find(made.rising.begin(), made.rising.end(), address) == made.rising.end()) {
            made.rising.push_back(address);
        }
    }
    std::sort(made.rising.begin(), made.rising.end());
    for (std::size_t a = 0; a < span; ++a) {
        made.readable[a] = random.below(4) != 0;
    }
    for (std::uint16_t const address : made.rising) {
        made.readable[address] = true;
    }
    return made;
}

/// Every way to cut the addresses into runs, one bit for each place between two of them.
plan_cost brute_force(problem const& asked)
{
    plan_cost best{0xFFFF'FFFF, 0};
    std::size_t const gaps = asked.rising.size() - 1;
    for (std::uint32_t cuts = 0; cuts < (1U << gaps); ++cuts) {
        plan_cost cost{};
        bool is_legal = true;
        std::size_t first = 0;
        for (std::size_t i = 0; i <= gaps; ++i) {
            if (i < gaps and ((cuts >> i) & 1U) == 0) {
                is_legal = is_legal and asked.may_cross(asked.rising[i], asked.rising[i + 1]);
                continue;
            }
            std::uint32_t const size = asked.rising[i] - asked.rising[first] + 1U;
            is_legal = is_legal and size <= asked.limit;
            cost = {cost.requests + 1, cost.registers + size};
            first = i + 1;
        }
        if (is_legal and cost.is_below(best)) {
            best = cost;
        }
    }
    return best;
}

} // namespace

TEST_CASE("plans of 10000 random sets are the cheapest there are, and cover each register once")
{
    test::random random{2026};
    unsigned dearer = 0;
    unsigned uncovered = 0;
    unsigned too_large = 0;
    for (unsigned round = 0; round < 10'000; ++round) {
        problem const asked = make(random);
        auto const plan = plan_blocks<most>(asked.rising, asked.limit,
                                            [&](std::uint16_t lower, std::uint16_t upper) {
                                                return asked.may_cross(lower, upper);
                                            });
        plan_cost cost{};
        for (address_block const& block : plan.view()) {
            cost = {cost.requests + 1, cost.registers + block.count};
            too_large += block.count > asked.limit ? 1U : 0U;
        }
        for (std::uint16_t const address : asked.rising) {
            unsigned times = 0;
            for (address_block const& block : plan.view()) {
                times += block.contains(address) ? 1U : 0U;
            }
            uncovered += times == 1 ? 0U : 1U;
        }
        plan_cost const best = brute_force(asked);
        dearer += cost.requests == best.requests and cost.registers == best.registers ? 0U : 1U;
    }
    CHECK(dearer == 0);
    CHECK(uncovered == 0);
    CHECK(too_large == 0);
}
