// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a simulated drive does by itself: the automatic restart after a lost link, the stop that DOTD names, and the
// images of its logic inputs.
#include "support/drive_bench.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;
using test::drive_bench;

namespace {

/// At 40 Hz, then without a request until it trips; then requests come again for three seconds.
template <typename Device> struct lost_link {
    drive_bench<Device> it;

    explicit lost_link(std::uint16_t restart)
    {
        REQUIRE(it.tell(Device::layout.safeguards.atr, restart) == errc::none);
        it.run(400);
        it.drive().note_contact();
        it.wait(31'000);
        it.wait(10'000);
        REQUIRE(it.state() == state::fault);
        REQUIRE(it.word("LFT") == 5);
        REQUIRE(it.frequency() == 0);
        for (unsigned i = 0; i < 30; ++i) {
            it.drive().note_contact();
            it.wait(100);
        }
        it.wait(3'000);
    }
};

} // namespace

TEST_CASE("a simulated drive that restarts by itself runs again once requests come")
{
    lost_link<atv320::device> yes{1};
    CHECK(yes.it.state() == state::operation_enabled);
    CHECK(yes.it.frequency() == 40'000);
    CHECK(lost_link<atv320::device>{0}.it.state() == state::fault);
    CHECK(lost_link<atv320::device>{0}.it.word("CMD") == 0);
}

TEST_CASE("a simulated ATV28 forgets its orders by the time-out: it resets itself and does not run")
{
    lost_link<atv28::device> yes{1};
    CHECK(yes.it.state() == state::switch_on_disabled);
    CHECK(yes.it.frequency() == 0);
    CHECK(lost_link<atv28::device>{0}.it.state() == state::fault);
    CHECK(lost_link<atv28::device>{2}.it.state() == state::fault);
}

TEST_CASE("a simulated drive stays in its fault until the link is back")
{
    drive_bench<atv320::device> it;
    REQUIRE(it.tell(7122, 1) == errc::none);
    it.run(400);
    it.drive().note_contact();
    it.wait(10'000);
    it.wait(60'000);
    CHECK(it.state() == state::fault);
}

TEST_CASE("a simulated ATV320 coasts on \"disable operation\" where DOTD says so")
{
    for (std::uint16_t const how : {std::uint16_t{0}, std::uint16_t{1}}) {
        drive_bench<atv320::device> it;
        REQUIRE(it.tell(8652, how) == errc::none);
        it.run(400);
        it.command(0x0007);
        it.wait(200);
        bool const is_on_the_ramp = it.word("ETI") >> 10U & 1U;
        INFO(how);
        CHECK(is_on_the_ramp == (how == 1));
        it.wait(60'000);
        CHECK(it.state() == state::switched_on);
    }
}

TEST_CASE("a simulated drive shows its logic inputs")
{
    drive_bench<atv320::device> later;
    later.drive().set_input(1, true);
    later.drive().set_input(6, true);
    CHECK(later.word("IL1R") == 0x0021);
    drive_bench<atv12::device> small;
    small.drive().set_input(4, true);
    CHECK(small.word("IL1I") == 0x0008);
    drive_bench<atv28::device> old;
    REQUIRE(old.tell(478, 0x0200) == errc::none);
    old.drive().set_input(2, true);
    CHECK(old.word("IOLR") == 0x0202);
    old.drive().set_input(2, false);
    CHECK(old.word("IOLR") == 0x0200);
}
