// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client that is made anew in its place, or becomes what a copy of it was before, knows nothing of what a conversation
// ordered before, and of the stops that came after it: such an order starts no motor.
#include "support/catch.hpp"
#include "support/simulated_bus.hpp"

#include <memory>
#include <optional>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

using device = atv320::device;
constexpr station<device> motor{unit_id{1}};
constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

enum class way {
    emplaced,
    assigned,
    copy_emplaced, ///< of what was kept before
    copy_assigned,
};

/// A client with one drive.
template <typename Link> struct plant : test::simulated_bus<Link, device> {
    using base = test::simulated_bus<Link, device>;

    std::optional<Link> kept{};

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
        } else if (how == way::assigned) {
            this->link() = Link{test::bus_timing, patient};
        } else if (how == way::copy_emplaced) {
            std::destroy_at(&this->link());
            std::construct_at(&this->link(), *kept);
        } else {
            this->link() = *kept;
        }
        this->idle(milliseconds(20));
    }
    void keep() { kept.emplace(this->link()); }
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
        it.keep();
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
        it.keep();
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
    it.keep();
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

/// A stop under way whose client becomes a copy that was made before the stop, or while it was under way: it stops.
template <typename Link> void stop_goes_on(way how, bool is_kept_before)
{
    for (unsigned visits = 1; visits < 24; ++visits) {
        INFO("visited " << visits << " times before the copy is back");
        plant<Link> it;
        start go{motor, 30_Hz};
        it.run_to_end(go);
        REQUIRE(go.running());
        it.keep();
        stop rest{motor, stop_by::ramp};
        it.run_to_end(rest, visits);
        if (rest.settled()) {
            break;
        }
        if (not is_kept_before) {
            it.keep();
        }
        it.make_anew(how);
        start other{motor, 30_Hz};
        it.step([&](instant now) { it.visit(rest, now); }, milliseconds(5));
        it.step([&](instant now) { it.visit(other, now); }, milliseconds(5));
        it.run_to_end(rest);
        CHECK(rest.succeeded());
        CHECK_FALSE(it.turns());
        CHECK_FALSE(turns_with(it, other));
        CHECK_FALSE(turns_with(it, go));
    }
}

/// A copy that was made while the motor ran knows that nobody holds it: reads alone do not keep it running.
template <typename Link> void reads_keep_no_motor_running(way how)
{
    plant<Link> it;
    start go{motor, 30_Hz};
    it.run_to_end(go);
    it.keep();
    it.make_anew(how);
    REQUIRE(it.turns());
    for (unsigned i = 0; i < 1'000 and it.turns(); ++i) {
        auto look = read<atv320::eta>(motor);
        it.run_to_end(look, 40);
        it.idle(milliseconds(50));
    }
    CHECK_FALSE(it.turns());
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

TEST_CASE("defect: A4 an order older than a stop starts no motor through a client that became a copy of before")
{
    for (way const how : {way::copy_emplaced, way::copy_assigned}) {
        no_old_start_runs<drive_client<1>>(how);
        no_old_start_runs<bus<1>>(how);
        no_old_cycle_runs<drive_client<1>>(how);
        no_old_cycle_runs<bus<1>>(how);
    }
}

TEST_CASE("defect: A4 an order to a client that became a copy since is not in force")
{
    for (way const how : {way::copy_emplaced, way::copy_assigned}) {
        old_order_is_not_in_force<drive_client<1>>(how);
        old_order_is_not_in_force<bus<1>>(how);
    }
}

TEST_CASE("defect: A4 a stop under way whose client becomes a copy of before goes on stopping")
{
    for (way const how : {way::copy_emplaced, way::copy_assigned}) {
        for (bool const is_kept_before : {false, true}) {
            stop_goes_on<drive_client<1>>(how, is_kept_before);
            stop_goes_on<bus<1>>(how, is_kept_before);
        }
    }
}

TEST_CASE("defect: A4 reads through a copy keep no motor running")
{
    for (way const how : {way::copy_emplaced, way::copy_assigned}) {
        reads_keep_no_motor_running<drive_client<1>>(how);
        reads_keep_no_motor_running<bus<1>>(how);
    }
}
