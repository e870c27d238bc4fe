// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server and a listener on a line on which nothing happens for any time, or whose program was stopped: what comes then
// is heard and answered as by one that is new.
#include "client_line.hpp"
#include "long_pauses.hpp"

#include "support/catch.hpp"

#include <algorithm>
#include <deque>

#include <rtuwire/server/blocking.hpp>
#include <rtuwire/trace/line_listener.hpp>

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

/// A server whose loop sleeps until its deadline, or until a byte arrives where it names none.
template <typename Node> struct sleeper {
    Node node;
    word_bank<1>& bank;
    std::uint64_t time{0xFFFF'FFFFU - 3'000'000U};
    unsigned answers{0};
    unsigned wakes{0};

    sleeper(Node made, word_bank<1>& its_bank) : node{made}, bank{its_bank}
    {
        pass();
        sleep(10'000);
    }
    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    void pass()
    {
        if constexpr (requires { node.serve(bank, now()); }) {
            node.serve(bank, now());
        } else {
            node.serve(now());
        }
        if (byte_view const frame = node.poll_transmit(); not frame.empty()) {
            ++answers;
            time += office_line.characters(frame.size()).microseconds;
            node.sent(now());
        }
    }
    void sleep(std::uint64_t length)
    {
        std::uint64_t const end = time + length;
        while (deadline const due = node.poll_deadline()) {
            auto const left = static_cast<std::int32_t>(due->microseconds - now().microseconds);
            std::uint64_t const next = time + static_cast<std::uint64_t>(std::max(left, 1));
            if (next > end) {
                break;
            }
            time = next;
            pass();
            ++wakes;
        }
        time = end;
    }
    /// One byte after the other, as an interrupt hands them over.
    void hear(frame_bytes const& frame)
    {
        for (std::byte const each : frame) {
            time += office_line.characters(1).microseconds;
            node.receive(each, now());
            pass();
        }
    }
};

/// The answer to a request after such a pause; how long it took, 0 for none.
template <typename Node> std::uint64_t answer_after(std::uint64_t pause, bool was_asked, Node made, word_bank<1>& bank)
{
    sleeper<Node> it{made, bank};
    if (was_asked) {
        it.hear(read_of(1, 0));
        it.sleep(50'000);
        REQUIRE(it.answers == 1);
    }
    unsigned const before = it.answers;
    it.wakes = 0;
    it.sleep(pause);
    CHECK(it.wakes <= 1);
    std::uint64_t const start = it.time;
    it.hear(read_of(1, 0));
    while (it.answers == before and it.time < start + 100'000) {
        it.sleep(100);
    }
    return it.answers == before ? 0 : it.time - start;
}

} // namespace

TEST_CASE("defect: D24 a server that sleeps until its deadline hears the next request after any time")
{
    word_bank<1> bank{};
    for (bool const was_asked : {false, true}) {
        std::uint64_t const usual = answer_after(1'000'000, was_asked, server{unit_id{1}, office_line}, bank);
        REQUIRE(usual != 0);
        for (std::uint64_t const pause : long_pauses) {
            INFO("silent for " << pause << " us, asked before: " << was_asked);
            CHECK(answer_after(pause, was_asked, server{unit_id{1}, office_line}, bank) == usual);
            CHECK(answer_after(pause, was_asked,
                               server::for_units(office_line, bank_at{unit_id{1}, bank}, bank_at{unit_id{4}, bank}),
                               bank) == usual);
        }
    }
}

TEST_CASE("defect: D24 a request that silence ended is as old as that: a server drops it where its time is over")
{
    word_bank<1> bank{};
    frame_bytes const request = framed({1, 100, 7}); // nothing but silence tells its end
    for (std::uint64_t const pause : long_pauses) {
        INFO("not called for " << pause << " us");
        sleeper<server> it{server{unit_id{1}, office_line}, bank};
        it.node.receive(request, it.now());
        it.time += pause;
        it.node.advance(it.now());
        CHECK_FALSE(it.node.is_asked());
        deadline const next = it.node.poll_deadline();
        CHECK((not next or reached(it.now(), *next)));
    }
    sleeper<server> in_time{server{unit_id{1}, office_line}, bank};
    in_time.node.receive(request, in_time.now());
    in_time.time += 50'000;
    in_time.node.advance(in_time.now());
    CHECK(in_time.node.is_asked());
}

namespace {

/// The port of a server; its clock is moved on by hand.
struct far_port {
    std::uint64_t time{0xFFFF'FFFFU - 3'000'000U};
    std::deque<std::pair<std::uint64_t, std::byte>> coming{};
    std::vector<std::uint64_t> answers{};

    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    void send(frame_bytes const& frame)
    {
        std::uint64_t at = time;
        for (std::byte const each : frame) {
            at += office_line.characters(1).microseconds;
            coming.emplace_back(at, each);
        }
    }
    result<void> write(byte_view bytes, instant)
    {
        answers.push_back(time);
        time += office_line.characters(bytes.size()).microseconds;
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        auto const left = static_cast<std::int32_t>(until.microseconds - now().microseconds);
        std::uint64_t const end = time + static_cast<std::uint64_t>(std::max(left, 0));
        time = coming.empty() or coming.front().first > end ? end : std::max(time, coming.front().first);
        std::size_t count = 0;
        while (not coming.empty() and coming.front().first <= time) {
            place[count++] = coming.front().second;
            coming.pop_front();
        }
        return place.first(count);
    }
};

enum class left_behind { nothing, half_a_frame, a_response };

/// How long the answer to a request takes after a pause in which nobody called the server; 0 for none.
std::uint64_t served_after(std::uint64_t pause, left_behind what)
{
    far_port port;
    server node{unit_id{1}, office_line};
    word_bank<1> bank{};
    auto const serve_for = [&](std::uint64_t length) {
        for (std::uint64_t const end = port.time + length; port.time < end;) {
            REQUIRE(serve_once(node, port, bank, microseconds(end - port.time)));
        }
    };
    serve_for(100'000);
    port.send(read_of(1, 0));
    serve_for(50'000);
    REQUIRE(port.answers.size() == 1);
    if (what == left_behind::half_a_frame) {
        port.send({std::byte{1}, std::byte{3}, std::byte{0}});
        serve_for(2'000);
    } else if (what == left_behind::a_response) {
        port.send(read_of(1, 0));
        while (node.poll_deadline() == deadline{} or not port.coming.empty()) {
            REQUIRE(serve_once(node, port, bank, microseconds(100)));
        }
        REQUIRE(port.answers.size() == 1);
    }
    port.time += pause;
    serve_for(50'000);
    CHECK(port.answers.size() == 1); // an hour later its client does not wait for that one
    std::uint64_t const start = port.time;
    port.send(read_of(1, 0));
    serve_for(50'000);
    return port.answers.size() == 1 ? 0 : port.answers.back() - start;
}

} // namespace

TEST_CASE("defect: D24 a server that nobody called for any time answers the next request, and no old one")
{
    std::uint64_t const usual = served_after(1'000'000, left_behind::nothing);
    REQUIRE(usual != 0);
    for (std::uint64_t const pause : long_pauses) {
        for (left_behind const what : {left_behind::nothing, left_behind::half_a_frame, left_behind::a_response}) {
            INFO("not called for " << pause << " us, left behind " << static_cast<int>(what));
            CHECK(served_after(pause, what) == usual);
        }
    }
}

namespace {

/// A listener that is called at its deadlines, or, where its program is stopped, only when bytes come.
struct heard_line {
    line_listener tap{office_line};
    std::uint64_t time{0xFFFF'FFFFU - 3'000'000U};
    std::vector<frame_verdict> verdicts{};
    std::vector<frame_role> roles{};

    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    auto note()
    {
        return [this](heard_frame const& it) {
            if (not it.is_unanswered) {
                verdicts.push_back(it.frame.verdict);
                roles.push_back(it.frame.role);
            }
        };
    }
    void hear(frame_bytes const& frame)
    {
        time += office_line.characters(frame.size()).microseconds;
        tap.receive(frame, now(), note());
    }
    void pass(std::uint64_t length, bool is_stopped)
    {
        std::uint64_t const end = time + length;
        while (not is_stopped and time < end) {
            std::uint64_t next = end;
            if (deadline const due = tap.poll_deadline()) {
                auto const left = static_cast<std::int32_t>(due->microseconds - now().microseconds);
                next = std::min(next, time + static_cast<std::uint64_t>(std::max(left, 1)));
            }
            time = next;
            tap.advance(now(), note());
        }
        time = end;
    }
};

} // namespace

TEST_CASE("defect: D24 a listener forgets a damaged byte, and a request without a response, after any time")
{
    for (std::uint64_t const pause : long_pauses) {
        for (bool const is_stopped : {false, true}) {
            INFO("nothing for " << pause << " us, stopped: " << is_stopped);
            heard_line it;
            it.pass(100'000, false);
            it.tap.receive_error(it.now(), it.note());
            it.pass(pause, is_stopped);
            it.hear(read_of(1, 7));
            it.pass(5'000, false);
            it.hear(response_to(read_of(1, 7)));
            it.pass(5'000, false);
            CHECK(it.verdicts == std::vector{frame_verdict::good, frame_verdict::good});

            it.hear(read_of(1, 7));
            it.pass(1'000'000, false);
            it.pass(pause, is_stopped);
            it.hear(response_to(read_of(1, 7)));
            it.pass(5'000, false);
            // Where nobody looked meanwhile, only the clock tells how long it was.
            bool const may_be_late = (is_stopped ? pause % (std::uint64_t{1} << 32U) : pause) < 35 * minute;
            CHECK(it.verdicts.back() == (may_be_late ? frame_verdict::late : frame_verdict::stray));
        }
    }
}
