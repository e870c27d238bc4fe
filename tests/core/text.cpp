// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Amounts as text: sign, point, digits and unit. tests/altivar/device/texts.cpp has every register of every drive.
#include <rtuwire/core/text.hpp>

#include <cinttypes>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>

#include <rtuwire/core/units.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

// The sign stands before the number, once, and a number below one begins with its 0.
STATIC_CHECK(text_of(signed_decihertz{-52}) == "-5.2 Hz" and text_of(signed_decihertz{52}) == "5.2 Hz");
STATIC_CHECK(text_of(signed_decihertz{-2}) == "-0.2 Hz" and text_of(signed_decihertz{-50}) == "-5.0 Hz");
STATIC_CHECK(text_of(signed_decihertz{-32'768}) == "-3276.8 Hz" and text_of(decihertz{65'535}) == "6553.5 Hz");
STATIC_CHECK(text_of(centiamperes{5}) == "0.05 A" and text_of(microamperes{65}) == "0.000065 A");
STATIC_CHECK(text_of(rpm{1'500}) == "1500 rpm" and text_of(signed_rpm{0}) == "0 rpm");
STATIC_CHECK(text_of(deciseconds{50}) == "5.0 s" and text_of(tenth_milliamperes{40}) == "0.0040 A");
STATIC_CHECK(text_of(celsius{-5}) == "-5 °C" and text_of(percent{200}) == "200 %" and
             text_of(centi_per_second{7}) == "0.07 1/s");
STATIC_CHECK(text_of(count16{7}) == "7" and text_of(count16_hundredths{85}) == "0.85");
// Steps above one, and such that are no power of ten.
STATIC_CHECK(text_of(hectohertz{40}) == "4000 Hz" and text_of(hectohertz{0}) == "0 Hz" and
             text_of(1.5_kHz) == "1500 Hz");
STATIC_CHECK(text_of(quantity<power, std::int16_t, std::ratio<1, 4>>{-5}) == "-1.25 W");
STATIC_CHECK(text_of(quantity<power, std::uint16_t, std::ratio<1, 20>>{3}) == "0.15 W");
STATIC_CHECK(text_of(quantity<power, std::uint16_t, std::ratio<25>>{4}) == "100 W");
// Sums and literals.
STATIC_CHECK(text_of(decihertz{5} - hertz{1}) == "-0.5 Hz" and text_of(-(1.30_s)) == "-1.30 s");
STATIC_CHECK(text_of(9'223'372'036'854'775'806_s) == "9223372036854775806 s");
STATIC_CHECK(text_of(9'223'372'036'854'775'807_s) == "out of range");

constexpr auto fifty = text_of(decihertz{500});
STATIC_CHECK(std::string_view{fifty} == "50.0 Hz" and fifty.size() == 7);
STATIC_CHECK(std::string_view{literal{"Hz"}} == "Hz" and not std::is_convertible_v<literal, std::string>);
STATIC_CHECK(not(literal{"Hz"} == literal{"Hx"}) and not(text_of(rpm{1}) == "1 rpn"));

template <typename Amount> std::string by_printf(Amount amount)
{
    std::array<char, 40> place{};
    std::snprintf(place.data(), place.size(), "%" PRId64 " W", static_cast<std::int64_t>(amount.count()));
    return place.data();
}

template <typename Rep> std::size_t mistakes_of()
{
    using watts_of = quantity<power, Rep>;
    std::size_t mistakes = 0;
    std::uint64_t seed = 1;
    for (int i = 0; i < 20'000; ++i) {
        seed = seed * 6'364'136'223'846'793'005U + 1'442'695'040'888'963'407U;
        watts_of const amount{static_cast<Rep>(static_cast<std::int64_t>(seed) >> (i % 60))};
        std::string const shown{text_of(amount)};
        mistakes += shown == by_printf(amount) ? 0U : 1U;
    }
    return mistakes;
}

} // namespace

TEST_CASE("whole numbers of every width are those of printf")
{
    CHECK(mistakes_of<std::int16_t>() == 0);
    CHECK(mistakes_of<std::uint16_t>() == 0);
    CHECK(mistakes_of<std::int32_t>() == 0);
    CHECK(mistakes_of<std::uint32_t>() == 0);
    CHECK(mistakes_of<std::int64_t>() == 0);
    using widest = quantity<power, std::int32_t>;
    CHECK(std::string{text_of(widest{(std::numeric_limits<std::int32_t>::min)()})} == "-2147483648 W");
}

TEST_CASE("a tenth is that of a division, for each number around a power of two or ten")
{
    for (std::uint64_t const base : {std::uint64_t{2}, std::uint64_t{10}}) {
        for (std::uint64_t power = base; power < 0x1000'0000'0000'0000U; power *= base) {
            for (std::uint64_t number = power < 40 ? 0 : power - 40; number < power + 40; ++number) {
                REQUIRE(tenth_of(number) == number / 10);
                auto const narrow = static_cast<std::uint32_t>(number);
                REQUIRE(tenth_of(narrow) == narrow / 10);
            }
        }
    }
    for (std::uint64_t number = ~std::uint64_t{0}; number > ~std::uint64_t{0} - 100; --number) {
        REQUIRE(tenth_of(number) == number / 10);
    }
    for (std::uint32_t number = 0; number < 0x10'0000; ++number) {
        if (tenth_of(number) != number / 10 or tenth_of(~number) != ~number / 10) {
            FAIL(number);
        }
    }
}
