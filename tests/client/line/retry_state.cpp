// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How long the pauses of a request are, and how long answers to its sendings may still come: rules 9 and 18 of
// docs/engine-rules.md.
#include <rtuwire/client/line/request.hpp>

#include <array>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr std::uint32_t half = 35U * 60U * 1'000'000U / 2U;

constexpr retry_state begun(duration pause)
{
    retry_state made;
    made.begin({.retries = 255, .busy_retries = 255, .busy_pause = pause}, true);
    return made;
}

/// Whether the pauses are so long, one after the other, and stay as long as the last one.
template <std::size_t Size>
constexpr bool pauses_for(std::uint32_t first, std::array<std::uint32_t, Size> const& expected)
{
    retry_state made = begun(duration{first});
    for (std::uint32_t const each : expected) {
        if (not made.may_pause(errc::server_device_busy) or made.take_pause() != duration{each}) {
            return false;
        }
    }
    return made.take_pause() == duration{expected.back()};
}
constexpr bool doubles()
{
    return pauses_for(100, std::array{100U, 200U, 400U, 800U, 1'600U, 3'200U, 6'400U}) and
           pauses_for(half - 1, std::array{half - 1, 2 * half - 2}) and pauses_for(half, std::array{half, half}) and
           pauses_for(0, std::array{0U, 0U});
}
PROOF("a pause is doubled six times, as long as the double is under 35 minutes", doubles)

/// What is owed for so many sendings, of which one was answered 5 ms after the first had left.
constexpr duration owed_after(unsigned sendings)
{
    constexpr instant first{0xFFFF'F000};
    retry_state made = begun(duration{});
    for (unsigned i = 0; i < sendings; ++i) {
        made.note_sent(first + microseconds(i), milliseconds(5), milliseconds(100));
        made.take_retry();
    }
    made.note_response();
    return made.all_that_follow(first + milliseconds(5), milliseconds(20));
}
constexpr bool waits_for_each()
{
    return owed_after(1) == duration{} and owed_after(2) == milliseconds(25) and owed_after(3) == milliseconds(50) and
           owed_after(5) == milliseconds(100);
}
PROOF("each sending without a response may take as long as the first, and be late", waits_for_each)

/// What is owed where a response came so long after the first of two sendings, or where none came.
constexpr bool is_bounded()
{
    constexpr instant first{0xFFFF'F000};
    constexpr duration most = milliseconds(2 * (1'000 + 5 + 100)); // `begun` leaves R as it is by default
    for (std::uint32_t const minutes : {1U, 35U, 36U, 50U, 71U}) {
        retry_state made = begun(duration{});
        made.note_sent(first, milliseconds(5), milliseconds(100));
        made.note_sent(first + milliseconds(100), milliseconds(5), milliseconds(100));
        instant const late{first.microseconds + minutes * 60'000'000U};
        if (made.owed_until(late) - late > most) {
            return false;
        }
        made.note_response();
        if (made.all_that_follow(late, milliseconds(20)) != most + milliseconds(20)) {
            return false;
        }
    }
    return true;
}
PROOF("a program that was stopped learns nothing of how long its unit takes", is_bounded)

} // namespace
