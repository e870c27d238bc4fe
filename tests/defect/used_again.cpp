// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A finished stop or start that is used again: it acts again, or says that it did not.
#include "support/catch.hpp"
#include "support/drive_port.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/client/blocking.hpp>
#include <rtuwire/sim/bench.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

template <typename Device> inline constexpr station<Device> drive{unit_id{3}};
constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

template <typename Device> struct plant : test::simulated_bus<drive_client<2>, Device> {
    plant() : test::simulated_bus<drive_client<2>, Device>{drive_client<2>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
    }
    bool has_power() { return cia402::has_power(this->drive().state_machine().state()); }
};

} // namespace

TEST_CASE("defect: D18 one stop of a blocking client stops the motor each time that it is run")
{
    test::all_drives::for_each([]<typename Device>() {
        test::drive_port<Device> port;
        blocking_client line{port, port.timing, patient};
        stop rest{drive<Device>};
        for (unsigned use = 0; use < 3; ++use) {
            start go{drive<Device>, 30_Hz};
            REQUIRE(line.run(go).kind == outcome_kind::succeeded);
            REQUIRE(port.has_power());
            port.sent.clear();
            CHECK(line.run(rest).kind == outcome_kind::succeeded);
            CHECK_FALSE(port.has_power());
            CHECK_FALSE(port.sent.empty());
            CHECK(rest.succeeded());
        }
    });
}

TEST_CASE("defect: D18 one stop of a bench stops the motor each time that it is run")
{
    test::all_drives::for_each([]<typename Device>() {
        sim::bench bench{test::bus_timing, drive<Device>};
        stop rest{drive<Device>};
        for (unsigned use = 0; use < 3; ++use) {
            start go{drive<Device>, 30_Hz};
            REQUIRE(bench.run(go).kind == outcome_kind::succeeded);
            REQUIRE(cia402::has_power(bench.drive().state_machine().state()));
            CHECK(bench.run(rest).kind == outcome_kind::succeeded);
            CHECK_FALSE(cia402::has_power(bench.drive().state_machine().state()));
        }
    });
}

TEST_CASE("defect: D18 a loop that visits one stop is told that it is used already, until that begins anew")
{
    test::all_drives::for_each([]<typename Device>() {
        plant<Device> it;
        stop rest{drive<Device>};
        start first{drive<Device>, 30_Hz};
        REQUIRE(it.run(first));
        REQUIRE(it.run(rest));
        REQUIRE(rest.succeeded());
        start second{drive<Device>, 30_Hz};
        REQUIRE(it.run(second));
        REQUIRE(it.has_power());
        std::size_t const before = it.requests();
        for (unsigned pass = 0; pass < 10; ++pass) {
            it.step([&](instant now) { it.link().converse(rest, now); }, milliseconds(50));
            CHECK(rest.settled());
            CHECK_FALSE(rest.succeeded());
            CHECK(rest.reason().kind == outcome_kind::used_already);
        }
        CHECK(it.requests() == before);
        CHECK(it.link().motor_orders().is_ordered(3)); // the visits took no order back
        CHECK(second.running());
        rest.again();
        CHECK_FALSE(rest.settled());
        REQUIRE(it.run(rest));
        CHECK(rest.succeeded());
        CHECK_FALSE(it.has_power());
    });
}

TEST_CASE("defect: D18 a start that ended and is visited in each pass never starts its motor again")
{
    test::all_drives::for_each([]<typename Device>() {
        plant<Device> it;
        start go{drive<Device>, 30_Hz};
        stop rest{drive<Device>};
        auto const loop = [&](instant now) {
            it.link().converse(go, now);
            it.link().converse(rest, now);
        };
        REQUIRE(it.run(go));
        rest.again(); // one that was not used yet
        bool has_ended = false;
        it.run(
            loop, [&] { return has_ended = has_ended or rest.succeeded(); }, milliseconds(30'000));
        REQUIRE(has_ended);
        for (unsigned pass = 0; pass < 200; ++pass) {
            it.step(loop, milliseconds(20));
            CHECK_FALSE(it.has_power());
        }
        CHECK(go.reason().kind == outcome_kind::used_already);
        go.again();
        REQUIRE(it.run(go));
        CHECK(go.succeeded());
        CHECK(it.has_power());
    });
}

TEST_CASE("defect: D19 a start runs no longer once the same client has stopped its unit, with and without a visit")
{
    test::all_drives::for_each([]<typename Device>() {
        test::drive_port<Device> port;
        blocking_client line{port, port.timing, patient};
        start go{drive<Device>, 30_Hz};
        REQUIRE(line.run(go).kind == outcome_kind::succeeded);
        CHECK(go.running());
        stop rest{drive<Device>};
        REQUIRE(line.run(rest).kind == outcome_kind::succeeded);
        CHECK_FALSE(go.running());
        REQUIRE(line.run(go).kind == outcome_kind::succeeded);
        CHECK(go.running());
        CHECK(port.has_power());
        broadcast_stop all{drive<Device>};
        REQUIRE(line.run(all));
        CHECK_FALSE(go.running());
        CHECK_FALSE(port.has_power());
    });
}

TEST_CASE("defect: D19 a start runs on while it is visited, and no longer once its order is stopped or replaced")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const is_visited : {true, false}) {
            INFO(is_visited);
            plant<Device> it;
            start go{drive<Device>, 30_Hz};
            REQUIRE(it.run(go));
            for (unsigned pass = 0; pass < 5; ++pass) {
                it.step([&](instant now) { it.link().converse(go, now); }, milliseconds(20));
                CHECK(go.running());
                CHECK_FALSE(go.succeeded());
            }
            start other{drive<Device>, 20_Hz};
            auto const loop = [&](auto& conversation) {
                return [&](instant now) {
                    if (is_visited) {
                        it.link().converse(go, now);
                    }
                    it.link().converse(conversation, now);
                };
            };
            REQUIRE(it.run(
                loop(other), [&] { return other.settled(); }, milliseconds(10'000)));
            CHECK(other.running());
            CHECK_FALSE(go.running()); // not as it ordered
            stop rest{drive<Device>};
            REQUIRE(it.run(
                loop(rest), [&] { return rest.settled(); }, milliseconds(30'000)));
            CHECK_FALSE(other.running());
        }
    });
}

TEST_CASE("defect: D19 a start runs no longer where its unit was lost, or read in fault or without power")
{
    enum class fate : std::uint8_t { lost, fault, power_cycle };
    test::all_drives::for_each([]<typename Device>() {
        for (fate const what : {fate::lost, fate::fault, fate::power_cycle}) {
            INFO(static_cast<int>(what));
            plant<Device> it;
            start go{drive<Device>, 30_Hz};
            REQUIRE(it.run(go));
            REQUIRE(go.running());
            switch (what) {
            case fate::lost: it.cut(0, true); break;
            case fate::fault: it.drive().inject_fault(9); break;
            case fate::power_cycle: it.drive().power_cycle(it.now()); break;
            }
            CHECK(go.running()); // nobody has looked yet
            check_supervision look{drive<Device>};
            REQUIRE(it.run(look));
            CHECK_FALSE(go.running());
        }
    });
}
