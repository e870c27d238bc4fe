// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A cycle that stops, and one whose drive somebody else stops.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

/// A cycle and a drive that runs at 50 Hz.
template <typename Device> struct cycling : test::simulated_bus<drive_client<4>, Device> {
    cyclic<Device> loop{station<Device>{unit_id{3}}};

    cycling() : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        pass(milliseconds(500));
        REQUIRE(order());
        pass(milliseconds(6'000));
        REQUIRE(far().motor().frequency() == 50'000);
    }

    void pass(duration length)
    {
        this->run([&](instant now) { this->link().converse(loop, now); }, [] { return false; }, length);
    }
    /// Passes until the motor stands; whether the drive stayed in one of these two states while it turned.
    bool comes_down_in(state first, state second)
    {
        bool stayed = true;
        for (unsigned i = 0; i < 1'000 and not far().motor().is_at_rest(); ++i) {
            pass(milliseconds(10));
            state const at = far().state_machine().state();
            stayed = stayed and (far().motor().is_at_rest() or at == first or at == second);
        }
        return stayed and far().motor().is_at_rest();
    }
    bool order()
    {
        if constexpr (cycle_layout<Device>::has_scanner) {
            return loop.run(1'500_rpm);
        } else {
            return loop.run(50_Hz);
        }
    }
    detail::simulated_drive<Device>& far() { return this->unit(0).drive(); }
};

} // namespace

TEST_CASE(
    "motion law: S10 a cycle stops in each way, takes the order away, and gives it back only once the motor stands")
{
    test::all_drives::for_each([]<typename Device>() {
        for (stop_by const how : {stop_by::ramp, stop_by::quick_stop, stop_by::freewheel, stop_by::halt}) {
            bool const can_halt = Device::layout.halt != 0;
            if (how == stop_by::halt and not can_halt) {
                continue;
            }
            cycling<Device> it;
            it.loop.stop(how);
            CHECK_FALSE(it.loop.control().is_ordered());
            CHECK_FALSE(it.order());
            it.pass(milliseconds(400));
            CHECK(it.far().motor().frequency() < 50'000);
            state const expected = how == stop_by::quick_stop  ? state::quick_stop_active
                                   : how == stop_by::freewheel ? state::switch_on_disabled
                                                               : state::operation_enabled;
            CHECK(it.far().state_machine().state() == expected);
            bool const was_taken = it.order();
            // A freewheel has come to its end for the drive, not for the motor, which coasts.
            CHECK(was_taken == (how == stop_by::freewheel));
            it.loop.stop(how);
            it.pass(milliseconds(12'000));
            CHECK(it.far().motor().is_at_rest());
            CHECK((it.far().state_machine().state() == state::operation_enabled) == (how == stop_by::halt));
            it.pass(milliseconds(20'000));
            CHECK(it.far().motor().is_at_rest());
            CHECK(it.order());
            it.pass(milliseconds(6'000));
            CHECK(it.far().motor().frequency() == 50'000);
        }
    });
}

TEST_CASE("motion law: S10 a halt of a drive that has none is its ramp")
{
    cycling<atv28::device> it;
    it.loop.stop(stop_by::halt);
    it.pass(milliseconds(12'000));
    CHECK(it.far().motor().is_at_rest());
    CHECK_FALSE(cia402::has_power(it.far().state_machine().state()));
}

TEST_CASE("motion law: S16 somebody else's quick stop is not cut short by a cycle, and no order ends it")
{
    test::all_drives::for_each([]<typename Device>() {
        cycling<Device> it;
        register_block<1> const quick_stop{2};
        it.far().write(Device::layout.cmd, quick_stop);
        REQUIRE(it.far().state_machine().state() == state::quick_stop_active);
        it.pass(milliseconds(400));
        CHECK_FALSE(it.loop.control().is_ordered());
        CHECK_FALSE(it.order());
        CHECK(it.comes_down_in(state::quick_stop_active, state::quick_stop_active));
        it.pass(milliseconds(5'000));
        CHECK(it.far().state_machine().state() == state::switch_on_disabled);
        CHECK(it.far().motor().is_at_rest());
        CHECK(it.order());
    });
}

TEST_CASE("motion law: S17 a cycle turns its motor round by the reference alone")
{
    test::all_drives::for_each([]<typename Device>() {
        cycling<Device> it;
        if constexpr (cycle_layout<Device>::has_scanner) {
            CHECK_FALSE(it.loop.run(-1'500_rpm, run_direction::reverse));
            CHECK(it.loop.run(900_rpm, run_direction::reverse));
        } else {
            CHECK_FALSE(it.loop.run(-50_Hz, run_direction::reverse));
            CHECK(it.loop.run(30_Hz, run_direction::reverse));
        }
        it.pass(milliseconds(10'000));
        CHECK(it.far().word("CMD") == 0x000F);
        CHECK(it.far().motor().frequency() == -30'000);
    });
}
