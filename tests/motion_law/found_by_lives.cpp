// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What random lives found, each reduced to the few frames that it takes.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/remembered.hpp"
#include "support/simulated_bus.hpp"

#include <optional>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_freewheel.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

template <typename Device, typename Link = drive_client<2>> struct hall : test::simulated_bus<Link, Device> {
    station<Device> motor{*station<Device>::checked(3)};
    station<Device> other{*station<Device>::checked(4)};

    hall() : test::simulated_bus<Link, Device>{Link{test::bus_timing, patient}}
    {
        this->add(motor.unit());
        this->add(other.unit());
        this->idle(milliseconds(20));
    }

    template <typename Work> void pass(Work work, duration length)
    {
        instant const end = this->now() + length;
        while (not reached(this->now(), end)) {
            this->step(work, end - this->now());
        }
    }

    /// Passes until a request of this function and word at the control word has left; whether it has.
    template <typename Work> bool pass_until_told(Work work, std::uint16_t word, duration most)
    {
        instant const end = this->now() + most;
        std::size_t const before = this->requests();
        while (not reached(this->now(), end)) {
            this->step(work, milliseconds(5));
            if (this->requests() != before and is_told(word)) {
                return true;
            }
        }
        return false;
    }

    /// Whether the last request wrote this control word, in whatever way.
    bool is_told(std::uint16_t word)
    {
        byte_view const frame = this->request();
        if (frame.empty()) {
            return false;
        }
        switch (to_u8(frame[1])) {
        case 6: return u16_at(frame, 2) == Device::layout.cmd and u16_at(frame, 4) == word;
        case 16: return u16_at(frame, 7) == word;
        case 23: return u16_at(frame, 11) == word;
        default: return false;
        }
    }
    /// A cycle is asked to run its motor, and does.
    template <typename Loop> void run_up(Loop& loop)
    {
        auto const cycle = [&](instant at) { this->link().converse(loop, at); };
        pass(cycle, milliseconds(500));
        REQUIRE(loop.run(1'200_rpm));
        pass(cycle, milliseconds(4'000));
        REQUIRE(has_power());
    }

    state drive_state() { return this->drive(0).state_machine().state(); }
    bool has_power() { return cia402::has_power(drive_state()); }
};

} // namespace

TEST_CASE("motion law: two stops at once are not blocked by an answer that nobody comes for")
{
    using device = atv320::device;
    hall<device> it;
    start go{it.motor, 40_Hz};
    REQUIRE(it.run(go));
    std::optional<single_request<read_holding_registers>> poll;
    poll.emplace(it.motor.unit(), read_holding_registers{3'201, 1});
    it.pass([&](instant at) { it.link().converse(*poll, at); }, milliseconds(5));
    poll.reset(); // its response comes, and it does not
    it.pass([](instant) {}, milliseconds(50));
    test::remembered<stop> first{it.motor};
    test::remembered<stop> second{it.other};
    auto const work = [&](instant at) {
        it.link().converse(first, at);
        it.link().converse(second, at);
    };
    CHECK(it.pass_until_told(work, 0x0000, milliseconds(500)));
    it.pass(work, milliseconds(2'000));
    CHECK(first.succeeded());
    CHECK(second.succeeded());
    CHECK_FALSE(it.has_power());
}

TEST_CASE("motion law: a stop of everyone, or of the drive, takes a direct start's order away")
{
    using device = atv28::device;
    for (std::uint32_t after_ms = 0; after_ms < 120; after_ms += 3) {
        for (bool const is_everyone : {false, true}) {
            INFO(after_ms << " ms, everyone " << is_everyone);
            hall<device> it;
            atv28::direct_start go{it.motor, 40_Hz};
            it.pass([&](instant at) { it.link().converse(go, at); }, milliseconds(after_ms));
            broadcast_stop all{it.motor};
            stop rest{it.motor};
            bool has_stopped = false;
            bool has_run_again = false;
            auto const work = [&](instant at) {
                if (is_everyone) {
                    it.link().converse(all, at);
                } else {
                    it.link().converse(rest, at);
                }
                it.link().converse(go, at);
                has_stopped = has_stopped or it.is_told(0x0000) or it.is_told(0x0007);
            };
            instant const end = it.now() + milliseconds(6'000);
            std::size_t const before = it.requests();
            while (not reached(it.now(), end)) {
                it.step(work, milliseconds(20));
                has_run_again = has_run_again or (it.requests() != before and it.is_told(0x800A));
            }
            CHECK_FALSE(has_run_again);
            CHECK_FALSE(it.has_power());
        }
    }
}

TEST_CASE("motion law: the STOP key pressed behind a start's first look ends it")
{
    for (bool const is_direct : {false, true}) {
        hall<atv28::device> it;
        test::remembered<start> go{it.motor, 40_Hz};
        test::remembered<atv28::direct_start> run{it.motor, 40_Hz};
        auto const work = [&](instant at) {
            if (is_direct) {
                it.link().converse(run, at);
            } else {
                it.link().converse(go, at);
            }
        };
        // The first look was answered, the first word is not there yet: the drive falls from rest to rest.
        REQUIRE(it.run(
            work, [&] { return it.answers(0) == 1; }, milliseconds(100)));
        it.drive(0).press_stop();
        it.pass(work, milliseconds(3'500));
        CHECK_FALSE(it.has_power());
        CHECK((is_direct ? run.reason().kind : go.reason().kind) == outcome_kind::stop_key);
    }
}

TEST_CASE("motion law: the STOP key that is shown from before does not keep a start from running")
{
    hall<atv28::device> it;
    it.drive(0).press_stop();
    start go{it.motor, 40_Hz};
    REQUIRE(it.run(go));
    CHECK(go.succeeded());
}

TEST_CASE("motion law: S22 a drive that lost its power behind a word that it answered is not pushed up again")
{
    using device = atv28::device; // functions 03 and 16: the response to the write tells no state
    hall<device> it;
    cyclic<device> loop{it.motor, {.period = milliseconds(100)}};
    auto const cycle = [&](instant at) { it.link().converse(loop, at); };
    it.pass(cycle, milliseconds(500));
    REQUIRE(loop.run(30_Hz));
    REQUIRE(it.run(
        cycle, [&] { return it.drive_state() == state::ready_to_switch_on; }, milliseconds(500)));
    std::size_t const answers = it.answers(0);
    REQUIRE(it.run(
        cycle, [&] { return it.answers(0) == answers + 1; }, milliseconds(50)));
    it.drive(0).power_cycle(it.now());
    it.pass(cycle, milliseconds(5'000));
    CHECK_FALSE(it.has_power());
    CHECK_FALSE(loop.control().is_ordered());
}

TEST_CASE("motion law: S22 the same of a start whose next look is lost")
{
    using device = atv320::device;
    hall<device> it;
    test::remembered<start> go{it.motor, 40_Hz};
    auto const work = [&](instant at) { it.link().converse(go, at); };
    REQUIRE(it.run(
        work, [&] { return it.drive_state() == state::ready_to_switch_on; }, milliseconds(500)));
    std::size_t const answers = it.answers(0);
    REQUIRE(it.run(
        work, [&] { return it.answers(0) != answers; }, milliseconds(100)));
    it.cut(0, true);
    it.pass(work, milliseconds(30));
    it.drive(0).power_cycle(it.now());
    it.cut(0, false);
    it.pass(work, milliseconds(4'000));
    CHECK_FALSE(it.has_power());
    CHECK(go.reason().kind == outcome_kind::state_timeout);
}

TEST_CASE("motion law: a halt that may not look becomes the ramp within a second")
{
    using device = atv320::device;
    // The drive is silent in this slot, so that the slot's next request waits for its turn to be probed.
    hall<device, bus<2>> it;
    start go{it.motor, 40_Hz};
    REQUIRE(
        it.run([&](instant at) { it.link().converse(0, go, at); }, [&] { return go.settled(); }, milliseconds(1'000)));
    bool loses = true;
    it.disturb([&](auto& frame, bool) {
        if (loses) {
            frame.clear();
        }
    });
    single_request poll{it.motor.unit(), read_holding_registers{3'201, 1}};
    REQUIRE(it.run([&](instant at) { it.link().converse(1, poll, at); }, [&] { return poll.settled(); },
                   milliseconds(1'000)));
    loses = false;
    REQUIRE(it.has_power());
    test::remembered<stop> rest{it.motor, stop_by::halt};
    auto const work = [&](instant at) { it.link().converse(1, rest, at); };
    CHECK(it.pass_until_told(work, 0x0000, milliseconds(1'100)));
    it.pass(work, milliseconds(4'000));
    CHECK(rest.succeeded());
    CHECK(rest.reason().is_other_stop);
    CHECK_FALSE(it.has_power());
}

TEST_CASE("motion law: a stop that has ended says nothing more, also where its unit's own time-out has passed")
{
    using device = atv320::device;
    for (stop_by const how : {stop_by::ramp, stop_by::quick_stop, stop_by::freewheel, stop_by::halt}) {
        hall<device> it;
        start go{it.motor, 40_Hz};
        REQUIRE(
            it.run([&](instant at) { it.link().converse(go, at); }, [&] { return go.settled(); }, milliseconds(3'000)));
        stop rest{it.motor, how};
        auto const work = [&](instant at) { it.link().converse(rest, at); };
        REQUIRE(it.run(
            work, [&] { return rest.settled(); }, milliseconds(9'000)));
        std::size_t const before = it.requests();
        it.pass(work, milliseconds(40'000));
        CHECK(it.requests() == before);
        CHECK(rest.settled());
    }
}

TEST_CASE("motion law: who commands a drive does not wait for the health of another one in its slot")
{
    using device = atv320::device;
    hall<device, bus<2>> it;
    it.cut(1, true);
    single_request poll{it.other.unit(), read_holding_registers{3'201, 1}};
    REQUIRE(it.run([&](instant at) { it.link().converse(1, poll, at); }, [&] { return poll.settled(); },
                   milliseconds(1'000)));
    REQUIRE(it.link().is_silent(1));
    stop rest{it.motor, stop_by::halt};
    std::size_t const before = it.requests();
    CHECK(it.run([&](instant at) { it.link().converse(1, rest, at); }, [&] { return it.requests() != before; },
                 milliseconds(50)));
}

TEST_CASE("motion law: a DC injection gives no power to a drive whose motor stands")
{
    using device = atv28::device;
    unsigned given_back = 0;
    for (std::uint32_t after_ms = 0; after_ms < 60; after_ms += 2) {
        INFO(after_ms << " ms");
        hall<device> it;
        start go{it.motor, 1_Hz};
        REQUIRE(it.run(go));
        it.pass([](instant) {}, milliseconds(1'000));
        auto const ramp = single_request{it.motor.unit(), write_single_register{device::layout.cmd, 0x0007}};
        auto told = ramp; // by whoever it is: not a stop that this one would take the drive from
        REQUIRE(it.run(told));
        it.pass([](instant) {}, milliseconds(after_ms));
        test::remembered<stop> brake{it.motor, stop_by::dc_injection};
        bool is_given_back = false;
        auto const work = [&](instant at) { it.link().converse(brake, at); };
        bool had_power = true;
        instant const end = it.now() + milliseconds(1'000);
        while (not reached(it.now(), end)) {
            it.step(work, milliseconds(1));
            is_given_back = is_given_back or (it.has_power() and not had_power and it.is_told(0xA00A));
            had_power = it.has_power();
        }
        given_back += is_given_back ? 1U : 0U;
        CHECK(brake.succeeded());
    }
    CHECK(given_back <= 1); // where it came to rest between the read of its frequency and the word
}

namespace {

/// Whether a motor that ran at 30 Hz has power once a stop was over at its limit, and time for a ramp.
template <typename Stop> bool keeps_power_behind(Stop stop)
{
    hall<atv28::device> it;
    start go{it.motor, 30_Hz};
    REQUIRE(it.run(go));
    it.pass([](instant) {}, milliseconds(300));
    REQUIRE(it.run(stop));
    it.pass([](instant) {}, milliseconds(4'000));
    return it.has_power();
}

} // namespace

TEST_CASE("motion law: L9 a stop whose word keeps the power leaves none behind its limit")
{
    constexpr station<atv28::device> motor{unit_id{3}};
    for (std::uint32_t limit_ms = 0; limit_ms < 400; limit_ms += 3) {
        INFO("a limit of " << limit_ms << " ms");
        duration const limit = milliseconds(limit_ms);
        CHECK_FALSE(keeps_power_behind(altivar::stop{motor, stop_by::dc_injection, limit}));
        for (auto const how :
             {atv28::direct_stop_by::ramp, atv28::direct_stop_by::dc_injection, atv28::direct_stop_by::fast_stop}) {
            CHECK_FALSE(keeps_power_behind(atv28::direct_stop{motor, how, limit}));
        }
    }
}

TEST_CASE("motion law: a cycle without an order writes no reference of an old one")
{
    using device = atv28::device;
    hall<device> it;
    cyclic<device> loop{it.motor, {.period = milliseconds(50)}};
    auto const cycle = [&](instant at) { it.link().converse(loop, at); };
    it.pass(cycle, milliseconds(500));
    REQUIRE(loop.run(40_Hz));
    it.pass(cycle, milliseconds(4'000));
    loop.stop();
    it.pass(cycle, milliseconds(6'000));
    REQUIRE_FALSE(it.has_power());
    CHECK(it.drive(0).word("LFR") == 0);
}

TEST_CASE("motion law: L3 a cycle's stop leaves before a look where the command to run was not answered, and lets the "
          "motor coast")
{
    using device = atv12::device;
    hall<device> it;
    bool loses_answers = false;
    it.disturb([&](auto& frame, bool is_request) {
        loses_answers = loses_answers or (is_request and it.is_told(0x000F));
        if (not is_request and loses_answers) {
            frame.clear();
        }
    });
    cyclic<device> loop{it.motor, {.period = milliseconds(100)}};
    auto const cycle = [&](instant at) { it.link().converse(loop, at); };
    it.pass(cycle, milliseconds(500));
    REQUIRE(loop.run(1'200_rpm));
    REQUIRE(it.run(
        cycle, [&] { return it.has_power(); }, milliseconds(1'000)));
    it.pass(cycle, milliseconds(180)); // the response is missed, the next step is a look
    loop.stop();
    std::size_t const before = it.requests();
    REQUIRE(it.run(
        cycle, [&] { return it.requests() != before; }, milliseconds(500)));
    CHECK(it.is_told(0x0000));
}

TEST_CASE(
    "motion law: L3 a cycle that is told to run while it stops somebody else's motor does not enable by a stop word")
{
    using device = atv28::device;
    hall<device> it;
    cyclic<device> loop{it.motor, {.period = milliseconds(50)}};
    start go{it.motor, 30_Hz};
    auto const cycle = [&](instant at) { it.link().converse(loop, at); };
    it.pass(cycle, milliseconds(500));
    REQUIRE(it.run(
        cycle, [&] { return to_u8(it.request()[1]) == 16; }, milliseconds(500)));
    it.pass(cycle, milliseconds(30)); // its next step is a read
    REQUIRE(it.run(go));
    // The cycle finds it running without an order of its own; its stop words get lost.
    it.disturb([&](auto& frame, bool is_request) {
        if (is_request and it.is_told(0x0007)) {
            frame.clear();
        }
    });
    REQUIRE(it.pass_until_told(cycle, 0x0007, milliseconds(500)));
    REQUIRE(loop.run(40_Hz));
    std::size_t const before = it.requests();
    REQUIRE(it.run(
        cycle, [&] { return it.requests() != before; }, milliseconds(500)));
    CHECK(to_u8(it.request()[1]) == 3); // a look
}

TEST_CASE("motion law: L3 a halt of a cycle looks first, also behind a stop word that was not answered")
{
    using device = atv320::device;
    hall<device> it;
    cyclic<device> loop{it.motor, {.period = milliseconds(50)}};
    auto const cycle = [&](instant at) { it.link().converse(loop, at); };
    it.run_up(loop);
    loop.stop();
    REQUIRE(it.pass_until_told(cycle, 0x0007, milliseconds(500)));
    it.cut(0, true); // the motor comes to rest; the cycle's words get lost meanwhile
    it.pass(cycle, milliseconds(1'000));
    loop.stop(stop_by::halt);
    std::size_t const before = it.requests();
    it.run(
        cycle, [&] { return it.requests() != before; }, milliseconds(500));
    CHECK_FALSE(it.is_told(0x010F));
}

TEST_CASE("motion law: a fault reset asked of a cycle without a fault renews no order that a stop took away")
{
    using device = atv320::device;
    hall<device> it;
    cyclic<device> loop{it.motor, {.period = milliseconds(150)}};
    auto const cycle = [&](instant at) { it.link().converse(loop, at); };
    it.pass(cycle, milliseconds(500));
    REQUIRE(loop.run(1'200_rpm));
    it.pass(cycle, milliseconds(1));
    stop rest{it.motor};
    it.run(
        [&](instant at) {
            it.link().converse(rest, at);
            cycle(at);
        },
        [&] { return rest.settled(); }, milliseconds(1'000));
    REQUIRE(rest.succeeded());
    loop.reset_fault();
    it.pass(cycle, milliseconds(3'000));
    CHECK_FALSE(it.has_power());
    CHECK_FALSE(loop.control().is_ordered());
}

TEST_CASE("motion law: L2 a fault that another conversation reset takes an older start's order away")
{
    using device = atv320::device;
    hall<device> it;
    start go{it.motor, 40_Hz};
    REQUIRE(
        it.run([&](instant at) { it.link().converse(go, at); }, [&] { return it.answers(0) == 2; }, milliseconds(200)));
    it.drive(0).inject_fault(9);
    it.drive(0).clear_cause();
    reset_fault reset{it.motor}; // the start never sees the fault
    REQUIRE(it.run(reset));
    REQUIRE(reset.succeeded());
    REQUIRE(it.run(go));
    CHECK(go.reason().kind == outcome_kind::overruled);
    CHECK_FALSE(it.has_power());
    start again{it.motor, 40_Hz};
    REQUIRE(it.run(again));
    CHECK(again.running());
}

TEST_CASE("motion law: L2 of two orders to run a drive the later one counts")
{
    using device = atv12::device;
    hall<device> it;
    test::remembered<start> first{it.motor, 40_Hz};
    it.pass([&](instant at) { it.link().converse(first, at); }, milliseconds(60));
    REQUIRE_FALSE(first.settled());
    start second{it.motor, 10_Hz};
    REQUIRE(it.run(
        [&](instant at) {
            it.link().converse(first, at);
            it.link().converse(second, at);
        },
        [&] { return first.settled() and second.settled(); }, milliseconds(3'000)));
    CHECK(first.reason().kind == outcome_kind::overruled);
    CHECK(second.running());
    it.pass([](instant) {}, milliseconds(3'000));
    CHECK(it.drive(0).motor().frequency() == 10'000);
}

namespace {

/// A drive that was started, and that nobody asked for longer than its time-out; it has lost its power meanwhile and stands.
template <typename Device> struct hall_after_silence : hall<Device> {
    hall_after_silence()
    {
        start before{this->motor, 30_Hz};
        REQUIRE(this->run(before));
        REQUIRE(before.running());
        this->idle(milliseconds(60'000));
        CHECK_FALSE(before.running());
        this->drive(0).power_cycle(this->now());
        this->idle(milliseconds(2'000));
        REQUIRE(this->drive_state() == state::switch_on_disabled);
    }
};

template <typename Device, typename Order> void order_behind_a_silence(Order order)
{
    hall_after_silence<Device> it;
    REQUIRE(it.run(order));
    CHECK(order.reason().kind == outcome_kind::succeeded);
    CHECK(order.running());
}

} // namespace

TEST_CASE("motion law: L2 a silence longer than the drive's time-out ends no order that is given behind it")
{
    test::all_drives::for_each([]<typename Device>() {
        order_behind_a_silence<Device>(start{*station<Device>::checked(3), 20_Hz});
    });
}

TEST_CASE("motion law: L2 a silence longer than the drive's time-out ends no direct start that is given behind it")
{
    order_behind_a_silence<atv28::device>(atv28::direct_start{*station<atv28::device>::checked(3), 20_Hz});
}

TEST_CASE("motion law: L4 a stop that nobody answers is followed by silence, though another controller gave the order")
{
    using device = atv320::device;
    hall<device> it;
    start go{it.motor, 40_Hz};
    REQUIRE(it.run(go));
    it.link() = drive_client<2>{test::bus_timing, patient}; // switched off and on: it ordered nothing
    it.disturb([&](auto& frame, bool) { frame.clear(); });
    stop rest{it.motor, stop_by::ramp, milliseconds(1'000)};
    REQUIRE(it.run(rest));
    CHECK(rest.reason().kind == outcome_kind::silent);
    it.disturb([&](auto& frame, bool is_request) {
        if (not is_request) {
            frame.clear(); // what is asked keeps the drive's time-out from ending
        }
    });
    single_request look{it.motor.unit(), read_holding_registers{3'201, 1}};
    it.pass(
        [&](instant at) {
            it.link().converse(look, at);
            if (look.settled()) {
                look.again();
            }
        },
        milliseconds(20'000));
    CHECK_FALSE(it.has_power());
}

TEST_CASE("motion law: L7 no halt and no DC injection gives a motor the power back that another stop has taken away")
{
    test::all_drives::for_each([]<typename Device>() {
        for (stop_by const how : {stop_by::halt, stop_by::dc_injection}) {
            if ((how == stop_by::halt ? Device::layout.halt : Device::layout.dc_injection) == 0) {
                continue;
            }
            for (std::uint32_t after_ms = 0; after_ms < 80; ++after_ms) {
                INFO("another stop " << after_ms << " ms behind the one by " << static_cast<int>(how));
                hall<Device> it;
                start go{it.motor, 10_Hz};
                REQUIRE(it.run(go));
                REQUIRE(go.running());
                stop in_place{it.motor, how};
                it.run([&](instant at) { it.link().converse(in_place, at); }, [] { return false; },
                       milliseconds(after_ms));
                stop rest{it.motor, stop_by::freewheel};
                REQUIRE(it.run(rest)); // the first one stays away
                bool const was_over = it.drive_state() == state::switch_on_disabled;
                bool has_power = false;
                it.run(
                    [&](instant at) {
                        if (not in_place.settled()) {
                            it.link().converse(in_place, at);
                        }
                        has_power = has_power or cia402::has_power(it.drive_state());
                    },
                    [] { return false; }, milliseconds(1'000));
                CHECK(was_over);
                CHECK_FALSE(has_power);
            }
        }
    });
}

TEST_CASE(
    "motion law: L15 a start whose motor runs says so, though another order came in its last moments and was refused")
{
    test::all_drives::for_each([]<typename Device>() {
        unsigned both = 0;
        for (std::uint32_t after_ms = 0; after_ms < 400; after_ms += 3) {
            INFO("another start " << after_ms << " ms behind the first one");
            hall<Device> it;
            start go{it.motor, 20_Hz};
            it.run([&](instant at) { it.link().converse(go, at); }, [&] { return go.settled(); },
                   milliseconds(after_ms));
            bool const was_done = go.settled();
            start beyond{it.motor, 400_Hz}; // above HSP
            it.run(
                [&](instant at) {
                    if (not go.settled()) {
                        it.link().converse(go, at);
                    }
                    if (not beyond.settled()) {
                        it.link().converse(beyond, at);
                    }
                },
                [&] { return go.settled() and beyond.settled(); }, milliseconds(20'000));
            CHECK_FALSE(beyond.succeeded());
            bool const has_power = cia402::has_power(it.drive_state());
            CHECK((go.reason().kind == outcome_kind::succeeded) == has_power);
            both += has_power and not was_done ? 1U : 0U;
        }
        CHECK(both > 0);
    });
}

TEST_CASE("motion law: L3 two stops of everyone that one drive does not answer keep the line from no other stop")
{
    using device = atv320::device;
    for (bool const frees_all : {false, true}) {
        INFO(frees_all);
        hall<device> it;
        it.cut(0, true);
        broadcast_stop first{it.motor}, second{it.motor};
        it.pass(
            [&](instant at) {
                it.link().converse(first, at);
                it.link().converse(second, at);
            },
            milliseconds(3'000)); // the broadcasts are over, and each of them tells drive 3 again and again
        REQUIRE_FALSE(first.settled());
        REQUIRE_FALSE(second.settled());
        stop rest{it.other};
        auto free = broadcast_freewheel<device>();
        std::size_t const before = it.requests();
        bool is_told = false;
        auto const work = [&](instant at) {
            it.link().converse(first, at);
            it.link().converse(second, at);
            if (frees_all) {
                it.link().converse(free, at);
            } else {
                it.link().converse(rest, at);
            }
            byte_view const frame = it.request();
            is_told = is_told or (it.requests() != before and to_u8(frame[0]) == (frees_all ? 0 : 4));
        };
        it.pass(work, milliseconds(1'000));
        CHECK(is_told);
        CHECK(it.requests() > before + 4); // and drive 3 goes on to be told
    }
}

TEST_CASE("motion law: L3 a halt of a cycle whose words get lost, and whose reads do not, becomes the ramp")
{
    using device = atv320::device;
    hall<device> it;
    cyclic<device> loop{it.motor, {.period = milliseconds(50)}};
    auto const cycle = [&](instant at) { it.link().converse(loop, at); };
    it.run_up(loop);
    unsigned halts = 0;
    it.disturb([&](auto& frame, bool is_request) {
        if (is_request and it.is_told(0x010F)) {
            ++halts;
            frame.clear();
        }
    });
    loop.stop(stop_by::halt);
    it.pass(cycle, milliseconds(6'000));
    CHECK(halts == 3);
    CHECK_FALSE(it.has_power());
}

TEST_CASE("motion law: L4 a broadcast restarts the silence of a lost unit, also of one that its stop would follow")
{
    using device = atv28::device;
    hall<device> it;
    start go{it.motor, 20_Hz};
    it.run([&](instant at) { it.link().converse(go, at); }, [&] { return go.settled(); }, milliseconds(5'000));
    REQUIRE(it.has_power());
    it.cut(0, true);
    single_request look{it.motor.unit(), read_holding_registers{458, 1}};
    it.run([&](instant at) { it.link().converse(look, at); }, [&] { return look.settled(); }, milliseconds(2'000));
    it.cut(0, false);
    it.idle(milliseconds(4'000)); // stop words are over, and the drive's time-out of 7 s is not
    {
        // Of another family: the drive hears a word that it does not take.
        broadcast_stop all{*station<atv320::device>::checked(3)};
        it.step([&](instant at) { it.link().converse(all, at); }, milliseconds(1));
        it.idle(milliseconds(4));
    }
    REQUIRE(it.has_power());
    instant const begin = it.now();
    bool was_asked = false;
    it.pass(
        [&](instant at) {
            if (look.settled()) {
                look.again();
            }
            it.link().converse(look, at);
            byte_view const frame = it.request();
            was_asked = was_asked or (to_u8(frame[0]) == 3 and at - begin > milliseconds(10) and
                                      to_u8(frame[1]) == 3 and it.has_power());
        },
        milliseconds(12'000));
    CHECK_FALSE(was_asked);
    CHECK_FALSE(it.has_power());
}

/// A motor is polled all the time; a stop of the other drive alone, which broadcasts nothing, begins while it answers.
template <typename Poll, typename Hall> void stop_the_other(Hall& it, Poll poll, duration visits)
{
    std::size_t const before = it.requests();
    while (it.requests() == before) {
        it.step(poll, milliseconds(1));
    }
    broadcast_stop all{broadcast_stop_options{.left_out = 8'501}, it.other};
    auto const work = [&](instant at) {
        it.link().converse(all, at);
        poll(at);
    };
    it.run(
        work, [&] { return all.settled(); }, visits);
}

TEST_CASE("motion law: L4 reads keep no motor running that a stop of others left, also where it answered meanwhile")
{
    using device = atv320::device;
    for (bool const is_given_up : {false, true}) {
        INFO("given up " << is_given_up);
        hall<device> it;
        start go{it.motor, 40_Hz};
        REQUIRE(it.run(go));
        single_request look{it.motor.unit(), read_holding_registers{3'201, 1}};
        auto const poll = [&](instant at) {
            if (look.settled()) {
                look.again();
            }
            it.link().converse(look, at);
        };
        stop_the_other(it, poll, is_given_up ? microseconds(10) : milliseconds(5'000));
        if (is_given_up) {
            it.link().release_all();
        }
        CHECK_FALSE(go.running());           // the order is over
        it.pass(poll, milliseconds(20'000)); // the drive's time-out is 10 s
        CHECK_FALSE(it.has_power());
    }
}
