// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A start that finds the drive in fault, in local control or stopped by its STOP key behind the order: what ends that state
// during the check - a key at the drive, its mains - does not start the motor.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using test::plant;

namespace {

enum class met { in_fault, in_local };

template <typename Device> void stop(plant<Device>& it, met what)
{
    what == met::in_fault ? it.far().inject_fault(9) : it.far().set_local(true);
}
template <typename Device> void clear(plant<Device>& it, met what)
{
    if (what == met::in_local) {
        it.far().set_local(false);
    } else {
        it.far().clear_cause();
        it.far().power_cycle(it.now());
    }
}

/// Lets an order find the drive stopped, and ends that behind so many of its frames. Whether it had as many.
template <typename Device, typename Order> bool is_cleared_after(unsigned frames, met what, Order order)
{
    plant<Device> it;
    stop(it, what);
    unsigned passed = 0;
    bool counts = true;
    it.disturb([&](test::frame_bytes const&, bool is_request) { passed += is_request and counts ? 1 : 0; });
    bool was_cleared = false;
    while (not order.settled()) {
        it.step([&](instant now) { it.link().converse(order, now); }, milliseconds(1));
        if (passed > frames and not was_cleared and not order.settled()) {
            was_cleared = true;
            counts = false;
            clear(it, what);
        }
        CHECK(it.millihertz() == 0);
    }
    auto const wanted = what == met::in_fault ? outcome_kind::in_fault : outcome_kind::local_control;
    CHECK(order.reason().kind == wanted);
    CHECK_FALSE(order.running());
    it.idle(milliseconds(1'000));
    CHECK(it.millihertz() == 0);
    return was_cleared;
}

template <typename Device, typename Make> void ends_as_it_was_met(Make make)
{
    unsigned cleared = 0;
    for (met const what : {met::in_fault, met::in_local}) {
        for (bool const is_reverse : {false, true}) {
            for (unsigned frames = 1; is_cleared_after<Device>(frames, what, make(is_reverse)); ++frames) {
                ++cleared;
            }
        }
    }
    CHECK(cleared != 0);
}

/// Orders a motor that runs anew while a unit that does not answer has the line, and presses STOP meanwhile.
template <typename Device, typename Order> outcome_kind pressed_before(plant<Device>& it, Order order)
{
    single_request absent{unit_id{9}, read_holding_registers{3'201, 1}};
    it.step([&](instant now) { it.link().converse(absent, now); }, milliseconds(1));
    bool is_pressed = false;
    while (not order.settled()) {
        it.step(
            [&](instant now) {
                it.link().converse(absent, now);
                it.link().converse(order, now);
            },
            milliseconds(10));
        if (not is_pressed) {
            it.far().press_stop();
            is_pressed = true;
        }
    }
    it.idle(milliseconds(200));
    CHECK_FALSE(order.running());
    return order.reason().kind;
}

} // namespace

TEST_CASE("defect: a start of a drive that is met in fault or in local control ends so, whatever becomes of that")
{
    test::all_drives::for_each([]<typename Device>() {
        ends_as_it_was_met<Device>([](bool is_reverse) {
            return start{plant<Device>::drive, 30_Hz, is_reverse ? run_direction::reverse : run_direction::forward};
        });
    });
    ends_as_it_was_met<atv28::device>([](bool is_reverse) {
        return is_reverse ? atv28::direct_start{plant<atv28::device>::drive, -30_Hz}
                          : atv28::direct_start{plant<atv28::device>::drive, 30_Hz};
    });
}

TEST_CASE("defect: a STOP key that is pressed behind an order to a motor that this client runs ends the order")
{
    test::all_drives::for_each([]<typename Device>() {
        plant<Device> it;
        start first{it.drive, 40_Hz};
        REQUIRE(it.run(first));
        REQUIRE(first.running());
        it.idle(milliseconds(500));
        CHECK(pressed_before(it, start{it.drive, -20_Hz, run_direction::forward, milliseconds(10'000)}) ==
              outcome_kind::stop_key);
        CHECK_FALSE(first.running());
        it.idle(milliseconds(9'000)); // its ramp, and the time-out of a drive that nobody asks
        CHECK(it.millihertz() == 0);
    });
    plant<atv28::device> it;
    atv28::direct_start first{it.drive, 40_Hz};
    REQUIRE(it.run(first));
    it.idle(milliseconds(500));
    CHECK(pressed_before(it, atv28::direct_start{it.drive, -20_Hz, milliseconds(10'000)}) == outcome_kind::stop_key);
}

TEST_CASE("defect: a STOP key that was pressed before an order of a motor that nobody had running counts no more")
{
    test::all_drives::for_each([]<typename Device>() {
        plant<Device> it;
        start first{it.drive, 40_Hz};
        REQUIRE(it.run(first));
        it.far().press_stop();
        start again{it.drive, 20_Hz};
        REQUIRE(it.run(again)); // it does not know which was first
        CHECK(again.reason().kind == outcome_kind::stop_key);
        start anew{it.drive, 20_Hz};
        REQUIRE(it.run(anew));
        CHECK(anew.running());
    });
}
