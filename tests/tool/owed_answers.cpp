// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a unit owes, of one that answers in the order in which it was asked, and of one that does not.
#include "line/owed_answers.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "frame/frame_fit.hpp"
#include "support/byte_list.hpp"
#include "support/catch.hpp"

using namespace rtuwire;
using rtuwire::test::bytes_of;
using tool::owed_answers;

namespace {

using frame_bytes = std::vector<std::byte>;

frame_bytes frame(std::string const& pdu) { return tool::frame_of(std::byte{1}, bytes_of(pdu)); }

frame_bytes const slow = frame("03 00 10 00 02"); // two registers
frame_bytes const slow_answer = frame("03 04 00 10 00 11");
frame_bytes const fast = frame("03 00 40 00 02"); // two others
frame_bytes const fast_answer = frame("03 04 00 40 00 41");
frame_bytes const mark = frame("04 00 00 00 01");
frame_bytes const mark_answer = frame("04 02 00 00");

struct line {
    owed_answers owed{};

    line() { owed.begin(client_options{.response_timeout = milliseconds(500)}, false); }

    void asks(frame_bytes const& asked) { owed.note({.bytes = asked, .at = instant{0}, .is_own = true}); }
    void hears(frame_bytes const& frame, frame_verdict as)
    {
        owed.note({.bytes = frame, .at = instant{0}, .verdict = as});
    }
    /// The slow one has no answer yet, and the mark behind it has.
    void passes_over()
    {
        asks(slow);
        asks(mark);
        hears(mark_answer, frame_verdict::good);
    }
};

} // namespace

TEST_CASE("owed: in its order a unit owes nothing that was asked before what it has answered")
{
    line on;
    on.asks(slow);
    CHECK(on.owed.hides(fast));
    CHECK_FALSE(on.owed.hides(mark));
    on.passes_over();
    CHECK_FALSE(on.owed.hides(fast));
}

TEST_CASE("owed: behind an answer that was taken for lost nobody knows what is owed: nothing is asked for a while")
{
    for (bool const was_taken_for_another : {false, true}) {
        INFO(was_taken_for_another);
        line on;
        on.passes_over();
        if (was_taken_for_another) { // the slow answer ends the fast request, and the fast one's comes behind
            on.asks(fast);
            on.hears(slow_answer, frame_verdict::good);
            on.hears(fast_answer, frame_verdict::stray);
        } else {
            on.hears(slow_answer, frame_verdict::stray);
        }
        CHECK(on.owed.hides(fast));
        CHECK(on.owed.hides(mark));
        CHECK_FALSE(on.owed.hides(frame("06 00 01 00 00"))); // a write says what it wrote
        CHECK(on.owed.rests_until(std::byte{1}) > owed_answers::clock::now());
        CHECK(on.owed.rests_until(std::byte{2}) < owed_answers::clock::now()); // another one
    }
}

TEST_CASE("owed: a request that is not sent ends as what came in the place of its marks, where that was no frame")
{
    struct conversation {
        std::vector<errc>* outcomes;

        std::optional<request_frame> next() { return request_frame{fast, repetition::never}; }
        void accept(result<response> const& outcome) { outcomes->push_back(outcome.error()); }
    };
    for (errc const heard : {errc::timed_out, errc::line_echo, errc::crc_mismatch, errc::frame_too_short,
                             errc::response_mismatch, errc::wrong_function}) {
        for (std::size_t const at : {0U, 2U}) {
            CAPTURE(heard, at);
            line on;
            on.asks(slow);
            std::vector<errc> outcomes;
            tool::in_step<conversation> asked{on.owed, {&outcomes}, 3};
            for (unsigned each = 0; each < 2; ++each) { // the second one heard nothing
                for (std::size_t i = 0; i < 3; ++i) {
                    REQUIRE(outcomes.size() == each);
                    REQUIRE_FALSE(std::ranges::equal(asked.next()->frame(), fast));
                    asked.accept(i == at and each == 0 ? heard : errc::timed_out);
                }
            }
            bool const is_reason = heard != errc::response_mismatch and heard != errc::wrong_function;
            CHECK(outcomes == std::vector<errc>{is_reason ? heard : errc::timed_out, errc::timed_out});
        }
    }
}

TEST_CASE("owed: answers that came in one lump are taken one by one")
{
    line on;
    on.asks(slow);
    on.asks(mark);
    frame_bytes lump = slow_answer;
    lump.insert(lump.end(), mark_answer.begin(), mark_answer.end());
    on.hears(lump, frame_verdict::stray);
    CHECK_FALSE(on.owed.hides(fast));
    CHECK_FALSE(on.owed.hides(mark));
}

TEST_CASE("owed: a late answer to what was passed over is not taken for that to the same again")
{
    line on;
    on.passes_over();
    on.asks(slow); // again
    on.hears(slow_answer, frame_verdict::late);
    on.asks(mark);
    on.hears(mark_answer, frame_verdict::good);
    CHECK(on.owed.hides(fast)); // the mark pays for nothing any more
}

TEST_CASE("owed: an answer that comes twice shows no other order where nothing was taken for lost")
{
    line on;
    on.asks(fast);
    on.hears(fast_answer, frame_verdict::good);
    on.hears(fast_answer, frame_verdict::stray);
    on.passes_over();
    CHECK_FALSE(on.owed.hides(fast));
}

TEST_CASE("owed: what comes while nobody waits is an answer, whole, in parts or beside others")
{
    frame_bytes both = slow_answer;
    both.insert(both.end(), mark_answer.begin(), mark_answer.end());
    frame_bytes noise{std::byte{0x55}};
    noise.insert(noise.end(), slow_answer.begin(), slow_answer.end());
    for (frame_bytes const& all : {slow_answer, noise, both}) {
        for (std::size_t part = 1; part <= all.size(); ++part) {
            CAPTURE(all.size(), part);
            line on;
            on.asks(slow);
            for (std::size_t at = 0; at < all.size(); at += part) {
                on.owed.note_unawaited(byte_view{all}.subspan(at, std::min(part, all.size() - at)));
            }
            CHECK_FALSE(on.owed.hides(fast)); // it owes nothing more

            line other; // where the slow answer was taken for lost it tells that the order is none
            other.passes_over();
            CHECK_FALSE(other.owed.hides(fast));
            for (std::size_t at = 0; at < all.size(); at += part) {
                other.owed.note_unawaited(byte_view{all}.subspan(at, std::min(part, all.size() - at)));
            }
            CHECK(other.owed.hides(fast));
        }
    }
    line on;
    on.asks(slow);
    on.owed.note_unawaited(frame("04 02 00 00"));
    on.owed.note_unawaited(frame_bytes{std::byte{1}, std::byte{3}, std::byte{0}});
    CHECK(on.owed.hides(fast));
}

TEST_CASE("owed: the answer by another function shows nothing of an answer that may come yet")
{
    line on;
    on.asks(slow);
    on.asks(mark);
    on.hears(mark_answer, frame_verdict::good);
    CHECK_FALSE(on.owed.hides(fast)); // as far as a unit in order goes
    auto const may_come = on.owed.functions_owed(std::byte{1});
    REQUIRE(may_come.contains(std::byte{3}));
    CHECK(may_come.at(std::byte{3}) > owed_answers::clock::now() + std::chrono::seconds{1});
    CHECK_FALSE(may_come.contains(std::byte{4}));
    CHECK(on.owed.functions_owed(std::byte{2}).empty());
    SECTION("until it comes")
    {
        on.hears(slow_answer, frame_verdict::stray);
        CHECK_FALSE(on.owed.functions_owed(std::byte{1}).contains(std::byte{3}));
    }
}
