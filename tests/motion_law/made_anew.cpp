// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client that is made anew in its place knows nothing of what a conversation ordered before, and of the stops that came
// after it: such an order starts no motor.
#include "support/catch.hpp"
#include "support/simulated_bus.hpp"

#include <memory>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

using device = atv320::device;
constexpr station<device> motor{unit_id{1}};
constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

enum class way { emplaced, assigned };

/// A client with one drive.
template <typename Link> struct plant : test::simulated_bus<Link, device> {
    using base = test::simulated_bus<Link, device>;

    plant() : base{Link{test::bus_timing, patient}}
    {
        this->add(motor.unit());
        this->idle(milliseconds(20));
    }
    /// Nothing is under way any more.
    void make_anew(way how)
    {
        this->idle(milliseconds(1'000));
        if (how == way::emplaced) {
            std::destroy_at(&this->link());
            std::construct_at(&this->link(), test::bus_timing, patient);
        } else {
            this->link() = Link{test::bus_timing, patient};
        }
        this->idle(milliseconds(20));
    }
    template <typename Conversation> void visit(Conversation& conversation, instant now)
    {
        if constexpr (requires { this->link().converse(0, conversation, now); }) {
            this->link().converse(0, conversation, now);
        } else {
            this->link().converse(conversation, now);
        }
    }
    /// Runs a conversation to its end, or for so many passes.
    template <typename Conversation> void run_to_end(Conversation& conversation, unsigned passes = 4'000)
    {
        for (; passes > 0 and not conversation.settled(); --passes) {
            this->step([&](instant now) { visit(conversation, now); }, milliseconds(5));
        }
    }
    bool turns() { return this->drive().motor().frequency() != 0; }
};

/// Whether the motor turns at any time while this conversation goes on.
template <typename Link, typename Conversation> bool turns_with(plant<Link>& it, Conversation& conversation)
{
    bool has_turned = false;
    for (unsigned i = 0; i < 1'000; ++i) {
        it.step([&](instant now) { it.visit(conversation, now); }, milliseconds(5));
        has_turned = has_turned or it.turns();
    }
    return has_turned;
}

/// A start visited so often, then a stop; its client is made anew, and the start goes on.
template <typename Link> void no_old_start_runs(way how)
{
    for (unsigned visits = 1; visits < 24; ++visits) {
        INFO("visited " << visits << " times before the stop");
        plant<Link> it;
        start go{motor, 30_Hz};
        it.run_to_end(go, visits);
        if (go.settled()) {
            break;
        }
        stop rest{motor};
        it.run_to_end(rest);
        REQUIRE(rest.succeeded());
        REQUIRE_FALSE(it.turns());
        it.make_anew(how);
        CHECK_FALSE(turns_with(it, go));
        CHECK(go.settled());
        CHECK_FALSE(go.succeeded());
    }
}

/// The same of a cycle whose order its client has not seen when the unit is stopped, or has.
template <typename Link> void no_old_cycle_runs(way how)
{
    for (bool const was_seen : {false, true}) {
        INFO((was_seen ? "ordered before its last visit" : "ordered after its last visit"));
        plant<Link> it;
        cyclic cycle{motor};
        auto const pass = [&](unsigned count) {
            for (unsigned i = 0; i < count; ++i) {
                it.step([&](instant now) { it.visit(cycle, now); }, milliseconds(5));
            }
        };
        pass(400);
        cycle.run(900_rpm);
        pass(was_seen ? 1 : 0);
        stop rest{motor};
        it.run_to_end(rest);
        REQUIRE(rest.succeeded());
        it.make_anew(how);
        CHECK_FALSE(turns_with(it, cycle));
        cycle.run(900_rpm);
        CHECK(turns_with(it, cycle));
    }
}

template <typename Link> void old_order_is_not_in_force(way how)
{
    plant<Link> it;
    start before{motor, 30_Hz};
    it.run_to_end(before);
    REQUIRE(before.running());
    it.make_anew(how);
    CHECK_FALSE(before.running());
    start anew{motor, 20_Hz};
    it.run_to_end(anew);
    CHECK(anew.running());
    CHECK_FALSE(before.running());
    stop rest{motor};
    it.run_to_end(rest);
    CHECK(rest.succeeded());
    CHECK_FALSE(anew.running());
}

} // namespace

TEST_CASE("motion law: L1 an order older than a stop starts no motor through a client made anew in its place")
{
    no_old_start_runs<drive_client<1>>(way::emplaced);
    no_old_start_runs<bus<1>>(way::emplaced);
    no_old_cycle_runs<drive_client<1>>(way::emplaced);
    no_old_cycle_runs<bus<1>>(way::emplaced);
}

TEST_CASE("motion law: L1 an order older than a stop starts no motor through a client that was assigned")
{
    no_old_start_runs<drive_client<1>>(way::assigned);
    no_old_start_runs<bus<1>>(way::assigned);
    no_old_cycle_runs<drive_client<1>>(way::assigned);
    no_old_cycle_runs<bus<1>>(way::assigned);
}

TEST_CASE("motion law: L1 an order to a client that was made anew since is not in force")
{
    old_order_is_not_in_force<drive_client<1>>(way::emplaced);
    old_order_is_not_in_force<drive_client<1>>(way::assigned);
    old_order_is_not_in_force<bus<1>>(way::emplaced);
    old_order_is_not_in_force<bus<1>>(way::assigned);
}
