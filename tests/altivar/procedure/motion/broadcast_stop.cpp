// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stopping everyone, frame by frame: which broadcasts go out and when, and who is told by its own address next.
#include <string>

#include "altivar/procedure/motion/broadcast_stop_by_hand.hpp"
#include "support/byte_list.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using test::frames;

namespace {

constexpr station<atv320::device> press{unit_id{1}}, mixer{unit_id{2}};
constexpr station<atv28::device> fan{unit_id{3}}, blower{unit_id{5}};
constexpr station<atv12::device> hoist{unit_id{4}};
constexpr std::uint16_t switched_on = 0x0233, enabled = 0x0237, locked = 0x0250;

// What is said to everyone: at 8501, and at the 400 of an ATV28.
std::string const coast_new = "00 06 21 35 00 00", coast_old = "00 06 01 90 00 00";
std::string const stop_new = "00 06 21 35 00 02", stop_old = "00 06 01 90 00 02";

} // namespace

TEST_CASE("everyone is told twice at once and once more a second later, each family of drives by "
          "one frame")
{
    test::everyone_by_hand<5> it{press, mixer, fan, hoist, blower};
    CHECK_FALSE(it.all.poll_deadline());
    CHECK(it.all.intent() == effect::none);
    CHECK(it.all.is_urgent());
    CHECK(it.asks() == coast_new);
    CHECK(it.all.intent() == effect::stopping);
    CHECK_FALSE(it.all.poll_deadline());
    CHECK(it.broadcasts(10) == frames{coast_new, coast_old, coast_new, coast_old});
    // Until no response that was cut short can be on its way: the line is let alone, for others to ask.
    CHECK(it.asks() == "");
    CHECK(it.all.intent() == effect::none);
    CHECK(it.all.is_urgent());
    CHECK(it.all.poll_deadline() == test::start_of_all + milliseconds(1'000));
    CHECK(it.asks_after(959) == "");
    CHECK(it.asks_after(1) == coast_new);
    CHECK(it.all.intent() == effect::stopping);
    CHECK(it.broadcasts() == frames{coast_new, coast_old});
    CHECK_FALSE(it.all.is_urgent());
    CHECK_FALSE(it.all.settled());
}

TEST_CASE("what everyone is told is one whole frame, its check at the end")
{
    broadcast_stop all{broadcast_stop_options{.freewheel = true}, hoist};
    all.advance(test::start_of_all);
    auto const request = all.next();
    REQUIRE(request);
    byte_view const frame = request->frame();
    CHECK(test::byte_list{frame.begin(), frame.end()} == test::bytes_of("00 06 21 35 00 00 92 29"));
}

TEST_CASE("where the turnarounds take longer than that, nothing more is waited for")
{
    auto it = test::everyone_by_hand<2>{fan, hoist}.with_known_words();
    CHECK(it.broadcasts(300) == frames{stop_old, stop_new, stop_old, stop_new, stop_old, stop_new});
    CHECK(it.now - test::start_of_all == milliseconds(1'800));
    test::everyone_by_hand<2> slow{broadcast_stop_options{.last_after = milliseconds(3'000)}, fan, hoist};
    CHECK(slow.broadcasts(300).size() == 4);
    CHECK(slow.all.poll_deadline() == test::start_of_all + milliseconds(3'000));
}

TEST_CASE("a broadcast that was lost is as good as one that left: nobody answers")
{
    auto it = test::everyone_by_hand<1>{hoist}.with_known_words();
    CHECK(it.asks() == stop_new);
    it.all.accept(errc::transmit_stalled);
    CHECK(it.broadcasts().size() == 1);
    CHECK(it.asks_after(1'000) == stop_new);
    it.all.accept(errc::transmit_stalled);
    CHECK(it.asks() == "04 06 21 35 00 02");
}

TEST_CASE("nothing is left out that nobody named, and each family is told once in a round however "
          "its drives stand")
{
    broadcast_rounds any{broadcast_stop_options{}};
    any.add(1);
    CHECK_FALSE(any.is_over());
    CHECK(any.request().address == 1);
    for (bool const is_old_first : {false, true}) {
        broadcast_rounds rounds{broadcast_stop_options{.left_out = 1}};
        for (bool const is_old : {is_old_first, not is_old_first, not is_old_first, is_old_first}) {
            rounds.add(is_old ? atv28::device::layout.cmd : atv12::device::layout.cmd);
        }
        for (unsigned i = 0; i < 6; ++i) {
            CHECK_FALSE(rounds.is_over());
            CHECK(rounds.request().address == ((i % 2 == 0) == is_old_first ? 400 : 8'501));
            CHECK(rounds.request().value == 0x0002);
            rounds.next();
        }
        CHECK(rounds.is_over());
    }
}

TEST_CASE("the family of a drive that is ordered and not given is told, too: where it was read, else both")
{
    using addresses = std::vector<unsigned>;
    auto const two_rounds = [](broadcast_stop<1>& all) {
        addresses told;
        while (auto const request = all.next()) {
            told.push_back(u16_at(request->frame(), 2));
            all.accept(result<response>{response{}});
        }
        return told;
    };
    addresses const own{8'501, 8'501}, both{8'501, 400, 8'501, 400};
    for (std::uint16_t const address : {std::uint16_t{0}, other_meaning, std::uint16_t{400}, std::uint16_t{8'501}}) {
        INFO("address " << address);
        broadcast_stop all{press};
        all.note_unlisted(400); // it has not begun
        all.advance(instant{0});
        all.note_unlisted(address);
        all.advance(instant{1});
        all.note_unlisted(400); // of a unit that is lost meanwhile
        CHECK(two_rounds(all) == (address == 8'501 ? own : both));
        all.again();
        all.advance(instant{2});
        CHECK(two_rounds(all) == own);
    }
}

TEST_CASE("a response that an ATV28 among the drives owes is waited for, unless it is said that it is not")
{
    broadcast_stop all{fan, press, hoist};
    CHECK_FALSE(all.may_cut(3));
    CHECK(all.may_cut(1));
    CHECK(all.may_cut(4));
    CHECK(all.may_cut(9)); // of a unit that nobody named
    broadcast_stop last{press, hoist, fan};
    CHECK_FALSE(last.may_cut(3));
    broadcast_stop hasty{broadcast_stop_options{.cuts_short = true}, fan, press, hoist};
    CHECK(hasty.may_cut(3));
    // Behind the broadcasts the word of one drive cuts short what that drive owes, and nothing else.
    auto it = test::everyone_by_hand<3>{fan, hoist, press}.with_known_words();
    it.tell_everyone();
    CHECK(it.asks() == "04 06 21 35 00 02");
    it.confirm();
    CHECK(it.all.intent() == effect::stopping);
    CHECK(it.all.may_cut(1));
    CHECK_FALSE(it.all.may_cut(3));
    CHECK_FALSE(it.all.may_cut(4));
}

TEST_CASE("each drive is told by its own address, in turn; a word that stops goes before any look")
{
    auto it = test::everyone_by_hand<3>{fan, hoist, press}.with_known_words();
    CHECK(it.broadcasts() == frames{stop_old, stop_new, stop_old, stop_new});
    it.wait(1'000);
    CHECK(it.broadcasts() == frames{stop_old, stop_new});
    it.confirms({"04 06 21 35 00 02", "01 06 21 35 00 02"});
    CHECK(it.asks() == "03 06 01 90 00 02");
    it.miss(3);
    CHECK(it.asks() == "04 03 0C 81 00 02");
    it.hear(switched_on);
    it.confirms({"04 06 21 35 00 00"}); // one word away from running: at once, before the others' looks
    // Both have something to ask, and the one that was asked longest ago is next.
    CHECK(it.asks() == "01 03 0C 81 00 02");
    it.wait(50); // the fan's word is due again, and goes before the look at the hoist
    it.hear(locked);
    CHECK(it.asks() == "03 06 01 90 00 02");
    it.confirm();
    CHECK(it.asks() == "04 03 0C 81 00 02");
    it.hear(enabled, 300);
    CHECK(it.asks() == "03 03 01 C9 00 02");
    it.hear(0x0240);
    CHECK(it.all.reason(0).kind == outcome_kind::succeeded);
    CHECK(it.all.reason(1).kind == outcome_kind::pending);
    CHECK(it.all.reason(2).kind == outcome_kind::succeeded);
    CHECK(it.asks() == "");
    CHECK(it.all.intent() == effect::none);
    CHECK(it.all.poll_deadline() == it.now + milliseconds(50));
}
