// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Descriptors, settings and tables.
#include <rtuwire/table/setting.hpp>

#include <limits>

#include "support/proof.hpp"

#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/table.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr reg<deciseconds> ramp{.code = "ACC", .address = 9001, .min = {1}, .max = {9999}};
constexpr reg<signed_rpm> speed{.code = "LFRD", .address = 8602};
constexpr reg<deciamperes> protection{.code = "ITH", .address = 9622, .min = share_of("INV", 1, 2), .max = "INV"};

constexpr setting<ramp> spelled = 1.3_s;
STATIC_CHECK(spelled.word() == 13 and spelled.value() == deciseconds{13});
constexpr setting<ramp> longest = 999.9_s;
constexpr setting<ramp> two_seconds = 2_s;
STATIC_CHECK(longest.word() == 9999 and two_seconds.word() == 20);
constexpr setting<speed> backwards = -1500_rpm;
STATIC_CHECK(backwards.word() == 0xFA24 and backwards.value() == signed_rpm{-1500});

STATIC_CHECK(setting<ramp>::checked(deciseconds{9999}).has_value());
STATIC_CHECK(setting<ramp>::checked(deciseconds{10'000}).error() == errc::value_too_high);
STATIC_CHECK(setting<ramp>::checked(deciseconds{0}).error() == errc::value_too_low);
STATIC_CHECK(setting<ramp>::clamped(deciseconds{65'535}).word() == 9999);
STATIC_CHECK(setting<ramp>::clamped(deciseconds{0}).word() == 1);

// A limit that hangs on another register is checked where that one's value is known.
STATIC_CHECK(protection.min.with(100) == 50 and protection.max.with(100) == 100);
STATIC_CHECK(setting<protection>::checked(deciamperes{70}, 50, 100).has_value());
STATIC_CHECK(setting<protection>::checked(deciamperes{49}, 50, 100).error() == errc::value_too_low);
STATIC_CHECK(setting<protection>::checked(deciamperes{101}, 50, 100).error() == errc::value_too_high);
STATIC_CHECK(product_of("HSP", "SDS", 10).with(500, 30) == 1'500);
// What 32 bits do not hold is the nearest number that they do, however large the product.
constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
constexpr bound as_it_is{"HSP", 65'535, 65'535, "SDS"};
constexpr bool keeps_to_32_bits()
{
    bool ok = true;
    for (std::int32_t const times : {2, 50'000, 80'000, 130'000, 150'000, 1'000'000, most}) {
        ok = ok and as_it_is.with(most, times) == most and as_it_is.with(least, times) == least and
             as_it_is.with(most, -times) == least;
    }
    return ok and as_it_is.with(most, 1) == most and as_it_is.with(7, 1'000) == 7'000;
}
PROOF("a limit that is a product of two registers has at most 32 bits", keeps_to_32_bits)
STATIC_CHECK(bound{}.is_open() and not bound{0}.is_open() and bound{0}.is_number());

// A register has sixteen bits, and so has what it holds.
enum class wide : std::uint16_t { one };
enum class narrow : std::uint8_t { one };
STATIC_CHECK(register_value<wide>);
STATIC_CHECK(register_value<decihertz>);
STATIC_CHECK(register_value<flags<wide>>);
STATIC_CHECK(not register_value<narrow>);
STATIC_CHECK(not register_value<std::uint16_t>);
STATIC_CHECK(not register_value<quantity<frequency, std::uint8_t>>);
STATIC_CHECK(not register_value<quantity<frequency, std::uint32_t>>);

using three = table<ramp, speed, protection>;
STATIC_CHECK(three::size == 3 and three::contains<speed> and three::addresses[2] == 9622);

enum class lamp : std::uint8_t { red = 0, green = 15 };
STATIC_CHECK(flags<lamp>{0x8000}.has(lamp::green) and not flags<lamp>{0x8000}.has(lamp::red));
STATIC_CHECK(flags<lamp>{}.with(lamp::green).bits == 0x8000);
STATIC_CHECK(flags<lamp>{0x8001}.without(lamp::green).bits == 1);

constexpr bool tells_its_share(std::uint16_t numerator)
{
    bound const part = share_of("INV", numerator, 4);
    return part.code() == literal{"INV"} and part.numerator() == numerator and part.denominator() == 4 and
           part.with(10) == 10 * numerator / 4;
}
constexpr bool tells_shares() { return tells_its_share(2) and tells_its_share(3); }
PROOF("a limit that is a share of another register says which", tells_shares)

} // namespace
