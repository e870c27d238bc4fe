// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A stop of everyone that nobody hears, and a motor that this client ordered and that is not among its drives.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/inspection/watch.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_freewheel.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

/// Two drives on a bus, a slot for each that polls it, and a line that loses every broadcast.
template <typename Device> struct pair_of_drives : test::simulated_bus<bus<4>, Device> {
    static constexpr station<Device> first{unit_id{1}}, second{unit_id{2}};
    watch<Device> poll{second};
    watch<Device> poll_first{first};
    start of_first{first, 30_Hz};
    start of_second{second, 30_Hz};

    pair_of_drives() : test::simulated_bus<bus<4>, Device>{bus<4>{test::bus_timing, patient}}
    {
        this->add(first.unit());
        this->add(second.unit());
        this->idle(milliseconds(20));
        this->disturb([](test::frame_bytes& frame, bool is_request) {
            if (is_request and frame[0] == std::byte{0}) {
                frame.clear();
            }
        });
    }
    std::int32_t millihertz() { return this->unit(1).drive().motor().frequency(); }

    template <typename Pass> void go_on(duration length, Pass const& pass)
    {
        instant const end = this->now() + length;
        while (not reached(this->now(), end)) {
            this->step(
                [&](instant now) {
                    pass(now);
                    this->link().converse(0, poll, now);
                    this->link().converse(3, poll_first, now);
                },
                milliseconds(10));
        }
    }
    void bring_up()
    {
        go_on(milliseconds(6'000), [&](instant now) {
            if (not of_first.settled()) {
                this->link().converse(1, of_first, now);
            }
            if (not of_second.settled()) {
                this->link().converse(2, of_second, now);
            }
        });
        REQUIRE((of_first.running() and of_second.running()));
        REQUIRE(millihertz() == 30'000);
    }
};

} // namespace

TEST_CASE(
    "defect: D27 a drive that a stop of all does not name, and that did not hear it, stops by itself: nobody feeds it")
{
    test::all_drives::for_each([]<typename Device>() {
        pair_of_drives<Device> it;
        it.bring_up();
        broadcast_stop all{it.first};
        bool has_succeeded = false;
        it.go_on(milliseconds(25'000), [&](instant now) {
            if (not all.settled()) {
                it.link().run_urgent(all, now);
                has_succeeded = has_succeeded or all.succeeded();
            }
        });
        CHECK(all.settled());
        CHECK(it.millihertz() == 0);
        CHECK_FALSE(has_succeeded);
        CHECK_FALSE(it.of_second.running());
    });
}

TEST_CASE("motion law: S45 a cycle of a drive that a stop of all does not name says words that stop it")
{
    test::all_drives::for_each([]<typename Device>() {
        pair_of_drives<Device> it;
        it.bring_up();
        cyclic<Device> loop{it.second};
        auto const work = [&](instant now) { it.link().converse(2, loop, now); };
        it.go_on(milliseconds(1'000), work);
        using at = setting<cycle_layout<Device>::reference>;
        constexpr std::int16_t at_30_hertz = cycle_layout<Device>::has_scanner ? 900 : 300;
        REQUIRE(loop.run(*at::checked(typename at::value_type{at_30_hertz})));
        it.go_on(milliseconds(4'000), work);
        REQUIRE(loop.control().is_ordered());
        REQUIRE(it.millihertz() == 30'000);
        broadcast_stop all{it.first};
        bool leaves_one = false;
        it.go_on(milliseconds(5'500), [&](instant now) { // none trips before 7 s
            if (not all.settled()) {
                it.link().run_urgent(all, now);
                leaves_one = leaves_one or all.leaves_ordered();
                CHECK(all.succeeded() == (all.settled() and not all.leaves_ordered()));
            }
            work(now);
        });
        CHECK(it.millihertz() == 0);
        CHECK_FALSE(loop.control().is_ordered());
        CHECK((all.settled() and leaves_one));
    });
}

TEST_CASE("motion law: S45 a drive that a stop of all does not name is stopped by its own stop afterwards")
{
    test::all_drives::for_each([]<typename Device>() {
        pair_of_drives<Device> it;
        it.bring_up();
        unsigned freed = 0, others = 0;
        it.disturb([&](test::frame_bytes const& frame, bool is_request) {
            if (is_request and frame[0] == std::byte{0}) {
                ++(u16_at(byte_view{frame}, 4) == 0x0000 ? freed : others);
            }
        });
        broadcast_stop all{it.first};
        bool has_ended = false;
        it.go_on(milliseconds(3'000), [&](instant now) {
            if (not has_ended) {
                it.link().run_urgent(all, now);
                has_ended = all.settled();
                CHECK((not has_ended or (all.leaves_ordered() and not all.succeeded())));
            }
        });
        REQUIRE(has_ended);
        CHECK((freed == 3 and others == 0)); // nobody has asked the first one for half a second: 0000
        CHECK(it.link().is_ordered(it.second.unit()));
        stop rest{it.second};
        bool has_rested = false;
        it.go_on(milliseconds(5'000), [&](instant now) {
            if (not rest.settled()) {
                it.link().converse(2, rest, now);
                has_rested = has_rested or rest.succeeded();
            }
        });
        CHECK(has_rested);
        CHECK_FALSE(it.link().is_ordered(it.second.unit()));
    });
}

TEST_CASE("defect: F7 a start does not run any more once its client has sent a freewheel to all")
{
    test::all_drives::for_each([]<typename Device>() {
        pair_of_drives<Device> it;
        it.bring_up();
        auto coast = broadcast_freewheel<Device>();
        it.go_on(milliseconds(100), [&](instant now) { it.link().converse(3, coast, now); });
        CHECK_FALSE(it.of_first.running());
        CHECK_FALSE(it.of_second.running());
    });
}
