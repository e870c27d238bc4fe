// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A restore writes what differs and may be written, in its order, each read back; it tells of everything; and it writes
// to no drive that runs, is commanded, or is another one.
#include <rtuwire/altivar/maintenance/restore.hpp>

#include <algorithm>
#include <tuple>

#include "altivar/maintenance/maintenance_bench.hpp"
#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using told = restore_outcome;
using kind = outcome_kind;

namespace {

std::uint16_t held(paper_drive const& drive, char const* code)
{
    parameter const* const row = small_map.by_code(std::string{code});
    return drive.word(row->address);
}

std::string const never[]{"ETA", "RFR", "TAC", "NCV", "IL1R", "CMD", "LFR", "CMI", "TUN", "STOA"};
std::string const of_channels[]{"CFG", "CHCF", "FR1", "CD1", "FLO", "TCC"};
std::string const of_link[]{"ADD", "TBR", "TFO"};

} // namespace

TEST_CASE("with every option, a restore writes all settings, and nothing that is none")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    restore_options options = all_of_it;
    options.save = true;
    word_list const words = other_words();
    CHECK(bench.restore(words, all, options).kind == kind::succeeded);
    for (auto const& [code, word] : words) {
        bool const is_never = std::find(std::begin(never), std::end(never), code) != std::end(never);
        bool const is_link = std::find(std::begin(of_link), std::end(of_link), code) != std::end(of_link);
        INFO(code);
        CHECK((held(drive, code.c_str()) == word) == not is_never);
        CHECK(all.last(code).outcome == (is_never ? told::never_written : is_link ? told::not_read_back : told::holds));
        CHECK(std::count(all.written.begin(), all.written.end(), code) == (is_never ? 0 : 1));
    }
    CHECK(bench.written == all.written.size());
    CHECK(bench.failed == 0);
    CHECK(drive.writes.size() == all.written.size()); // each once
    CHECK(drive.commands.empty());
    CHECK(drive.saves == 2); // the settings, and after the link's own
}

TEST_CASE("the order is macro, step size, limits, settings, supervision, restart, inputs, channels, link")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    REQUIRE(bench.restore(other_words(), all, all_of_it).kind == kind::succeeded);
    std::vector<std::string> const order{"CFG", "INR", "TFR",  "HSP", "LSP", "ACC", "DEC", "SP2",
                                         "SP3", "SP4", "SP6",  "SLL", "NST", "FLR", "ATR", "TCC",
                                         "FR1", "CD1", "CHCF", "FLO", "TTO", "ADD", "TBR", "TFO"};
    CHECK(all.written == order);
}

TEST_CASE("without options only ordinary settings are written, and the rest is told with what the drive holds")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    CHECK(bench.restore(other_words(), all, ordinary_ones).kind == kind::succeeded);
    std::vector<std::string> const order{"INR", "TFR", "HSP", "LSP", "ACC", "DEC", "SP2", "SP3", "SP4", "SP6"};
    CHECK(all.written == order);
    for (std::string const& code : of_channels) {
        CHECK(all.last(code) == restore_report{told::needs_channels, held(drive, code.c_str())});
    }
    for (std::string const& code : of_link) {
        CHECK(all.last(code) == restore_report{told::needs_link, held(drive, code.c_str())});
    }
    CHECK(all.last("TTO").outcome == told::needs_link);
    CHECK(all.last("SLL") == restore_report{told::needs_supervision, std::uint16_t{1}});
    CHECK(all.last("NST").outcome == told::needs_supervision);
    CHECK(all.last("ATR").outcome == told::needs_autorestart);
    CHECK(all.last("FLR").outcome == told::needs_autorestart);
    CHECK(drive.saves == 0);

    // The time-out is the link's, and supervises it: both have to be asked for.
    restore_options options = ordinary_ones;
    options.with_link = true;
    told_list with_link;
    REQUIRE(bench.restore(other_words(), with_link, options).kind == kind::succeeded);
    CHECK(with_link.last("TTO").outcome == told::needs_supervision);
}

TEST_CASE("inferred parameters are left out unless they are asked for")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    CHECK(bench.restore({{"SP2", 11}, {"SP3", 12}}, all, {}).kind == kind::succeeded);
    CHECK(all.last("SP2").outcome == told::holds);
    CHECK(all.last("SP3") == restore_report{told::needs_inferred, std::uint16_t{150}});
    CHECK(all.last("SP4").outcome == told::not_wanted);
}

