// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a client says to a unit that is ordered and does not answer: docs/engine-rules.md, rules 40 and 41, to the
// microsecond.
#include "client/command_desk.hpp"

#include "support/catch.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_freewheel.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr std::uint64_t words = 2'000'000;
constexpr std::uint64_t silence = 6'000'000; ///< of a drive whose time-out is 5 s

/// One unit that ran and was lost just now.
struct loss {
    command_desk<2> it{};
    hand_commander one;
    std::uint64_t begun;

    explicit loss(unsigned unit = 3) : one{unit}
    {
        REQUIRE(it.runs(one) == errc::none);
        begun = it.misses(one, effect::enabling);
        REQUIRE(it.is_lost(unit));
    }
    /// Whether a read of a unit leaves.
    bool reads(unsigned unit)
    {
        return leaves(series{[=](unsigned) { return read_of(unit, 3'201); }, 1});
    }
    /// It comes by twice, for its turn.
    bool leaves(series conversation)
    {
        it.link.converse(conversation, it.now());
        it.link.converse(conversation, it.now());
        return it.leaves();
    }
};

/// Words that stop it leave up to the microsecond before `end`, and no later.
void check_words_until(loss& of, hand_commander& who, std::uint64_t end)
{
    of.it.pass_until(end - 1 - office_line.characters(8).microseconds - 200'000);
    REQUIRE(of.it.misses(who, effect::stopping) == end - 1);
    of.it.see(who);
    CHECK_FALSE(who.is_silenced());
    of.it.pass(1);
    of.it.see(who);
    CHECK(who.is_silenced());
    CHECK_FALSE(of.it.says(who, effect::stopping));
}

void check_silence_until(loss& of, unit_id unit, std::uint64_t end)
{
    of.it.pass_until(end - 1);
    CHECK(of.it.link.is_held(unit));
    CHECK(of.it.is_lost(unit.byte()));
    CHECK_FALSE(of.reads(unit.byte()));
    of.it.pass(1);
    CHECK_FALSE(of.it.link.is_held(unit));
    CHECK_FALSE(of.it.is_lost(unit.byte()));
    CHECK(of.reads(unit.byte()));
}

} // namespace

TEST_CASE("rule 40: words that stop it go to a lost unit for 2 s, nothing else does")
{
    for (unsigned const unit : {1U, 3U}) {
        loss of{unit};
        CHECK_FALSE(of.reads(unit));
        CHECK(of.it.does(of.one, effect::enabling) == errc::unit_lost);
        check_words_until(of, of.one, of.begun + words);
        CHECK(of.reads(unit == 1 ? 3 : 1)); // others hear everything
    }
}

TEST_CASE("rule 40: silence lasts for the drive's time-out and 1 s from the last request without "
          "a response")
{
    for (bool const has_word : {false, true}) {
        loss of;
        std::uint64_t const last = has_word ? of.it.misses(of.one, effect::stopping) : of.begun;
        REQUIRE(last != 0);
        check_silence_until(of, unit_id{3}, last + silence);
    }
}

TEST_CASE("rule 40: the client wakes up when the words are over and when the silence is")
{
    loss of;
    of.it.pass(0); // the one that its last outcome asks for
    CHECK(of.it.link.poll_deadline() == instant{static_cast<std::uint32_t>(of.begun + words)});
    of.it.pass_until(of.begun + words);
    CHECK(of.it.link.poll_deadline() == instant{static_cast<std::uint32_t>(of.begun + silence)});
    of.it.pass_until(of.begun + silence);
    CHECK_FALSE(of.it.link.poll_deadline());
}

TEST_CASE("rule 40: who was held back by the silence has a turn when it is over")
{
    for (bool const is_waiting : {false, true}) {
        loss of;
        command_desk<2>& it = of.it;
        series other{[](unsigned) { return read_of(3, 3'201); }}, third{[](unsigned) { return read_of(4, 3'201); }};
        if (is_waiting) {
            it.link.converse(other, it.now());
            REQUIRE_FALSE(it.link.is_busy());
        }
        it.pass_until(of.begun + silence);
        it.link.receive(frame_bytes{std::byte{0x55}}, it.now());
        it.link.converse(third, it.now());
        CHECK(it.link.is_busy() == not is_waiting); // while others wait, nobody asks before the line is quiet
    }
}

TEST_CASE("rule 40: a response ends the loss at once, the order stays gone")
{
    loss of;
    CHECK(of.it.does(of.one, effect::stopping) == errc::none);
    CHECK_FALSE(of.it.is_lost(3));
    CHECK(of.it.does(of.one, effect::none) == errc::none);
    CHECK(of.it.does(of.one, effect::enabling) == errc::unit_lost);
    CHECK(of.it.is_ordered(3));
    CHECK(of.it.runs(of.one) == errc::none);
}

TEST_CASE("rule 40: every commander of a lost unit is told, also one that comes by for the first time")
{
    command_desk<1> it;
    hand_commander one{3}, late{3}, apart{4};
    CHECK_FALSE(late.is_silenced());
    REQUIRE(it.misses(one, effect::resetting) != 0);
    REQUIRE(it.is_lost(3));
    for (hand_commander* const each : {&one, &late, &apart}) {
        it.see(*each);
        it.see(*each);
        CHECK(each->losses == (each == &apart ? 0 : 1));
    }
}

TEST_CASE("rule 40: a stop that begins behind a loss has 2 s from its first word on, however long it has not said it")
{
    loss of;
    hand_commander other{3};
    of.it.pass(2'500'000);
    CHECK_FALSE(of.it.says(of.one, effect::stopping));
    other.note_stop();
    for (unsigned i = 0; i < 3; ++i) {
        of.it.see(other);
        CHECK_FALSE(other.is_silenced());
        of.it.pass(900'000);
    }
    std::uint64_t const begin = of.it.time;
    REQUIRE(of.it.misses(other, effect::stopping) != 0);
    of.it.see(other);
    check_words_until(of, other, begin + words);
}

TEST_CASE("rule 40: a stop of all that begins behind a loss has 2 s for its words, however often it comes by")
{
    loss of;
    hand_commander other{3};
    hand_for_all all{9};
    of.it.pass(3'000'000);
    std::uint64_t const begin = of.it.time;
    all.note_stop();
    for (unsigned i = 0; i < 2; ++i) {
        of.it.see(all);
        of.it.see(other);
        of.it.pass(500'000);
    }
    check_words_until(of, other, begin + words);
}

TEST_CASE("rule 40: of a unit that was not ordered here its type tells how long it is left alone")
{
    for (bool const is_for_all : {false, true}) {
        command_desk<1> it;
        hand_commander one{3};
        hand_for_all all{3};
        if (is_for_all) {
            all.note_stop();
            all.each[0].note_stop();
            all.to = 3;
            REQUIRE(it.says(all));
            it.fail(all);
        } else {
            one.note_stop();
            REQUIRE(it.misses(one, effect::stopping) != 0);
        }
        REQUIRE(it.is_lost(3));
        it.pass(silence - 1);
        CHECK(it.is_lost(3));
        it.pass(1);
        CHECK_FALSE(it.is_lost(3));
    }
}

TEST_CASE("rule 41: while a unit is lost a broadcast waits, but for one that stops everyone")
{
    loss of;
    series const writer{[](unsigned) { return write_of(0, 8'502, 300); }, 1};
    CHECK_FALSE(of.leaves(writer));
    of.it.pass(3'000'000); // words to the unit itself are over
    hand_for_all all{9};
    std::uint64_t const last = of.it.time;
    CHECK(of.it.says(all));
    of.it.fail(all);
    CHECK(all.told == errc::none);
    CHECK_FALSE(of.leaves(writer));
    of.it.pass_until(last + silence - 1);
    CHECK_FALSE(of.leaves(writer));
    of.it.pass(1);
    CHECK(of.leaves(writer));
}

TEST_CASE("rule 41: a broadcast that takes the power is sent while a unit is lost, and begins its silence anew")
{
    loss of;
    of.it.pass(3'000'000);
    auto all = altivar::broadcast_freewheel<altivar::atv320::device>();
    std::uint64_t const last = of.it.time;
    of.it.link.converse(all, of.it.now());
    REQUIRE(of.it.leaves());
    of.it.pass(100'000);
    of.it.link.converse(all, of.it.now());
    CHECK(all.outcome());
    check_silence_until(of, unit_id{3}, last + silence);
}

namespace {

/// A stop that says its word again as soon as it knows that the one before had no response.
struct repeated_stop : hand_commander {
    using hand_commander::hand_commander;
    void accept(result<response> const& outcome)
    {
        hand_commander::accept(outcome);
        has_request = true;
    }
};

} // namespace

TEST_CASE("rule 41: words to a lost unit do not keep back the broadcast that takes the power")
{
    for (bool const is_first : {false, true}) {
        INFO(is_first);
        loss of;
        repeated_stop stop{3};
        stop.note_stop();
        REQUIRE(of.it.says(stop, effect::stopping));
        auto all = altivar::broadcast_freewheel<altivar::atv320::device>();
        unsigned before = 0;
        bool is_freed = false;
        for (unsigned pass = 0; pass < 20 and not is_freed; ++pass) {
            if (is_first) {
                of.it.link.converse(all, of.it.now());
            }
            of.it.link.converse(stop, of.it.now());
            if (not is_first) {
                of.it.link.converse(all, of.it.now());
            }
            if (of.it.leaves()) {
                is_freed = of.it.left[0] == std::byte{0};
                before += is_freed ? 0 : 1;
            }
            of.it.pass(pass % 2 == 0 ? 120'000 : 100);
        }
        CHECK(is_freed);
        CHECK(before == 0);
    }
}

TEST_CASE("rule 41: the broadcast that takes the power lets a request that has left have its response, and is next")
{
    command_desk<2> it;
    series asked{[](unsigned) { return read_of(5, 3'201); }, 1}, waiting{[](unsigned) { return read_of(6, 3'201); }};
    it.link.converse(asked, it.now());
    REQUIRE(it.leaves());
    auto all = altivar::broadcast_freewheel<altivar::atv320::device>();
    it.pass(20'000);
    it.link.converse(waiting, it.now());
    it.link.converse(all, it.now());
    it.hear(response_to(it.left));
    it.link.converse(asked, it.now());
    CHECK(asked.answered == 1);
    it.link.converse(waiting, it.now()); // it came first
    CHECK_FALSE(it.leaves());
    it.link.converse(all, it.now());
    REQUIRE(it.leaves());
    CHECK(it.left[0] == std::byte{0});
    it.pass(100'000);
    it.link.converse(all, it.now());
    REQUIRE(all.outcome());
    for (unsigned request = 0; request < 3; ++request) { // once settled, it keeps nobody from the line
        it.link.converse(waiting, it.now());
        REQUIRE(it.leaves());
        it.link.converse(all, it.now());
        it.hear(response_to(it.left));
        it.link.converse(all, it.now());
        it.link.converse(waiting, it.now());
    }
    CHECK(waiting.answered == 3);
}

TEST_CASE("rule 40: a stop of all units loses those that are ordered and not among its drives, while it broadcasts")
{
    command_desk<3> it;
    hand_commander one{3}, other{4};
    REQUIRE(it.runs(one) == errc::none);
    REQUIRE(it.runs(other) == errc::none);
    hand_for_all all{4};
    all.note_stop();
    std::uint64_t const last = it.time;
    REQUIRE(it.says(all));
    CHECK((it.is_lost(3) and not it.is_lost(4)));
    it.fail(all);
    it.see(all);
    it.see(one);
    CHECK(one.losses == 1);
    CHECK_FALSE(one.is_silenced()); // words may go to it
    it.pass_until(last + silence - 1);
    CHECK(it.is_lost(3));
    it.pass(1);
    CHECK_FALSE(it.is_lost(3));
    CHECK((it.link.motor_orders().is_ordered(3) and it.link.motor_orders().is_ordered(4)));
}

namespace {

/// A unit that was ordered to run, in passes of 20 ms, each with a poll that is answered.
struct left_alone {
    command_desk<2> it{};
    hand_commander one{3};
    series poll{[](unsigned) { return read_of(3, 3'201); }};
    unsigned polls{0};

    left_alone() { REQUIRE(it.runs(one) == errc::none); }

    /// One poll, if it may leave. Returns whether it did.
    bool asks()
    {
        it.pass(10'000);
        poll.most = poll.number + 1;
        it.link.converse(poll, it.now());
        if (not it.leaves()) {
            it.link.cancel(it.now());
            return false;
        }
        it.hear(response_to(it.left));
        it.link.converse(poll, it.now());
        return true;
    }
    unsigned polls_in(std::uint64_t length)
    {
        unsigned count = 0;
        for (std::uint64_t const end = it.time + length; it.time < end;) {
            count += asks() ? 1U : 0U;
        }
        return count;
    }
};

} // namespace

TEST_CASE("rule 40: an ordered unit whose stop was given up is silent until its own time-out has stopped it")
{
    left_alone of;
    {
        hand_commander stop{3};
        stop.note_stop();
        of.it.see(stop); // its word never leaves
    }
    std::uint64_t const begun = of.it.time;
    CHECK(of.polls_in(500'000) > 10);
    static_cast<void>(of.polls_in(100'000));
    REQUIRE(of.it.is_lost(3));
    CHECK(of.it.link.is_held(unit_id{3}));
    CHECK(of.polls_in(silence - 200'000) == 0);
    of.it.pass_until(begun + 700'000 + words + silence);
    CHECK_FALSE(of.it.is_lost(3));
    CHECK(of.polls_in(1'000'000) > 20);           // it has stopped by itself
    CHECK(of.it.runs(of.one) == errc::overruled); // and is held up to a stop's end, or `release`
    of.it.link.release(unit_id{3});
    of.it.see(of.one);
    CHECK(of.it.runs(of.one) == errc::none);
}

TEST_CASE("rule 40: what else ends the order of a unit that is left does not put its loss off")
{
    left_alone of;
    of.one.tolerates = 1;
    REQUIRE(of.it.does(of.one, effect::enabling) == errc::none);
    hand_commander stop{3};
    stop.note_stop();
    of.it.see(stop);
    of.it.pass(600'000);
    for (unsigned pass = 0; pass < 4; ++pass) {
        of.it.pass(100);
    }
    constexpr std::uint64_t rare = 4'700'000; // of a drive whose time-out is 5 s
    auto const reads = [&](bool is_answered) {
        of.it.pass(rare);
        of.poll.most = of.poll.number + 1;
        of.it.link.converse(of.poll, of.it.now());
        REQUIRE(of.it.leaves());
        is_answered ? of.it.hear(response_to(of.it.left)) : of.it.pass(200'000);
        of.it.link.converse(of.poll, of.it.now());
    };
    REQUIRE(of.asks());
    reads(true);
    reads(false);
    of.it.pass(1'000'000); // behind its time-out
    REQUIRE_FALSE(of.it.is_lost(3));
    of.it.pass(0);
    reads(true);
    CHECK(of.it.is_lost(3));
}

TEST_CASE("rule 40: beside a stop that was given up another commander may stop its unit")
{
    left_alone of;
    {
        hand_commander stop{3};
        stop.note_stop();
        of.it.see(stop);
        CHECK(of.it.does(of.one, effect::stopping) == errc::overruled);
    }
    static_cast<void>(of.polls_in(600'000));
    REQUIRE(of.it.is_lost(3));
    CHECK(of.it.does(of.one, effect::stopping) == errc::none); // and is answered
    CHECK_FALSE(of.it.is_lost(3));
    CHECK(of.it.does(of.one, effect::enabling) == errc::overruled);
}

TEST_CASE("rule 40: a stop that comes by again holds its unit, however long it was away")
{
    left_alone of;
    hand_commander stop{3};
    stop.note_stop();
    of.it.see(stop);
    static_cast<void>(of.polls_in(600'000));
    REQUIRE(of.it.is_lost(3));
    of.it.see(stop);
    CHECK(of.it.does(of.one, effect::stopping) == errc::overruled);
    CHECK(of.it.does(stop, effect::stopping) == errc::none);
    CHECK_FALSE(of.it.is_lost(3));
    for (unsigned pass = 0; pass < 100; ++pass) {
        of.it.see(stop);
        CHECK(of.asks());
        CHECK_FALSE(of.it.is_lost(3));
    }
}

TEST_CASE("rule 40: a stop that visits in each pass is given up by no pause of the program")
{
    left_alone of;
    hand_commander stop{3};
    stop.note_stop();
    of.it.see(stop);
    of.it.pass(3'000'000);
    of.it.see(stop);
    CHECK_FALSE(of.it.is_lost(3));
    CHECK(of.it.does(of.one, effect::stopping) == errc::overruled);
}

TEST_CASE("rule 40: a stop of all units that is given up leaves each ordered unit silent")
{
    left_alone of;
    {
        hand_for_all all{9};
        all.note_stop();
        of.it.link.converse(all, of.it.now());
    }
    static_cast<void>(of.polls_in(600'000));
    CHECK(of.it.is_lost(3));
    CHECK(of.polls_in(silence - 200'000) == 0);
}

TEST_CASE("rule 40: reads keep no ordered unit running whose stop was released, or that was freed by a broadcast")
{
    enum class end { release, release_all, release_all_of_all, free_all };
    for (end const way : {end::release, end::release_all, end::release_all_of_all, end::free_all}) {
        CAPTURE(static_cast<int>(way));
        left_alone of;
        auto& orders = of.it.link.motor_orders();
        if (way == end::release_all_of_all) {
            hand_for_all all{9};
            all.note_stop();
            of.it.link.converse(all, of.it.now());
        } else if (way != end::free_all) {
            hand_commander stop{3};
            stop.note_stop();
            of.it.see(stop);
        }
        if (way == end::release) {
            orders.release(3);
        } else if (way == end::free_all) {
            orders.note_all_freed();
        } else {
            orders.release_all();
        }
        CHECK(of.polls_in(1'000'000) == 3);
        CHECK(of.it.is_lost(3));
        CHECK_FALSE(of.one.is_in_force());
    }
}

TEST_CASE("rule 40: reads keep no motor running whose order another one replaced that sent no word")
{
    left_alone of;
    hand_commander other{3};
    other.note_order_to_run();
    other.goes_on = true;
    for (unsigned pass = 0; pass < 20; ++pass) { // it looks at the drive
        of.it.see(other);
        CHECK(of.asks());
    }
    CHECK_FALSE(of.it.is_lost(3));
    SECTION("it enables the unit, and holds it")
    {
        REQUIRE(of.it.does(other, effect::enabling) == errc::none);
        other.goes_on = false;
        CHECK(of.polls_in(1'000'000) > 20);
        CHECK_FALSE(of.it.is_lost(3));
    }
    SECTION("it ends, and comes by")
    {
        other.goes_on = false;
        unsigned polls = 0;
        for (unsigned pass = 0; pass < 20; ++pass) {
            of.it.see(other);
            polls += of.asks() ? 1U : 0U;
        }
        CHECK(polls == 2); // behind one that was answered since it went on
        CHECK(of.it.is_lost(3));
    }
    SECTION("it is gone")
    {
        CHECK(of.polls_in(1'000'000) == 2);
        CHECK(of.it.is_lost(3));
    }
}

TEST_CASE("rule 40: those who command keep no motor running by their reads that nobody's order or stop holds")
{
    constexpr unsigned most = 51; // each counts as five of 255
    left_alone of;
    hand_commander other{3};
    unsigned reads = 0;
    auto const reads_on = [&](auto prepare) {
        for (unsigned pass = 0; pass < 200 and not of.it.is_lost(3); ++pass) {
            prepare();
            of.it.pass(20'000);
            reads += of.it.does(other, effect::none) == errc::none ? 1U : 0U;
        }
    };
    SECTION("not one that orders nothing, behind a release")
    {
        hand_commander stop{3};
        stop.note_stop();
        of.it.see(stop);
        of.it.link.release(unit_id{3});
        reads_on([] {});
    }
    SECTION("not one that never ends, and whose order to run sends no word")
    {
        other.note_order_to_run();
        other.goes_on = true;
        reads_on([] {});
    }
    SECTION("not one that is ordered to run again and again, and sends no word")
    {
        reads_on([&] { other.note_order_to_run(); });
    }
    CHECK(reads == most);
    CHECK(of.it.is_lost(3));
}

TEST_CASE("rule 40: an order has enough reads before its first word, also beside a poll of its unit")
{
    left_alone of;
    hand_commander other{3};
    other.note_order_to_run();
    other.goes_on = true;
    for (unsigned look = 0; look < 40; ++look) {
        of.it.pass(20'000);
        REQUIRE(of.it.does(other, effect::none) == errc::none);
        REQUIRE(of.asks());
    }
    CHECK(of.it.does(other, effect::enabling) == errc::none);
    other.goes_on = false;
    for (unsigned look = 0; look < 100; ++look) { // its order holds it
        of.it.pass(20'000);
        REQUIRE(of.it.does(other, effect::none) == errc::none);
    }
    CHECK_FALSE(of.it.is_lost(3));
}

TEST_CASE("rule 40: behind a word that stops it, or behind the order before, 255 answers are counted, each to a "
          "commander five times")
{
    for (effect const first : {effect::none, effect::stopping}) {
        CAPTURE(static_cast<int>(first));
        left_alone of;
        hand_commander other{3};
        other.note_order_to_run();
        other.goes_on = true;
        for (unsigned look = 0; look < 50; ++look) {
            of.it.pass(20'000);
            REQUIRE(of.it.does(other, look == 0 ? first : effect::none) == errc::none);
            REQUIRE((look >= 4 or of.asks()));
        }
        CHECK_FALSE(of.it.is_lost(3)); // 254
        CHECK(of.asks());
        CHECK(of.it.is_lost(3));
    }
}

TEST_CASE("rule 40: who sends words that stop it may look between them")
{
    left_alone of;
    of.it.link.motor_orders().note_all_freed();
    hand_commander other{3};
    for (unsigned look = 0; look < 200; ++look) {
        of.it.pass(20'000);
        REQUIRE(of.it.does(other, look % 40 == 0 ? effect::stopping : effect::none) == errc::none);
    }
    CHECK_FALSE(of.it.is_lost(3));
}

TEST_CASE("rule 40: what a motor that was left has had of looks does not count behind a new order")
{
    left_alone of;
    hand_commander other{3};
    for (unsigned turn = 0; turn < 10; ++turn) {
        other.note_order_to_run();
        other.goes_on = true;
        for (unsigned look = 0; look < 20; ++look) {
            of.it.pass(20'000);
            REQUIRE(of.it.does(other, effect::none) == errc::none);
        }
        REQUIRE(of.it.does(other, effect::enabling) == errc::none);
    }
    CHECK_FALSE(of.it.is_lost(3));
}

TEST_CASE("rule 40: a stop that comes by again behind a release, or behind an absence, keeps its unit from being lost")
{
    for (bool const is_for_all : {false, true}) {
        for (bool const is_released : {false, true}) {
            CAPTURE(is_for_all, is_released);
            left_alone of;
            hand_commander stop{3};
            hand_for_all all{9};
            auto const visit = [&] {
                if (is_for_all) {
                    of.it.link.converse(all, of.it.now());
                } else {
                    of.it.see(stop);
                }
            };
            is_for_all ? all.note_stop() : stop.note_stop();
            visit();
            if (is_released) {
                of.it.link.motor_orders().release_all();
            } else {
                of.it.pass(600'000);
                for (unsigned pass = 0; pass < 4; ++pass) {
                    of.it.pass(100);
                }
            }
            visit();
            for (unsigned pass = 0; pass < 10; ++pass) {
                CHECK(of.asks());
                visit();
            }
            CHECK_FALSE(of.it.is_lost(3));
        }
    }
}

TEST_CASE("rule 41: an order stands where each request left within the drive's time-out, however late its response")
{
    left_alone of;
    REQUIRE(of.asks());
    for (unsigned i = 0; i < 20; ++i) {
        of.it.pass(4'880'000); // of a drive whose time-out is 5 s
        of.poll.most = of.poll.number + 1;
        of.it.link.converse(of.poll, of.it.now());
        REQUIRE(of.it.leaves());
        of.it.pass(60'000);
        of.it.hear(response_to(of.it.left));
        of.it.link.converse(of.poll, of.it.now());
        CHECK(of.one.is_in_force());
        CHECK_FALSE(of.it.is_lost(3));
    }
}

TEST_CASE("rule 41: where only the repetition of a request is answered, behind the time-out, the unit is lost")
{
    constexpr client_options repeating{
        .response_timeout = milliseconds(100), .turnaround = milliseconds(20), .late_response = {}, .retries = 1};
    // An order that was given since, and whose word was not sent yet, holds it no more than the one that is over.
    for (bool const is_ordered_anew : {false, true}) {
        command_desk<2> it{repeating};
        hand_commander one{3, 5};
        hand_commander another{3, 5};
        REQUIRE(it.runs(one) == errc::none);
        series poll{[](unsigned) { return read_of(3, 3'201); }};
        it.pass(4'950'000);
        it.link.converse(poll, it.now());
        REQUIRE(it.leaves());
        it.pass(110'000);
        it.link.converse(poll, it.now());
        it.pass(5'000);
        it.link.converse(poll, it.now());
        REQUIRE(it.leaves()); // the first one may not have reached it
        it.hear(response_to(it.left));
        it.link.converse(poll, it.now());
        CHECK_FALSE(one.is_in_force());
        if (is_ordered_anew) {
            another.note_order_to_run();
            it.see(another);
        }
        for (unsigned answered = 1; answered < 3; ++answered) { // a commander might look at its power
            CHECK_FALSE(it.is_lost(3));
            it.pass(300'000);
            it.link.converse(poll, it.now());
            REQUIRE(it.leaves());
            it.hear(response_to(it.left));
            it.link.converse(poll, it.now());
        }
        CHECK(it.is_lost(3));
    }
}
