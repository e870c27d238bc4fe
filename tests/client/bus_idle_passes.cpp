// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Passes in which nobody has a turn (rule 42) against a bus that lets every conversation visit in every pass, over
// random lines: the same frames leave at the same times, each conversation gets the same outcomes, and a stop that
// begins at any moment leaves as soon.
#include <rtuwire/client/bus.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "client/command_desk.hpp"

#include "support/catch.hpp"
#include "support/one_in.hpp"
#include "support/random.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr std::size_t readers = 4;

/// What happened: when, and which bytes left or which slot was told what.
using history = std::vector<std::string>;

/// Reads while it has reads left.
struct reader : asker {
    unsigned of{1};
    unsigned left{0};
    std::size_t slot{0};
    history* told{nullptr};
    std::uint32_t const* time{nullptr};
    frame_bytes frame{};

    std::optional<request_frame> next()
    {
        frame = read_of(of, 3'201);
        return request_frame{frame};
    }
    void accept(result<response> const& outcome)
    {
        left -= left > 0 ? 1U : 0U;
        told->push_back(std::to_string(*time) + " slot " + std::to_string(slot) + " is told " +
                        std::to_string(static_cast<unsigned>(outcome.error())));
    }
    bool settled() const { return left == 0; }
};

/// Never asks. One with a time of its own keeps every pass of its bus awake.
struct sleeper : reader {};
struct waker : reader {
    static void advance(instant) {}
    static deadline poll_deadline() { return {}; }
};

/// How a unit treats the n-th request: how long it takes, and whether it answers at all.
struct habit {
    std::uint32_t delay;
    bool is_silent;
    bool is_damaged;
};

/// A bus with four readers, a stop and one that never asks, on a line whose units do the same in every world.
template <typename Last> struct world {
    bus<readers + 2> link;
    bool asks_first; ///< whether it leaves out the visits where nobody has a turn
    std::array<reader, readers> reads{};
    hand_commander stop{9};
    Last last{};
    history told{};
    std::uint32_t time{0xFFFF'0000U};
    std::multimap<std::uint32_t, frame_bytes> to_come{}; ///< by time since the start; no bytes: the request has left
    std::uint32_t const start{time};
    unsigned visited{0};
    unsigned passes{0};

    world(bool is_asking, client_options const& options, bus_options const& share)
        : link{office_line, options, share}, asks_first{is_asking}
    {
        for (std::size_t i = 0; i < readers; ++i) {
            reads[i].of = static_cast<unsigned>(1 + i);
            reads[i].slot = i;
            reads[i].told = &told;
            reads[i].time = &time;
        }
        last.told = &told;
        last.time = &time;
    }
    instant now() const { return instant{time}; }

    void pass(std::uint32_t length, std::vector<habit> const& habits)
    {
        time += length;
        for (; not to_come.empty() and to_come.begin()->first <= time - start; to_come.erase(to_come.begin())) {
            frame_bytes const& bytes = to_come.begin()->second;
            if (bytes.empty()) {
                link.sent(instant{start + to_come.begin()->first});
            } else {
                link.receive(byte_view{bytes}, now());
            }
        }
        link.advance(now());
        ++passes;
        if (not asks_first or link.has_turn()) {
            visited += link.has_turn() ? 1U : 0U;
            for (std::size_t i = 0; i < readers; ++i) {
                link.converse(i, reads[i], now());
            }
            link.converse(readers + 1, last, now());
        }
        if (stop.has_request) {
            link.converse(readers, stop, now());
            if (stop.told) {
                told.push_back(std::to_string(time) + " stop is told " +
                               std::to_string(static_cast<unsigned>(*stop.told)));
                stop.told.reset();
                stop.note_stop_over();
            }
        }
        transmit(habits);
    }
    void transmit(std::vector<habit> const& habits)
    {
        byte_view const frame = link.poll_transmit();
        if (frame.empty()) {
            return;
        }
        frame_bytes const request{frame.begin(), frame.end()};
        std::string line = std::to_string(time) + " leaves";
        for (std::byte const each : request) {
            line += ' ' + std::to_string(to_u8(each));
        }
        habit const& now_is = habits[told.size() % habits.size()];
        told.push_back(line);
        std::uint32_t const end = time - start + office_line.characters(frame.size()).microseconds;
        to_come.emplace(end, frame_bytes{});
        if (not now_is.is_silent) {
            frame_bytes answer = response_to(request);
            if (now_is.is_damaged) {
                answer.back() ^= std::byte{1};
            }
            to_come.emplace(end + 1 + now_is.delay, answer);
        }
    }
    void begin(std::size_t index, unsigned count)
    {
        if (reads[index].settled()) {
            reads[index].left = count;
        }
    }
    void begin_stop()
    {
        if (not stop.has_request) {
            stop.note_stop();
            stop.wanted = effect::stopping;
            stop.has_request = true;
        }
    }
};

struct figures {
    unsigned long long visited{0};
    unsigned long long passes{0};
};

/// One random life of three buses. `may_be_silent`: units stay away, and the readers never pause.
void live(std::uint32_t seed, bool may_be_silent, figures& sums)
{
    test::random roll{seed};
    client_options const options{.response_timeout = microseconds(20'000U + roll.below(80'000)),
                                 .late_response = microseconds(roll.below(30'000)),
                                 .retries = static_cast<std::uint8_t>(roll.below(3))};
    bus_options const share{static_cast<std::uint8_t>(1 + roll.below(100)), static_cast<std::uint8_t>(roll.below(4))};
    world<waker> every{false, options, share};
    world<sleeper> all{false, options, share};
    world<sleeper> asking{true, options, share};
    auto const each = [&](auto what) {
        what(every);
        what(all);
        what(asking);
    };
    std::vector<habit> habits(64);
    for (habit& one : habits) {
        one = {roll.below(roll.below(4) == 0 ? 120'000 : 15'000), may_be_silent and roll.below(3) == 0,
               roll.below(20) == 0};
    }
    for (std::size_t i = 0; i < readers; ++i) {
        slot_options const as{.with = {.response_timeout = options.response_timeout, .retries = options.retries},
                              .least_idle = microseconds(roll.below(2) * roll.below(60'000))};
        unsigned const count = may_be_silent ? 1'000'000 : roll.below(4);
        each([&](auto& one) {
            one.link.set(i, as);
            one.begin(i, count);
        });
    }
    for (unsigned i = 0; i < 400; ++i) {
        std::uint32_t length = roll.below(3) == 0 ? roll.below(3'000) : roll.below(300);
        if (deadline const next = every.link.poll_deadline(); next and roll.below(2) == 0) {
            bool const is_over = reached(every.now(), *next);
            length = is_over ? 0 : (*next - every.now()).microseconds;
            length = length > 20'000 ? 20'000 : length;
        }
        if (not may_be_silent and roll.below(12) == 0) {
            auto const index = static_cast<std::size_t>(roll.below(readers));
            unsigned const count = 1 + roll.below(5);
            each([&](auto& one) { one.begin(index, count); });
        }
        if (roll.below(150) == 0) {
            each([](auto& one) { one.begin_stop(); });
        }
        each([&](auto& one) { one.pass(length, habits); });
        REQUIRE(every.link.poll_deadline() == all.link.poll_deadline());
        REQUIRE(every.link.poll_deadline() == asking.link.poll_deadline());
    }
    REQUIRE(every.told == all.told);
    REQUIRE(every.told == asking.told);
    REQUIRE(every.visited == every.passes);
    sums.visited += asking.visited;
    sums.passes += asking.passes;
}

} // namespace

TEST_CASE("leaving out the visits where nobody has a turn changes nothing that leaves, nor when")
{
    figures sums{};
    for (std::uint32_t seed = 1; seed <= 300; seed += test::one_in(7)) {
        CAPTURE(seed);
        live(seed, false, sums);
    }
    CHECK(sums.visited * 10 < sums.passes * 9);
    CHECK(sums.visited * 10 > sums.passes);
}

TEST_CASE("nor where units stay silent")
{
    figures sums{};
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        live(seed, true, sums);
    }
    CHECK(sums.visited * 10 < sums.passes * 9);
}
