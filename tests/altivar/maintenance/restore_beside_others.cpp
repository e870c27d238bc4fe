// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A restore beside other conversations: on a bus with other units, against a stop of its unit, and of a drive that runs.
#include <rtuwire/altivar/maintenance/restore.hpp>

#include "altivar/maintenance/maintenance_bench.hpp"
#include "support/catch.hpp"
#include "support/commissioned.hpp"
#include "support/remembered.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/maintenance/backup.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr auto ignore = [](parameter_group const&, parameter const&, restore_report const&) {};

auto restore_of(word_list const& words, restore_options const& options = all_of_it)
{
    return restore{paper_station, small_map, wanted_settings{drive_family::of("ATV320"), words_by_code{&words}}, ignore,
                   options};
}

} // namespace

TEST_CASE("a restore on a bus ends beside a backup of another unit, and leaves that alone")
{
    paper_drive first = small_drive();
    paper_drive second = small_drive();
    constexpr station<atv320::device> other{unit_id{8}};
    sim::bench line{bus<2>{paper_line}, bank_at{unit_id{7}, first, paper_identity<320>::profile},
                    bank_at{unit_id{8}, second, paper_identity<320>::profile}};
    word_list const words = other_words();
    auto one = restore_of(words);
    unsigned read = 0;
    backup two{other, small_map, [&](parameter_group const&, parameter const&, result<std::uint16_t> const& word) {
                   read += word ? 1U : 0U;
               }};
    REQUIRE(line.run(one, two));
    CHECK(one.reason().kind == kind::succeeded);
    CHECK(two.outcome().has_value());
    CHECK(read == small_map.size());
    CHECK(first.word(11410) == 11);
    CHECK(second.writes.empty());
    CHECK(second.commands.empty());
}

TEST_CASE("a stop of its unit ends a restore: no setting is written behind it")
{
    word_list const words = other_words();
    for (unsigned at = 10; at < 120; at += 7) {
        paper_drive drive = small_drive();
        sim::bench line{bus<2>{paper_line}, bank_at{unit_id{7}, drive, paper_identity<320>::profile}};
        remembered one{restore_of(words)};
        line.run_until([&] { return drive.requests() >= at; }, milliseconds(60'000), one);
        stop halt{paper_station};
        std::size_t const before = drive.writes.size();
        REQUIRE(line.run_until([&] { return one.settled() and halt.settled(); }, milliseconds(60'000), one, halt));
        INFO("at " << at << " ended as " << static_cast<unsigned>(one.reason().kind) << ", "
                   << static_cast<unsigned>(one.reason().error));
        CHECK((one.reason().kind == kind::overruled or one.reason().kind == kind::overwritten));
        CHECK(not drive.commands.empty());
        CHECK(drive.writes.size() <= before + 1); // the one that was under way
    }
}

TEST_CASE("a drive that this client has ordered to run gets no setting")
{
    constexpr station<atv320::device> drive{unit_id{7}};
    sim::bench line{drive_client<2>{paper_line}, drive};
    start run{drive, 20_Hz, run_direction::forward, milliseconds(5'000), commissioned()};
    REQUIRE(line.run(run).kind == kind::succeeded);
    std::uint16_t const before = line.drive().word("ACC");
    word_list const words{{"ACC", static_cast<std::uint16_t>(before + 1)}};
    auto one = restore_of(words);
    CHECK(line.run(one).kind == kind::refused_while_running);
    CHECK(line.drive().word("ACC") == before);
    CHECK(one.written() == 0);
    CHECK(line.drive().motor().frequency() > 0); // nor is it stopped
}

TEST_CASE("each write tells the client that it rearranges, and nothing but a last look takes power away")
{
    paper_drive drive = small_drive();
    word_list const words = other_words();
    auto one = restore_of(words);
    unsigned writes = 0;
    sim::bench line{drive_client<2>{paper_line}, bank_at{unit_id{7}, drive, paper_identity<320>::profile}};
    auto const look = [&](instant) {
        auto same = one; // asked aside
        auto const asked = same.next();
        bool const is_write = asked and asked->frame()[1] == std::byte{6};
        bool const is_setting = is_write and u16_at(asked->frame(), 2) != paper_drive::extended_command;
        CHECK(one.intent() == (is_setting ? effect::rearranging : effect::none));
        CHECK((not is_setting or not asked->may_be_repeated()));
        writes += is_setting ? 1U : 0U;
    };
    REQUIRE(line.run_until([&] { return one.settled(); }, milliseconds(600'000), look, one));
    CHECK(writes > 24);
    CHECK(one.reason().kind == kind::succeeded);
    CHECK(drive.commands.empty());
}
