// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Thirty drives on one line of 19 200 bit/s: how close the bus comes to what the wire allows, and what
// three silent drives cost the others.
#include <rtuwire/altivar/cyclic/cyclic.hpp>

#include <vector>

#include "support/catch.hpp"
#include "support/simulated_bus.hpp"

#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr std::size_t drives = 30;
constexpr client_options patient{.response_timeout = milliseconds(50), .retries = 1};

struct hall : test::simulated_bus<bus<drives>, atv320::device> {
    std::vector<cyclic<atv320::device>> loops;

    hall() : test::simulated_bus<bus<drives>, atv320::device>{bus<drives>{test::bus_timing, patient}}
    {
        for (std::uint32_t unit = 1; unit <= drives; ++unit) {
            add(*unit_id::checked(unit));
            loops.emplace_back(*station<atv320::device>::checked(unit), cyclic_options{.period = milliseconds(1)});
        }
        idle(milliseconds(20));
        run_for(milliseconds(15'000)); // each is looked at and checked before its first exchange
    }

    void run_for(duration length)
    {
        run(
            [&](instant at) {
                for (std::size_t i = 0; i < loops.size(); ++i) {
                    link().converse(i, loops[i], at);
                }
            },
            [] { return false; }, length);
    }

    /// How many answers the drives that `counts` says gave in 30 s.
    template <typename Counts> std::size_t answers_in_half_a_minute(Counts counts)
    {
        auto const sum = [&] {
            std::size_t all = 0;
            for (std::size_t i = 0; i < drives; ++i) {
                all += counts(i) ? answers(i) : 0;
            }
            return all;
        };
        std::size_t const before = sum();
        run_for(milliseconds(30'000));
        return sum() - before;
    }
};

/// A cycle of one drive: 21 bytes asked, t3.5 until the drive answers, 13 bytes, t3.5.
constexpr std::uint32_t cycle_us = test::bus_timing.characters(21).microseconds +
                                   test::bus_timing.characters(13).microseconds +
                                   2 * test::bus_timing.t3_5().microseconds;

} // namespace

TEST_CASE("thirty drives share a line that is busy 97 % of what it can be")
{
    hall all;
    std::size_t const cycles = all.answers_in_half_a_minute([](std::size_t) { return true; });
    double const share = double(cycles) * cycle_us / 30'000'000.0;
    INFO("cycles in 30 s: " << cycles << ", " << 100 * share << " % of what the line allows");
    CHECK(share >= 0.97);
    CHECK(share <= 1.001);
}

TEST_CASE("three silent drives of thirty leave the others 80 % of their rate")
{
    hall all;
    auto const is_silent = [](std::size_t i) { return i == 4 or i == 15 or i == 29; };
    auto const is_other = [&](std::size_t i) { return not is_silent(i); };
    auto const before = double(all.answers_in_half_a_minute(is_other));
    for (std::size_t i = 0; i < drives; ++i) {
        all.cut(i, is_silent(i));
    }
    auto const after = double(all.answers_in_half_a_minute(is_other));
    INFO("the 27 keep " << 100 * after / before << " % of their rate");
    CHECK(after >= 0.8 * before);
    CHECK(all.link().is_silent(4));
    CHECK_FALSE(all.link().is_silent(5));
}
