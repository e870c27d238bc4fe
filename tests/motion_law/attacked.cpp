// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What an attack on the promises of the headers found: orders older than a stop, stops that waited, loops that slept.
#include "support/catch.hpp"
#include "support/remembered.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using device = atv320::device;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(1'000), .retries = 1};

template <std::size_t Places> struct hall : test::simulated_bus<drive_client<Places>, device> {
    station<device> press{unit_id{3}};
    station<device> fan{unit_id{4}};

    hall() : test::simulated_bus<drive_client<Places>, device>{drive_client<Places>{test::bus_timing, patient}}
    {
        this->add(press.unit());
        this->add(fan.unit());
        this->idle(milliseconds(20));
    }
    template <typename Work> void pass(Work work, duration length)
    {
        this->run(
            work, [] { return false; }, length);
    }
    bool has_power(std::size_t index = 0) { return cia402::has_power(this->drive(index).state_machine().state()); }
    bool is_stop_word()
    {
        byte_view const frame = this->request();
        return frame.size() == 8 and frame[1] == std::byte{6} and u16_at(frame, 2) == device::layout.cmd and
               u16_at(frame, 4) != 0x000F;
    }
};

} // namespace

TEST_CASE("motion law: L2 an order that was given before a stop, and comes by behind it, is gone")
{
    for (bool const is_everyone : {false, true}) {
        INFO(is_everyone);
        hall<2> it;
        cyclic<device> loop{it.press};
        auto const cycle = [&](instant at) { it.link().converse(loop, at); };
        it.pass(cycle, milliseconds(1'000));
        REQUIRE(loop.run(900_rpm));
        // A function that stops and waits for it; the cycle does not come by meanwhile.
        broadcast_stop all{it.press};
        bool is_done = false;
        test::remembered<stop> rest{it.press};
        it.pass(
            [&](instant at) {
                if (is_everyone) {
                    it.link().converse(all, at);
                    is_done = is_done or all.succeeded();
                } else {
                    it.link().converse(rest, at);
                }
            },
            milliseconds(2'000));
        REQUIRE((is_everyone ? is_done : rest.succeeded()));
        bool had_power = false;
        for (unsigned moment = 0; moment < 300; ++moment) {
            it.pass(cycle, milliseconds(10));
            had_power = had_power or it.has_power();
        }
        CHECK_FALSE(had_power);
        CHECK_FALSE(loop.control().is_ordered());
        CHECK(loop.control().reason().kind == outcome_kind::overruled);
        REQUIRE(loop.run(900_rpm)); // anew
        it.pass(cycle, milliseconds(3'000));
        CHECK(it.has_power());
    }
}

TEST_CASE("motion law: L3 a stop with a short limit says its word behind another unit's time-out")
{
    for (std::uint32_t const limit_ms : {0U, 100U, 500U, 900U}) {
        INFO(limit_ms);
        hall<2> it;
        start go{it.press, 40_Hz};
        REQUIRE(it.run(go));
        single_request off{unit_id{44}, read_holding_registers{3'201, 1}};
        it.pass([&](instant at) { it.link().converse(off, at); }, milliseconds(30));
        stop rest{it.press, stop_by::ramp, milliseconds(limit_ms)};
        it.pass(
            [&](instant at) {
                it.link().converse(off, at);
                it.link().converse(rest, at);
            },
            milliseconds(6'000));
        CHECK(rest.settled());
        CHECK(it.drive(0).state_machine().state() != state::operation_enabled);
    }
}

TEST_CASE("motion law: L3 a stop does not wait for the pause of another unit that is busy")
{
    hall<2> it;
    start go{it.press, 40_Hz};
    REQUIRE(it.run(go));
    // The fan answers 06 to everything.
    it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
        if (not is_request and frame[0] == std::byte{4}) {
            frame = {frame[0], frame[1] | std::byte{0x80}, std::byte{6}};
            std::uint16_t const crc = crc16(frame);
            frame.push_back(to_byte(crc));
            frame.push_back(to_byte(crc >> 8U));
        }
    });
    single_request busy{it.fan.unit(), read_holding_registers{3'201, 1}};
    retry_policy const slow{
        .response_timeout = milliseconds(1'000), .busy_retries = 3, .busy_pause = milliseconds(2'000)};
    it.pass([&](instant at) { it.link().converse(busy, at, slow); }, milliseconds(100));
    stop rest{it.press};
    std::size_t const before = it.requests();
    instant const asked = it.now();
    auto const work = [&](instant at) {
        it.link().converse(busy, at, slow);
        it.link().converse(rest, at);
    };
    REQUIRE(it.run(
        work, [&] { return it.requests() != before; }, milliseconds(3'000)));
    CHECK(it.is_stop_word());
    CHECK(it.now() - asked < milliseconds(30));
}

TEST_CASE("motion law: L5 settings are not restored of a drive that is being started")
{
    // Every moment of a start at which somebody asks for factory settings.
    for (std::uint32_t after_ms = 0; after_ms < 300; after_ms += 7) {
        INFO(after_ms);
        hall<2> it;
        start go{it.press, 40_Hz};
        auto const first = [&](instant at) { it.link().converse(go, at); };
        it.pass(first, milliseconds(after_ms));
        bool is_written_under_power = false;
        it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
            bool const is_order = is_request and frame[1] == std::byte{6} and
                                  u16_at(byte_view{frame}, 2) == device::layout.cmi and
                                  u16_at(byte_view{frame}, 4) == 1;
            is_written_under_power = is_written_under_power or (is_order and it.has_power());
        });
        restore_factory_settings restore{it.press, losing_control_and_address{}};
        it.pass(
            [&](instant at) {
                it.link().converse(go, at);
                it.link().converse(restore, at);
            },
            milliseconds(3'000));
        CHECK_FALSE(is_written_under_power);
    }
}

TEST_CASE("motion law: L3 a stop that was given up holds its unit where all places are taken, until it is let go")
{
    hall<1> it;
    start go{it.press, 40_Hz};
    REQUIRE(it.run(go));
    {
        stop rest{it.fan};
        it.pass([&](instant at) { it.link().converse(rest, at); }, milliseconds(3));
    }
    stop other{it.press};
    REQUIRE(it.run(other));
    start turn{it.fan, 20_Hz};
    REQUIRE(it.run(turn));
    CHECK(turn.reason().kind == outcome_kind::overruled);
    CHECK_FALSE(it.has_power(1));
    stop again{it.fan};
    REQUIRE(it.run(again));
    start anew{it.fan, 20_Hz};
    REQUIRE(it.run(anew));
    CHECK(anew.running());
}

TEST_CASE("motion law: L5 a stop of everyone that was given up is let go by its name")
{
    hall<2> it;
    {
        broadcast_stop all{it.press, it.fan};
        it.pass([&](instant at) { it.link().converse(all, at); }, milliseconds(3));
    }
    start go{it.press, 40_Hz};
    REQUIRE(it.run(go));
    CHECK(go.reason().kind == outcome_kind::overruled);
    it.link().motor_orders().release_all();
    start anew{it.press, 40_Hz};
    REQUIRE(it.run(anew));
    CHECK(anew.running());
}

TEST_CASE("motion law: a client without a place for one more order says so")
{
    hall<1> it;
    start go{it.press, 40_Hz};
    REQUIRE(it.run(go));
    start more{it.fan, 20_Hz};
    REQUIRE(it.run(more));
    CHECK(more.reason().kind == outcome_kind::no_place);
    CHECK(more.reason().error == errc::too_many_ordered);
    CHECK_FALSE(it.has_power(1));
}

TEST_CASE("motion law: a loop that sleeps by a client's deadline alone wakes for its conversations")
{
    hall<2> it;
    stop rest{it.press, stop_by::ramp, milliseconds(5'000)};
    // The drive never answers; nothing else happens on the line.
    it.cut(0, true);
    instant now = it.now();
    unsigned words = 0;
    unsigned passes = 0;
    instant const begin = now;
    while (not rest.settled() and passes < 10'000) {
        ++passes;
        it.link().advance(now);
        it.link().converse(rest, now);
        if (byte_view const frame = it.link().poll_transmit(); not frame.empty()) {
            ++words;
            now = now + test::bus_timing.characters(frame.size());
            it.link().sent(now);
        }
        if (rest.settled()) {
            break;
        }
        deadline const next = it.link().poll_deadline();
        REQUIRE(next); // there is no interrupt to come
        now = reached(now, *next) ? now + microseconds(10) : *next;
    }
    CHECK(rest.settled());
    CHECK(now - begin < milliseconds(6'000));
    CHECK(words > 2);
}

TEST_CASE("motion law: L3 a halt that could not look by its limit says the ramp's word all the same")
{
    hall<2> it;
    start go{it.press, 40_Hz};
    REQUIRE(it.run(go));
    it.cut(0, true);
    test::remembered<stop> rest{it.press, stop_by::halt, milliseconds(300)};
    bool is_said = false;
    it.pass(
        [&](instant at) {
            it.link().converse(rest, at);
            is_said = is_said or it.is_stop_word();
        },
        milliseconds(8'000));
    CHECK(is_said);
    CHECK(rest.settled());
    CHECK(rest.reason().kind == outcome_kind::silent);
    CHECK(rest.reason().is_other_stop);
}

TEST_CASE(
    "motion law: settings are restored of a drive that tripped while it was ordered, without a word about the order")
{
    hall<2> it;
    start go{it.press, 40_Hz};
    REQUIRE(it.run(go));
    it.drive(0).inject_fault(9); // nobody has read it when the settings are asked for
    it.pass([](instant) {}, milliseconds(2'000));
    REQUIRE(it.drive(0).state_machine().state() == state::fault);
    restore_factory_settings restore{it.press, losing_control_and_address{}};
    REQUIRE(it.run(restore));
    CHECK(restore.reason().kind == outcome_kind::executed_unconfirmed);
    CHECK_FALSE(it.link().motor_orders().is_ordered(it.press.unit().byte()));
}

TEST_CASE("motion law: L4 a stop that waits for its unit's silence keeps nobody else of a bus from asking")
{
    constexpr client_options quick{.response_timeout = milliseconds(100), .retries = 1};
    test::simulated_bus<bus<3>, device> it{bus<3>{test::bus_timing, quick}};
    station<device> const press{unit_id{3}};
    station<device> const fan{unit_id{4}};
    it.add(press.unit());
    it.add(fan.unit());
    start go{press, 40_Hz};
    REQUIRE(
        it.run([&](instant at) { it.link().converse(0, go, at); }, [&] { return go.settled(); }, milliseconds(3'000)));
    it.cut(0, true);
    stop rest{press, stop_by::ramp, milliseconds(20'000)};
    auto const wait = [&](instant at) { it.link().converse(2, rest, at); };
    it.run(
        wait, [] { return false; }, milliseconds(6'000));
    REQUIRE_FALSE(rest.settled());
    REQUIRE(it.link().is_ordered(press.unit()));

    cyclic<device> loop{fan, {.period = milliseconds(50)}};
    auto const both = [&](instant at) {
        it.link().converse(1, loop, at);
        wait(at); // behind it: a request of the cycle has not left yet
    };
    std::size_t const before = it.answers(1);
    it.run(
        both, [] { return false; }, milliseconds(2'000));
    CHECK(it.answers(1) - before > 20);
    REQUIRE(loop.run(900_rpm));
    it.run(
        both, [] { return false; }, milliseconds(2'000));
    CHECK(loop.control().is_running());
    loop.stop();
    it.run(
        both, [] { return false; }, milliseconds(3'000));
    CHECK_FALSE(cia402::has_power(it.drive(1).state_machine().state()));
    CHECK_FALSE(rest.settled());
}

TEST_CASE("motion law: L5 a drive that does not answer does not keep the others from being stopped one by one")
{
    for (bool const is_first : {false, true}) {
        INFO(is_first);
        hall<2> it;
        start go{it.press, 40_Hz};
        REQUIRE(it.run(go));
        start more{it.fan, 20_Hz};
        REQUIRE(it.run(more));
        std::size_t const dead = is_first ? 0 : 1;
        it.cut(dead, true);
        broadcast_stop all{broadcast_stop_options{.limit = milliseconds(10'000)}, it.press, it.fan};
        REQUIRE(it.run([&](instant at) { it.link().converse(all, at); },
                       [&] { return all.reason(1 - dead).kind != outcome_kind::pending; }, milliseconds(8'000)));
        CHECK(all.reason(1 - dead).kind == outcome_kind::succeeded);
        CHECK(all.reason(dead).kind == outcome_kind::pending);
        CHECK_FALSE(it.has_power(1 - dead));
        REQUIRE(it.run(all, milliseconds(9'000))); // its limit ends in the silence
        CHECK(all.reason(dead).kind == outcome_kind::silent);
    }
}
