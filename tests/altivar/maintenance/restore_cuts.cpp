// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A restore that is cut at any request leaves the old or the new word in each register, and says which; a second one
// goes on. The same where the drive loses its power, is replaced, refuses for a moment, or is started by another master.
#include <rtuwire/altivar/maintenance/restore.hpp>

#include <algorithm>
#include <optional>

#include "altivar/maintenance/maintenance_bench.hpp"
#include "support/catch.hpp"
#include "support/one_in.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using told = restore_outcome;
using kind = outcome_kind;

namespace {

constexpr bool is_known_new(told outcome)
{
    return outcome == told::written or outcome == told::holds or outcome == told::not_read_back or
           outcome == told::confirmed;
}

/// Whether what was told last of each parameter is true of the drive.
void check_reports(told_list const& all, word_list const& words, paper_drive const& before, paper_drive const& now)
{
    small_map.for_each([&](parameter const& row, parameter_group const&) {
        std::string const code = rtuwire::test::text_of(row.code);
        INFO(code);
        REQUIRE(all.of.count(code) == 1);
        restore_report const last = all.last(code);
        CHECK(std::ranges::count(all.of.at(code), told::not_reached, &restore_report::outcome) <= 1);
        std::uint16_t const old = before.word(row.address);
        std::uint16_t const held = now.word(row.address);
        auto const wanted = words.find(code);
        std::uint16_t const next = wanted == words.end() ? old : wanted->second;
        if (is_known_new(last.outcome)) {
            CHECK(held == next);
        } else if (last.outcome == told::unconfirmed) {
            CHECK((held == old or held == next));
        } else {
            CHECK(held == old);
        }
        CHECK((not last.held or last.outcome == told::not_read_back or *last.held == held));
    });
}

bool holds_all(word_list const& words, paper_drive const& drive)
{
    return std::all_of(words.begin(), words.end(), [&](auto const& one) {
        parameter const& row = *small_map.by_code(one.first);
        return not is_restorable(role_of(row)) or drive.word(row.address) == one.second;
    });
}

/// How many requests to registers a whole restore takes.
unsigned all_requests(word_list const& words, restore_options const& options = all_of_it)
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    REQUIRE(bench.restore(words, all, options).kind == kind::succeeded);
    return drive.requests();
}

} // namespace

TEST_CASE("cut at any request, or at any response, each word is the old or the new one and the report is right")
{
    word_list const words = other_words();
    unsigned const count = all_requests(words);
    REQUIRE(count > 100);
    unsigned endings[32]{};
    for (unsigned const lost_sender : {0U, 1U}) { // what the client sends from here on, or what the drive does
        for (unsigned at = 0; at < count; at += one_in(7)) {
            paper_drive const before = small_drive();
            paper_drive drive = before;
            told_list all;
            {
                paper_bench bench{drive};
                drive.before = [&](unsigned number) {
                    if (number == at) {
                        bench.line.wire().set_faults(lost_sender, {.is_cut = true});
                    }
                };
                auto const how = bench.restore(words, all, all_of_it);
                INFO("cut at " << at << " of sender " << lost_sender);
                CHECK(how.kind != kind::pending);
                // Of the last request only its confirmation is missing.
                bool const is_whole = lost_sender == 0 and at == count - 1;
                CHECK((how.kind == kind::succeeded) == is_whole);
                ++endings[static_cast<unsigned>(how.kind)];
                check_reports(all, words, before, drive);
            }
            drive.before = {};
            paper_bench again{drive};
            told_list second;
            REQUIRE(again.restore(words, second, all_of_it).kind == kind::succeeded);
            REQUIRE(holds_all(words, drive));
        }
    }
    CHECK(endings[static_cast<unsigned>(kind::silent)] > count / one_in(7));
    CHECK(endings[static_cast<unsigned>(kind::executed_unconfirmed)] > 0); // after ADD, TBR or TFO
}

