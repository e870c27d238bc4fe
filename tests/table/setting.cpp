// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Values known only at run time, against a model in ten-thousandths of the unit that knows nothing of settings.
#include <rtuwire/table/setting.hpp>

#include <cstdint>
#include <limits>

#include "support/proof.hpp"

using namespace rtuwire;

namespace {

constexpr reg<deciseconds> ramp{.code = "ACC", .address = 9001, .min = {1}, .max = {9'999}};
constexpr reg<signed_decihertz> lfr{.code = "LFR", .address = 8502, .min = {-5'990}, .max = {5'990}};
constexpr reg<hectohertz> sfr{.code = "SFR", .address = 3102, .min = {20}, .max = {160}};
constexpr reg<count16> any{.code = "ANY", .address = 1};
constexpr reg<rpm> gapped{.code = "GAP", .address = 2, .min = {0}, .max = {100}, .gap = {.first = 11, .last = 19}};

/// What ought to become of an amount of so many ten-thousandths: the word, or why not.
struct expected {
    std::int64_t step; ///< of the register, in ten-thousandths
    std::int64_t least;
    std::int64_t most;

    constexpr errc of(std::int64_t amount) const
    {
        return amount % step != 0      ? errc::value_between_steps
               : amount / step > most  ? errc::value_too_high
               : amount / step < least ? errc::value_too_low
                                       : errc::none;
    }
};

template <auto const& R, typename Value>
bool is_as_expected(expected const& model, Value value, std::int64_t ten_thousandths)
{
    auto const checked = setting<R>::checked(value);
    errc const why = model.of(ten_thousandths);
    if (why != errc::none) {
        return not checked and checked.error() == why;
    }
    return checked and checked->word() == static_cast<std::uint16_t>(ten_thousandths / model.step);
}

STATIC_CHECK(setting<gapped>::checked(10_rpm).has_value() and setting<gapped>::checked(20_rpm).has_value());
STATIC_CHECK(setting<gapped>::checked(11_rpm).error() == errc::value_never_written);
STATIC_CHECK(setting<gapped>::checked(19_rpm).error() == errc::value_never_written);
STATIC_CHECK(setting<any>::checked(65'535_raw).has_value() and setting<any>::checked(0_raw).has_value());
STATIC_CHECK(setting<any>::checked(65'536_raw).error() == errc::value_too_high);
STATIC_CHECK(setting<any>::checked(-1_raw).error() == errc::value_too_low);
STATIC_CHECK(setting<any>::checked(signed_count16{-1}).error() == errc::value_too_low);

} // namespace

TEST_CASE("a value known at run time becomes its word, or is refused with the reason")
{
    constexpr expected of_ramp{1'000, 1, 9'999};
    constexpr expected of_lfr{1'000, -5'990, 5'990};
    constexpr expected of_sfr{1'000'000, 20, 160};
    std::size_t mistakes = 0;
    for (std::int32_t n = -70'000; n <= 70'000; ++n) {
        mistakes += is_as_expected<ramp>(of_ramp, n * 0.1_s, std::int64_t{n} * 1'000) ? 0U : 1U;
        mistakes += is_as_expected<ramp>(of_ramp, n * 0.01_s, std::int64_t{n} * 100) ? 0U : 1U;
        mistakes += is_as_expected<ramp>(of_ramp, n * 1_s, std::int64_t{n} * 10'000) ? 0U : 1U;
        mistakes += is_as_expected<lfr>(of_lfr, n * 0.1_Hz, std::int64_t{n} * 1'000) ? 0U : 1U;
        mistakes += is_as_expected<sfr>(of_sfr, n * 0.1_kHz, std::int64_t{n} * 1'000'000) ? 0U : 1U;
        mistakes += is_as_expected<sfr>(of_sfr, n * 1_Hz, std::int64_t{n} * 10'000) ? 0U : 1U;
    }
    CHECK(mistakes == 0);
}

TEST_CASE("an amount beyond 64 bits is refused on its side")
{
    std::int64_t volatile most = (std::numeric_limits<std::int64_t>::max)();
    std::int64_t volatile least = (std::numeric_limits<std::int64_t>::min)();
    CHECK(setting<ramp>::checked(most * 1_s).error() == errc::value_too_high);
    CHECK(setting<ramp>::checked(least * 1_s).error() == errc::value_too_low);
    CHECK(setting<ramp>::checked((most - 1) * 0.1_s).error() == errc::value_too_high);
    CHECK(setting<ramp>::checked((most - 1) * 1_s + 1_s - (most - 1) * 1_s).error() == errc::value_too_high);
    CHECK(setting<ramp>::checked(1_s / static_cast<int>(most - most)).error() == errc::value_too_high);
    // 32 bits of tenths look like a small word where they are cut off.
    CHECK(setting<ramp>::checked(0x1'0000'000D * 0.1_s).error() == errc::value_too_high);
    CHECK(setting<ramp>::checked(0x1'000D * 0.1_s).error() == errc::value_too_high);
}
