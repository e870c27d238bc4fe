// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Amounts in floating point: how they compare with quantities, become quantities, and read. The digits are those of
// printf, which knows nothing of them.
#include <rtuwire/table/form/floating.hpp>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>

#include "support/catch.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"

#include <rtuwire/print.hpp>
#include <rtuwire/table/form/real_text.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

using energy = real<kilowatt_hours>;
using exact = real<kilowatt_hours, double>;

// Whatever the unit and the width on the other side, and whichever side.
STATIC_CHECK(energy{12.5F} > 5_kWh and 5_kWh < energy{12.5F} and energy{12.5F} == 12500_Wh and
             12.5_kWh == energy{12.5F});
STATIC_CHECK(energy{12.5F} <= 12.5_kWh and energy{12.5F} != 12.501_kWh and energy{-1.0F} < watt_hours{0});
STATIC_CHECK(real<watt_hours>{500.0F} == energy{0.5F} and exact{0.5} == energy{0.5F} and exact{0.1} < energy{0.1F});
STATIC_CHECK(energy{0.1F} > 0.1_kWh); // it is 0.100000001490116
// 2^53 + 1 has 54 bits; below that, double is exact.
STATIC_CHECK(exact{9007199254740992.0} > 9'007'199'254'740'991_kWh);
constexpr energy no_number{std::numeric_limits<float>::quiet_NaN()};
STATIC_CHECK(not(no_number < 1_kWh) and not(no_number >= 1_kWh) and not(no_number == 1_kWh) and no_number != 1_kWh);

constexpr energy from_literal = 2.5_kWh;
constexpr energy from_coarse = 2500_Wh;
STATIC_CHECK(from_literal.count() == 2.5F and from_coarse.count() == 2.5F);
STATIC_CHECK(energy{3.0F} - energy{0.5F} == 2.5_kWh and energy{3.0F} + 1_kWh == 4_kWh and -energy{3.0F} == -3_kWh);
STATIC_CHECK(energy{3.0F} * 2.0F == 6_kWh and 2.0F * energy{3.0F} == 6_kWh and energy{3.0F} / 2.0F == 1.5_kWh);

// Out of range stays so: no number that only looks right.
constexpr quantity<electrical_energy, std::int64_t> too_much{(std::numeric_limits<std::int64_t>::max)()};
constexpr quantity<electrical_energy, std::int64_t> too_little{(std::numeric_limits<std::int64_t>::min)()};
STATIC_CHECK(energy{too_much}.count() == std::numeric_limits<float>::infinity());
STATIC_CHECK((exact{too_little} / 1e18).count() == -std::numeric_limits<double>::infinity());

// The nearest, halves away from zero.
using amount = quantity<electrical_energy, std::int16_t>;
using byte_amount = quantity<electrical_energy, std::uint8_t>;
STATIC_CHECK(energy{12.5F}.rounded_to<watt_hours>() == watt_hours{12'500});
STATIC_CHECK(energy{2.5F}.rounded_to<amount>() == amount{3} and energy{-2.5F}.rounded_to<amount>() == amount{-3});
STATIC_CHECK(exact{0.49999999999999994}.rounded_to<amount>() == amount{0});
STATIC_CHECK(energy{255.4F}.rounded_to<byte_amount>() == byte_amount{std::uint8_t{255}});
STATIC_CHECK(energy{255.5F}.rounded_to<byte_amount>() == errc::value_too_high);
STATIC_CHECK(energy{-0.4F}.rounded_to<byte_amount>() == byte_amount{std::uint8_t{0}});
STATIC_CHECK(energy{-0.5F}.rounded_to<byte_amount>() == errc::value_too_low);
STATIC_CHECK(energy{3.4e38F}.rounded_to<quantity<electrical_energy, std::int64_t>>() == errc::value_too_high);
STATIC_CHECK(energy{9223372036854775808.0F}.rounded_to<quantity<electrical_energy, std::int64_t>>() ==
             errc::value_too_high);
STATIC_CHECK(no_number.rounded_to<amount>() == errc::value_without_meaning);

STATIC_CHECK(text_of(energy{12.5F}) == "12.5 kWh" and text_of(energy{-0.25F}) == "-0.25 kWh");
STATIC_CHECK(text_of(real<watt_hours>{12'500.0F}) == "12.5 kWh" and text_of(real<count16>{3.0F}) == "3");
STATIC_CHECK(text_of(energy{0.0F}) == "0 kWh" and text_of(real<hectohertz>{1.0F}) == "100 Hz");
STATIC_CHECK(text_of(energy{16'777'216.0F}) == "16777216 kWh" and text_of(energy{1e16F}) == "1e16 kWh");
STATIC_CHECK(text_of(energy{3.4028235e38F}) == "3.402823e38 kWh" and text_of(energy{1.5e-7F}) == "1.5e-7 kWh");
STATIC_CHECK(text_of(no_number) == "not a number");
STATIC_CHECK(text_of(energy{-std::numeric_limits<float>::infinity()}) == "infinite");

/// What printf makes of a number, in the form of `text_of`.
std::string expected(double number, int digits)
{
    constexpr int room = 512;
    char text[room];
    static_cast<void>(std::snprintf(text, room, "%.*e", digits - 1, number));
    std::string shown{text};
    std::size_t const mark = shown.find('e');
    int const exponent = std::atoi(shown.c_str() + mark + 1);
    bool const is_plain = number == 0 or (exponent >= -5 and exponent < 15);
    std::string end;
    if (is_plain) {
        int const decimals = digits - 1 - exponent;
        static_cast<void>(std::snprintf(text, room, "%.*f", decimals > 0 ? decimals : 0, number));
        shown = text;
    } else {
        shown.resize(mark);
        end = "e" + std::to_string(exponent);
    }
    if (shown.find('.') != std::string::npos) {
        shown.resize(shown.find_last_not_of('0') + 1);
        shown.resize(shown.back() == '.' ? shown.size() - 1 : shown.size());
    }
    return shown + end;
}

template <typename Float> std::string shown(Float number)
{
    auto const text = text_of(real<count16, Float>{number});
    return {text.begin(), text.end()};
}

} // namespace

TEST_CASE("a floating point number reads as printf prints it")
{
    test::random random{1};
    auto const draw = [&] { return std::uint64_t{random.below(0xFFFF'FFFFU)} << 32U | random.below(0xFFFF'FFFFU); };
    for (int i = 0; i < 40'000; ++i) {
        auto const bits = draw();
        auto const number = std::bit_cast<float>(static_cast<std::uint32_t>(bits >> 32U));
        auto const usual =
            static_cast<float>(static_cast<double>(bits >> 34U) / static_cast<double>(1U << (bits % 24U)));
        auto const wide = std::bit_cast<double>(bits);
        auto const usual_wide = static_cast<double>(bits >> 20U) / static_cast<double>(1U << (bits % 30U));
        if (is_finite(static_cast<std::uint32_t>(bits >> 32U))) {
            REQUIRE(shown(number) == expected(static_cast<double>(number), 7));
        }
        REQUIRE(shown(usual) == expected(static_cast<double>(usual), 7));
        if (is_finite(bits)) {
            REQUIRE(shown(wide) == expected(wide, 15));
        }
        REQUIRE(shown(usual_wide) == expected(usual_wide, 15));
    }
    for (double const number : {5e-324, 1.7976931348623157e308, 0.1 + 0.2, 9.95, 999999999999999.4, 2.5e-6, 0.00001}) {
        REQUIRE(shown(number) == expected(number, 15));
    }
}

TEST_CASE("a floating point amount goes to a stream")
{
    std::ostringstream out;
    out << energy{12.5F} << ", " << exact{0.001};
    CHECK(out.str() == "12.5 kWh, 0.001 kWh");
}
