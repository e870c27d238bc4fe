// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Menu numbers and mnemonics, looked up both ways, by constants and by texts that the program gets while it runs. Which
// number the manuals print for which address is compared in tests/parameters.
#include <rtuwire/altivar/parameters/menu_numbers.hpp>

#include "support/proof.hpp"

#include <string>
#include <string_view>

#include <rtuwire/altivar/atv310_parameters.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr menu_number two_rows[]{{"501.0", "ACC"}, {"501.1", "DEC"}};
constexpr menu_numbers menu{two_rows};

STATIC_CHECK(menu.code_of("501.1") == literal{"DEC"} and menu.number_of("ACC") == literal{"501.0"});
STATIC_CHECK(menu.code_of("501").size() == 0 and menu.number_of("AC").size() == 0);
STATIC_CHECK(menu.code_of(std::string_view{"501.0"}) == literal{"ACC"});

TEST_CASE("menu numbers: a text that somebody typed is one of them or none")
{
    std::string typed{"501.0 and more"};
    CHECK(menu.code_of(typed).size() == 0);
    typed.resize(5);
    CHECK(menu.code_of(typed) == literal{"ACC"});
    CHECK(menu.number_of(std::string_view{"DEC"}) == literal{"501.1"});
    for (std::string_view const unknown : {"", "5", "501", "501.", "501.2", "501.00", "0501.0", "ACC"}) {
        CHECK(menu.code_of(unknown).size() == 0);
    }
    for (std::string_view const unknown : {"", "acc", "ACC ", "501.0"}) {
        CHECK(menu.number_of(unknown).size() == 0);
    }
}

/// Each row leads to the other name and back, and to a parameter of the map.
void check_both_ways(menu_numbers const& of)
{
    for (menu_number const& each : of.rows()) {
        CAPTURE(std::string_view{each.number});
        CHECK(of.code_of(each.number) == each.code);
        CHECK(of.number_of(each.code) == each.number);
        CHECK(atv310::parameters.by_code(each.code) != nullptr);
    }
}

TEST_CASE("menu numbers of the ATV310: every number is that of one parameter, and every parameter's is one number")
{
    check_both_ways(atv310::menu_2014);
    check_both_ways(atv310::menu_2026);
}

TEST_CASE("menu numbers of the ATV310: what only the later manual prints is none of the earlier one")
{
    CHECK(atv310::menu_2026.code_of("705.4") == literal{"NMA5"});
    CHECK(atv310::menu_2014.code_of("705.4").size() == 0);
    CHECK(atv310::menu_2026.number_of("STT") == literal{"502.0"});
    CHECK(atv310::menu_2014.number_of("STT").size() == 0);
}

} // namespace
