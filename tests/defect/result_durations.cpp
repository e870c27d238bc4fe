// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A duration that does not fit is the longest one, and no deadline made of it looks as if it were over.
#include <rtuwire/client/line/request.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/rtu/line.hpp>

#include <cstdint>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr std::uint64_t longest_us = 35ULL * 60 * 1'000'000;
constexpr instant times[] = {instant{0}, instant{0x7FFF'FFFF}, instant{0xFFFF'0000}};

/// Whether a duration that is told when the program runs is the nearest one that fits.
template <typename Count> bool is_nearest(Count count)
{
    Count const volatile told = count;
    std::uint64_t const us = count < 0 ? 0 : static_cast<std::uint64_t>(count);
    bool const whole = microseconds(told).microseconds == (us < longest_us ? us : longest_us);
    std::uint64_t const by_ms = us > longest_us ? longest_us : us * 1'000;
    return whole and milliseconds(told).microseconds == (by_ms < longest_us ? by_ms : longest_us);
}

constexpr bool sums_and_multiples()
{
    duration const most = longest_duration;
    duration const half{most.microseconds / 2 + 1};
    using test::is;
    return is(most.microseconds == longest_us, "the longest is 35 minutes") and
           is(most + microseconds(1) == most, "the longest and one more") and
           is(half + half == most, "two halves, rounded up") and is(half * 2 == most, "twice a half, rounded up") and
           is(most * 0xFFFF'FFFFU == most, "the largest multiple of the longest") and
           is(microseconds(0x1'0001) * 0x1'0000 == most, "what wraps to 65 536 in 32 bits") and
           is(duration{0xFFFF'FFFF} + duration{2} == most, "a sum that wraps to 1") and
           is(microseconds(7) * 3 == microseconds(21), "a multiple that fits") and
           is(most + duration{} == most, "the longest and nothing") and is(most * 1 == most, "once the longest") and
           is(most * 0 == duration{}, "no times the longest");
}
PROOF("defect: sums and multiples of durations do not wrap", sums_and_multiples)

/// The deadline that an engine makes of the longest response time-out and the longest frame.
constexpr bool deadlines_lie_ahead()
{
    // The lowest rate by the longest characters.
    for (std::uint32_t const bits_per_second : {65U, 300U, 1'200U, 19'200U, 115'200U}) {
        line_timing const line{bits_per_second, character_format::even_8_2};
        for (instant const now : times) {
            if (reached(now, now + line.with_characters(longest_duration, 256)) or
                line.with_characters(milliseconds(10), 3) != milliseconds(10) + line.characters(3)) {
                return false;
            }
        }
    }
    return true;
}
PROOF("defect: a deadline of the longest duration lies ahead", deadlines_lie_ahead)

constexpr bool pauses_grow()
{
    for (duration const first : {milliseconds(50), milliseconds(60'000), longest_duration}) {
        retry_state many;
        many.begin({.busy_retries = 20, .busy_pause = first}, true);
        std::uint64_t expected = first.microseconds;
        for (unsigned i = 0; i < 20; ++i) {
            duration const pause = many.take_pause();
            bool const is_capped = pause > duration{longest_duration.microseconds / 2} and pause <= longest_duration and
                                   expected > pause.microseconds;
            if (pause.microseconds != expected and not is_capped) {
                return false;
            }
            expected *= i < 6 ? 2 : 1;
        }
    }
    return true;
}
PROOF("defect: the pauses for a busy unit double, but never beyond the longest duration", pauses_grow)

} // namespace

TEST_CASE("defect: a duration known only when running is the nearest that fits")
{
    for (std::int64_t const around :
         {0LL, 2'100'000LL, 2'100'000'000LL, 5'000'000LL, 4'294'967LL, 4'294'967'296LL, 9'000'000'000'000'000'000LL}) {
        for (std::int64_t const off : {-1LL, 0LL, 1LL}) {
            INFO(around + off);
            CHECK(is_nearest(around + off));
        }
    }
    CHECK(is_nearest<std::uint64_t>(0xFFFF'FFFF'FFFF'FFFFULL));
    CHECK(is_nearest<std::uint32_t>(0xFFFF'FFFFU));
    CHECK(is_nearest<std::int32_t>(-5));
    CHECK(is_nearest<std::uint16_t>(0xFFFF));
    CHECK(is_nearest<std::int8_t>(-128));
}
