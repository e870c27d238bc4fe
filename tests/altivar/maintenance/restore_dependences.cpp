// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a write depends on beside its own register: the steps that its count is of, limits that have to fit each other, and
// the inputs of a drive whose motor the write may set free.
#include <rtuwire/altivar/maintenance/restore.hpp>

#include "altivar/maintenance/maintenance_bench.hpp"
#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using told = restore_outcome;
using kind = outcome_kind;

namespace {

constexpr std::uint16_t acc = 9001, dec = 9002, inr = 9020, sp2 = 11410;
constexpr std::uint16_t tfr = paper_drive::tfr, hsp = paper_drive::hsp, lsp = paper_drive::lsp;
constexpr std::uint16_t tcc = 11101, nst = 11202, inputs = 5202;

/// The time of a ramp in hundredths of a second: INR 0, 1, 2 are steps of 0.01 s, 0.1 s, 1 s.
unsigned ramp(paper_drive const& drive, std::uint16_t address)
{
    unsigned const steps[]{1, 10, 100};
    return drive.word(address) * steps[drive.word(inr)];
}

} // namespace

TEST_CASE("a ramp is written in the steps of its configuration, or not at all")
{
    paper_drive drive = small_drive(); // 30 steps of 0.1 s
    drive.save();
    paper_bench bench{drive};
    told_list all;
    word_list words{{"INR", 0}, {"ACC", 300}, {"DEC", 400}, {"SP2", 11}};
    SECTION("with INR")
    {
        CHECK(bench.restore(words, all, ordinary_ones).kind == kind::succeeded);
        CHECK(ramp(drive, acc) == 300);
        CHECK(ramp(drive, dec) == 400);
    }
    SECTION("INR is left out")
    {
        parameter changed[]{*small_map.at(inr)};
        changed[0].is_written.source = provenance::inferred;
        parameter_group const groups[]{small::groups[0], small::groups[1], {"steps", changed}};
        auto const report = [&](parameter_group const&, parameter const& row, restore_report const& what) {
            all(row, what);
        };
        // The row of the map that is found first has the say, so the map has INR once only.
        std::vector<parameter> others;
        for (parameter const& each : groups[0].rows) {
            if (each.address != inr) {
                others.push_back(each);
            }
        }
        parameter_group const with_one[]{{"settings", others}, groups[1], groups[2]};
        restore conversation{paper_station, parameter_map{with_one},
                             wanted_settings{drive_family::of("ATV320"), words_by_code{&words}}, report,
                             restore_options{}};
        CHECK(bench.line.run(conversation, milliseconds(600'000)).kind == kind::not_taken);
        CHECK(conversation.failed() == 2);
        CHECK(all.last("INR").outcome == told::needs_inferred);
        CHECK(all.last("ACC") == restore_report{told::other_steps, std::uint16_t{30}});
        CHECK(ramp(drive, acc) == 300);
        CHECK(drive.word(acc) == 30);
        CHECK(drive.word(sp2) == 11);

        // Where the drive counts as the configuration does, nothing is in the way.
        drive.set(inr, 0);
        restore again{paper_station, parameter_map{with_one},
                      wanted_settings{drive_family::of("ATV320"), words_by_code{&words}}, report, restore_options{}};
        CHECK(bench.line.run(again, milliseconds(600'000)).kind == kind::succeeded);
        CHECK(drive.word(acc) == 300);
    }
    SECTION("the configuration does not say which")
    {
        words.erase("INR");
        CHECK(bench.restore(words, all, ordinary_ones).kind == kind::not_taken);
        CHECK(all.last("DEC") == restore_report{told::other_steps, std::uint16_t{30}});
        CHECK(drive.word(dec) == 30);
        CHECK(bench.failed == 2);
    }
    SECTION("INR alone would make other ramps of those that are left alone")
    {
        words.erase("ACC");
        CHECK(bench.restore(words, all, ordinary_ones).kind == kind::not_taken);
        CHECK(all.last("INR") == restore_report{told::other_steps, std::uint16_t{1}});
        CHECK(all.last("DEC").outcome == told::other_steps);
        CHECK(ramp(drive, acc) == 300);
        CHECK(ramp(drive, dec) == 300);
        CHECK(drive.word(sp2) == 11);

        words["INR"] = 1; // as it is: then the others may come alone
        CHECK(bench.restore(words, all, ordinary_ones).kind == kind::succeeded);
        CHECK(drive.word(dec) == 400);
    }
    SECTION("a ramp that is right as a number is none in other steps")
    {
        words = {{"ACC", 30}};
        CHECK(bench.restore(words, all, ordinary_ones).kind == kind::not_taken);
        CHECK(all.last("ACC").outcome == told::other_steps);
    }
    SECTION("the drive refuses INR")
    {
        drive.registers[inr].refuses_write = errc::server_device_failure;
        CHECK(bench.restore(words, all, ordinary_ones).kind == kind::not_taken);
        CHECK(all.last("INR").outcome == told::refused);
        CHECK(all.last("ACC").outcome == told::other_steps);
        CHECK(drive.word(acc) == 30);
        CHECK(bench.failed == 3);
    }
    SECTION("the drive does not tell INR")
    {
        drive.registers[inr].refuses_read = errc::illegal_data_address;
        CHECK(bench.restore(words, all, ordinary_ones).kind == kind::not_taken);
        CHECK(all.last("ACC").outcome == told::other_steps);
        CHECK(drive.word(acc) == 30);
    }
    SECTION("a dry run says the same as the restore")
    {
        restore_options options = ordinary_ones;
        options.dry_run = true;
        CHECK(bench.restore(words, all, options).kind == kind::succeeded);
        CHECK(all.last("ACC").outcome == told::planned);
        words.erase("INR");
        CHECK(bench.restore(words, all, options).kind == kind::not_taken);
        CHECK(all.last("ACC").outcome == told::other_steps);
        CHECK(drive.writes.empty());
    }
}

TEST_CASE("a configuration that changes its mind gets no word written that was not judged")
{
    // Of each parameter it is asked many times: from one of these times on it says something else.
    for (std::optional<std::uint16_t> const later : {std::optional<std::uint16_t>{}, {std::uint16_t{5991}}}) {
        for (unsigned from = 1; from < 40; ++from) {
            paper_drive drive = small_drive();
            paper_bench bench{drive};
            unsigned asked = 0;
            auto const words = [&](parameter const& row) -> std::optional<std::uint16_t> {
                if (row.address != sp2) {
                    return std::nullopt;
                }
                return ++asked < from ? std::optional<std::uint16_t>{11} : later;
            };
            auto const ignored = [](auto const&...) {};
            restore conversation{paper_station, small_map, wanted_settings{drive_family::of("ATV320"), words}, ignored,
                                 ordinary_ones};
            static_cast<void>(bench.line.run(conversation, milliseconds(60'000)));
            INFO("from the time " << from);
            for (auto const& [address, word] : drive.writes) {
                CHECK(address == sp2);
                CHECK(word == 11);
            }
        }
    }
}

TEST_CASE("of limits that do not fit each other none is written")
{
    for (bool const checks : {false, true}) {
        for (auto const& words :
             {word_list{{"LSP", 400}, {"HSP", 100}}, word_list{{"HSP", 650}}, word_list{{"TFR", 450}},
              word_list{{"LSP", 501}}, word_list{{"TFR", 90}, {"HSP", 100}},
              word_list{{"TFR", 700}, {"HSP", 100}, {"LSP", 101}}}) {
            paper_drive drive = small_drive();
            drive.is_lenient = not checks;
            paper_bench bench{drive};
            told_list all;
            CHECK(bench.restore(words, all, ordinary_ones).kind == kind::not_taken);
            CHECK(drive.writes.empty());
            CHECK(bench.failed == words.size());
            for (auto const& [code, word] : words) {
                CHECK(all.last(code).outcome == told::out_of_limits);
                CHECK(all.last(code).held == drive.word(small_map.by_code(code)->address));
            }
        }
    }
}

TEST_CASE("a limit that the drive does not take holds back those that need it")
{
    paper_drive drive = small_drive(); // 0 <= 50.0 <= 60.0 Hz
    drive.is_lenient = true;
    drive.registers[hsp].refuses_write = errc::server_device_failure;
    paper_bench bench{drive};
    told_list all;
    CHECK(bench.restore({{"LSP", 700}, {"HSP", 800}, {"TFR", 900}}, all, ordinary_ones).kind == kind::not_taken);
    CHECK(drive.word(lsp) == 0);
    CHECK(drive.word(tfr) == 900);
    CHECK(all.last("HSP").outcome == told::refused);
    CHECK(all.last("LSP").outcome == told::out_of_limits);
    CHECK(bench.failed == 2);
}

TEST_CASE("one limit that cannot be read counts once, in a dry run as well")
{
    for (bool const is_dry : {false, true}) {
        paper_drive drive = small_drive();
        drive.registers[hsp].refuses_read = errc::server_device_failure;
        paper_bench bench{drive};
        told_list all;
        restore_options options = ordinary_ones;
        options.dry_run = is_dry;
        CHECK(bench.restore({{"HSP", 400}}, all, options).kind == kind::not_taken);
        CHECK(bench.failed == 1);
    }
}

TEST_CASE("a stop contact of three-wire control is no run input yet, and would be one")
{
    paper_drive drive = small_drive();
    drive.set(tcc, 1);
    drive.set(inputs, 1); // the contact is closed, as it is at rest
    drive.after_write = [&](std::uint16_t address, std::uint16_t word) {
        address == tcc and word == 0 ? drive.run() : void();
    };
    paper_bench bench{drive};
    told_list all;
    CHECK(bench.restore({{"TCC", 0}, {"SP2", 11}}, all, all_of_it).kind == kind::run_input_closed);
    CHECK(drive.word(tcc) == 1);
    CHECK(drive.word(paper_drive::speed) == 0);
}

TEST_CASE("what holds a motor back that a terminal commands is not taken away")
{
    paper_drive drive = small_drive();
    drive.set(inputs, 1);
    drive.set(nst, 130); // an open input keeps the motor without power
    drive.after_write = [&](std::uint16_t address, std::uint16_t word) {
        address == nst and word == 0 ? drive.run() : void();
    };
    paper_bench bench{drive};
    told_list all;
    CHECK(bench.restore({{"NST", 0}, {"SP2", 11}}, all, all_of_it).kind == kind::run_input_closed);
    CHECK(drive.word(nst) == 130);

    // An input that closes between the look and the write: the motor loses its power.
    drive.set(inputs, 0);
    CHECK(bench.restore({{"NST", 0}}, all, all_of_it).kind == kind::started_by_terminals);
    CHECK(drive.commands == std::vector<std::uint16_t>{0});
}
