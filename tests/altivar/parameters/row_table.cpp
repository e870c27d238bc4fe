// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Rows as registers of a device: by their mnemonics, with values by their names.
#include <rtuwire/altivar/parameters/row_table.hpp>

#include "support/proof.hpp"

#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/altivar/atv310_parameters.hpp>
#include <rtuwire/altivar/atv320_parameters.hpp>
#include <rtuwire/client.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr station<atv320::full_device> drive{unit_id{2}};

// What a row holds is the type of its register.
STATIC_CHECK(std::same_as<value_of<atv320::parameter<"TDC1">>, deciseconds>);
STATIC_CHECK(std::same_as<value_of<atv320::parameter<"CP1">>, signed_deciamperes>);
STATIC_CHECK(std::same_as<value_of<atv320::parameter<"OL1R">>, flags<bit_number>>);
STATIC_CHECK(register_enumeration<value_of<atv320::parameter<"NST">>>);
STATIC_CHECK(not std::same_as<value_of<atv320::parameter<"NST">>, value_of<atv320::parameter<"FST">>>);

// A mnemonic is one register, and its own.
STATIC_CHECK(is_same_register<atv320::parameter<"TDC1">, atv320::parameter<"TDC1">>);
STATIC_CHECK(not is_same_register<atv320::parameter<"TDC1">, atv320::parameter<"TDC2">>);

// None of another drive; an ATV310 has the same in both editions of its manual.
STATIC_CHECK(has_register<atv320::full_device, atv320::parameter<"SP2">>);
STATIC_CHECK(not has_register<atv320::full_device, atv12::parameter<"SP2">>);
STATIC_CHECK(not has_register<atv320::device, atv320::parameter<"SP2">>);
STATIC_CHECK(has_register<atv310::full_device, atv310::parameter<"CTT">>);
STATIC_CHECK(has_register<atv310::full_device_2014, atv310::parameter<"CTT">>);
STATIC_CHECK(has_register<atv320::full_device, atv320::acc>and has_register<atv310::full_device, atv310::nma8>);
STATIC_CHECK(not has_register<atv310::full_device_2014, atv310::nma8>);

// By the mnemonic, or by what it means; of an enumeration with a type, too.
constexpr setting<atv320::parameter<"FLR">> by_mnemonic = named<"YES">;
STATIC_CHECK(by_mnemonic.word() == 1);
constexpr setting<atv320::parameter<"RPT">> by_meaning = named<"as TA1 to TA4 say">;
STATIC_CHECK(by_meaning.word() == 3 and by_meaning.value() == named<"CUS">);
STATIC_CHECK(atv320::stop_mode::rmp == named<"rMP"> and not(atv320::stop_mode::fst == named<"rMP">));
STATIC_CHECK(setting<atv320::parameter<"RPT">>::checked(static_cast<value_of<atv320::parameter<"RPT">>>(4)).error() ==
             errc::value_without_meaning);

// In a plan, beside objects, with limits that others set.
using plan = read_plan<atv320::full_device, atv320::parameter<"SP2">, atv320::rfr, atv320::parameter<"NST">>;
STATIC_CHECK(plan::register_count == 3 and plan::contains<atv320::parameter<"SP2">>);
STATIC_CHECK(not plan::contains<atv320::parameter<"SP3">>);

template <typename... Ts> constexpr bool are_told_apart(amount_types<Ts...>)
{
    std::size_t place = 0;
    return ((amount_types<Ts...>::place_of(in<Ts>) == place++) and ...);
}
STATIC_CHECK(are_told_apart(usual_amounts{}));

TEST_CASE("a parameter by its mnemonic: what is sent is its row's address, and the word of the name")
{
    auto asked = write<atv320::parameter<"RPT">>(drive, named<"CUS">);
    auto const frame = asked.next();
    REQUIRE(frame.has_value());
    byte_view const bytes = frame->frame();
    REQUIRE(bytes.size() == 8);
    CHECK(to_u8(bytes[0]) == 2);
    CHECK(to_u8(bytes[1]) == 6);
    CHECK((to_u8(bytes[2]) << 8U | to_u8(bytes[3])) == 9004);
    CHECK((to_u8(bytes[4]) << 8U | to_u8(bytes[5])) == 3);
}

TEST_CASE("a parameter by its mnemonic: the text of a value is its mnemonic and what it means")
{
    constexpr value_of<atv320::parameter<"RPT">> linear = named<"LIn">;
    auto const text = text_of(linear);
    CHECK(std::string(text.begin(), text.end()) == "LIn: linear");
}

} // namespace
