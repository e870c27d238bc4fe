// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The parameters of a drive of one's own: the rows say what its list says, and the drive with all of them is simulated.
#include <rtuwire/altivar/own_parameters.hpp>

#include "altivar/parameters/own_parameters.hpp"
#include "support/catch.hpp"
#include "support/own_file.hpp"

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

//! [list]
/// The columns of one line, empty ones too.
std::vector<std::string> columns_of(std::string const& line)
{
    std::vector<std::string> columns;
    std::istringstream rest{line + ","};
    for (std::string column; std::getline(rest, column, ',');) {
        columns.push_back(column);
    }
    return columns;
}

std::vector<std::vector<std::string>> list_of(std::string const& path)
{
    std::ifstream file{path};
    std::vector<std::vector<std::string>> lines;
    std::string line;
    std::getline(file, line); // the heads of the columns
    while (std::getline(file, line)) {
        lines.push_back(columns_of(line));
    }
    return lines;
}
//! [list]

//! [compare]
rtuwire::access mode_of(std::string const& text)
{
    using rtuwire::access;
    return text == "r" ? access::read_only : text == "conf" ? access::configuration : access::read_write;
}

parameter_kind kind_of(std::string const& text)
{
    return text == "bits"    ? parameter_kind::bits
           : text == "enum"  ? parameter_kind::enumeration
           : text == "int16" ? parameter_kind::signed_number
                             : parameter_kind::number;
}

/// "0=Auto;1=On", as the list writes it.
std::string values_of(parameter const& row)
{
    std::string text;
    for (choice const& each : row.listed()) {
        text +=
            (text.empty() ? "" : ";") + std::to_string(each.word) + "=" + std::string{std::string_view{each.mnemonic}};
    }
    return text;
}

/// An amount of the list in counts of its row: 400 Hz are 4000 of a tenth.
long counts_of(std::string const& amount, parameter const& row)
{
    return std::lround(std::stod(amount) * row.type->step_denominator / row.type->step_numerator);
}

/// A limit of the list; where it has none, the row has none.
void check_limit(bound const& limit, std::string const& amount, parameter const& row)
{
    REQUIRE(limit.is_open() == amount.empty());
    if (not amount.empty()) {
        CHECK(limit.raw() == counts_of(amount, row));
    }
}

void check_factory(parameter const& row, std::string const& text)
{
    REQUIRE(row.factory.has_value() == not text.empty());
    if (row.type->kind == parameter_kind::enumeration) {
        CHECK(values_of(row).find(std::to_string(*row.factory) + "=" + text) != std::string::npos);
    } else if (not text.empty()) {
        CHECK(*row.factory == counts_of(text, row));
    }
}

void check_line(std::vector<std::string> const& line)
{
    parameter const* const row = atv99::parameters.by_code(line[0]);
    REQUIRE(row != nullptr);
    CHECK(row->address == std::stoul(line[1]));
    CHECK(row->mode() == mode_of(line[2]));
    CHECK(row->type->kind == kind_of(line[3]));
    CHECK(std::string_view{row->type->unit} == line[4]);
    CHECK((line[5].empty() or counts_of("1", *row) == std::lround(1 / std::stod(line[5]))));
    check_limit(row->min, line[6], *row);
    check_limit(row->max, line[7], *row);
    check_factory(*row, line[8]);
    CHECK(values_of(*row) == line[9]);
}

TEST_CASE("parameters of one's own: each line of the list is a row, and each row a line")
{
    std::set<std::string> codes;
    for (auto const& line : list_of(test::own_file("altivar/parameters/own_list.csv"))) {
        CAPTURE(line[0]);
        CHECK(codes.insert(line[0]).second);
        check_line(line);
    }
    CHECK(codes.size() == atv99::parameters.size());
    CHECK(codes.size() == atv99::full_device::registers::size);
}
//! [compare]

TEST_CASE("parameters of one's own: the bits of the words that all drives share have names")
{
    parameter const* const status = atv99::parameters.by_code("ETA");
    REQUIRE(status != nullptr);
    REQUIRE(status->type->kind == parameter_kind::bits);
    REQUIRE(status->choices().size() > 3);
    CHECK(status->choices()[3].word == 3);
    CHECK(std::string_view{status->choices()[3].meaning} == "in fault");
}

// 200 to 240 V and 380 to 460 V.
inline constexpr reg<volts> with_gap{.code = "UNS", .address = 2, .min = {200}, .max = {460}, .gap = {241, 379}};

TEST_CASE("parameters of one's own: a row takes what its register takes, and nothing in its gap")
{
    parameter const row = row_of(with_gap, roles::ordinary);
    for (std::uint16_t count = 190; count < 470; ++count) {
        CAPTURE(count);
        CHECK(row.takes(count) == setting<with_gap>::checked(volts{count}).has_value());
    }
}

//! [simulated]
TEST_CASE("parameters of one's own: the drive with all of them is simulated")
{
    constexpr station<atv99::full_device> drive{unit_id{41}};
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, drive};
    CHECK(bench.run(read<atv99::parameter<"SP2">>(drive)) == 10_Hz);
    CHECK(bench.run(write<atv99::parameter<"SP2">>(drive, 12.5_Hz)));
    CHECK(bench.run(read<atv99::parameter<"SP2">>(drive)) == 12.5_Hz);
    CHECK(bench.run(write<atv99::parameter<"FFM">>(drive, named<"Off">)));
}
//! [simulated]

} // namespace
