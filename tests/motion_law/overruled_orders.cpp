// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An order that a later stop of the same client brings down ends as overruled, at whatever moment the stop comes and
// whatever its own reads would have found.
#include "support/catch.hpp"
#include "support/commissioned.hpp"
#include "support/drives.hpp"
#include "support/one_in.hpp"
#include "support/remembered.hpp"
#include "support/simulated_bus.hpp"

#include <string>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

/// A client and one drive at address 7.
template <typename Device> struct pair : test::simulated_bus<drive_client<4>, Device> {
    using base = test::simulated_bus<drive_client<4>, Device>;
    static constexpr station<Device> drive{unit_id{7}};

    pair() : base{drive_client<4>{test::bus_timing, patient}}
    {
        this->add(unit_id{7});
        this->idle(milliseconds(20));
    }

    /// How an order ends where a stop begins this long after it; `pending` where the order had ended before, or ends by a
    /// response that was on its way when the stop began: the drive then still holds the command to run.
    template <typename Order, typename Stop> outcome_kind end_of(Order& order, Stop& halt, duration later)
    {
        instant const at = this->now() + later;
        bool has_begun = false;
        bool is_true = false;
        for (unsigned i = 0; i < 40'000 and not(order.settled() and halt.settled()); ++i) {
            if (not has_begun and reached(this->now(), at)) {
                if (order.settled()) {
                    return outcome_kind::pending;
                }
                has_begun = true;
            }
            this->step(
                [&](instant now) {
                    this->link().converse(order, now);
                    if (has_begun) {
                        this->link().converse(halt, now);
                    }
                },
                milliseconds(1));
            is_true = is_true or (order.settled() and commands_to_run());
        }
        CHECK(has_begun);
        CHECK(order.settled());
        CHECK(halt.settled());
        outcome_kind const kind = order.reason().kind;
        return kind == outcome_kind::succeeded and is_true ? outcome_kind::pending : kind;
    }

    bool commands_to_run()
    {
        std::uint16_t const word = base::drive(0).word("CMD");
        return word == 0x000F or word == 0x800A;
    }
};

/// Every moment of an order, in steps of 3 ms.
template <typename Device, typename Order, typename Prepare>
void stop_at_every_moment(Order const& order, Prepare prepare, unsigned steps)
{
    unsigned overruled = 0;
    for (unsigned i = 1; i < steps; ++i) {
        pair<Device> it;
        prepare(it);
        test::remembered<Order> told{order};
        stop halt{it.drive};
        outcome_kind const kind = it.end_of(told, halt, milliseconds(3 * i));
        if (kind == outcome_kind::pending) {
            break;
        }
        INFO(3 * i << " ms, " << std::string(name_of(kind).begin(), name_of(kind).end()));
        CHECK(kind == outcome_kind::overruled);
        ++overruled;
    }
    CHECK(overruled > 10);
}

constexpr auto nothing_before = [](auto&) {};
constexpr auto runs_before = []<typename Device>(pair<Device>& it) {
    start go{it.drive, 20_Hz};
    REQUIRE(it.run(go));
    REQUIRE(go.running());
};

} // namespace

TEST_CASE("motion law: L2 a start that a later stop brings down ends as overruled")
{
    test::all_drives::for_each([]<typename Device>() {
        start const order{pair<Device>::drive, 50_Hz, run_direction::forward, milliseconds(3'000),
                          test::commissioned()};
        stop_at_every_moment<Device>(order, nothing_before, 200);
    });
    atv28::direct_start const order{pair<atv28::device>::drive, 50_Hz};
    stop_at_every_moment<atv28::device>(order, nothing_before, 200);
}

TEST_CASE("motion law: L2 a change of the reference that a later stop brings down ends as overruled")
{
    test::all_drives::for_each([]<typename Device>() {
        change_reference const order{pair<Device>::drive, 50_Hz};
        stop_at_every_moment<Device>(order, runs_before, 60);
    });
}

TEST_CASE("motion law: L2 an order that a stop of all brings down ends as overruled")
{
    for (unsigned i = 5; i < 150; i += 5) {
        pair<atv320::device> it;
        runs_before(it);
        test::remembered<change_reference> order{it.drive, 50_Hz};
        broadcast_stop all{it.drive};
        instant const at = it.now() + milliseconds(i);
        while (not(order.settled() and all.settled())) {
            it.step(
                [&](instant now) {
                    if (reached(now, at)) {
                        it.link().converse(all, now);
                    }
                    it.link().converse(order, now);
                },
                milliseconds(1));
        }
        INFO(i << " ms");
        CHECK(order.reason().kind == outcome_kind::overruled);
    }
}

TEST_CASE("motion law: L2 a cycle whose drive another conversation stops says that it was overruled")
{
    test::all_drives::for_each([]<typename Device>() {
        for (unsigned i = 0; i < 40; i += test::one_in(7)) {
            pair<Device> it;
            cyclic loop{it.drive, {.period = milliseconds(100)}};
            stop halt{it.drive};
            bool has_begun = false;
            auto const pass = [&](duration length) {
                instant const end = it.now() + length;
                while (not reached(it.now(), end)) {
                    it.step(
                        [&](instant now) {
                            it.link().converse(loop, now);
                            if (has_begun) {
                                it.link().converse(halt, now);
                            }
                        },
                        milliseconds(3));
                }
            };
            pass(milliseconds(1'000));
            if constexpr (Device::scanner.words == 0) {
                REQUIRE(loop.run(50_Hz));
            } else {
                REQUIRE(loop.run(1'500_rpm));
            }
            pass(milliseconds(500 + 10 * i));
            REQUIRE(loop.control().is_ordered());
            has_begun = true;
            pass(milliseconds(4'000));
            REQUIRE(halt.settled());
            INFO(i);
            CHECK_FALSE(loop.control().is_ordered());
            outcome_kind const kind = loop.control().reason().kind;
            INFO(std::string(name_of(kind).begin(), name_of(kind).end()));
            INFO(static_cast<int>(loop.control().reason().error));
            CHECK(kind == outcome_kind::overruled);
            // An order after the stop is another one.
            if constexpr (Device::scanner.words == 0) {
                REQUIRE(loop.run(50_Hz));
            } else {
                REQUIRE(loop.run(1'500_rpm));
            }
            pass(milliseconds(1'000));
            CHECK(loop.control().is_running());
        }
    });
}
