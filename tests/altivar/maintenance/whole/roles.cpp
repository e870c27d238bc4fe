// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Every parameter of every map that can be written was looked at: roles.tsv says what it is.
#include <rtuwire/altivar/parameters/parameter.hpp>

#include <fstream>
#include <map>
#include <set>
#include <string>

#include "support/catch.hpp"
#include "support/own_file.hpp"

#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/altivar/atv310_parameters.hpp>
#include <rtuwire/altivar/atv320_parameters.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/maintenance/restore_agenda.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

std::map<parameter_role, std::string> const role_names{{parameter_role::setting, "setting"},
                                                       {parameter_role::macro, "macro"},
                                                       {parameter_role::step_size, "step_size"},
                                                       {parameter_role::frequency_limit, "frequency_limit"},
                                                       {parameter_role::motion, "motion"},
                                                       {parameter_role::supervision, "supervision"},
                                                       {parameter_role::restart, "restart"},
                                                       {parameter_role::run_input, "run_input"},
                                                       {parameter_role::channel, "channel"},
                                                       {parameter_role::link_timeout, "link_timeout"},
                                                       {parameter_role::other_link, "other_link"},
                                                       {parameter_role::link, "link"},
                                                       {parameter_role::derived, "derived"},
                                                       {parameter_role::measured, "measured"},
                                                       {parameter_role::of_this_drive, "of_this_drive"},
                                                       {parameter_role::order, "order"},
                                                       {parameter_role::safety, "safety"}};

std::map<std::string, std::string> listed_roles()
{
    std::ifstream file{test::own_file("altivar/maintenance/whole/roles.tsv")};
    std::map<std::string, std::string> found;
    for (std::string line; std::getline(file, line);) {
        std::size_t const end = line.find('\t');
        if (end != std::string::npos) {
            found[line.substr(0, end)] = line.substr(end + 1);
        }
    }
    return found;
}

} // namespace

TEST_CASE("each parameter has the role that the list says, and a reason where it is no ordinary setting")
{
    auto const listed = listed_roles();
    REQUIRE(listed.size() > 600);
    std::set<std::string> seen;
    for (parameter_map const* const map : {&atv12::parameters, &atv310::parameters, &atv320::parameters}) {
        map->for_each([&](parameter const& row, parameter_group const&) {
            std::string const code{row.code.begin(), row.code.end()};
            INFO(code);
            if (not row.is_writable()) {
                CHECK(role_of(row) == parameter_role::read_only);
                CHECK(why(row).size() != 0);
                return;
            }
            seen.insert(code);
            REQUIRE(listed.count(code) == 1);
            CHECK(role_names.at(role_of(row)) == listed.at(code));
            CHECK((why(row).size() == 0) == (role_of(row) == parameter_role::setting));
            // What sets the steps of others is written before them.
            if (row.steps_set_by.size() != 0) {
                CHECK(role_of(*map->by_code(row.steps_set_by)) == parameter_role::step_size);
            }
        });
    }
    CHECK(seen.size() == listed.size());
}

TEST_CASE("what a drive's layout names as its safeguards is no ordinary setting")
{
    auto const check = [](parameter_map const& map, drive_layout const& layout) {
        auto const role = [&](std::uint16_t address) {
            parameter const* const row = address == 0 ? nullptr : map.at(address);
            return row == nullptr ? parameter_role::read_only : role_of(*row);
        };
        safeguard_layout const& at = layout.safeguards;
        for (std::uint16_t const address : {at.chcf, at.cd1, at.fr1, at.flo}) {
            CHECK((address == 0 or role(address) == parameter_role::channel));
        }
        CHECK((at.sll == 0 or role(at.sll) == parameter_role::supervision));
        CHECK((at.tto == 0 or role(at.tto) == parameter_role::link_timeout));
        CHECK((at.atr == 0 or role(at.atr) == parameter_role::restart));
        CHECK((at.tcc == 0 or role(at.tcc) == parameter_role::run_input));
        for (std::uint16_t const address : {layout.cmd, layout.cmi}) {
            CHECK(role(address) == parameter_role::order);
        }
    };
    check(atv12::parameters, atv12::device::layout);
    check(atv310::parameters, atv310::device::layout);
    check(atv320::parameters, atv320::device::layout);
}

TEST_CASE("no row of a drive is left out of a restore for want of a role")
{
    CHECK(drive_check<atv12::full_device>::passed);
    CHECK(drive_check<atv310::full_device>::passed);
    CHECK(drive_check<atv310::full_device_2014>::passed);
    CHECK(drive_check<atv320::full_device>::passed);
}
