// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Texts, enumerations with holes, packed words and scaled counts.
#include <rtuwire/table/form/form_setting.hpp>

#include <string>
#include <string_view>

#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/table/form/ascii.hpp>
#include <rtuwire/table/form/packed.hpp>
#include <rtuwire/table/form/whole.hpp>
#include <rtuwire/table/register_text.hpp>

using namespace rtuwire;

namespace {

enum class valve : std::uint16_t { closed = 1, open = 4 };

} // namespace

template <>
inline constexpr auto rtuwire::enumerators<valve> = rtuwire::detail::name_list({{1, "closed"}, {4, "open"}});

namespace {

// Texts.
constexpr reg<ascii<8>> device_name{.code = "NAM", .address = 10};
constexpr reg<ascii<8, word_order::high_first_bytes_swapped>> swapped{.code = "SWP", .address = 20};
using words4 = std::array<std::uint16_t, 4>;
constexpr setting<device_name> entered_name = "PUMP 3";
STATIC_CHECK(entered_name.words() == words4{0x5055, 0x4D50, 0x2033, 0x0000});
constexpr setting<swapped> pump_swapped = "PUMP 3";
STATIC_CHECK(pump_swapped.words() == words4{0x5550, 0x504D, 0x3320, 0x0000});
STATIC_CHECK(ascii<8>::from_words({0x5055, 0x4D50, 0x2033, 0x0000})->size() == 6);
STATIC_CHECK(*ascii<8>::from_words({0x5055, 0x4D50, 0x2020, 0x2020}) == "PUMP");
STATIC_CHECK(*ascii<8>::from_words({0x5000, 0x4D50, 0x2020, 0x2020}) == "P");
STATIC_CHECK(*ascii<8>::from_words({0x2050, 0x2041, 0x4242, 0x4343}) == " P ABBCC");
STATIC_CHECK(*ascii<8>::from_words({0, 0, 0, 0}) == "" and *ascii<8>::from_words({0x2020, 0x2020, 0, 0}) == "");
STATIC_CHECK(setting<device_name>::checked(literal{"12345678"}).has_value());
STATIC_CHECK(setting<device_name>::checked(literal{"123456789"}).error() == errc::value_too_high);
// A text ends before its first zero, also one that is given with a size.
STATIC_CHECK(ascii<4>::to_words(*ascii<4>::convert(std::string_view{"A\0BCDE", 6})) == ascii<4>::words{0x4100, 0x0000});
STATIC_CHECK(ascii<4>::convert(std::string_view{"ABCDE"}) == errc::value_too_high);
STATIC_CHECK(text_of(*ascii<8>::from_words({0x5055, 0x4D50, 0, 0})) == "PUMP");

// An enumeration with holes.
constexpr reg<known<valve>> flap{.code = "FLP", .address = 30};
STATIC_CHECK(known<valve>::from_words({4}) == valve::open and known<valve>::from_words({1}) == valve::closed);
STATIC_CHECK(known<valve>::from_words({0}) == errc::value_without_meaning);
STATIC_CHECK(known<valve>::from_words({2}) == errc::value_without_meaning);
STATIC_CHECK(known<valve>::from_words({0xFFFF}) == errc::value_without_meaning);
constexpr setting<flap> opened = valve::open;
STATIC_CHECK(opened.word() == 4);

// Fields of one word.
constexpr field<count16, 0, 4> gear{};
constexpr field<signed_count16, 4, 3> trim{};
constexpr field<known<valve>, 8, 3> position{};
constexpr field<bool, 15, 1> enabled{};
using state = packed<gear, trim, position, enabled>;
constexpr reg<state> sta{.code = "STA", .address = 40};

// 1.... 100. 111. 0101: enabled, open, trim -1, gear 5; bits 7 and 11 to 14 belong to nobody.
constexpr state seen{0x8475};
STATIC_CHECK(seen.get<gear>() == count16{5} and seen.get<trim>() == signed_count16{-1});
STATIC_CHECK(seen.get<position>() == valve::open and seen.get<enabled>());
STATIC_CHECK(state{0x0275}.get<position>() == errc::value_without_meaning);
STATIC_CHECK(state{0xFFFF}.with<gear>(3_raw)->bits == 0xFFF3 and state{0x0000}.with<gear>(15_raw)->bits == 0x000F);
STATIC_CHECK(state{0x0000}.with<trim>(signed_count16{-4})->bits == 0x0040);
STATIC_CHECK(state{0xFFFF}.with<trim>(signed_count16{3})->bits == 0xFFBF);
STATIC_CHECK(state{0xFFFF}.with<position>(valve::closed)->bits == 0xF9FF);
STATIC_CHECK(state{0xFFFF}.with<enabled>(false)->bits == 0x7FFF);
STATIC_CHECK(state{0}.with<gear>(16_raw) == errc::value_too_high);
STATIC_CHECK(state{0}.with<trim>(signed_count16{4}) == errc::value_too_high);
STATIC_CHECK(state{0}.with<trim>(signed_count16{-5}) == errc::value_too_low);
STATIC_CHECK(state{0}.with<position>(static_cast<valve>(2)) == errc::value_without_meaning);
constexpr setting<sta> stated = state{0x8475};
STATIC_CHECK(stated.word() == 0x8475);

// A field as wide as its word.
constexpr field<signed_count16, 0, 16> all{};
STATIC_CHECK(packed<all>{0x8000}.get<all>() == signed_count16{-32'768});
STATIC_CHECK(packed<all>{0}.with<all>(signed_count16{-2})->bits == 0xFFFE);

// A count and its scale.
constexpr reg<signed_count16> sf{.code = "SF", .address = 5};
using volt_form = scaled_by<volts, sf>;
using watt_form = scaled_by<quantity<power, std::int32_t>, sf, word_order::low_first>;
using amount = scaled<volts>;
STATIC_CHECK(volt_form::from_words({2304}, 0xFFFF) == amount{2304, -1});
STATIC_CHECK(*volt_form::from_words({2304}, 0xFFFF) == 230.4_V and *volt_form::from_words({23}, 1) == 230_V);
STATIC_CHECK(*volt_form::from_words({2304}, 0xFFFF) > 230_V and 231_V > *volt_form::from_words({2304}, 0xFFFF));
STATIC_CHECK(watt_form::from_words({0xFFFE, 0xFFFF}, 3)->count() == -2);
STATIC_CHECK(*watt_form::from_words({0xFFFE, 0xFFFF}, 3) == -2000_W);
// "Not implemented", of a value and of a scale; a scale out of range.
STATIC_CHECK(volt_form::from_words({0xFFFF}, 0) == errc::value_without_meaning);
STATIC_CHECK(volt_form::from_words({0x8000}, 0)->count() == 0x8000);
STATIC_CHECK(watt_form::from_words({0x0000, 0x8000}, 0) == errc::value_without_meaning);
STATIC_CHECK(volt_form::from_words({1}, 0x8000) == errc::value_without_meaning);
STATIC_CHECK(volt_form::from_words({1}, 11) == errc::value_without_meaning and volt_form::from_words({1}, 10));
STATIC_CHECK(volt_form::from_words({1}, 0xFFF5) == errc::value_without_meaning and volt_form::from_words({1}, 0xFFF6));
// Beyond 64 bits on one side of the comparison.
using large = scaled<quantity<power, std::int32_t>>;
STATIC_CHECK(large{2'000'000'000, 10} > 9'223'372'036'854'775'800_W);
STATIC_CHECK(-9'223'372'036'854'775'800_W > large{-2'000'000'000, 10});
STATIC_CHECK(large{2'000'000'000, 10} > large{1'999'999'999, 10} and large{1, 0} == large{10, -1});
STATIC_CHECK(amount{2305, -1}.rounded_to<volts>() == volts{231} and amount{2304, -1}.rounded_to<volts>() == volts{230});
STATIC_CHECK(amount{2304, -1}.rounded_to<decivolts>() == decivolts{2304});
STATIC_CHECK(amount{7, 10}.rounded_to<volts>() == errc::value_too_high);
STATIC_CHECK(large{-7, 0}.rounded_to<watts>() == errc::value_too_low);
STATIC_CHECK(large{-15, -1}.rounded_to<quantity<power, std::int16_t>>() == quantity<power, std::int16_t>{-2});
STATIC_CHECK(amount{65'534, -10}.rounded_to<volts>() == volts{0});
STATIC_CHECK(text_of(amount{2304, -1}) == "230.4 V" and text_of(amount{5, 2}) == "500 V" and
             text_of(amount{0, 2}) == "0 V");
STATIC_CHECK(text_of(large{-5, -3}) == "-0.005 W" and text_of(scaled<watt_hours>{12'345, 2}) == "1234.5 kWh");

} // namespace

TEST_CASE("a text of the program's memory is taken as a setting")
{
    std::string const entered{"PUMP 3"};
    CHECK(setting<device_name>::checked(std::string_view{entered})->words() == entered_name.words());
    CHECK(setting<device_name>::checked(entered)->words() == entered_name.words());
    CHECK(setting<device_name>::checked(entered + "456").error() == errc::value_too_high);
    auto const text = *ascii<8>::from_words({0x5055, 0x4D50, 0, 0});
    CHECK(std::string_view{text} == "PUMP");
    CHECK(std::string{*ascii<8>::from_words({0x5055, 0x4D50, 0, 0})} == "PUMP");
}
