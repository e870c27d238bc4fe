// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A stop is the strongest thing on the line: whatever else is asked of its drive, it goes first, and keeps the drive.
#include "support/catch.hpp"
#include "support/one_in.hpp"
#include "support/remembered.hpp"
#include "support/simulated_bus.hpp"

#include <optional>
#include <vector>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

using device = atv320::device;
constexpr station<device> motor{unit_id{1}};
constexpr station<device> other{unit_id{2}};
constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

struct hall : test::simulated_bus<bus<4>, device> {
    explicit hall(client_options const& options = patient)
        : test::simulated_bus<bus<4>, device>{bus<4>{test::bus_timing, options}}
    {
        add(motor.unit());
        add(other.unit());
        idle(milliseconds(20));
    }

    template <typename Work> void pass(Work work, duration length)
    {
        instant const end = now() + length;
        while (not reached(now(), end)) {
            step(work, end - now());
        }
    }
    bool has_power(std::size_t index = 0) { return cia402::has_power(drive_state(index)); }
    state drive_state(std::size_t index = 0) { return drive(index).state_machine().state(); }
};

bool is_stop_word(byte_view frame)
{
    return frame.size() == 8 and frame[1] == std::byte{6} and u16_at(frame, 2) == device::layout.cmd;
}

} // namespace

