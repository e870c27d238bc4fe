// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Numbers that come from the line or from a measurement: whatever they are, no arithmetic overflows. What
// these tests run must not be left out of coverage, or the sanitizers do not see it.
#include <rtuwire/table/register.hpp>

#include <array>
#include <cstdint>

#include "support/proof.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/table/read_plan.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

using plan = read_plan<atv28::device, atv28::tfr, atv28::lsp, atv28::hsp, atv28::sds>;

/// A snapshot in which every register of the plan holds the same word.
plan::snapshot all_are(std::uint16_t word)
{
    plan::snapshot seen;
    std::array<std::uint16_t, 125> words{};
    words.fill(word);
    for (std::size_t at = 0; at < plan::request_count; ++at) {
        seen.store(at, words);
    }
    return seen;
}

/// What a limit is, calculated in another way: by long division of sign and size.
std::int32_t expected(std::int32_t other, std::int32_t multiplier, std::uint32_t numerator, std::uint32_t denominator)
{
    auto const size = [](std::int64_t n) { return static_cast<std::uint64_t>(n < 0 ? -n : n); };
    bool const is_negative = (other < 0) != (multiplier < 0);
    std::uint64_t const product = size(other) * size(multiplier);
    std::uint64_t const high = (product >> 32U) * numerator;
    std::uint64_t const low = (product & 0xFFFF'FFFFU) * numerator;
    std::uint64_t const top = high + (low >> 32U);
    std::uint64_t const rest = (top % denominator) << 32U | (low & 0xFFFF'FFFFU);
    std::uint64_t const most = is_negative ? 0x8000'0000U : 0x7FFF'FFFFU;
    std::uint64_t const quotient =
        top / denominator > 0xFFFFU ? most : ((top / denominator) << 32U) + rest / denominator;
    std::uint64_t const kept = quotient < most ? quotient : most;
    return static_cast<std::int32_t>(is_negative ? -static_cast<std::int64_t>(kept) : static_cast<std::int64_t>(kept));
}

} // namespace

TEST_CASE("defect: D6 a limit made of received words does not overflow")
{
    CHECK(product_of("TFR", "SDS", 10).with(65'535, 65'535) == 429'483'622);
    CHECK(product_of("TFR", "SDS", 1).with(65'535, 65'535) == 0x7FFF'FFFF);
    CHECK(product_of("TFR", "SDS", 1).with(-65'535, 65'535) == -0x7FFF'FFFF - 1);

    constexpr std::array<std::int32_t, 9> edges{-0x7FFF'FFFF - 1, -65'536, -32'768,    -1, 0, 1,
                                                32'767,           65'535,  0x7FFF'FFFF};
    constexpr std::array<std::uint16_t, 5> parts{1, 2, 10, 32'768, 65'535};
    for (std::int32_t const other : edges) {
        for (std::int32_t const multiplier : edges) {
            for (std::uint16_t const numerator : parts) {
                for (std::uint16_t const denominator : parts) {
                    CAPTURE(other, multiplier, numerator, denominator);
                    CHECK(bound{literal{"A"}, numerator, denominator, literal{"B"}}.with(other, multiplier) ==
                          expected(other, multiplier, numerator, denominator));
                }
            }
        }
    }
}

TEST_CASE("defect: D6 a snapshot of any words tells limits without overflow")
{
    constexpr std::array<std::uint16_t, 5> words{0x0000, 0x0001, 0x7FFF, 0x8000, 0xFFFF};
    constexpr std::array<std::uint16_t, 5> speeds{0, 1, 1'500, 0x7FFF, 0xFFFF};
    for (std::uint16_t const word : words) {
        CAPTURE(word);
        plan::snapshot const seen = all_are(word);
        std::uint64_t const most = std::uint64_t{word} * word / 10;
        for (std::uint16_t const speed : speeds) {
            CAPTURE(speed);
            auto const smil = seen.checked<atv28::smil>(rpm{speed});
            CHECK(smil.has_value() == (speed <= most));
            auto const smal = seen.checked<atv28::smal>(rpm{speed});
            CHECK(smal.has_value() == (speed == most));
        }
    }
}

TEST_CASE("defect: (c) an amount that does not fit its target is the nearest that does")
{
    for (std::uint32_t i = 0; i <= 0xFFFF; ++i) {
        auto const number = static_cast<std::uint16_t>(i);
        std::uint32_t const tenths = i * 10;
        REQUIRE(truncated_to<decihertz>(hertz{number}).count() == (tenths < 0xFFFF ? tenths : 0xFFFF));
        REQUIRE(truncated_to<hertz>(decihertz{number}).count() == i / 10);
        auto const half = static_cast<std::int16_t>(number);
        std::int32_t const signed_tenths = std::int32_t{half} * 10;
        using narrow = quantity<rotation, std::int16_t, std::deci>;
        REQUIRE(truncated_to<narrow>(signed_rpm{half}).count() == (signed_tenths > 32'767    ? 32'767
                                                                   : signed_tenths < -32'768 ? -32'768
                                                                                             : signed_tenths));
        REQUIRE(truncated_to<rpm>(signed_rpm{half}).count() == (half < 0 ? 0 : half));
    }
    using many = quantity<frequency, std::int64_t, std::kilo>;
    constexpr std::int64_t huge = 0x7FFF'FFFF'FFFF'FFFF;
    std::int64_t const volatile told = huge;
    CHECK(truncated_to<hertz>(many{told}).count() == 0xFFFF);
    CHECK(truncated_to<hertz>(many{-told - 1}).count() == 0);
    using wide_hertz = quantity<frequency, std::int64_t>;
    CHECK(truncated_to<wide_hertz>(many{told}).count() == huge);
    CHECK(truncated_to<wide_hertz>(many{-told - 1}).count() == -huge - 1);
    // The largest number of 64 bits stands for an amount that is out of range, and stays so.
    CHECK(truncated_to<many>(wide_hertz{told}).count() == huge);
    CHECK(truncated_to<many>(wide_hertz{told - 1}).count() == huge / 1'000);
}
