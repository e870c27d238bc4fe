// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive that was ordered to run and does not answer hears words that stop it, or nothing: its own time-out then stops
// it, whichever direction of the line was lost.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

/// A request that the drive heard, and when.
struct heard_request {
    instant at;
    std::vector<std::byte> frame;
};

template <typename Device> struct hall : test::simulated_bus<bus<3>, Device> {
    station<Device> drive{*station<Device>::checked(3)};
    bool loses_answers{false};
    bool loses_requests{false};
    std::vector<heard_request> heard{};

    hall() : test::simulated_bus<bus<3>, Device>{bus<3>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->disturb([this](auto& frame, bool is_request) {
            if (is_request and not loses_requests) {
                heard.push_back({this->now(), frame});
            }
            if (is_request ? loses_requests : loses_answers) {
                frame.clear();
            }
        });
        this->idle(milliseconds(20));
    }

    template <typename Work> void pass(Work work, duration length)
    {
        instant const end = this->now() + length;
        while (not reached(this->now(), end)) {
            this->step(work, end - this->now());
        }
    }
    bool has_power()
    {
        return cia402::has_power(this->test::simulated_bus<bus<3>, Device>::drive(0).state_machine().state());
    }

    /// After how long the drive stops by itself, as its manual says: TTO, or 7 s of an ATV28.
    duration timeout()
    {
        auto& far = this->test::simulated_bus<bus<3>, Device>::drive(0);
        bool const has_tto = Device::layout.cmd == 8'501;
        return has_tto ? milliseconds(100) * far.word("TTO") : milliseconds(7'000);
    }

    bool order(cyclic<Device>& loop)
    {
        if constexpr (cycle_layout<Device>::has_scanner) {
            return loop.run(1'200_rpm);
        } else {
            return loop.run(40_Hz);
        }
    }
};

bool is_stop(std::vector<std::byte> const& frame, std::uint16_t cmd)
{
    bool const is_write = frame.size() == 8 and frame[1] == std::byte{6} and u16_at(frame, 2) == cmd;
    std::uint16_t const word = is_write ? u16_at(frame, 4) : std::uint16_t{0xFFFF};
    return word == 0x0000 or word == 0x0002 or word == 0x0007;
}

} // namespace

TEST_CASE("motion law: S12 a cycle whose answers get lost lets the drive's own time-out stop the motor")
{
    test::all_drives::for_each([]<typename Device>() {
        hall<Device> it;
        cyclic<Device> loop{it.drive, {.period = milliseconds(100)}};
        // A poll of the same drive goes on beside it, and would keep its watchdog fed.
        single_request poll{it.drive.unit(), read_holding_registers{Device::layout.eta, 1}};
        auto const work = [&](instant at) {
            it.link().converse(0, loop, at);
            it.link().converse(1, poll, at);
            if (poll.settled()) {
                poll.again();
            }
        };
        it.pass(work, milliseconds(1'000));
        REQUIRE(it.order(loop));
        it.pass(work, milliseconds(6'000));
        REQUIRE(it.has_power());
        it.heard.clear();
        it.loses_answers = true;
        instant const lost = it.now();
        it.pass(work, milliseconds(600'000));
        CHECK_FALSE(it.has_power());
        CHECK(loop.control().reason().kind == outcome_kind::silent);
        // Two misses of the cycle, or one of the poll with its repetition, and 2 s of words: then silence.
        duration const until_silence = milliseconds(2'000 + 4 * 130 + 200);
        REQUIRE_FALSE(it.heard.empty());
        std::optional<instant> last;
        for (auto const& each : it.heard) {
            bool const is_early = each.at - lost < until_silence;
            last = is_early ? each.at : last;
        }
        REQUIRE(last);
        auto const next = std::find_if(it.heard.begin(), it.heard.end(),
                                       [&](auto const& each) { return each.at - lost >= until_silence; });
        REQUIRE(next != it.heard.end());
        CHECK(next->at - *last >= it.timeout() + milliseconds(1'000));
        // Between the loss and the silence: nothing but words that stop.
        instant const loss = lost + milliseconds(4 * 130 + 200);
        for (auto const& each : it.heard) {
            if (reached(each.at, loss) and each.at - lost < until_silence) {
                CHECK(is_stop(each.frame, Device::layout.cmd));
            }
        }
    });
}

TEST_CASE("motion law: S12 a probe of a silent unit does not feed it")
{
    hall<atv320::device> it;
    start go{it.drive, 40_Hz};
    REQUIRE(
        it.run([&](instant at) { it.link().converse(0, go, at); }, [&] { return go.settled(); }, milliseconds(3'000)));
    it.loses_answers = true;
    // The start has ended; only a poll goes on.
    single_request poll{it.drive.unit(), read_holding_registers{3'201, 1}};
    it.pass(
        [&](instant at) {
            it.link().converse(1, poll, at);
            if (poll.settled()) {
                poll.again();
            }
        },
        milliseconds(60'000));
    CHECK_FALSE(it.has_power());
}

TEST_CASE("motion law: L4 a user's stop breaks the silence with its own words, 2 s at most")
{
    hall<atv320::device> it;
    cyclic<atv320::device> loop{it.drive, {.period = milliseconds(100)}};
    auto const cycle = [&](instant at) { it.link().converse(0, loop, at); };
    it.pass(cycle, milliseconds(1'000));
    REQUIRE(it.order(loop));
    it.pass(cycle, milliseconds(4'000));
    it.loses_answers = true;
    it.loses_requests = true;
    it.pass(cycle, milliseconds(6'000));
    REQUIRE(it.link().is_held(it.drive.unit()));
    REQUIRE(it.has_power());
    // The drive hears again, and is not heard: the user's word reaches it.
    it.loses_requests = false;
    it.heard.clear();
    stop rest{it.drive};
    instant const asked = it.now();
    it.pass(
        [&](instant at) {
            cycle(at);
            it.link().converse(1, rest, at);
        },
        milliseconds(12'000));
    CHECK_FALSE(it.has_power());
    REQUIRE_FALSE(it.heard.empty());
    CHECK(it.heard.front().at - asked < milliseconds(20));
    CHECK(it.heard.back().at - asked < milliseconds(2'150));
    for (auto const& each : it.heard) {
        CHECK(is_stop(each.frame, atv320::device::layout.cmd));
    }
}

TEST_CASE("motion law: L4 an answer to a stop word ends the loss, and the order stays gone")
{
    hall<atv12::device> it;
    cyclic<atv12::device> loop{it.drive, {.period = milliseconds(100)}};
    auto const cycle = [&](instant at) { it.link().converse(0, loop, at); };
    it.pass(cycle, milliseconds(1'000));
    REQUIRE(it.order(loop));
    it.pass(cycle, milliseconds(4'000));
    it.loses_answers = true;
    it.pass(cycle, milliseconds(1'000));
    it.loses_answers = false;
    it.pass(cycle, milliseconds(15'000));
    CHECK_FALSE(loop.link_lost());
    CHECK_FALSE(it.has_power());
    CHECK_FALSE(loop.control().is_ordered());
    CHECK(it.order(loop));
    it.pass(cycle, milliseconds(3'000));
    CHECK(it.has_power());
}

TEST_CASE("motion law: S7 the two frames lost at a moment of their own: every prefix of a start's answers may be lost "
          "for ever")
{
    test::all_drives::for_each([]<typename Device>() {
        for (unsigned answered = 0; answered < 12; ++answered) {
            INFO(answered << " answers arrive");
            hall<Device> it;
            unsigned left = answered;
            start go{it.drive, 40_Hz};
            it.disturb([&](auto& frame, bool is_request) {
                if (not is_request) {
                    left == 0 ? frame.clear() : static_cast<void>(--left);
                }
            });
            it.pass([&](instant at) { it.link().converse(0, go, at); }, milliseconds(100'000));
            CHECK(go.settled());
            CHECK((not it.has_power() or go.running()));
        }
    });
}