TEST_CASE("options that name nothing leave out all but documented settings, and do not save")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    CHECK(bench.restore(other_words(), all, {}).kind == kind::not_taken); // ramps whose steps are inferred
    CHECK(all.last("CD1").outcome == told::needs_channels);
    CHECK(all.last("ADD").outcome == told::needs_link);
    CHECK(all.last("SLL").outcome == told::needs_supervision);
    CHECK(all.last("FLR").outcome == told::needs_autorestart);
    CHECK(all.last("SP3").outcome == told::needs_inferred);
    CHECK(all.last("SP2").outcome == told::holds);
    CHECK(drive.saves == 0);
}

TEST_CASE("what lets the drive start by itself is told with its word before anything is written")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    for (bool const is_asked : {false, true}) {
        told_list all;
        bool was_told = false;
        drive.after_write = [&](std::uint16_t, std::uint16_t) {
            auto const is_told = [&](char const* code) {
                return std::any_of(all.of[code].begin(), all.of[code].end(), [](restore_report const& one) {
                    return one.held == std::uint16_t{0} and
                           (one.outcome == told::planned or one.outcome == told::needs_autorestart);
                });
            };
            was_told = is_told("ATR") and is_told("FLR");
            drive.after_write = {};
        };
        restore_options options = ordinary_ones;
        options.with_autorestart = is_asked;
        REQUIRE(bench.restore({{"SP2", static_cast<std::uint16_t>(1 + is_asked)}, {"ATR", 1}, {"FLR", 1}}, all, options)
                    .kind == kind::succeeded);
        CHECK(was_told);
        CHECK(drive.word(7122) == (is_asked ? 1 : 0));
    }
}

TEST_CASE("a dry run tells the same and writes nothing")
{
    paper_drive drive = small_drive();
    auto const before = drive.registers.size();
    paper_bench bench{drive};
    restore_options options = all_of_it;
    options.dry_run = true;
    options.save = true;
    told_list all;
    CHECK(bench.restore(other_words(), all, options).kind == kind::succeeded);
    CHECK(drive.writes.empty());
    CHECK(drive.commands.empty());
    CHECK(drive.saves == 0);
    CHECK(drive.registers.size() == before);
    std::vector<std::string> planned;
    for (auto const& [code, reports] : all.of) {
        if (reports.back().outcome == told::planned) {
            CHECK(reports.back().held == held(drive, code.c_str()));
            planned.push_back(code);
        }
    }
    told_list real;
    options.dry_run = false;
    REQUIRE(bench.restore(other_words(), real, options).kind == kind::succeeded);
    std::sort(real.written.begin(), real.written.end());
    CHECK(planned == real.written);
}

TEST_CASE("a drive that holds the configuration gets no write, and is saved where that was asked for")
{
    paper_drive drive = small_drive();
    word_list words;
    small_map.for_each([&](parameter const& row, parameter_group const&) {
        words[rtuwire::test::text_of(row.code)] = drive.word(row.address);
    });
    paper_bench bench{drive};
    told_list all;
    restore_options options = all_of_it;
    CHECK(bench.restore(words, all, options).kind == kind::succeeded);
    CHECK(drive.writes.empty());
    options.save = true;
    CHECK(bench.restore(words, all, options).kind == kind::succeeded);
    CHECK(drive.writes.empty());
    CHECK(drive.saves == 1);
}

TEST_CASE("no write goes to a drive that runs, is commanded, in another state, or another one")
{
    paper_drive drive = small_drive();
    std::uint16_t status = 0;
    kind expected{};
    std::tie(status, expected) = GENERATE(Catch::Generators::table<std::uint16_t, kind>({
        {0x0237, kind::refused_while_running}, // operation enabled
        {0x0217, kind::refused_while_running}, // quick stop active
        {0x023F, kind::refused_while_running}, // fault reaction
        {0x0000, kind::aborted},               // not ready
        {0x0250, kind::succeeded},
        {0x0231, kind::succeeded}, // ready
        {0x0238, kind::succeeded}, // fault
    }));
    drive.set(paper_drive::status, status);
    paper_bench bench{drive};
    told_list all;
    CHECK(bench.restore({{"SP2", 44}, {"SP6", 5}}, all, ordinary_ones).kind == expected);
    CHECK(drive.writes.size() == (expected == kind::succeeded ? 2 : 0));
    CHECK(all.last("SP6").outcome == (expected == kind::succeeded ? told::holds : told::not_reached));
}

TEST_CASE("no write goes to a drive with a command, or whose motor turns")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    SECTION("a command")
    {
        drive.set(paper_drive::command, 6);
        CHECK(bench.restore({{"SP2", 44}}, all, ordinary_ones).kind == kind::overwritten);
    }
    SECTION("a motor that coasts")
    {
        drive.set(paper_drive::speed, static_cast<std::uint16_t>(-3));
        CHECK(bench.restore({{"SP2", 44}}, all, ordinary_ones).kind == kind::refused_while_running);
    }
    SECTION("a configuration of another family")
    {
        CHECK(bench.restore({{"SP2", 44}}, all, ordinary_ones, "atv31c").kind == kind::other_family);
        CHECK(drive.requests() == 0);
    }
    CHECK(drive.writes.empty());
    CHECK(all.last("SP2").outcome == told::not_reached);
}

