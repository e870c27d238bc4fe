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
struct register_with_role {
    std::uint16_t address;
    parameter_role role;
};
constexpr register_with_role by_role[]{
    {7010, parameter_role::supervision},     {6005, parameter_role::link_timeout},    // SLL, TTO
    {7122, parameter_role::restart},         {8401, parameter_role::channel},         // ATR, CHCF
    {8423, parameter_role::channel},         {8413, parameter_role::channel},         // CD1, FR1
    {8431, parameter_role::channel},         {11101, parameter_role::run_input},      // FLO, TCC
    {12721, parameter_role::channel},        {12728, parameter_role::channel},        // NCA1, NCA8
    {8652, parameter_role::motion},                                                   // DOTD
    {3105, parameter_role::frequency_limit}, {3104, parameter_role::frequency_limit}, // LSP, HSP
};
constexpr row_role const* other_roles[]{&roles::ordinary,  &roles::ramp,      &roles::steps,  &roles::speed_limit,
                                        &roles::link_loss, &roles::timeout,   &roles::wiring, &roles::commander,
                                        &roles::restarts,  &roles::other_bus, &roles::macro,  &roles::this_line};

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
STATIC_CHECK(row_demand{1}.is_met_by(parameter_role::order));
STATIC_CHECK(row_demand{1}.is_met_by(parameter_role::read_only));
STATIC_CHECK(not row_demand{1}.is_met_by(parameter_role::channel));
STATIC_CHECK(row_demand{1, parameter_role::supervision}.is_met_by(parameter_role::supervision));
STATIC_CHECK(row_demand{1, parameter_role::supervision}.is_met_by(parameter_role::read_only));
STATIC_CHECK(not row_demand{1, parameter_role::supervision}.is_met_by(parameter_role::other_link));
STATIC_CHECK(not row_demand{1, parameter_role::supervision}.is_met_by(parameter_role::setting));

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

TEST_CASE("a row of another role at a safeguard of the drive, or at a limit of its speed, is never restored")
{
    for (register_with_role const& each : by_role) {
        for (row_role const* const role : other_roles) {
            if (role->role == each.role) {
                continue;
            }
            INFO(each.address << " " << static_cast<int>(role->role));
            paper_drive drive;
            CHECK(restored(each.address, *role, drive) == told::never_written);
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
