// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the simulated ATV28 does otherwise than the later drives, by its bulletin.
#include "support/drive_bench.hpp"

#include <array>

#include <rtuwire/altivar/atv28.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;
using bench = test::drive_bench<atv28::device>;

TEST_CASE("an ATV28 shows sizes where its bulletin says absolute, in reverse as well")
{
    bench it;
    it.run(-400);
    CHECK(it.frequency() == -40'000);
    CHECK(it.word("FRH") == 400);
    CHECK(it.word("RFR") == 400);
    CHECK(it.word("SPD") == 1'200);
    CHECK(it.word("RFRD") == 1'200);
    CHECK(it.number("FRHD") == -1'200);
    CHECK((it.eta() & 0x8000) != 0);
    CHECK((it.word("ETI") & 0x8000) != 0);
}

TEST_CASE("CMDD is the same word as CMD")
{
    bench it;
    CHECK(it.word("CMD") == 0x00F0);
    it.refer(300);
    CHECK(it.tell(601, 0x0006) == errc::none);
    CHECK(it.state() == state::ready_to_switch_on);
    CHECK(it.word("CMD") == 0x0006);
    it.command(0x0007);
    CHECK(it.word("CMDD") == 0x0007);
    it.tell(601, 0x000F);
    it.wait(4'000);
    CHECK(it.frequency() == 30'000);
}

TEST_CASE("the five words of direct control do what the bulletin says")
{
    struct line {
        std::uint16_t word;
        std::int32_t at_once; ///< mHz, from 40 Hz, after 0.3 s
        std::int32_t at_last;
    };
    constexpr std::array lines{line{0x800A, 40'000, 40'000}, line{0x900A, 35'000, 0}, line{0xA00A, 0, 0},
                               line{0xC00A, 20'000, 0}, line{0x880A, 35'000, -40'000}};
    for (line const& each : lines) {
        bench it;
        it.refer(400);
        it.command(0x800A);
        it.wait(4'000);
        REQUIRE(it.frequency() == 40'000);
        it.command(each.word);
        it.wait(300);
        INFO("word " << each.word);
        CHECK(it.frequency() == each.at_once);
        CHECK(((it.word("ETI") & 0x0020) != 0) == (each.word == 0xA00A));
        it.wait(5'000);
        CHECK(it.frequency() == each.at_last);
        CHECK(it.state() == state::operation_enabled);
    }
}

TEST_CASE("the link gives the control to the terminals, and takes it again")
{
    bench it;
    it.run(200);
    CHECK((it.word("ETI") & 0x6000) == 0x4000);
    it.command(0x8100);
    CHECK((it.word("ETI") & 0x6000) == 0x0000);
    CHECK(it.state() == state::switch_on_disabled);
    CHECK((it.eta() & 0x0200) != 0); // nobody forces local
    it.drive().set_analog_reference(10'000);
    it.drive().set_input(1, true);
    it.wait(2'000);
    CHECK(it.state() == state::operation_enabled);
    CHECK(it.frequency() == 10'000);
    it.command(0x0006);
    CHECK(it.state() == state::ready_to_switch_on);
    CHECK((it.word("ETI") & 0x6000) == 0x4000);
    it.run(200);
    CHECK(it.frequency() == 20'000);
}

TEST_CASE("after power-up the terminals are obeyed until the link commands")
{
    bench it;
    it.drive().set_analog_reference(10'000);
    it.drive().set_input(1, true);
    it.wait(2'000);
    CHECK(it.frequency() == 10'000);
    it.command(0x0000);
    CHECK(it.frequency() == 0);
    it.cycle_power();
    it.wait(2'000);
    CHECK(it.frequency() == 10'000);
}

TEST_CASE("an input that forces local counts where it is assigned so, and commands are refused then")
{
    bench it;
    it.drive().set_input(3, true);
    CHECK(it.command(0x0006) == errc::none);
    it.command(0x0000);
    it.drive().set_input(3, false);
    REQUIRE(it.tell(102, 17) == errc::none);
    it.run(200);
    it.drive().set_input(3, true);
    CHECK(it.frequency() == 0);
    CHECK((it.eta() & 0x0200) == 0);
    CHECK(it.command(0x000F) == errc::server_device_failure);
    CHECK(it.tell(601, 0x000F) == errc::server_device_failure);
    CHECK(it.tell(252, 40) == errc::none);
    it.drive().set_input(3, false);
    CHECK((it.eta() & 0x0200) != 0);
    CHECK(it.state() == state::switch_on_disabled);
}

TEST_CASE("an ATV28 shows a fault in LFT, ERRD, DF1 and DF2")
{
    struct line {
        std::uint16_t lft;
        std::uint16_t errd;
        std::uint16_t df1;
        std::uint16_t df2;
    };
    constexpr std::array lines{line{9, 0x2310, 0, 0x0008},  line{5, 0x7510, 0x0100, 0},  line{16, 0x4210, 0, 0x0080},
                               line{17, 0x1000, 0, 0x0100}, line{18, 0x3310, 0, 0x0400}, line{19, 0x3110, 0, 0x0800},
                               line{20, 0x3310, 0, 0x1000}, line{21, 0x3130, 0, 0x2000}, line{2, 0x5520, 0x0008, 0},
                               line{1, 0x6100, 0x0001, 0}};
    for (line const& each : lines) {
        bench it;
        it.drive().inject_fault(each.lft);
        it.wait(10);
        CHECK(it.word("LFT") == each.lft);
        CHECK(it.word("DP1") == each.lft);
        CHECK(it.word("ERRD") == each.errd);
        CHECK(it.word("DF1") == each.df1);
        CHECK(it.word("DF2") == each.df2);
        it.drive().clear_cause();
        it.command(0x0000);
        it.command(0x8080); // bit 7 counts in a word of direct control, too
        CHECK(it.state() == state::switch_on_disabled);
        CHECK(it.word("LFT") == each.lft);
        CHECK(it.word("DF1") == 0);
        CHECK(it.word("DF2") == 0);
    }
}

TEST_CASE("reserved bits of an ATV28's status words stay 0")
{
    constexpr std::uint16_t eta = 0x3100, eti = 0x160F, eti2 = 0xFF8F;
    bench it;
    std::uint16_t seen = 0, seen_1 = 0, seen_2 = 0;
    auto const look = [&] {
        seen = static_cast<std::uint16_t>(seen | it.eta());
        seen_1 = static_cast<std::uint16_t>(seen_1 | it.word("ETI"));
        seen_2 = static_cast<std::uint16_t>(seen_2 | it.word("ETI2"));
    };
    it.refer(400);
    for (std::uint16_t const word :
         std::array<std::uint16_t, 7>{0x0006, 0x0007, 0x000F, 0x080F, 0xA00A, 0x0007, 0x0000}) {
        it.command(word);
        it.wait(500);
        look();
    }
    it.drive().inject_fault(9);
    it.wait(10);
    it.drive().clear_cause();
    it.wait(10);
    look();
    it.tell(402, 0x0002);
    look();
    CHECK((seen & eta) == 0);
    CHECK((seen_1 & eti) == 0);
    CHECK((seen_2 & eti2) == 0);
    CHECK((seen_1 & 0xC030) == 0xC030);
}