TEST_CASE("a drive of another family gets no write; one that does not say what it is, is known by what it lacks")
{
    paper_drive drive = small_drive();
    told_list all;
    SECTION("a configuration that names no family")
    {
        CHECK_FALSE(identity_check{drive_family{}, drive_family{}, {}, true}.is_meant()); // nor for a drive of none
        paper_bench bench{drive};
        CHECK(bench.restore({{"SP2", 44}}, all, ordinary_ones, "unseen").kind == kind::other_family);
        CHECK(drive.requests() == 0);
    }
    SECTION("a map of another family")
    {
        parameter_map const map_of_another{small::groups, "ATV12"};
        paper_bench bench{drive};
        word_list const words{{"SP2", 44}};
        auto const ignored = [](auto const&...) {};
        restore conversation{paper_station, map_of_another,
                             wanted_settings{drive_family::of("ATV320"), words_by_code{&words}}, ignored,
                             ordinary_ones};
        CHECK(bench.line.run(conversation, milliseconds(60'000)).kind == kind::other_family);
        CHECK(drive.requests() == 0);
    }
    SECTION("by its product code")
    {
        paper_bench<12> bench{drive};
        CHECK(bench.restore({{"SP2", 44}}, all, ordinary_ones).kind == kind::other_family);
        CHECK(drive.writes.empty());
    }
    SECTION("without one, it has all registers that are only read")
    {
        paper_bench<0> bench{drive};
        CHECK(bench.restore({{"SP2", 44}}, all, ordinary_ones).kind == kind::succeeded);
        CHECK(drive.word(11410) == 44);
    }
    SECTION("without one, it lacks a register")
    {
        drive.registers.erase(5202);
        paper_bench<0> bench{drive};
        CHECK(bench.restore({{"SP2", 44}}, all, ordinary_ones).kind == kind::other_family);
        CHECK(drive.writes.empty());
    }
}

TEST_CASE("a closed run input ends the restore before channels, and before whatever else may start the motor")
{
    paper_drive drive = small_drive();
    drive.set(5202, 1);
    paper_bench bench{drive};
    told_list all;
    CHECK(bench.restore({{"SP2", 44}, {"CD1", 1}}, all, all_of_it).kind == kind::run_input_closed);
    CHECK(drive.word(11410) == 44);
    CHECK(drive.word(8423) == 10);
    CHECK(all.last("SP2").outcome == told::holds);
    CHECK(all.last("CD1") == restore_report{told::not_reached, std::uint16_t{10}});
}

TEST_CASE("a motor that a terminal starts after a write loses its power")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    drive.after_write = [&](std::uint16_t address, std::uint16_t) { address == 8423 ? drive.run() : void(); };
    CHECK(bench.restore({{"SP2", 44}, {"CD1", 1}, {"CHCF", 2}}, all, all_of_it).kind == kind::started_by_terminals);
    CHECK(drive.commands == std::vector<std::uint16_t>{0});
    CHECK(drive.word(8401) == 1);
    CHECK(all.last("CD1").outcome == told::written);
    CHECK(all.last("CHCF").outcome == told::not_reached);
}

TEST_CASE("what the drive refuses is told with its exception, tried again while others succeed, and counted")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    drive.registers[11410].refuses_write = errc::server_device_failure;
    drive.registers[11411].highest = 100;
    drive.registers[11412].refuses_read = errc::illegal_data_address;
    CHECK(bench.restore({{"SP2", 11}, {"SP3", 111}, {"SP4", 1}, {"SP6", 5}}, all, ordinary_ones).kind ==
          kind::not_taken);
    CHECK(all.last("SP2") == restore_report{told::refused, std::uint16_t{100}, errc::server_device_failure});
    CHECK(all.last("SP3") == restore_report{told::refused, std::uint16_t{150}, errc::illegal_data_value});
    CHECK(all.last("SP4") == restore_report{told::unreadable, std::nullopt, errc::illegal_data_address});
    CHECK(all.last("SP6").outcome == told::holds);
    CHECK(bench.failed == 3);
    CHECK(bench.written == 1);

    SECTION("a register that waits for another")
    {
        drive.registers[11410].refuses_write = errc::server_device_failure;
        drive.after_write = [&](std::uint16_t address, std::uint16_t) {
            drive.registers[11410].refuses_write = address == 11414 ? errc::none : drive.registers[11410].refuses_write;
        };
        CHECK(bench.restore({{"SP2", 11}, {"SP6", 6}}, all, ordinary_ones).kind == kind::succeeded);
        CHECK(drive.word(11410) == 11);
    }
    SECTION("a word that is none of the register is not sent")
    {
        std::size_t const before = drive.writes.size();
        CHECK(bench.restore({{"SP2", 5991}}, all, ordinary_ones).kind == kind::not_taken);
        CHECK(bench.failed == 1);
        CHECK(all.last("SP2").outcome == told::out_of_limits);
        CHECK(drive.writes.size() == before);
    }
}

TEST_CASE("what one write changes in another is written again, and what never settles is told")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    SECTION("once")
    {
        drive.after_write = [&](std::uint16_t address, std::uint16_t) {
            if (address == 3052) { // a macro sets others
                drive.set(11410, 1), drive.set(11414, 1), drive.set(8423, 1);
            }
        };
        CHECK(bench.restore({{"CFG", 2}, {"SP2", 100}, {"SP6", 300}, {"CD1", 10}}, all, all_of_it).kind ==
              kind::succeeded);
        CHECK(drive.word(11410) == 100);
        CHECK(drive.word(8423) == 10);
    }
    SECTION("once, and the step that could mend it is over")
    {
        drive.after_write = [&](std::uint16_t address, std::uint16_t) {
            drive.writes.size() == 2 and address == 11410 ? drive.set(3052, 1) : void();
        };
        CHECK(bench.restore({{"CFG", 2}, {"SP2", 11}}, all, all_of_it).kind == kind::succeeded);
        CHECK(drive.word(3052) == 2);
        CHECK(drive.writes.size() == 3);
    }
    SECTION("always, in steps that are far apart: the agenda is gone through three times")
    {
        drive.after_write = [&](std::uint16_t address, std::uint16_t) {
            address == 3052 ? drive.set(11410, 1) : drive.set(3052, 1);
        };
        CHECK(bench.restore({{"CFG", 2}, {"SP2", 11}}, all, all_of_it).kind == kind::not_taken);
        CHECK(bench.failed == 1);
        CHECK(all.last("CFG") == restore_report{told::differs, std::uint16_t{1}});
        CHECK(drive.writes.size() == 6);
    }
    SECTION("always")
    {
        drive.after_write = [&](std::uint16_t address, std::uint16_t) {
            address == 11410 ? drive.set(11414, 1) : address == 11414 ? drive.set(11410, 1) : void();
        };
        CHECK(bench.restore({{"SP2", 11}, {"SP6", 5}}, all, ordinary_ones).kind == kind::not_taken);
        CHECK(bench.failed == 1);
        CHECK((all.last("SP2").outcome == told::differs) != (all.last("SP6").outcome == told::differs));
        CHECK(drive.writes.size() < 100);
    }
    SECTION("a drive that confirms, and does nothing")
    {
        drive.after_write = [&](std::uint16_t address, std::uint16_t) {
            address == 11410 ? drive.set(11410, 3) : void();
        };
        CHECK(bench.restore({{"SP2", 11}, {"SP6", 5}}, all, ordinary_ones).kind == kind::not_taken);
        CHECK(all.last("SP2") == restore_report{told::differs, std::uint16_t{3}});
    }
}