TEST_CASE("a restore that its user ends at any request says what became of each parameter")
{
    word_list const words = other_words();
    unsigned const count = all_requests(words);
    unsigned unconfirmed = 0;
    unsigned confirmed = 0;
    for (unsigned at = 1; at < count; ++at) {
        paper_drive const before = small_drive();
        paper_drive drive = before;
        paper_bench bench{drive};
        told_list all;
        auto const report = [&](parameter_group const&, parameter const& row, restore_report const& what) {
            all(row, what);
        };
        restore conversation{paper_station, small_map,
                             wanted_settings{drive_family::of("ATV320"), words_by_code{&words}}, report, all_of_it};
        bench.line.run_until([&] { return drive.requests() >= at; }, milliseconds(600'000), conversation);
        conversation.cancel();
        std::size_t const writes = drive.writes.size();
        REQUIRE(bench.line.run_until([&] { return conversation.settled(); }, milliseconds(1'000), conversation));
        INFO("at " << at);
        CHECK(conversation.reason() == reason{kind::aborted, errc::cancelled, conversation.reason().state});
        CHECK(drive.writes.size() == writes);
        check_reports(all, words, before, drive);
        auto const tells = [&](told outcome) {
            return std::ranges::any_of(all.of, [&](auto const& one) { return one.second.back().outcome == outcome; });
        };
        unconfirmed += tells(told::unconfirmed) ? 1U : 0U;
        confirmed += tells(told::confirmed) ? 1U : 0U;
    }
    // Each write was cut before its response, and before its read-back, which one of the link's own has not.
    CHECK(unconfirmed > 20);
    CHECK(confirmed > unconfirmed - 4);
}

TEST_CASE("a conversation that is destroyed at any request and made anew in the same place completes the restore")
{
    word_list const words = other_words();
    unsigned const count = all_requests(words);
    for (unsigned at = 0; at < count; at += 3) {
        paper_drive drive = small_drive();
        paper_bench bench{drive};
        auto const ignore = [](parameter_group const&, parameter const&, restore_report const&) {};
        using conversation = decltype(altivar::restore{
            paper_station, small_map, wanted_settings{drive_family{}, words_by_code{&words}}, ignore, all_of_it});
        std::optional<conversation> one;
        auto const make = [&] {
            one.emplace(paper_station, small_map, wanted_settings{drive_family::of("ATV320"), words_by_code{&words}},
                        ignore, all_of_it);
        };
        make();
        bench.line.run_until([&] { return drive.requests() > at; }, milliseconds(60'000), *one);
        make();
        REQUIRE(bench.line.run(*one, milliseconds(600'000)).kind == kind::succeeded);
        REQUIRE(holds_all(words, drive));
    }
}

TEST_CASE("a drive that loses its power, or is replaced by another of its family, ends with the configuration")
{
    word_list const words = other_words();
    unsigned const count = all_requests(words);
    for (bool const is_replaced : {false, true}) {
        for (unsigned at = 0; at < count; at += one_in(7)) {
            paper_drive drive = small_drive();
            paper_bench bench{drive};
            drive.before = [&](unsigned number) {
                if (number == at) {
                    drive.cycle_power();
                    is_replaced ? drive.set(11410, 4'000), drive.set(3052, 7) : void();
                }
            };
            told_list all;
            INFO("at " << at);
            auto const how = bench.restore(words, all, all_of_it);
            // The words of the link are never read back: what is lost behind them is not seen.
            bool const is_seen = at + 20 < count;
            if (is_seen) {
                REQUIRE(how.kind == kind::succeeded);
                REQUIRE(holds_all(words, drive));
            }
        }
    }
}

TEST_CASE("a drive that loses its power at any request has saved what it is said to hold")
{
    word_list const words{{"SP2", 11}, {"SP6", 14}, {"CD1", 1}};
    restore_options options = all_of_it;
    options.save = true;
    unsigned const count = all_requests(words, options);
    for (unsigned at = 0; at < count; ++at) {
        paper_drive drive = small_drive();
        paper_bench bench{drive};
        told_list all;
        drive.before = [&](unsigned number) { number == at ? drive.cycle_power() : void(); };
        auto const how = bench.restore(words, all, options);
        drive.before = {};
        INFO("at " << at);
        CHECK(how.kind == kind::succeeded);
        drive.cycle_power();
        CHECK(holds_all(words, drive));
    }
}

TEST_CASE("what is not held as a whole is not saved, and neither is nothing")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    restore_options options = ordinary_ones;
    options.save = true;
    CHECK(bench.restore({}, all, options).kind == kind::succeeded);
    CHECK(bench.restore({{"SP2", 5991}, {"SP6", 14}}, all, options).kind == kind::not_taken);
    drive.registers[11410].refuses_write = errc::server_device_failure;
    CHECK(bench.restore({{"SP2", 11}, {"SP6", 15}}, all, options).kind == kind::not_taken);
    CHECK(drive.word(11414) == 15);
    CHECK(drive.saves == 0);
    CHECK_FALSE(bench.saved);
    drive.registers[11410].refuses_write = errc::none;
    CHECK(bench.restore({{"SP2", 11}, {"SP6", 15}}, all, options).kind == kind::succeeded);
    CHECK(drive.saves == 1);
    CHECK(bench.saved);
}

TEST_CASE("what was read anew before the cut is told as it was read")
{
    // The last write of a section undoes two of its neighbours, which are then read again, and one is written first.
    word_list const words{{"SP2", 11}, {"SP3", 12}, {"SP6", 14}};
    bool was_told = false;
    for (unsigned at = 0; at < 80; ++at) {
        paper_drive drive = small_drive();
        unsigned writes = 0;
        drive.after_write = [&](std::uint16_t address, std::uint16_t) {
            if (address == 11414 and writes++ == 0) {
                drive.set(11410, 5), drive.set(11411, 9);
            }
        };
        paper_bench bench{drive};
        told_list all;
        drive.before = [&](unsigned number) { number == at ? bench.line.cut() : void(); };
        static_cast<void>(bench.restore(words, all, ordinary_ones));
        restore_report const last = all.last("SP3");
        bool const is_neighbour_first = drive.word(11410) == 5; // and SP3 was not begun
        was_told = was_told or (is_neighbour_first and last == restore_report{told::not_reached, 9, errc::timed_out});
    }
    CHECK(was_told);
}

TEST_CASE("a drive that another master holds ready after the last write is not saved")
{
    word_list const words{{"SP2", 11}};
    restore_options options = ordinary_ones;
    options.save = true;
    unsigned written = 0;
    unsigned saved = 0;
    paper_drive whole = small_drive();
    whole.after_write = [&](std::uint16_t address, std::uint16_t) {
        (address == 11410 ? written : saved) = whole.requests();
    };
    paper_bench whole_bench{whole};
    told_list ignored;
    REQUIRE(whole_bench.restore(words, ignored, options).kind == kind::succeeded);
    unsigned refused = 0;
    for (unsigned at = written; at < saved; ++at) {
        paper_drive drive = small_drive();
        paper_bench bench{drive};
        told_list all;
        drive.before = [&](unsigned number) { number == at ? drive.set(paper_drive::command, 6) : void(); };
        auto const how = bench.restore(words, all, options);
        INFO("at " << at << " of " << written << " to " << saved);
        refused += how.kind == kind::overwritten ? 1U : 0U;
        CHECK((drive.saves == 0) == (how.kind == kind::overwritten));
    }
    CHECK(refused >= 3); // between the write and the check before the save, whatever is read there
}

TEST_CASE("a restore that is cut after a write has undone others does not say that they hold")
{
    // A macro of the drive's own: whoever writes SLL resets two settings that were written before.
    auto const with_macro = [](paper_drive& drive) {
        unsigned writes = 0;
        drive.after_write = [&drive, writes](std::uint16_t address, std::uint16_t) mutable {
            if (address == 7010 and writes++ == 0) {
                drive.set(11410, 5), drive.set(11414, 9);
            }
        };
    };
    word_list const words{{"SP2", 11}, {"SP6", 14}, {"SLL", 0}};
    paper_drive whole = small_drive();
    with_macro(whole);
    paper_bench whole_bench{whole};
    told_list ignored;
    REQUIRE(whole_bench.restore(words, ignored, all_of_it).kind == kind::succeeded);
    unsigned cuts_that_tell = 0;
    for (unsigned at = 0; at < whole.requests(); ++at) {
        paper_drive drive = small_drive();
        with_macro(drive);
        paper_bench bench{drive};
        told_list all;
        drive.before = [&](unsigned number) { number == at ? bench.line.cut() : void(); };
        auto const how = bench.restore(words, all, all_of_it);
        bool const is_undone = drive.word(11410) == 5;
        cuts_that_tell += is_undone and all.last("SP2") == restore_report{told::differs, std::uint16_t{5}} ? 1U : 0U;
        INFO("at " << at);
        CHECK(how.kind != kind::succeeded);
    }
    CHECK(cuts_that_tell > 0);
}

TEST_CASE("a drive that another master starts gets no write any more")
{
    word_list const words = other_words();
    unsigned const count = all_requests(words);
    for (unsigned at = 0; at + 1 < count; ++at) {
        paper_drive drive = small_drive();
        paper_bench bench{drive};
        std::size_t before = 0;
        drive.before = [&](unsigned number) {
            if (number == at) {
                before = drive.writes.size();
                drive.set(paper_drive::command, 0x000F);
                drive.run();
            }
        };
        told_list all;
        INFO("at " << at);
        auto const how = bench.restore(words, all, all_of_it);
        bool const is_over = how.kind == kind::succeeded; // no write was left
        // The one write that the check had allowed.
        CHECK(drive.writes.size() <= before + 1);
        CHECK((is_over or how.kind == kind::refused_while_running or how.kind == kind::overwritten or
               how.kind == kind::started_by_terminals));
        for (std::uint16_t const word : drive.commands) {
            CHECK(word == 0);
        }
        CHECK((drive.commands.empty() or how.kind == kind::started_by_terminals));
    }
}

TEST_CASE("a drive that refuses everything for a moment ends the restore, or not, and the report is right")
{
    word_list const words = other_words();
    unsigned const count = all_requests(words);
    for (errc const refusal : {errc::server_device_failure, errc::acknowledge, errc::server_device_busy}) {
        for (unsigned const length : {1U, 9U}) {
            for (unsigned at = 0; at < count; at += 2 * one_in(7)) {
                paper_drive const before = small_drive();
                paper_drive drive = before;
                told_list all;
                paper_bench bench{drive};
                drive.before = [&](unsigned number) {
                    drive.refuses_all = number >= at and number < at + length ? refusal : errc::none;
                };
                INFO("at " << at << " for " << length);
                auto const how = bench.restore(words, all, all_of_it);
                CHECK((how.kind == kind::succeeded or how.kind == kind::refused or how.kind == kind::not_taken));
                check_reports(all, words, before, drive);
                drive.before = {};
                drive.refuses_all = errc::none;
                REQUIRE(bench.restore(words, all, all_of_it).kind == kind::succeeded);
                REQUIRE(holds_all(words, drive));
            }
        }
    }
}

TEST_CASE("over a line that loses one frame in a hundred, every restore ends with the configuration")
{
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        detail::random_source random{seed};
        word_list words = other_words();
        words["SP2"] = static_cast<std::uint16_t>(random.below(5990));
        words["SP4"] = static_cast<std::uint16_t>(random.next());
        paper_drive drive = small_drive();
        paper_bench bench{drive, 5};
        bench.line.wire() = sim::line{paper_line, seed};
        bench.line.wire().set_faults({.lost = 10'000});
        told_list all;
        REQUIRE(bench.restore(words, all, all_of_it).kind == kind::succeeded);
        REQUIRE(holds_all(words, drive));
    }
}
