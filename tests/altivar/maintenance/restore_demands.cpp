// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A map whose rows forget what they are: the registers that the description of the drive names are never restored as
// ordinary settings.
#include <rtuwire/altivar/parameters/row_demands.hpp>

#include <vector>

#include "altivar/device/sixth_drive.hpp"
#include "altivar/maintenance/maintenance_bench.hpp"
#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/maintenance/restore.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using told = restore_outcome;

namespace {

constexpr row_access rw{access::read_write, provenance::documented};

// Addresses of the ATV320's manual, not of its table.
constexpr std::uint16_t never[]{8501,  8502,  8504,  8602,          // CMD, LFR, CMI, LFRD
                                3201,  3202,  3206,  7121,  5202,   // ETA, RFR, ETI, LFT, IL1R
                                12761, 12762, 12763, 12767, 12768}; // NC1 and on
constexpr std::uint16_t by_option[]{7010,  6005, 7122, 8401,
                                    8423,  8413, 8431, 11101, // SLL, TTO, ATR, CHCF, CD1, FR1, FLO, TCC
                                    12721, 12728};            // NCA1, NCA8

constexpr std::uint16_t wanted_word = 15;

/// Restores a map of one row, with every option that there is, to a drive that holds 0 there.
told restored(std::uint16_t address, row_role const& role, paper_drive& drive)
{
    drive = small_drive();
    drive.set(address, address == paper_drive::status ? drive.word(address) : 0);
    parameter const rows[]{{"X", address, rw, in<count16>, {}, {}, {}, "Forgotten", &role}};
    parameter_group const groups[]{{"x", rows}};
    told last{};
    paper_bench bench{drive};
    auto const report = [&](parameter_group const&, parameter const&, restore_report const& what) {
        last = what.outcome;
    };
    word_list const words{{"X", wanted_word}};
    restore conversation{paper_station, parameter_map{groups},
                         wanted_settings{drive_family::of(literal{"ATV320"}), words_by_code{&words}}, report,
                         all_of_it};
    static_cast<void>(bench.line.run(conversation, milliseconds(600'000)));
    return last;
}

bool was_sent_anything(paper_drive const& drive)
{
    return not drive.writes.empty() or not drive.commands.empty() or drive.saves != 0;
}

/// A drive whose command is at address 0, and its reference behind it; of its safeguards it has no CHCF.
struct drive_at_zero : atv99::plain_device {
    static constexpr reg<signed_decihertz> lfr{.code = "LFR", .address = 1};
    static constexpr auto const& frequency_reference = lfr;
    static constexpr drive_layout layout = [] {
        drive_layout as_told = atv99::plain_device::layout;
        as_told.cmd = 0;
        return as_told;
    }();
    static constexpr cycle_registers cycle{
        .by = function_code::write_multiple_registers, .reads = {2'310, 2'311}, .writes = {0, 1}, .speed = 2'310};
};

/// One that has nothing there: 0 is a word of its scanner that a program may use, and a safeguard that it lacks.
using drive_without_zero = atv99::device;

constexpr parameter at_zero(row_role const& role) { return {"X", 0, rw, in<count16>, {}, {}, {}, "Forgotten", &role}; }
STATIC_CHECK(not agrees_with_drive<drive_at_zero>(at_zero(roles::ordinary)));
STATIC_CHECK(not agrees_with_drive<drive_at_zero>(at_zero(roles::link_loss)));
STATIC_CHECK(agrees_with_drive<drive_at_zero>(at_zero(roles::commands)));
STATIC_CHECK(agrees_with_drive<drive_without_zero>(at_zero(roles::ordinary)));

// What meets a demand.
STATIC_CHECK(row_demand{1, true}.is_met_by(parameter_role::order));
STATIC_CHECK(not row_demand{1, true}.is_met_by(parameter_role::channel));
STATIC_CHECK(row_demand{1, false}.is_met_by(parameter_role::supervision));
STATIC_CHECK(not row_demand{1, false}.is_met_by(parameter_role::setting));

} // namespace

TEST_CASE("a row without a role at a register that commands the drive, or tells of it, is never restored")
{
    for (std::uint16_t const address : never) {
        for (row_role const* const role : {&roles::ordinary, &roles::speed, &roles::speed_limit, &roles::timeout}) {
            INFO(address << " " << static_cast<int>(role->role));
            paper_drive drive;
            CHECK(restored(address, *role, drive) == told::never_written);
            CHECK(not was_sent_anything(drive));
        }
    }
}

TEST_CASE("a row without a role at a safeguard of the drive is never restored")
{
    for (std::uint16_t const address : by_option) {
        for (row_role const* const role : {&roles::ordinary, &roles::ramp, &roles::steps}) {
            INFO(address << " " << static_cast<int>(role->role));
            paper_drive drive;
            CHECK(restored(address, *role, drive) == told::never_written);
            CHECK(not was_sent_anything(drive));
        }
    }
}

TEST_CASE("a row without a role at any other register is an ordinary setting")
{
    paper_drive drive;
    CHECK(restored(11410, roles::ordinary, drive) == told::holds);
    CHECK(drive.word(11410) == wanted_word);
}
