// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Wrapping time: every test stands across the wrap of the counter.
#include <rtuwire/core/time.hpp>

#include <cstdint>
#include <type_traits>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

// Five seconds before the counter wraps.
constexpr instant late{0xFFFF'FFFFU - 5'000'000U};

// An instant is always made from a count, in so many words: 0 is a time like any other.
STATIC_CHECK(not std::is_default_constructible_v<instant>);
STATIC_CHECK(not std::is_convertible_v<std::uint32_t, instant>);
STATIC_CHECK(std::is_constructible_v<instant, std::uint32_t>);
STATIC_CHECK(std::is_trivially_copyable_v<instant> and sizeof(instant) == 4);

STATIC_CHECK((late + milliseconds(10'000)).microseconds < late.microseconds);
STATIC_CHECK(late + milliseconds(10'000) - late == milliseconds(10'000));
STATIC_CHECK(late + milliseconds(10'000) - milliseconds(10'000) == late);
STATIC_CHECK(reached(late, late));
STATIC_CHECK(reached(late + milliseconds(10'000), late + milliseconds(9'999)));
STATIC_CHECK(not reached(late, late + milliseconds(10'000)));
STATIC_CHECK(not reached(late, late + microseconds(1)));
STATIC_CHECK(reached(late + milliseconds(35 * 60'000), late));
STATIC_CHECK(milliseconds(3) == microseconds(3'000) and milliseconds(2) < milliseconds(3));
STATIC_CHECK(milliseconds(2) + microseconds(5) == microseconds(2'005));
STATIC_CHECK(microseconds(7) * 3 == microseconds(21));
STATIC_CHECK(milliseconds(0) == duration{} and microseconds(0).microseconds == 0);

// Half the counter's range is the horizon: one microsecond less is past, half of it is to come.
STATIC_CHECK(reached(late + duration{0x7FFF'FFFF}, late));
STATIC_CHECK(not reached(late + duration{0x8000'0000}, late));
STATIC_CHECK(reached(instant{0}, instant{0xFFFF'FFFF}));
STATIC_CHECK(not reached(instant{0xFFFF'FFFF}, instant{0}));
STATIC_CHECK(instant{4} - instant{0xFFFF'FFFE} == microseconds(6));

// What was named at `late`, up to 35 minutes ahead, is over after a pause that makes it look as if it lay ahead; nothing
// is over because a clock steps back by a few seconds, and nothing that has just begun looks over.
STATIC_CHECK(within_reach(late, late) == late);
STATIC_CHECK(within_reach(late, late + duration{0x7FFF'FFFF}) == late + duration{0x7FFF'FFFF});
STATIC_CHECK(within_reach(late, late - milliseconds(16'000), milliseconds(16'777)) == late - milliseconds(16'000));
STATIC_CHECK(within_reach(late, late - milliseconds(65)) == late - milliseconds(65));
constexpr bool finds_over(std::uint32_t pause, duration ahead)
{
    instant const now = late + duration{pause};
    instant const at = within_reach(late, now, ahead);
    return reached(at, late) and reached(at, late + longest_duration + milliseconds(20'000)) and
           not reached(at, now + microseconds(1));
}
constexpr bool finds_over_up_to(std::uint32_t longest, duration ahead)
{
    return finds_over(0x8000'0000U, ahead) and finds_over(0x8000'0000U + 1, ahead) and
           finds_over(0xC000'0000U, ahead) and finds_over(longest, ahead);
}
STATIC_CHECK(finds_over_up_to(0xFEFF'FFFFU - 2, microseconds(0x100'0000)) and
             finds_over_up_to(0xFFFE'FFFFU, microseconds(0x1'0000)));

STATIC_CHECK(earlier(late, late + milliseconds(10'000)) == deadline{late});
STATIC_CHECK(earlier(late + milliseconds(10'000), late) == deadline{late});
STATIC_CHECK(earlier({}, late) == deadline{late} and earlier(late, {}) == deadline{late});
STATIC_CHECK(not earlier({}, {}).has_value());

// What a processor without a division does: compared with a division, around each power of two and each multiple of it.
constexpr bool divides_near(std::uint32_t number)
{
    bool is_right = true;
    for (std::uint32_t const each : {number - 2, number - 1, number, number + 1, number + 2}) {
        is_right = is_right and third_by_shifts(each) == each / 3;
        constexpr std::uint32_t divisors[]{1, 2, 3, 7, 10, 99, 100, 0x7FFF'FFFF};
        for (std::uint32_t const by : divisors) {
            is_right = is_right and quotient_by_bits(each, by) == each / by;
        }
    }
    return is_right;
}
constexpr bool divides()
{
    bool is_right = divides_near(0);
    for (unsigned bit = 0; bit < 32; ++bit) {
        std::uint32_t const power = std::uint32_t{1} << bit;
        is_right = is_right and divides_near(power) and divides_near(power * 3) and divides_near(power * 100);
    }
    return is_right;
}
PROOF("thirds and quotients without a division are those of a division", divides)

} // namespace
