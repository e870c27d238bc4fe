// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A program that is stopped twice between two passes: it comes back, calls one function of its client, and is stopped again
// before the next pass. What that call began is over then, and no time of it lies ahead.
#include "client_line.hpp"
#include "long_pauses.hpp"

#include "support/catch.hpp"

#include <memory>
#include <string_view>
#include <type_traits>

#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr client_options once{.response_timeout = milliseconds(100), .late_response = milliseconds(30), .retries = 0};

/// Where the request of the conversation is that asked before the pause.
enum class stage { none, waiting, ready, handed_out, leaving, awaiting, answered };
constexpr stage all_stages[]{stage::none,    stage::waiting,  stage::ready,   stage::handed_out,
                             stage::leaving, stage::awaiting, stage::answered};

/// What is called between the pauses.
enum class call { nothing, cancel, cancel_own, sent, receive, receive_error, release, release_all };
constexpr call all_calls[]{call::nothing, call::cancel,        call::cancel_own, call::sent,
                           call::receive, call::receive_error, call::release,    call::release_all};

template <typename Link> struct desk {
    Link link{office_line, once};
    std::uint64_t time{0xFFFF'FFFFU - 5'000'000U};

    desk()
    {
        pass(0);
        pass(second);
    }
    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    void pass(std::uint64_t length)
    {
        time += length;
        link.advance(now());
    }
    void visit(std::size_t slot, series& conversation)
    {
        if constexpr (requires { link.converse(slot, conversation, now()); }) {
            link.converse(slot, conversation, now());
        } else {
            link.converse(conversation, now());
        }
    }
    void bring_to(stage wanted, series& conversation)
    {
        if (wanted == stage::none) {
            return;
        }
        if (wanted == stage::waiting) {
            link.receive(std::byte{0}, now()); // the line is not silent
        }
        visit(0, conversation);
        if (wanted <= stage::ready) {
            return;
        }
        REQUIRE_FALSE(link.poll_transmit().empty());
        if (wanted == stage::handed_out) {
            return;
        }
        pass(1'000);
        if (wanted == stage::leaving) {
            return;
        }
        time += 10'000;
        link.sent(now());
        pass(1'000);
        if (wanted == stage::answered) {
            link.receive(response_to(conversation.frame), now());
        }
    }
    void make(call what, series& conversation)
    {
        switch (what) {
        case call::nothing: return;
        case call::cancel: return link.cancel(now());
        case call::cancel_own: return link.cancel(conversation, now());
        case call::sent: return link.sent(now() + office_line.characters(8));
        case call::receive: return link.receive(response_to(read_of(1, 3201)), now());
        case call::receive_error: return link.receive_error(now());
        case call::release:
            if constexpr (not std::is_same_v<Link, client>) {
                link.release(unit_id{1});
            }
            return;
        case call::release_all:
            if constexpr (not std::is_same_v<Link, client>) {
                link.release_all();
            }
            return;
        }
    }
    /// Sleeps as long as the client says, and no longer than to `end`.
    void sleep(std::uint64_t end)
    {
        deadline const next = link.poll_deadline();
        std::uint64_t const ahead = next and not reached(now(), *next) ? (*next - now()).microseconds : 0;
        pass(next ? std::min(ahead, end - time) : end - time);
    }
    /// How long a conversation of one request takes until its unit has answered; at most 5 s.
    std::uint64_t time_for(std::size_t slot, series& conversation, frame_bytes& first)
    {
        std::uint64_t const start = time;
        std::uint64_t const end = start + 5 * second;
        for (unsigned passes = 0; passes < 1'000 and time < end and conversation.answered == 0; ++passes) {
            visit(slot, conversation);
            if (conversation.answered != 0) {
                break;
            }
            if (byte_view const left = link.poll_transmit(); not left.empty()) {
                frame_bytes const frame{left.begin(), left.end()};
                first = first.empty() ? frame : first;
                time += office_line.characters(frame.size()).microseconds;
                link.sent(now());
                time += 10'000;
                link.receive(response_to(frame), now());
                pass(10'000);
            } else {
                sleep(end);
            }
        }
        return conversation.answered == 0 ? 5 * second : time - start;
    }
};

/// Whether a conversation with the same unit, or with another one, is answered in the time that it would take behind a
/// minute, and no earlier request leaves.
template <typename Link> void is_as_behind_a_minute(std::uint64_t first, std::uint64_t then)
{
    for (stage const before : all_stages) {
        for (call const what : all_calls) {
            for (unsigned const unit : {1U, 2U}) {
                INFO("stage " << static_cast<int>(before) << ", call " << static_cast<int>(what) << ", unit " << unit
                              << ", pauses of " << first / second << " s and " << then / second << " s");
                desk<Link> it;
                auto old = std::make_unique<series>([](unsigned) { return read_of(1, 3201); }, 1);
                it.bring_to(before, *old);
                it.time += first;
                it.make(what, *old);
                old.reset();
                it.time += then;
                it.pass(0);
                series next{[=](unsigned) { return read_of(unit, 8602); }, 1};
                frame_bytes left;
                CHECK(it.time_for(1, next, left) < second);
                CHECK(left == read_of(unit, 8602));
            }
        }
    }
}

template <typename Link> void is_as_behind_a_minute()
{
    for (std::uint64_t const first : long_pauses) {
        for (std::uint64_t const then : long_pauses) {
            is_as_behind_a_minute<Link>(first, then);
        }
    }
}

} // namespace

TEST_CASE("defect: A6 what one call began between two pauses is over behind them, whatever they are")
{
    is_as_behind_a_minute<client>();
    is_as_behind_a_minute<drive_client<2>>();
    is_as_behind_a_minute<bus<2>>();
}

TEST_CASE("defect: A6 a call lets time pass first behind more than 2^20 us, and not where its time is up to 100 ms "
          "older than the latest pass")
{
    constexpr std::int64_t longest_pass = 1 << 20, latency = 100'000;
    struct {
        std::int64_t behind; ///< the latest pass
        bool passes;
    } const calls[]{{longest_pass - 1, false}, {longest_pass + 1, true}, {-latency, false}, {-latency - 1, true}};
    for (auto const& [behind, passes] : calls) {
        for (bool const is_cancel : {true, false}) {
            INFO((is_cancel ? "cancel, " : "sent, ") << behind << " us behind the latest pass");
            desk<client> it;
            series old{[](unsigned) { return read_of(1, 3201); }, 1};
            it.bring_to(stage::handed_out, old);
            instant const pass = it.now();
            it.link.hold(unit_id{5}, pass + milliseconds(behind < 0 ? 10'000 : 1'000)); // it is over behind the pause
            instant const at{pass.microseconds + static_cast<std::uint32_t>(behind)};
            is_cancel ? it.link.cancel(at) : it.link.sent(behind < 0 ? at : at + office_line.characters(8));
            CHECK(it.link.is_held(unit_id{5}) != passes);
        }
    }
}

TEST_CASE("defect: A6 no time passes by a call before the first pass")
{
    client link{office_line, once};
    series old{[](unsigned) { return read_of(1, 3201); }, 1};
    link.hold(unit_id{5}, instant{1'000'000});
    link.converse(old, instant{0});
    REQUIRE(link.is_busy());
    link.cancel(instant{1'500'000});
    CHECK(link.is_held(unit_id{5}));
}
