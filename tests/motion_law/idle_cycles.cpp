// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A cycle without an order: beside another conversation that brings its drive up, and beside another master.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <algorithm>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

/// Whether a request writes several words, as only a cycle does here.
bool is_exchange(byte_view request) { return request[1] == std::byte{16} or request[1] == std::byte{23}; }

} // namespace

TEST_CASE("motion law: a cycle without an order writes nothing to a drive that a start of its client brings up")
{
    test::all_drives::for_each([]<typename Device>() {
        test::plant<Device> it;
        cyclic<Device> loop{it.drive};
        start go{it.drive, 30_Hz};
        auto const cycle = [&](instant now) { it.link().converse(loop, now); };
        it.run(
            cycle, [] { return false; }, milliseconds(1'000));
        REQUIRE_FALSE(loop.link_lost());
        unsigned writes = 0;
        bool has_run = false; // the cycle stops it then, before its start is done or behind that
        it.disturb([&](test::frame_bytes& frame, bool is_request) {
            writes += is_request and is_exchange(frame) ? 1U : 0U;
            has_run = has_run or it.far().state_machine().state() == cia402::state::operation_enabled;
        });
        REQUIRE(it.run(
            [&](instant now) {
                cycle(now);
                it.link().converse(go, now);
            },
            [&] { return go.settled(); }, milliseconds(5'000)));
        CHECK(has_run);
        CHECK(writes == 0);
    });
}

TEST_CASE("motion law: a cycle without an order turns no direct start's motor the other way")
{
    // Every moment of the cycle at which the start may begin; the motor turns at LSP forward for a reference of 0.
    for (unsigned after_ms = 0; after_ms < 200; after_ms += 3) {
        INFO("after " << after_ms << " ms");
        test::plant<atv28::device> it;
        it.tell(atv28::lsp.address, 100);
        cyclic<atv28::device> loop{it.drive};
        atv28::direct_start go{it.drive, -20_Hz};
        auto const cycle = [&](instant now) { it.link().converse(loop, now); };
        it.run(
            cycle, [] { return false; }, milliseconds(1'000 + after_ms));
        std::int32_t most = 0;
        for (unsigned i = 0; i < 300; ++i) {
            it.run(
                [&](instant now) {
                    cycle(now);
                    if (not go.settled()) {
                        it.link().converse(go, now);
                    }
                },
                [] { return false; }, milliseconds(10));
            most = std::max(most, it.millihertz());
        }
        CHECK(most <= 0);
        CHECK(go.settled());
    }
}

TEST_CASE(
    "motion law: L2 a cycle beside one without an order runs its motor once for one order, whatever their periods")
{
    test::all_drives::for_each([]<typename Device>() {
        for (unsigned const period_ms : {50U, 100U, 130U, 200U}) {
            for (unsigned const other_ms : {50U, 100U, 200U}) {
                INFO("periods of " << period_ms << " and " << other_ms << " ms");
                test::plant<Device> it;
                cyclic<Device> loop{it.drive, {.period = milliseconds(period_ms)}};
                cyclic<Device> idle{it.drive, {.period = milliseconds(other_ms)}};
                auto const both = [&](instant now) {
                    it.link().converse(loop, now);
                    it.link().converse(idle, now);
                };
                it.run(
                    both, [] { return false; }, milliseconds(3'000));
                using at = setting<cycle_layout<Device>::reference>;
                REQUIRE(loop.run(*at::checked(typename at::value_type{300})));
                unsigned times = 0;
                bool had_power = false;
                for (unsigned i = 0; i < 1'000; ++i) {
                    it.run(
                        both, [] { return false; }, milliseconds(10));
                    bool const has_power = cia402::has_power(it.far().state_machine().state());
                    times += has_power and not had_power ? 1U : 0U;
                    had_power = has_power;
                }
                CHECK(times <= 1);
                CHECK_FALSE(had_power);
                CHECK_FALSE(loop.control().is_ordered());
            }
        }
    });
}

TEST_CASE("motion law: L7 a cycle without an order stops another master's motor, and does not cut that one's quick "
          "stop short")
{
    test::all_drives::for_each([]<typename Device>() {
        for (unsigned visited_ms = 0; visited_ms < 700; visited_ms += 50) {
            INFO("visited for " << visited_ms << " ms");
            test::plant<Device> it;
            it.tell(static_cast<std::uint16_t>(Device::layout.direct_control != 0 ? 253 : 9'002), 600); // DEC
            it.turn(30, false);
            cyclic<Device> loop{it.drive};
            auto const cycle = [&](instant now) { it.link().converse(loop, now); };
            it.run(
                cycle, [] { return false; }, milliseconds(visited_ms));
            register_block<1> const quick_stop{2};
            it.far().write(Device::layout.cmd, quick_stop);
            REQUIRE(it.far().state_machine().state() == cia402::state::quick_stop_active);
            it.idle(milliseconds(5'000)); // nobody visits it
            for (unsigned i = 0; i < 700 and it.millihertz() != 0; ++i) {
                it.run(
                    cycle, [] { return false; }, milliseconds(10));
                bool const goes_on = it.far().state_machine().state() == cia402::state::quick_stop_active;
                REQUIRE((goes_on or it.millihertz() == 0));
            }
            CHECK(it.millihertz() == 0);
        }
        test::plant<Device> other;
        other.turn(30, false);
        cyclic<Device> loop{other.drive};
        other.run([&](instant now) { other.link().converse(loop, now); }, [] { return false; }, milliseconds(12'000));
        CHECK(other.millihertz() == 0);
        CHECK_FALSE(cia402::has_power(other.far().state_machine().state()));
    });
}
