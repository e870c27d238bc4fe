// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive that takes 400 ms from the command to run to "operation enabled", as
// one that closes a contactor or releases a brake first. What it shows
// meanwhile is no rest, whoever reads it.
#include "support/catch.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/sim/bench.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr unit_id unit{7};
constexpr station<atv320::device> motor{unit};
constexpr line_timing line{19'200, character_format::even_8_1};

struct slow_drive {
    word_bank<20'000> bank{};
    instant at{0};
    bool is_told{false};

    slow_drive()
    {
        auto const& its = atv320::device::layout.safeguards;
        set(its.sll, 1);
        set(its.tto, 30);
        set(its.chcf, 1);
        set(its.cd1, 10);
        set(its.fr1, 164);
        set(atv320::hsp.address, 500);
        set(atv320::eta.address, 0x0250);
    }
    void set(std::uint16_t address, std::uint16_t word) { static_cast<void>(bank.set(address, word)); }
    void advance(instant now)
    {
        switch (bank.get(atv320::cmd.address)) {
        case 0x0000: show(0x0250); break;
        case 0x0006: show(0x0231); break;
        case 0x0007: show(0x0233); break;
        case 0x000F: follow(now); break;
        default: break;
        }
    }
    void follow(instant now)
    {
        at = is_told ? at : now;
        is_told = true;
        if (now - at > milliseconds(400)) {
            show(0x0637);
        }
    }
    void show(std::uint16_t status) { set(atv320::eta.address, status); }
};

} // namespace

TEST_CASE("defect: a drive that follows its command to run later stays "
          "ordered, whoever reads it meanwhile")
{
    slow_drive it;
    sim::bench bench{bus<3>{line, {.response_timeout = milliseconds(200), .retries = 0}}, bank_at{unit, it.bank}};
    start go{motor, 40_Hz};
    reset_fault beside{motor};
    for (int i = 0; i < 5'000 and not go.settled(); ++i) {
        bench.pass([&](instant now) {
            it.advance(now);
            bench.link().converse(0, go, now);
            if (it.is_told and not beside.settled()) {
                bench.link().converse(1, beside, now);
            }
        });
    }
    REQUIRE(beside.settled());
    CHECK(go.succeeded());
    CHECK(go.running());
    CHECK(bench.link().is_ordered(unit));
}

TEST_CASE("defect: a drive that was told to stop before it followed its order "
          "is at rest where it waits")
{
    slow_drive it;
    sim::bench bench{bus<3>{line, {.response_timeout = milliseconds(200), .retries = 0}}, bank_at{unit, it.bank}};
    start go{motor, 40_Hz};
    stop rest{motor};
    for (int i = 0; i < 5'000 and not rest.settled(); ++i) {
        bench.pass([&](instant now) {
            it.advance(now);
            if (not it.is_told) {
                bench.link().converse(0, go, now);
            } else {
                bench.link().converse(1, rest, now);
            }
        });
    }
    CHECK(rest.succeeded());
    CHECK_FALSE(bench.link().is_ordered(unit));
}
