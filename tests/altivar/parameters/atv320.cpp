// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The full map of the ATV320: registers and rows agree, and a program reads and writes any of them typed.
#include <rtuwire/altivar/parameters/atv320.hpp>

#include "altivar/parameters/agreement.hpp"

#include <string>
#include <string_view>

#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

TEST_CASE("parameters of the ATV320: each register for driving is a row, and takes what the row takes")
{
    test::check_agreement<atv320::device, atv320::full_device>(atv320::parameters, atv320::unverified_parameters);
}

TEST_CASE("parameters of the ATV320: a register by its mnemonic takes what its row takes")
{
    test::check_row<atv320::parameter<"TDC1">>(atv320::parameters);
    test::check_row<atv320::parameter<"NST">>(atv320::parameters);
    test::check_row<atv320::parameter<"SMIL">>(atv320::parameters);
    test::check_row<atv320::parameter<"OL1R">>(atv320::parameters);
    test::check_row<atv320::parameter<"CP1">>(atv320::parameters);
}

// A register of the map is none of the device for driving.
STATIC_CHECK(has_register<atv320::full_device, atv320::parameter<"SP2">> and
             not has_register<atv320::device, atv320::parameter<"SP2">>);

static_assert(setting<atv320::parameter<"SP2">>{12.5_Hz}.word() == 125); // Clang 14 fails on it at run time
STATIC_CHECK(setting<atv320::parameter<"SP2">>::checked(decihertz{5991}).error() == errc::value_too_high);
STATIC_CHECK(atv320::full_device::registers::has_address(11410) and
             not atv320::full_device::registers::has_address(11409));

TEST_CASE("parameters of the ATV320: a row is found by its mnemonic and by its address")
{
    parameter const* const row = atv320::parameters.by_code("SP2");
    REQUIRE(row != nullptr);
    CHECK(row == atv320::parameters.at(11410));
    CHECK(row->type->unit == literal{"Hz"});
    CHECK(row->type->step_denominator == 10);
    CHECK(row->max.raw() == 5990);
    CHECK(row->takes(5990));
    CHECK_FALSE(row->takes(5991));
    CHECK(atv320::parameters.by_code("CLI") == nullptr);
    CHECK(atv320::parameters.at(1) == nullptr);
    parameter const* const record = atv320::unverified_parameters.by_code("CLI");
    REQUIRE(record != nullptr);
    CHECK_FALSE(record->is_writable());
}

TEST_CASE("parameters of the ATV320: a row is found by a text that is known only when the program runs")
{
    std::string entered{"SP2 and more"};
    CHECK(atv320::parameters.by_code(entered) == nullptr);
    CHECK(atv320::parameters.by_code(std::string_view{entered}.substr(0, 3)) == atv320::parameters.at(11410));
    entered.resize(3);
    CHECK(atv320::parameters.by_code(entered) == atv320::parameters.at(11410));
    CHECK(atv320::parameters.by_code(literal{"SP2"}) == atv320::parameters.at(11410));
    for (std::string_view const unknown : {"", "S", "SP", "sp2", "SP22", "NONE"}) {
        CHECK(atv320::parameters.by_code(unknown) == nullptr);
    }
}
STATIC_CHECK(atv320::parameters.by_code(std::string_view{"SP2"}) == atv320::parameters.by_code("SP2"));

} // namespace
