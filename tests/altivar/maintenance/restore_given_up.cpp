// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A restore that its user gives up: before it begins, from its own report, and again and again while a motor is told to stop
// or an order to save is taken back.
#include <rtuwire/altivar/maintenance/restore.hpp>

#include "altivar/maintenance/maintenance_bench.hpp"
#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using told = restore_outcome;
using kind = outcome_kind;

namespace {

constexpr std::uint16_t cd1 = 8423;

/// A restore that gives itself up in its first report with this outcome.
struct giving_up {
    std::function<void()> give_up;
    told_list* all;
    told at;

    void operator()(parameter_group const&, parameter const& row, restore_report const& what) const
    {
        (*all)(row, what);
        if (what.outcome == at) {
            give_up();
        }
    }
};

template <typename Report> auto restore_of(word_list const& words, Report report, restore_options const& options)
{
    return restore{paper_station, small_map, wanted_settings{drive_family::of("ATV320"), words_by_code{&words}}, report,
                   options};
}

} // namespace

TEST_CASE("a restore that is given up before it begins sends nothing, and tells of everything")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    word_list const words{{"SP2", 11}, {"CMD", 15}};
    told_list all;
    auto const report = [&](parameter_group const&, parameter const& row, restore_report const& what) {
        all(row, what);
    };
    auto conversation = restore_of(words, report, all_of_it);
    conversation.cancel();
    conversation.cancel();
    CHECK(conversation.settled());
    bench.line.pass(conversation);
    CHECK(conversation.reason() == reason{.kind = kind::aborted, .error = errc::cancelled});
    for (unsigned i = 0; i < 100; ++i) {
        bench.line.pass(conversation);
    }
    CHECK(conversation.reason().kind == kind::used_already);
    CHECK(drive.requests() == 0);
    CHECK(all.last("SP2") == restore_report{told::not_reached, std::nullopt, errc::cancelled});
    CHECK(all.last("CMD").outcome == told::never_written);
    CHECK(all.of.size() == small_map.size());
}

TEST_CASE("a report may give its restore up: nothing is sent after it, and what is told last is true")
{
    told const at = GENERATE(told::written, told::holds, told::not_wanted, told::refused);
    paper_drive drive = small_drive();
    drive.registers[11411].refuses_write = errc::server_device_failure;
    paper_bench bench{drive};
    word_list const words{{"SP2", 11}, {"SP3", 12}, {"SP4", 200}, {"SP6", 14}};
    told_list all;
    giving_up report{{}, &all, at};
    std::size_t at_once = 0;
    std::function<void()> give_up;
    report.give_up = [&] { give_up(); };
    auto conversation = restore_of(words, report, ordinary_ones);
    bool is_first = true;
    give_up = [&] {
        at_once = is_first ? drive.writes.size() : at_once;
        is_first = false;
        conversation.cancel();
    };
    CHECK(bench.line.run(conversation, milliseconds(60'000)).kind == kind::aborted);
    CHECK(drive.writes.size() == at_once);
    for (auto const& [code, word] : words) {
        restore_report const last = all.last(code);
        std::uint16_t const held = drive.word(small_map.by_code(code)->address);
        INFO(code);
        CHECK((last.outcome == told::written or last.outcome == told::holds ? held == word
                                                                            : held != word or word == 200));
        CHECK((not last.held or *last.held == held));
    }
}

TEST_CASE("a motor that a terminal started gets its 0000 however often the restore is given up")
{
    // From one pass to the next: as soon as the motor runs, or later.
    for (unsigned pass = 0; pass < 6; ++pass) {
        paper_drive drive = small_drive();
        paper_bench bench{drive};
        word_list const words{{"CD1", 1}, {"CHCF", 2}};
        auto const ignored = [](auto const&...) {};
        auto conversation = restore_of(words, ignored, all_of_it);
        unsigned since = 0;
        drive.after_write = [&](std::uint16_t address, std::uint16_t) {
            if (address == cd1) {
                drive.run();
                since = 1;
            }
        };
        for (unsigned i = 0; i < 100'000 and not conversation.settled(); ++i) {
            if (since != 0 and since++ > pass) {
                conversation.cancel();
            }
            bench.line.pass(conversation);
        }
        INFO(pass);
        REQUIRE(conversation.settled());
        CHECK(conversation.reason().kind == kind::started_by_terminals);
        CHECK(drive.commands == std::vector<std::uint16_t>{0});
    }
}

TEST_CASE("an order to save does not stay set where the restore is given up again and again")
{
    for (unsigned pass = 0; pass < 12; ++pass) {
        paper_drive drive = small_drive();
        paper_bench bench{drive};
        word_list const words{{"SP2", 11}};
        auto const ignored = [](auto const&...) {};
        restore_options options = ordinary_ones;
        options.save = true;
        auto conversation = restore_of(words, ignored, options);
        unsigned since = 0;
        drive.after_write = [&](std::uint16_t address, std::uint16_t word) {
            since = address == paper_drive::extended_command and word != 0 ? 1 : since;
        };
        for (unsigned i = 0; i < 100'000 and not conversation.settled(); ++i) {
            if (since != 0 and since++ > pass) {
                conversation.cancel();
            }
            bench.line.pass(conversation);
        }
        INFO(pass);
        REQUIRE(conversation.settled());
        CHECK(drive.word(paper_drive::extended_command) == 0);
    }
}
