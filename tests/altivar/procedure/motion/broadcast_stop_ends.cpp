// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How a stop of everyone ends: each drive by what it shows, one that does not answer by the limit. A unit that is lost
// hears nothing for a while, and holds up nobody.
#include <string>

#include "altivar/procedure/motion/broadcast_stop_by_hand.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv320::device> press{unit_id{1}};
constexpr station<atv12::device> hoist{unit_id{4}};
constexpr std::uint16_t enabled = 0x0237, locked = 0x0250;

std::string const stop_hoist = "04 06 21 35 00 02", look_at_hoist = "04 03 0C 81 00 02",
                  coast_press = "01 06 21 35 00 00", coast_hoist = "04 06 21 35 00 00",
                  look_at_press = "01 03 0C 81 00 02";

} // namespace

TEST_CASE("who names no options has the quick stop, half a minute for each drive, and hears which "
          "one did not answer")
{
    auto it = test::everyone_by_hand<1>{hoist}.with_known_words();
    it.tell_everyone();
    CHECK(it.asks() == stop_hoist);
    instant const begin = it.now;
    it.all.accept(errc::timed_out);
    while (it.now - begin < milliseconds(29'950)) {
        CHECK(it.asks_after(50) == stop_hoist);
        it.all.accept(errc::timed_out);
    }
    CHECK_FALSE(it.all.settled());
    CHECK(it.asks_after(50) == "");
    CHECK(it.all.settled());
    CHECK_FALSE(it.all.succeeded());
    CHECK(it.all.reason(0).kind == outcome_kind::silent);
    CHECK(it.all.reason(0).error == errc::timed_out);
    CHECK(it.all.reason(1) == reason{}); // of a drive that is not there
    CHECK_FALSE(it.all.poll_deadline());
    CHECK(it.all.intent() == effect::none);
    CHECK(it.asks_after(1'000) == "");
}

TEST_CASE("everyone stands only where each of them was seen to stand")
{
    for (bool const answers : {true, false}) {
        test::everyone_by_hand<2> it{broadcast_stop_options{.limit = milliseconds(200)}, hoist, press};
        it.tell_everyone();
        CHECK(it.asks() == coast_press);
        it.confirm();
        CHECK(it.asks() == coast_hoist); // all coast: nobody has read what their words mean
        it.confirm();
        CHECK(it.asks() == look_at_press);
        it.hear(locked);
        CHECK_FALSE(it.all.settled());
        CHECK_FALSE(it.all.succeeded());
        CHECK(it.asks() == look_at_hoist);
        if (answers) {
            it.hear(locked);
        } else {
            it.all.accept(errc::timed_out);
            CHECK(it.asks_after(200) == "");
        }
        CHECK(it.all.settled());
        CHECK(it.all.succeeded() == answers);
        CHECK(it.all.reason(0).kind == (answers ? outcome_kind::succeeded : outcome_kind::unconfirmed));
        CHECK(it.all.reason(1).kind == outcome_kind::succeeded);
    }
}

TEST_CASE("a unit that is lost hears words that stop it for two seconds, then nothing, and the "
          "others are asked on")
{
    test::everyone_by_hand<2> it{hoist, press};
    // It was ordered to run before, and stops by itself 10 s behind the last request.
    commander one{hoist.unit()};
    it.motors.note_asked(one, effect::enabling, milliseconds(10'000), 1);
    it.tell_everyone();
    it.confirms({coast_press, coast_hoist});
    instant const lost = it.now;
    instant last_word = it.now;
    unsigned looks = 0;
    unsigned looks_meanwhile = 0;
    bool was_silent = false;
    while (it.now - lost < milliseconds(20'000) and not was_silent) {
        std::string const next = it.asks_after(10);
        if (next == coast_hoist or next == look_at_hoist) {
            was_silent = it.now - last_word > milliseconds(1'000);
            CHECK((was_silent or it.now - lost < milliseconds(2'100)));
            CHECK((not was_silent or it.now - last_word >= milliseconds(11'000)));
            last_word = was_silent ? last_word : it.now;
            it.miss(4);
        } else if (not next.empty()) {
            ++looks;
            looks_meanwhile += it.now - last_word > milliseconds(100) ? 1U : 0U;
            it.hear(enabled, 300);
        }
    }
    CHECK(was_silent);
    CHECK(last_word - lost > milliseconds(1'900));
    CHECK(looks_meanwhile > 125); // one each 50 ms
    CHECK(looks > looks_meanwhile);
}

TEST_CASE("while the only drive is lost nothing is asked, and the end is its limit")
{
    auto it = test::everyone_by_hand<1>{broadcast_stop_options{.limit = milliseconds(5'000)}, hoist}.with_known_words();
    commander one{hoist.unit()};
    it.motors.note_asked(one, effect::enabling, milliseconds(10'000), 1);
    it.tell_everyone();
    CHECK(it.asks() == stop_hoist);
    instant const begin = it.now;
    it.miss(4);
    while (it.now - begin < milliseconds(2'500)) {
        if (not it.asks_after(50).empty()) {
            it.miss(4);
        }
    }
    while (it.now - begin < milliseconds(4'950)) {
        CHECK(it.asks_after(50) == "");
        CHECK(it.all.intent() == effect::none);
        CHECK_FALSE(it.all.settled());
    }
    CHECK(it.asks_after(50) == "");
    CHECK(it.all.settled());
    CHECK(it.all.reason(0).kind == outcome_kind::silent);
}