TEST_CASE("motion law: S9 a stop that is asked while a start climbs keeps the drive")
{
    for (std::uint32_t after_ms = 0; after_ms <= 150; after_ms += test::one_in(7)) {
        INFO("stopped " << after_ms << " ms after the start");
        hall it;
        start go{motor, 50_Hz};
        it.pass([&](instant at) { it.link().converse(0, go, at); }, milliseconds(after_ms));
        test::remembered<stop> rest{motor};
        it.pass(
            [&](instant at) {
                it.link().converse(0, go, at);
                it.link().converse(1, rest, at);
            },
            milliseconds(35'000));
        CHECK(rest.settled());
        CHECK(rest.succeeded());
        CHECK(go.settled());
        CHECK_FALSE(it.has_power());
        CHECK(it.drive(0).motor().is_at_rest());
    }
}

TEST_CASE("motion law: S9 a start that was begun before a stop has ended is not taken up by it")
{
    hall it;
    start first{motor, 50_Hz};
    REQUIRE(it.run([&](instant at) { it.link().converse(0, first, at); }, [&] { return first.settled(); },
                   milliseconds(3'000)));
    it.pass([](instant) {}, milliseconds(4'000));
    test::remembered<stop> rest{motor, stop_by::quick_stop};
    it.pass([&](instant at) { it.link().converse(1, rest, at); }, milliseconds(100));
    REQUIRE_FALSE(rest.settled());
    test::remembered<start> meanwhile{motor, 30_Hz};
    it.run(
        [&](instant at) {
            it.link().converse(0, meanwhile, at);
            it.link().converse(1, rest, at);
        },
        [&] { return rest.settled() and meanwhile.settled(); }, milliseconds(20'000));
    CHECK(rest.succeeded());
    CHECK(meanwhile.reason().kind == outcome_kind::overruled);
    CHECK_FALSE(it.has_power());
    test::remembered<start> behind{motor, 30_Hz};
    it.pass([&](instant at) { it.link().converse(0, behind, at); }, milliseconds(3'000));
    CHECK(behind.succeeded());
}

TEST_CASE("motion law: a stop that was destroyed before its end releases nothing")
{
    hall it;
    start go{motor, 50_Hz};
    REQUIRE(
        it.run([&](instant at) { it.link().converse(0, go, at); }, [&] { return go.settled(); }, milliseconds(3'000)));
    std::optional<stop> rest{std::in_place, motor};
    it.pass([&](instant at) { it.link().converse(1, *rest, at); }, milliseconds(15));
    rest.reset();
    it.idle(milliseconds(1'000)); // the motor stands by now
    test::remembered<start> again{motor, 50_Hz};
    it.pass([&](instant at) { it.link().converse(0, again, at); }, milliseconds(5'000));
    CHECK(again.reason().kind == outcome_kind::overruled);
    it.link().release(motor.unit());
    test::remembered<start> behind{motor, 50_Hz};
    it.pass([&](instant at) { it.link().converse(0, behind, at); }, milliseconds(5'000));
    CHECK(behind.succeeded());
}

TEST_CASE("motion law: L3 a release of a unit that no stop holds does not end the order that runs it")
{
    for (std::uint32_t after_ms = 0; after_ms < 400; after_ms += 7) {
        INFO("released " << after_ms << " ms after the order");
        hall it;
        start go{motor, 50_Hz};
        auto const work = [&](instant at) {
            if (not go.settled()) {
                it.link().converse(0, go, at);
            }
        };
        it.pass(work, milliseconds(after_ms));
        it.link().release(motor.unit());
        it.link().release_all();
        it.pass(work, milliseconds(3'000));
        CHECK(go.reason().kind == outcome_kind::succeeded);
        CHECK(go.running());
    }
}

TEST_CASE("motion law: S11 a stop leaves at once to a unit that missed its polls, or owes answers")
{
    constexpr client_options slow{.response_timeout = milliseconds(1'000), .retries = 2};
    for (std::uint32_t misses = 1; misses <= 8; ++misses) {
        std::size_t const slot = misses % 2; // its own, or the one that is held back because its unit is silent
        INFO(misses << " polls were lost, slot " << slot);
        hall it{slow};
        single_request poll{motor.unit(), read_holding_registers{3'201, 1}};
        auto const work = [&](instant at) {
            it.link().converse(0, poll, at);
            if (poll.settled()) {
                poll.again();
            }
        };
        it.cut(0, true);
        it.pass(work, milliseconds(1'500 * misses));
        it.cut(0, false);
        test::remembered<stop> rest{motor};
        instant const asked = it.now();
        while (not is_stop_word(it.request()) and it.now() - asked < milliseconds(5'000)) {
            it.step(
                [&](instant at) {
                    slot == 1 ? work(at) : void();
                    it.link().converse(slot, rest, at);
                },
                milliseconds(5));
        }
        CHECK(is_stop_word(it.request()));
        CHECK(it.now() - asked < milliseconds(20));
        it.pass([&](instant at) { it.link().converse(slot, rest, at); }, milliseconds(5'000));
        CHECK(rest.succeeded());
    }
}

TEST_CASE("motion law: a stop waits for no more than one answer of another unit, and for none of its own")
{
    constexpr client_options slow{.response_timeout = milliseconds(1'000), .retries = 2};
    for (bool const is_own : {false, true}) {
        for (std::uint32_t after_ms = 5; after_ms < 2'900; after_ms += 65) {
            INFO(after_ms << " ms after the request, which was to " << (is_own ? "the drive itself" : "another one"));
            hall it{slow};
            it.cut(0, is_own);
            it.cut(1, not is_own);
            single_request request{is_own ? motor.unit() : other.unit(), read_holding_registers{3'201, 1}};
            auto const ask = [&](instant at) { it.link().converse(0, request, at); };
            it.pass(ask, milliseconds(after_ms));
            it.cut(0, false);
            stop rest{motor};
            instant const asked = it.now();
            while (not is_stop_word(it.request()) and it.now() - asked < milliseconds(5'000)) {
                it.step(
                    [&](instant at) {
                        ask(at);
                        it.link().converse(1, rest, at);
                    },
                    milliseconds(5));
            }
            duration const waited = it.now() - asked;
            CHECK(waited < (is_own ? milliseconds(20) : milliseconds(1'030)));
        }
    }
}

TEST_CASE("motion law: a stop goes before all that others ask, wherever its slot stands")
{
    for (std::size_t slot = 0; slot < 4; ++slot) {
        for (std::uint32_t after_ms = 0; after_ms < 40; ++after_ms) {
            INFO("slot " << slot << ", " << after_ms << " ms");
            hall it;
            std::vector<single_request<read_holding_registers>> polls(
                3, single_request{other.unit(), read_holding_registers{3'201, 7}});
            auto const ask = [&](std::size_t at_slot, std::size_t i, instant at) {
                it.link().converse(at_slot, polls[i], at);
                if (polls[i].settled()) {
                    polls[i].again();
                }
            };
            std::optional<stop> rest;
            auto const work = [&](instant at) {
                for (std::size_t i = 0, poll = 0; i < 4; ++i) {
                    if (i != slot) {
                        ask(i, poll++, at);
                    } else if (rest) {
                        it.link().converse(i, *rest, at);
                    }
                }
            };
            it.pass(work, milliseconds(100 + after_ms));
            std::size_t const before = it.requests();
            rest.emplace(motor);
            while (not is_stop_word(it.request())) {
                it.step(work, milliseconds(5));
            }
            CHECK(it.requests() - before == 1); // what was under way had left already
        }
    }
}

TEST_CASE("motion law: a stop that stays away holds up nobody")
{
    hall it;
    single_request poll{other.unit(), read_holding_registers{3'201, 1}};
    unsigned answers = 0;
    for (unsigned i = 0; i < 300; ++i) {
        std::optional<stop> rest{std::in_place, motor};
        unsigned pass = 0;
        it.pass(
            [&](instant at) {
                it.link().converse(0, poll, at);
                if (poll.settled()) {
                    answers += poll.outcome() ? 1U : 0U;
                    poll.again();
                }
                if (pass++ < i % 5) {
                    it.link().converse(1, *rest, at);
                }
            },
            milliseconds(100));
    }
    CHECK(answers > 300 * 3);
}

TEST_CASE("motion law: S34 a cycle leaves a drive alone that another stop has, and is told so")
{
    hall it;
    cyclic<device> loop{motor, {.period = milliseconds(50)}};
    auto const cycle = [&](instant at) { it.link().converse(0, loop, at); };
    it.pass(cycle, milliseconds(600));
    REQUIRE(loop.run(1'200_rpm));
    it.pass(cycle, milliseconds(4'000));
    REQUIRE(it.drive_state() == state::operation_enabled);
    test::remembered<stop> rest{motor, stop_by::halt};
    it.pass(
        [&](instant at) {
            cycle(at);
            it.link().converse(1, rest, at);
        },
        milliseconds(10'000));
    // A halt stays in operation: the cycle's own ramp did not take its place while it was under way.
    CHECK(rest.succeeded());
    CHECK(loop.control().reason().kind == outcome_kind::overruled);
    CHECK_FALSE(loop.control().is_ordered());
    CHECK(it.drive(0).motor().is_at_rest());
}
