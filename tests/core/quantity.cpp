// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Sums, differences, multiples, parts and comparisons against plain 64-bit arithmetic in millionths of the unit, which
// knows nothing of steps.
#include <rtuwire/core/quantity.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <tuple>

#include <rtuwire/core/units.hpp>

#include "support/proof.hpp"

using namespace rtuwire;

namespace {

using limits = std::numeric_limits<std::int64_t>;

// Results are wide enough for 16-bit operands, and in the finer of both steps.
STATIC_CHECK(std::same_as<decltype(decihertz{1} + hertz{1}), quantity<frequency, std::int32_t, std::deci>>);
STATIC_CHECK((decihertz{65'535} + hertz{65'535}).count() == 720'885);
STATIC_CHECK((decihertz{0} - decihertz{65'535}).count() == -65'535);
STATIC_CHECK((-signed_rpm{-32'768}).count() == 32'768 and (-rpm{65'535}).count() == -65'535);
STATIC_CHECK((rpm{65'535} * std::int16_t{-32'768}).count() == -2'147'450'880);
STATIC_CHECK(50_Hz + 0.5_Hz == 50.5_Hz and 50_Hz - 1.25_Hz == 48.75_Hz and -(2_A) == -2_A);
STATIC_CHECK(3 * 0.1_s == deciseconds{3} and 10_s / 4 == 2_s and 10.0_s / 4 == 2.5_s and -7_s / 2 == -3_s);

// Signed and unsigned, tenths and whole: by value.
STATIC_CHECK(signed_decihertz{-1}<decihertz{0} and decihertz{65'535}> signed_decihertz{-1});
STATIC_CHECK(hertz{50} == decihertz{500} and hertz{50} < decihertz{501} and decihertz{499} < hertz{50});
STATIC_CHECK(decihertz{501} > 50_Hz and not(decihertz{500} > 50_Hz) and decihertz{500} >= 50_Hz);
STATIC_CHECK(microamperes{1} < tenth_milliamperes{1} and 0.1_mA == tenth_milliamperes{1});
using quarters = quantity<rotation, std::int16_t, std::ratio<1, 4>>;
STATIC_CHECK(quarters{2} == 0.5_rpm and quarters{1} > 0.2_rpm and quarters{1} < 0.3_rpm and quarters{-1} < 0_rpm);
STATIC_CHECK((quarters{1} + 0.1_rpm) == 0.35_rpm);

// 64 bits compare where a product would not fit.
STATIC_CHECK(decihertz{65'535}<9'223'372'036'854'775'000_Hz and 0.1_Hz> - 9'223'372'036'854'775'000_kHz);

using numbers =
    std::tuple<decihertz, signed_decihertz, hertz, hectohertz, quantity<frequency, std::uint8_t, std::milli>,
               quantity<frequency, std::int32_t>, quantity<frequency, std::uint32_t, std::micro>,
               quantity<frequency, std::int32_t, std::ratio<1, 4>>>;

/// An amount in millionths; of what is counted here it fits 64 bits.
template <typename Amount> std::int64_t millionths(Amount amount)
{
    using scale = typename Amount::scale;
    return std::int64_t{amount.count()} * (1'000'000 / scale::den) * scale::num;
}

/// A repeatable choice, of the ends and of what lies between.
template <typename Amount> Amount drawn(std::uint64_t& seed)
{
    using rep = typename Amount::rep;
    constexpr std::array<rep, 5> ends{rep{0}, rep{1}, (std::numeric_limits<rep>::max)(),
                                      (std::numeric_limits<rep>::min)(), static_cast<rep>(-1)};
    seed = seed * 6'364'136'223'846'793'005U + 1'442'695'040'888'963'407U;
    auto const upper = static_cast<std::uint32_t>(seed >> 32U);
    return Amount{upper % 4 == 0 ? ends[upper / 4 % 5] : static_cast<rep>(upper >> 4U)};
}

int sign_of(std::strong_ordering order) { return order < 0 ? -1 : order > 0 ? 1 : 0; }

template <typename Left, typename Right> std::size_t mistakes(std::uint64_t& seed)
{
    std::size_t found = 0;
    for (int i = 0; i < 400; ++i) {
        auto const left = drawn<Left>(seed);
        auto const right = drawn<Right>(seed);
        std::int64_t const a = millionths(left);
        std::int64_t const b = millionths(right);
        bool const compares = sign_of(left <=> right) == (a > b) - (a < b) and (left == right) == (a == b) and
                              (left < right) == (a < b) and (left >= right) == (a >= b) and (left != right) == (a != b);
        bool const computes =
            millionths(left + right) == a + b and millionths(left - right) == a - b and millionths(-left) == -a;
        found += compares and computes ? 0U : 1U;
    }
    return found;
}

template <typename Left, typename... Right> std::size_t mistakes_with(std::tuple<Right...>*, std::uint64_t& seed)
{
    return (mistakes<Left, Right>(seed) + ...);
}

template <typename... Left> std::size_t mistakes_of_all(std::tuple<Left...>* all, std::uint64_t& seed)
{
    return (mistakes_with<Left>(all, seed) + ...);
}

template <typename Amount, typename Integer> std::size_t mistakes_of_multiples(std::uint64_t& seed)
{
    std::size_t found = 0;
    for (int i = 0; i < 400; ++i) {
        auto const amount = drawn<Amount>(seed);
        auto const integer = drawn<quantity<dimensionless, Integer>>(seed).count();
        std::int64_t const steps = amount.count();
        bool const multiplies =
            (amount * integer).count() == steps * std::int64_t{integer} and integer * amount == amount * integer;
        bool const divides = integer == 0 or (amount / integer).count() == steps / std::int64_t{integer};
        found += multiplies and divides ? 0U : 1U;
    }
    return found;
}

template <typename... Amount> std::size_t mistakes_of_multiples(std::tuple<Amount...>*, std::uint64_t& seed)
{
    return ((mistakes_of_multiples<Amount, std::int8_t>(seed) + mistakes_of_multiples<Amount, std::uint16_t>(seed) +
             mistakes_of_multiples<Amount, std::int32_t>(seed)) +
            ...);
}

} // namespace

TEST_CASE("sums, differences and comparisons are those of 64-bit arithmetic")
{
    std::uint64_t seed = 2026;
    CHECK(mistakes_of_all(static_cast<numbers*>(nullptr), seed) == 0);
}

TEST_CASE("multiples and parts are those of 64-bit arithmetic")
{
    std::uint64_t seed = 7;
    CHECK(mistakes_of_multiples(static_cast<numbers*>(nullptr), seed) == 0);
}

TEST_CASE("what 64 bits do not hold stays out of range, on its side")
{
    using span = quantity<time_span, std::int64_t>;
    auto const most = (limits::max)();
    auto const least = (limits::min)();
    span const long_ago{least + 1};
    span const long_away{most - 1};
    span const one{1};
    CHECK((long_away + one).count() == most);
    CHECK((long_away + one - long_away).count() == most);
    CHECK((long_ago - one).count() == least);
    CHECK((long_ago - one + long_away).count() == least);
    CHECK((long_away - long_away).count() == 0);
    CHECK((long_away + 0.1_s).count() == most); // not in tenths
    CHECK((long_away * 2).count() == most);
    CHECK((long_away * -2).count() == least);
    CHECK((long_ago * -2).count() == most);
    CHECK((long_away * 2 * 0).count() == most);
    CHECK((long_away * 2 / 3).count() == most);
    CHECK((long_away * 2 / -3).count() == least);
    CHECK((-(long_away * 2)).count() == least);
    CHECK((-(long_ago * 2)).count() == most);
    CHECK((long_away * 1).count() == most - 1);
    CHECK((long_away / -1).count() == least + 2);
    CHECK((span{3'037'000'499} * 3'037'000'499).count() == 9'223'372'030'926'249'001);
    CHECK((span{3'037'000'500} * 3'037'000'500).count() == most);
    CHECK((span{0x1'0000'0000} * 0x7FFF'FFFF).count() == 0x7FFF'FFFF'0000'0000);
    CHECK((span{0x1'0000'0000} * 0x8000'0000U).count() == most);
    CHECK((span{0x1'FFFF'FFFF} * 0x7FFF'FFFF).count() == most);
    CHECK((span{0x1'FFFF'FFFF} * 0x3FFF'FFFF).count() == 0x7FFF'FFFD'C000'0001);
    CHECK((one * (std::numeric_limits<std::uint64_t>::max)()).count() == most);
    CHECK((one / (std::numeric_limits<std::uint64_t>::max)()).count() == 0);
    CHECK((-1 * one * (std::numeric_limits<std::uint64_t>::max)()).count() == least);
    CHECK((0 * one * (std::numeric_limits<std::uint64_t>::max)()).count() == 0);
    CHECK((span{least + 1} / (std::numeric_limits<std::uint64_t>::max)()).count() == 0);
    CHECK((span{least} / (std::numeric_limits<std::uint64_t>::max)()).count() == least);
    using thousands = quantity<span::dimension, std::int64_t, std::ratio_multiply<span::scale, std::kilo>>;
    CHECK(truncated_to<thousands>(long_away * 2).count() == most);
    CHECK(truncated_to<thousands>(long_ago * 2).count() == least);
    CHECK(truncated_to<thousands>(span{5'999}).count() == 5);
}

TEST_CASE("a division by 0 is out of range, and no undefined behaviour")
{
    int volatile none = 0;
    CHECK((seconds{3} / none).count() == (limits::max)());
    CHECK((seconds{0} / none).count() == (limits::max)());
    CHECK((celsius{-3} / none).count() == (limits::min)());
    quantity<rotation, std::int32_t> const least{(std::numeric_limits<std::int32_t>::min)()};
    int volatile minus_one = -1;
    CHECK((least / minus_one).count() == 2'147'483'648);
}
