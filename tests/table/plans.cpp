// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Plans: the very one that brute force finds, every register exactly once, never over the limit.
#include <rtuwire/table/request_plan.hpp>

#include <algorithm>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr std::size_t most = 12;

struct problem {
    std::vector<std::uint16_t> rising;
    std::vector<bool> readable;
    std::uint32_t limit;
    std::vector<bool> joined; ///< of each address: whether it goes with the one before

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

/// Addresses of which one of so many stays with the one before it; none does for 0.
problem make(test::random& random, std::uint32_t joined_of = 0)
{
    constexpr std::uint32_t span = 64;
    problem made{{}, std::vector<bool>(span), 1 + random.below(20), {}};
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
        made.joined.push_back(joined_of > 0 and random.below(joined_of) == 0);
    }
    return made;
}

/// What brute force found: the blocks, none where there is no plan.
struct cheapest {
    plan_cost cost{0xFFFF'FFFF, 0};
    std::vector<address_block> blocks;
};

/// Every way to cut the addresses into runs, one bit for each place between two of them. Of equal ones the last, whose
/// bits are the higher number: it cuts later, counted from the end.
cheapest brute_force(problem const& asked)
{
    cheapest best;
    std::size_t const gaps = asked.rising.size() - 1;
    for (std::uint32_t cuts = 0; cuts < (1U << gaps); ++cuts) {
        cheapest found{{}, {}};
        bool is_legal = true;
        std::size_t first = 0;
        for (std::size_t i = 0; i <= gaps; ++i) {
            if (i < gaps and ((cuts >> i) & 1U) == 0) {
                is_legal = is_legal and asked.may_cross(asked.rising[i], asked.rising[i + 1]);
                continue;
            }
            std::uint32_t const size = asked.rising[i] - asked.rising[first] + 1U;
            is_legal = is_legal and size <= asked.limit and not asked.joined[first];
            found.cost = {found.cost.requests + 1, found.cost.registers + size};
            found.blocks.push_back({asked.rising[first], static_cast<std::uint16_t>(size)});
            first = i + 1;
        }
        if (is_legal and not best.cost.is_below(found.cost)) {
            best = found;
        }
    }
    return best;
}

struct mistakes {
    unsigned dearer, uncovered, too_large, different;
    friend bool operator==(mistakes, mistakes) noexcept = default;
};

/// What is wrong with the plans of so many random sets.
mistakes in_random_sets(unsigned rounds)
{
    test::random random{2026};
    mistakes found{};
    for (unsigned round = 0; round < rounds; ++round) {
        problem const asked = make(random);
        auto const plan = plan_blocks<most>(asked.rising, asked.limit, [&](std::uint16_t lower, std::uint16_t upper) {
            return asked.may_cross(lower, upper);
        });
        plan_cost cost{};
        for (address_block const& block : plan.view()) {
            cost = {cost.requests + 1, cost.registers + block.count};
            found.too_large += block.count > asked.limit ? 1U : 0U;
        }
        for (std::uint16_t const address : asked.rising) {
            unsigned times = 0;
            for (address_block const& block : plan.view()) {
                times += block.contains(address) ? 1U : 0U;
            }
            found.uncovered += times == 1 ? 0U : 1U;
        }
        auto const best = brute_force(asked);
        found.dearer += cost.requests == best.cost.requests and cost.registers == best.cost.registers ? 0U : 1U;
        found.different += std::ranges::equal(plan.view(), best.blocks) ? 0U : 1U;
    }
    return found;
}

/// Sets of which some addresses stay with the one before: how many plans differ from brute force, and how many sets
/// have a plan at all.
struct joined_sets {
    unsigned different{0}, without_a_plan{0}, with_a_plan{0};
};
joined_sets in_joined_sets(unsigned rounds)
{
    test::random random{2027};
    joined_sets found;
    for (unsigned round = 0; round < rounds; ++round) {
        problem const asked = make(random, 2 + random.below(4));
        auto const plan = plan_blocks<most>(
            asked.rising, asked.limit,
            [&](std::uint16_t lower, std::uint16_t upper) { return asked.may_cross(lower, upper); },
            [&](std::size_t index) { return asked.joined[index]; });
        auto const best = brute_force(asked);
        found.different += std::ranges::equal(plan.view(), best.blocks) ? 0U : 1U;
        (best.blocks.empty() ? found.without_a_plan : found.with_a_plan) += 1;
    }
    return found;
}

} // namespace

TEST_CASE("plans of a hundred random sets are the cheapest there are, and cover each register once")
{
    CHECK(in_random_sets(100) == mistakes{});
}

TEST_CASE("plans of 10000 random sets, too") { CHECK(in_random_sets(10'000) == mistakes{}); }

TEST_CASE("plans whose blocks must not start anywhere are those of brute force, or none where none can be")
{
    joined_sets const found = in_joined_sets(4'000);
    CHECK(found.different == 0);
    CHECK(found.without_a_plan > 400);
    CHECK(found.with_a_plan > 400);
}

TEST_CASE("whether a gap may be crossed is asked once, and never of one that is too long")
{
    std::array<std::uint16_t, 5> const rising{10, 12, 15, 40, 41};
    unsigned asked = 0;
    auto const plan = plan_blocks<5>(rising, 6, [&](std::uint16_t lower, std::uint16_t upper) {
        ++asked;
        return upper - lower <= 6;
    });
    CHECK(asked == 3);
    CHECK(std::ranges::equal(plan.view(), std::array<address_block, 2>{{{10, 6}, {40, 2}}}));
}

TEST_CASE("a block holds the addresses from its first on, as many as it counts")
{
    address_block const block{100, 3};
    for (std::uint32_t address = 0; address <= 0xFFFF; ++address) {
        REQUIRE(block.contains(static_cast<std::uint16_t>(address)) ==
                (address == 100 or address == 101 or address == 102));
    }
}

TEST_CASE("addresses are put in order, whatever order they are in")
{
    test::random random{2026};
    for (unsigned round = 0; round < 200; ++round) {
        std::uint32_t const count = round % 10 == 0 ? random.below(1'000) : random.below(9);
        std::vector<std::uint16_t> addresses(count);
        for (std::uint16_t& address : addresses) {
            address = static_cast<std::uint16_t>(random.below(2 * count));
        }
        auto rising = addresses;
        std::sort(rising.begin(), rising.end());
        sort_addresses(addresses);
        REQUIRE(addresses == rising);
    }
}

TEST_CASE("of two plans the one with fewer requests is cheaper, then the one with fewer registers")
{
    CHECK(plan_cost{1, 9}.is_below({2, 3}));
    CHECK_FALSE(plan_cost{2, 3}.is_below({1, 9}));
    CHECK(plan_cost{2, 3}.is_below({2, 4}));
    CHECK_FALSE(plan_cost{2, 4}.is_below({2, 4}));
    CHECK_FALSE(plan_cost{2, 5}.is_below({2, 4}));
}