TEST_CASE("after the link's own was written the drive may be elsewhere")
{
    paper_drive drive = small_drive();
    paper_bench bench{drive};
    told_list all;
    drive.after_write = [&](std::uint16_t address, std::uint16_t) { address == 6001 ? bench.line.cut() : void(); };
    restore_options options = all_of_it;
    options.save = true;
    auto const how = bench.restore({{"SP2", 5}, {"ADD", 9}, {"TBR", 28}}, all, options);
    CHECK(how.kind == kind::silent);
    CHECK(how.error == errc::timed_out);
    CHECK(all.last("ADD").outcome == told::unconfirmed);
    CHECK(all.last("TBR").outcome == told::not_reached);
    CHECK(drive.saves == 1);
    CHECK(drive.writes.back() == std::pair<std::uint16_t, std::uint16_t>{6001, 9});
}

TEST_CASE("the order of the writes to frequency limits stands where they cross")
{
    for (auto const& words :
         {word_list{{"TFR", 450}, {"HSP", 400}, {"LSP", 350}}, word_list{{"TFR", 400}, {"HSP", 300}},
          word_list{{"LSP", 499}, {"HSP", 499}, {"TFR", 499}}, word_list{{"HSP", 5}, {"TFR", 5990}}}) {
        paper_drive drive = small_drive();
        paper_bench bench{drive};
        told_list all;
        CHECK(bench.restore(words, all, ordinary_ones).kind == kind::succeeded);
        for (auto const& [code, word] : words) {
            CHECK(held(drive, code.c_str()) == word);
        }
    }
}
