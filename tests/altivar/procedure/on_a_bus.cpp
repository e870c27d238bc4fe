// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Conversations that pause, on a bus that sleeps until one of them has something to do.
#include <rtuwire/client/bus.hpp>

#include "support/catch.hpp"
#include "support/remembered.hpp"
#include "support/simulated_bus.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

using device = atv320::device;
constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

struct two_drives : test::simulated_bus<bus<2>, device> {
    station<device> first = *station<device>::checked(1);
    station<device> second = *station<device>::checked(2);

    two_drives() : test::simulated_bus<bus<2>, device>{bus<2>{test::bus_timing, patient}}
    {
        add(*unit_id::checked(1));
        add(*unit_id::checked(2));
        idle(milliseconds(20));
    }

    /// Runs both to their ends, each jump as long as the bus may sleep.
    template <typename One, typename Other> void run_both(One& one, Other& other)
    {
        run(
            [&](instant now) {
                link().converse(0, one, now);
                link().converse(1, other, now);
            },
            [&] { return one.settled() and other.settled(); }, milliseconds(60'000));
    }
};

} // namespace

TEST_CASE("two drives are started and stopped side by side")
{
    two_drives it;
    start one{it.first, 50_Hz};
    constexpr supervision_options at_the_limit{.beyond = beyond_limits::limit};
    test::remembered<start> other{it.second, 2'000_rpm, run_direction::reverse, milliseconds(3'000), at_the_limit};
    CHECK_FALSE(one.running());
    it.run_both(one, other);
    CHECK(one.running());
    CHECK(other.running());
    CHECK(other.reason().kind == outcome_kind::reference_limited);
    it.idle(milliseconds(3'000));
    CHECK(it.drive(0).motor().frequency() == 50'000);
    CHECK(it.drive(1).motor().frequency() == -50'000);
    test::remembered<stop> slow{it.first};
    test::remembered<stop> fast{it.second, stop_by::quick_stop};
    it.run_both(slow, fast);
    CHECK(slow.succeeded());
    CHECK(fast.succeeded());
    CHECK(it.drive(0).motor().is_at_rest());
    CHECK(it.drive(1).motor().is_at_rest());
    CHECK_FALSE(it.link().is_silent(0));
    CHECK_FALSE(it.link().is_silent(7));
}

TEST_CASE("a bus that runs one slot waits for its pauses, and a drive that is off ends by its limit")
{
    two_drives it;
    test::remembered<start> one{it.first, 50_Hz};
    test::remembered<start> other{it.second, 50_Hz};
    it.cut(1, true);
    it.run_both(one, other);
    CHECK(one.succeeded());
    CHECK(other.reason().kind == outcome_kind::silent);
    CHECK_FALSE(other.running());
}
