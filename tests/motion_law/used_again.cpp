// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An ended order or stop never repeats its old "done": it begins anew, and acts, or it does nothing and says so.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <memory>

#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

/// A drive that is commanded from a client or from a slot of a bus.
template <typename Link, typename Device> struct plant : test::simulated_bus<Link, Device> {
    static constexpr station<Device> drive{unit_id{3}};

    plant() : test::simulated_bus<Link, Device>{Link{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
    }
    template <typename Conversation> void visit(Conversation& conversation, instant now)
    {
        if constexpr (requires { this->link().converse(conversation, now); }) {
            this->link().converse(conversation, now);
        } else {
            this->link().converse(0, conversation, now);
        }
    }
    template <typename Conversation> void run_anew(Conversation& conversation)
    {
        conversation.again();
        this->run([&](instant now) { visit(conversation, now); }, [&] { return conversation.settled(); },
                  milliseconds(60'000));
        REQUIRE(conversation.settled());
    }
    bool has_power() { return cia402::has_power(this->drive_of().state_machine().state()); }
    auto& drive_of() { return this->unit(0).drive(); }
};

template <typename F> void everywhere(F const& visit)
{
    test::all_drives::for_each([&]<typename Device>() {
        visit.template operator()<drive_client<2>, Device>();
        visit.template operator()<bus<2>, Device>();
    });
}

} // namespace

TEST_CASE("motion law: S39 one stop object stops the motor again and again, each way of stopping")
{
    everywhere([]<typename Link, typename Device>() {
        for (stop_by const how : {stop_by::ramp, stop_by::freewheel, stop_by::quick_stop, stop_by::halt}) {
            if (how == stop_by::halt and Device::layout.halt == 0) {
                continue;
            }
            INFO(static_cast<int>(how));
            plant<Link, Device> it;
            stop rest{it.drive, how};
            for (unsigned use = 0; use < 3; ++use) {
                start go{it.drive, 30_Hz};
                it.run_anew(go);
                REQUIRE(go.succeeded());
                it.idle(milliseconds(6'000));
                REQUIRE(it.drive_of().motor().frequency() == 30'000);
                std::size_t const before = it.requests();
                for (unsigned pass = 0; pass < 20 and use != 0; ++pass) {
                    it.step([&](instant now) { it.visit(rest, now); }, milliseconds(10));
                    CHECK(rest.reason().kind == outcome_kind::used_already);
                }
                CHECK(it.requests() == before);
                CHECK(go.running());
                it.run_anew(rest);
                CHECK(rest.succeeded());
                CHECK(it.drive_of().motor().frequency() == 0);
                CHECK_FALSE(go.running());
            }
        }
    });
}

TEST_CASE("motion law: S40 one start object behind a stop says that it runs only where it has started again")
{
    everywhere([]<typename Link, typename Device>() {
        plant<Link, Device> it;
        start go{it.drive, 30_Hz};
        std::size_t asked = 0;
        for (unsigned use = 0; use < 3; ++use) {
            std::size_t const before = it.requests();
            it.run_anew(go);
            asked = use == 0 ? it.requests() - before : asked;
            CHECK(it.requests() - before == asked); // the check with it
            CHECK(go.succeeded());
            CHECK(go.running());
            CHECK(it.has_power());
            stop rest{it.drive};
            it.run_anew(rest);
            REQUIRE(rest.succeeded());
            CHECK_FALSE(go.running());
            for (unsigned pass = 0; pass < 100; ++pass) {
                it.step([&](instant now) { it.visit(go, now); }, milliseconds(20));
                CHECK_FALSE(go.running());
                CHECK_FALSE(go.succeeded());
                CHECK(go.settled());
                CHECK_FALSE(it.has_power());
            }
        }
    });
}

TEST_CASE("motion law: S40 a start of 0 that was begun anew keeps no direction from the first time")
{
    everywhere([]<typename Link, typename Device>() {
        plant<Link, Device> it;
        std::uint16_t told = 0x1234;
        it.disturb([&](test::frame_bytes& frame, bool is_request) {
            byte_view const bytes{frame};
            if (is_request and bytes[1] == std::byte{6} and u16_at(bytes, 2) == Device::frequency_reference.address) {
                told = u16_at(bytes, 4);
            }
        });
        start back{it.drive, -30_Hz}, slow{it.drive, 0_Hz};
        stop rest{it.drive};
        it.run_anew(back);
        REQUIRE(back.running());
        it.idle(milliseconds(3'000));
        it.run_anew(slow);
        CHECK(told == 0xFFFF); // it kept to the reverse
        it.run_anew(rest);
        REQUIRE(rest.succeeded());
        it.run_anew(slow);
        CHECK(told == 0);
    });
}

TEST_CASE("motion law: L2 a start that was begun anew before a stop, and comes by behind it, moves nothing")
{
    everywhere([]<typename Link, typename Device>() {
        for (bool const is_for_all : {false, true}) {
            for (bool const is_behind : {false, true}) {
                INFO("a stop of " << (is_for_all ? "all" : "one") << ", begun anew "
                                  << (is_behind ? "behind" : "before") << " it");
                plant<Link, Device> it;
                start go{it.drive, 30_Hz};
                it.run_anew(go);
                REQUIRE(go.succeeded());
                if (not is_behind) {
                    go.again(); // its user stays away
                }
                if (is_for_all) {
                    broadcast_stop all{it.drive};
                    it.run(
                        [&](instant now) {
                            if constexpr (requires { it.link().run_urgent(all, now); }) {
                                it.link().run_urgent(all, now);
                            } else {
                                it.link().converse(all, now);
                            }
                        },
                        [&] { return all.settled(); }, milliseconds(60'000));
                } else {
                    stop rest{it.drive};
                    it.run_anew(rest);
                }
                REQUIRE_FALSE(it.has_power());
                if (is_behind) {
                    go.again();
                }
                for (unsigned i = 0; i < 200; ++i) {
                    it.step(
                        [&](instant now) {
                            if (not go.settled()) {
                                it.visit(go, now);
                            }
                        },
                        milliseconds(10));
                }
                CHECK(it.has_power() == is_behind);
                CHECK(go.reason().kind == (is_behind ? outcome_kind::succeeded : outcome_kind::overruled));
                if (not is_behind) { // and it takes the next order
                    it.run_anew(go);
                    CHECK(go.running());
                }
            }
        }
    });
}

TEST_CASE("motion law: L2 a start that was begun anew more than once before a stop moves nothing behind it")
{
    everywhere([]<typename Link, typename Device>() {
        for (unsigned times = 1; times <= 3; ++times) {
            INFO("begun anew " << times << " times");
            plant<Link, Device> it;
            start go{it.drive, 30_Hz};
            it.run_anew(go);
            REQUIRE(go.succeeded());
            for (unsigned i = 0; i < times; ++i) {
                go.again(); // its user stays away
            }
            stop rest{it.drive};
            it.run_anew(rest);
            REQUIRE_FALSE(it.has_power());
            it.run([&](instant now) { it.visit(go, now); }, [&] { return go.settled(); }, milliseconds(5'000));
            CHECK(go.reason().kind == outcome_kind::overruled);
            CHECK_FALSE(it.has_power());
        }
    });
}

TEST_CASE("motion law: L2 a start that a blocking client runs again asks nothing of the client that it outlived")
{
    test::all_drives::for_each([]<typename Device>() {
        using hall = plant<drive_client<2>, Device>;
        start go{hall::drive, 30_Hz};
        for (unsigned use = 0; use < 3; ++use) {
            auto const it = std::make_unique<hall>(); // another place each time
            REQUIRE(can_run(go));
            it->run([&](instant now) { it->visit(go, now); }, [&] { return go.settled(); }, milliseconds(60'000));
            CHECK(go.running());
        }
    });
}
