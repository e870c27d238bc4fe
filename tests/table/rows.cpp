// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A device as rows: registers of all four kinds, one word wide or several, by their mnemonics.
#include <rtuwire/table/row_table.hpp>

#include <array>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/client.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim/bench.hpp>

using namespace rtuwire;

namespace {

namespace meter {

using low_float = float32<volts, word_order::low_first>;
using high_float = float32<volts>;
using wide_counter = unsigned64<watt_hours>;
using offset = signed32<count16, word_order::low_first>;

inline constexpr reg<ascii<8>> place{.code = "PLACE", .address = 200};

namespace rows {

using namespace row_words;

inline constexpr choice tariffs[]{{1, "DAY", "day rate"}, {4, "NIGHT", "night rate"}};

// clang-format off
inline constexpr register_row measured[]{
    {"FIRST",  0,     input,    in<decihertz>},
    {"LAST",   65532, input,    in<wide_counter>},
    {"U1",     40,    input,    in<low_float>},
    {"U2",     42,    input,    in<high_float>},
    {"E",      44,    input,    in<wide_counter>},
    {"NOW",    48,    input,    tariffs},
};
inline constexpr register_row set[]{
    {"TARIFF", 40,    rw,       tariffs,    {},     {},     1, "Tariff"},
    {"ZERO",   41,    rw,       in<offset>, -70000, 70000, -5, "Offset"},
    {"HZ",     43,    ro,       in<decihertz>},
    {"K1",     40,    coil_rw,  in<bool>,   {},     {},     1, "Relay"},
    {"K2",     41,    coil_ro,  in<bool>},
    {"S1",     40,    discrete, in<bool>},
};
// clang-format on

} // namespace rows

struct device {
    static constexpr literal name{"meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{.read = 16};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using amounts = amount_types<high_float, low_float, wide_counter, offset, decihertz>;
    using registers = row_table<device, table<place>, rows::measured, rows::set>;
};
template <mnemonic Code> inline constexpr auto const& row = parameter_called<device, Code>;

} // namespace meter

// A row's type is that of the list, its word order among it, and its kind that of the column.
template <auto const& R> using form_of_register = typename std::remove_cvref_t<decltype(R)>::form;
STATIC_CHECK(std::same_as<form_of_register<meter::row<"U1">>, meter::low_float>);
STATIC_CHECK(std::same_as<form_of_register<meter::row<"U2">>, meter::high_float>);
STATIC_CHECK(std::same_as<form_of_register<meter::row<"E">>, meter::wide_counter>);
STATIC_CHECK(std::same_as<form_of_register<meter::row<"ZERO">>, meter::offset>);
STATIC_CHECK(meter::row<"U1">.space == register_space::input and meter::row<"U1">.mode == access::read_only);
STATIC_CHECK(meter::row<"K1">.space == register_space::coil and meter::row<"K1">.mode == access::read_write);
STATIC_CHECK(meter::row<"K2">.space == register_space::coil and meter::row<"K2">.mode == access::read_only);
STATIC_CHECK(meter::row<"S1">.space == register_space::discrete_input);
STATIC_CHECK(meter::row<"TARIFF">.space == register_space::holding and meter::row<"TARIFF">.name == literal{"Tariff"});

// Each address of each kind is one register's, with every word of it.
using all = meter::device::registers;
STATIC_CHECK(all::has_address(47, register_space::input) and not all::has_address(49, register_space::input));
STATIC_CHECK(all::has_address(42) and not all::has_address(44));
STATIC_CHECK(all::has_address(41, register_space::coil) and not all::has_address(41, register_space::discrete_input));
STATIC_CHECK(all::has_address(203) and not all::has_address(204)); // an object's
STATIC_CHECK(all::has_address(0, register_space::input) and all::has_address(65535, register_space::input));
STATIC_CHECK(all::size == 12);

constexpr station<meter::device> far_meter{unit_id{3}};

using bytes = std::vector<unsigned>;
using count = value_of<meter::row<"ZERO">>;

/// What is sent, without its check.
template <typename Conversation> bytes sent(Conversation const& what)
{
    bytes all_of_it;
    auto const frame = what.next();
    REQUIRE(frame.has_value());
    for (std::byte const each : frame->frame()) {
        all_of_it.push_back(std::to_integer<unsigned>(each));
    }
    all_of_it.resize(all_of_it.size() - 2);
    return all_of_it;
}

} // namespace

TEST_CASE("a row of any kind: what is sent is the function of its kind, its address and all its words")
{
    CHECK(sent(read<meter::row<"U1">>(far_meter)) == bytes{3, 4, 0, 40, 0, 2});
    CHECK(sent(read<meter::row<"E">>(far_meter)) == bytes{3, 4, 0, 44, 0, 4});
    CHECK(sent(read<meter::row<"FIRST">>(far_meter)) == bytes{3, 4, 0, 0, 0, 1});
    CHECK(sent(read<meter::row<"LAST">>(far_meter)) == bytes{3, 4, 0xFF, 0xFC, 0, 4});
    CHECK(sent(read<meter::row<"TARIFF">>(far_meter)) == bytes{3, 3, 0, 40, 0, 1});
    CHECK(sent(read<meter::row<"K2">>(far_meter)) == bytes{3, 1, 0, 41, 0, 1});
    CHECK(sent(read<meter::row<"S1">>(far_meter)) == bytes{3, 2, 0, 40, 0, 1});
    CHECK(sent(write<meter::row<"K1">>(far_meter, true)) == bytes{3, 5, 0, 40, 0xFF, 0});
    CHECK(sent(write<meter::row<"TARIFF">>(far_meter, named<"NIGHT">)) == bytes{3, 6, 0, 40, 0, 4});
    // 65538 is 0001 0002, its low word first.
    CHECK(sent(write<meter::row<"ZERO">>(far_meter, checked(count{65'538}))) ==
          bytes{3, 16, 0, 41, 0, 2, 4, 0, 2, 0, 1});
}

TEST_CASE("a row of any kind: limits and choices are kept")
{
    auto const too_high = write<meter::row<"ZERO">>(far_meter, checked(count{70'001}));
    auto const too_low = write<meter::row<"ZERO">>(far_meter, checked(count{-70'001}));
    CHECK(too_high.outcome().error() == errc::value_too_high);
    CHECK(too_low.outcome().error() == errc::value_too_low);
    using tariff = value_of<meter::row<"TARIFF">>;
    CHECK(setting<meter::row<"TARIFF">>::checked(static_cast<tariff>(2)).error() == errc::value_without_meaning);
    CHECK(setting<meter::row<"TARIFF">>::checked(static_cast<tariff>(4)).has_value());
}

TEST_CASE("a bank of all rows and objects answers for each kind, with the values as delivered")
{
    bank_of<meter::device> inside;
    CHECK(inside.get<meter::row<"TARIFF">>() == named<"DAY">);
    CHECK(inside.get<meter::row<"ZERO">>().count() == -5);
    CHECK(inside.get<meter::row<"K1">>());
    CHECK_FALSE(inside.get<meter::row<"S1">>());
    CHECK(inside.contains<meter::place>);

    inside.set<meter::row<"U1">>(real<volts>{1.0F});
    inside.set<meter::row<"U2">>(real<volts>{1.0F});
    std::array<std::byte, 8> out{};
    byte_writer writer{out};
    REQUIRE(inside.input_registers().read(40, 4, writer) == errc::none);
    // 1.0 is 3F80 0000: U1 has the low word first, U2 the high one.
    std::array<unsigned, 8> const expected{0, 0, 0x3F, 0x80, 0x3F, 0x80, 0, 0};
    for (std::size_t i = 0; i < out.size(); ++i) {
        CHECK(std::to_integer<unsigned>(out[i]) == expected[i]);
    }
}

TEST_CASE("rows of all kinds and an object are read by one plan, a request for each kind")
{
    using plan = read_plan<meter::device, meter::row<"U1">, meter::row<"NOW">, meter::row<"TARIFF">, meter::row<"K1">,
                           meter::row<"S1">, meter::place>;
    CHECK(plan::request_count == 5);
    bank_of<meter::device> inside;
    inside.set<meter::row<"U1">>(real<volts>{230.5F});
    inside.set<meter::row<"NOW">>(named<"NIGHT">);
    sim::bench bench{bus<2>{line_timing{19'200, character_format::even_8_1}}, bank_at{far_meter.unit(), inside}};
    poller<plan> panel{far_meter};
    REQUIRE(bench.run(panel));
    REQUIRE(panel.outcome());
    CHECK(*panel.latest().get<meter::row<"U1">>() == real<volts>{230.5F});
    CHECK(panel.latest().get<meter::row<"NOW">>() == named<"NIGHT">);
    CHECK(panel.latest().get<meter::row<"K1">>());
}

TEST_CASE("the rows of a device are walked in their order")
{
    std::string codes;
    all::for_each_row([&](register_row const& row) { codes += std::string{row.code.begin(), row.code.end()} + " "; });
    CHECK(codes == "FIRST LAST U1 U2 E NOW TARIFF ZERO HZ K1 K2 S1 ");
}
