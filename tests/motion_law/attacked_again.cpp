// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a second attack on the promises of the headers found: reads that were never waited for, stops of units that have
// no place, a set-up under a start's feet.
#include "support/catch.hpp"
#include "support/remembered.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/table/read_plan.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using device = atv320::device;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(200), .retries = 1};
constexpr std::array<station<device>, 3> drives{station<device>{unit_id{3}}, station<device>{unit_id{4}},
                                                station<device>{unit_id{5}}};

/// Three drives and a client that commands some of them.
template <std::size_t Places> struct hall : test::simulated_bus<drive_client<Places>, device> {
    using base = test::simulated_bus<drive_client<Places>, device>;
    std::optional<std::byte> mute{}; ///< the unit whose responses are lost

    explicit hall(client_options const& options = patient) : base{drive_client<Places>{test::bus_timing, options}}
    {
        for (station<device> const& each : drives) {
            this->add(each.unit());
        }
        this->idle(milliseconds(20));
        this->disturb([this](std::vector<std::byte>& frame, bool is_request) {
            if (not is_request and mute == frame[0]) {
                frame.clear();
            }
        });
    }
    template <typename Work> void pass(Work work, duration length)
    {
        this->run(
            work, [] { return false; }, length);
    }
    bool has_power(std::size_t index) { return cia402::has_power(this->drive(index).state_machine().state()); }

    /// Runs by another controller's words, for half a minute without a request.
    void run_by_another(std::size_t index)
    {
        auto& far = this->drive(index);
        for (auto const& [address, word] : {std::pair{6'005, 300}, {8'501, 6}, {8'501, 7}, {8'502, 300}, {8'501, 15}}) {
            register_block const block{static_cast<std::uint16_t>(word)};
            REQUIRE(far.write(static_cast<std::uint16_t>(address), block) == errc::none);
            this->idle(milliseconds(20));
        }
        REQUIRE(has_power(index));
    }
};

/// How a panel gives its request up before the response is late.
enum class giving_up { begun_anew, cancelled, destroyed };

} // namespace

TEST_CASE("motion law: L4 reads that nobody waits for do not keep a motor running whose answers are lost")
{
    for (giving_up const how : {giving_up::begun_anew, giving_up::cancelled, giving_up::destroyed}) {
        for (std::uint32_t const each_ms : {100U, 250U, 900U, 1'500U}) {
            INFO(static_cast<int>(how) << ", each " << each_ms << " ms");
            hall<1> it{client_options{}};
            {
                start go{drives[0], 30_Hz};
                REQUIRE(it.run(go));
                REQUIRE(go.running());
            }
            it.mute = std::byte{3};
            instant const lost = it.now();
            while (it.has_power(0) and it.now() - lost < milliseconds(60'000)) {
                single_request look{unit_id{3}, read_holding_registers{3'201, 2}};
                auto const work = [&](instant at) { it.link().converse(look, at); };
                it.pass(work, milliseconds(each_ms));
                if (how == giving_up::begun_anew) {
                    look.again();
                    it.pass(work, milliseconds(each_ms));
                } else if (how == giving_up::cancelled) {
                    it.link().cancel(look, it.now());
                }
            }
            // TTO is 10 s; three misses of at most 3 s come first, then words that stop for 2 s.
            CHECK(it.now() - lost < milliseconds(24'000));
        }
    }
}

TEST_CASE("motion law: L3 a stop is nobody's but its unit's, however many units have no place")
{
    for (bool const is_ordered : {false, true}) {
        INFO(is_ordered);
        hall<1> it;
        if (is_ordered) {
            start go{drives[0], 30_Hz};
            REQUIRE(it.run(go));
        } else {
            it.run_by_another(0);
        }
        it.run_by_another(1);
        it.run_by_another(2);
        test::remembered<stop> one{drives[0]}, two{drives[1]}, three{drives[2]};
        it.pass(
            [&](instant at) {
                it.link().converse(one, at);
                it.link().converse(two, at);
                it.link().converse(three, at);
            },
            milliseconds(8'000));
        CHECK(one.succeeded());
        CHECK(two.succeeded());
        CHECK(three.succeeded());
        CHECK_FALSE((it.has_power(0) or it.has_power(1) or it.has_power(2)));
    }
}

TEST_CASE("motion law: L3 a unit is not held for ever by another one's stop that is over")
{
    hall<1> it;
    it.mute = std::byte{4};
    broadcast_stop all{broadcast_stop_options{.limit = milliseconds(4'000)}, drives[0], drives[1]};
    std::optional<start> early{};
    auto const work = [&](instant at) {
        it.link().converse(all, at);
        if (early) {
            it.link().converse(*early, at);
        }
    };
    it.pass(work, milliseconds(2'000));
    early = start{drives[2], 30_Hz};
    it.pass(work, milliseconds(8'000));
    REQUIRE(all.settled());
    REQUIRE(early->settled());
    CHECK_FALSE(early->running());
    // The unit that did not answer keeps its place for 31 s; the other one's time-out is held off.
    single_request look{unit_id{5}, read_holding_registers{3'201, 1}};
    it.pass(
        [&](instant at) {
            if (look.settled()) {
                look.again();
            }
            it.link().converse(look, at);
        },
        milliseconds(31'000));
    start late{drives[2], 30_Hz};
    REQUIRE(it.run(late));
    CHECK(late.running());
}

TEST_CASE("motion law: L3 a stop that goes on keeps holding its unit when another one's is over")
{
    hall<1> it;
    start keep{drives[0], 30_Hz};
    REQUIRE(it.run(keep));
    it.run_by_another(1);
    it.mute = std::byte{4};
    test::remembered<stop> slow{drives[1]}, quick{drives[2]};
    auto const stops = [&](instant at) {
        it.link().converse(slow, at);
        it.link().converse(quick, at);
    };
    it.pass(stops, milliseconds(2'000));
    REQUIRE(quick.succeeded());
    REQUIRE_FALSE(slow.settled());
    start late{drives[1], 30_Hz};
    it.pass(
        [&](instant at) {
            stops(at);
            it.link().converse(late, at);
        },
        milliseconds(5'000));
    CHECK(late.settled());
    CHECK_FALSE(late.running());
}

TEST_CASE("motion law: L4 everyone's stop leaves a unit alone that does not answer, as any other stop does")
{
    hall<3> it;
    it.mute = std::byte{4};
    broadcast_stop all{broadcast_stop_options{.limit = milliseconds(20'000)}, drives[0], drives[1]};
    instant const begun = it.now();
    instant last = begun;
    duration longest{};
    std::size_t seen = it.requests();
    single_request look{unit_id{4}, read_holding_registers{3'201, 1}};
    it.pass(
        [&](instant at) {
            if (it.requests() != seen and it.request()[0] == std::byte{4}) {
                longest = at - last > longest ? at - last : longest;
                last = at;
            }
            seen = it.requests();
            it.link().converse(all, at);
            if (look.settled()) {
                look.again();
            }
            it.link().converse(look, at);
        },
        milliseconds(60'000));
    CHECK(all.settled());
    CHECK(longest >= milliseconds(31'000)); // the longest TTO is 30 s
}

TEST_CASE("motion law: L4 a unit that is left alone keeps its place, whoever else is stopped or ordered")
{
    for (bool const is_stop : {false, true}) {
        INFO(is_stop);
        hall<1> it;
        it.mute = std::byte{3};
        stop first{drives[0], stop_by::ramp, milliseconds(3'000)};
        REQUIRE(it.run(first));
        test::remembered<stop> second{drives[1]};
        test::remembered<start> go{drives[1], 30_Hz};
        single_request look{unit_id{3}, read_holding_registers{3'201, 1}};
        bool is_asked = false;
        it.pass(
            [&](instant at) {
                is_asked = is_asked or look.settled();
                it.link().converse(look, at);
                if (is_stop) {
                    it.link().converse(second, at);
                } else {
                    it.link().converse(go, at);
                }
            },
            milliseconds(20'000));
        CHECK_FALSE(is_asked);
        CHECK((is_stop ? second.succeeded() : go.reason().kind == outcome_kind::no_place));
    }
}

TEST_CASE("motion law: L3 everyone is let go by release_all, in whatever part of its stop it was given up")
{
    for (std::uint32_t after_ms = 0; after_ms < 1'400; after_ms += 20) {
        INFO("given up after " << after_ms << " ms");
        hall<2> it;
        {
            broadcast_stop all{drives[0], drives[1]};
            it.pass([&](instant at) { it.link().converse(all, at); }, milliseconds(after_ms));
        }
        it.link().release_all();
        for (std::size_t index : {0U, 1U}) {
            start go{drives[index], 30_Hz};
            REQUIRE(it.run(go));
            CHECK(go.running());
        }
    }
}

TEST_CASE("motion law: L3 a stop that waits for a line to fall silent does not keep its loop from sleeping")
{
    drive_client<> link{test::bus_timing, patient};
    stop rest{drives[0]};
    single_request look{unit_id{4}, read_holding_registers{3'201, 1}};
    instant now{0};
    unsigned at_once = 0;
    for (unsigned pass = 0; pass < 5'000; ++pass) { // somebody babbles without an end
        link.receive(std::array{std::byte{0x55}}, now);
        link.advance(now);
        link.converse(look, now);
        link.converse(rest, now);
        CHECK(link.poll_transmit().empty());
        deadline const next = link.poll_deadline();
        at_once += next and reached(now, *next) ? 1U : 0U;
        now = now + microseconds(600);
    }
    CHECK(at_once < 50);
}

TEST_CASE("motion law: L9 a drive that was looked at once is not said to disobey")
{
    hall<1> it;
    start go{drives[0], 30_Hz};
    REQUIRE(it.run(go));
    it.idle(milliseconds(4'000));
    test::remembered<stop> rest{drives[0], stop_by::ramp, milliseconds(3'000)};
    auto const work = [&](instant at) { it.link().converse(rest, at); };
    // The word, the look and one frequency are answered, then nothing any more.
    std::size_t const before = it.answers(0);
    it.run(
        work, [&] { return it.answers(0) >= before + 3; }, milliseconds(1'000));
    REQUIRE(it.answers(0) == before + 3);
    it.mute = std::byte{3};
    it.pass(work, milliseconds(10'000));
    REQUIRE(rest.settled());
    CHECK(rest.reason().kind == outcome_kind::unconfirmed);
}

TEST_CASE("motion law: L11 an order that a cycle takes behind a stop is carried out, and no other is taken")
{
    enum class stopped_by { itself, another, everyone };
    for (stopped_by const who : {stopped_by::itself, stopped_by::another, stopped_by::everyone}) {
        for (unsigned waits = 0; waits < 120; waits += waits < 10 ? 1 : 10) {
            INFO(static_cast<int>(who) << ", ordered " << waits << " passes behind the end");
            hall<2> it;
            cyclic<device> loop{drives[0], {.period = milliseconds(50)}};
            stop rest{drives[0]};
            broadcast_stop all{drives[0], drives[1]};
            bool is_stopped = false;
            auto const work = [&](instant at) {
                if (is_stopped and who == stopped_by::everyone and not all.settled()) {
                    it.link().converse(all, at);
                }
                if (is_stopped and who == stopped_by::another and not rest.settled()) {
                    it.link().converse(rest, at);
                }
                it.link().converse(loop, at);
            };
            it.pass(work, milliseconds(2'000));
            REQUIRE(loop.run(900_rpm));
            it.pass(work, milliseconds(2'000));
            REQUIRE(loop.control().is_running());
            is_stopped = true;
            if (who == stopped_by::itself) {
                loop.stop(stop_by::quick_stop);
            }
            bool is_taken = false;
            unsigned passes = 0;
            it.run(
                work,
                [&] {
                    bool const is_over =
                        who == stopped_by::itself ? not loop.control().is_running() : rest.settled() or all.settled();
                    passes += is_over ? 1U : 0U;
                    is_taken = is_over and passes > waits and loop.run(900_rpm);
                    return is_taken;
                },
                milliseconds(10'000));
            REQUIRE(is_taken);
            it.pass(work, milliseconds(3'000));
            CHECK(loop.control().is_running());
            CHECK(it.has_power(0));
        }
    }
}

TEST_CASE("motion law: L3 a stop that was given up without a place lets go when its unit was stopped again")
{
    hall<1> it;
    start first{drives[0], 30_Hz};
    REQUIRE(it.run(first));
    it.run_by_another(1);
    {
        stop given_up{drives[1]};
        it.pass([&](instant at) { it.link().converse(given_up, at); }, milliseconds(10));
        REQUIRE_FALSE(given_up.settled());
    }
    for (std::size_t index : {0U, 1U}) {
        stop whole{drives[index]};
        REQUIRE(it.run(whole));
        REQUIRE(whole.succeeded());
    }
    for (std::size_t index : {0U, 1U, 2U}) {
        INFO(index);
        start go{drives[index], 30_Hz};
        REQUIRE(it.run(go));
        CHECK(go.running());
        stop rest{drives[index]};
        REQUIRE(it.run(rest));
    }
}
