// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A machine that slept: a drive went on counting, and so does the clock of the ports.
#if defined(__linux__) && defined(__LP64__)

#include <atomic>
#include <chrono>
#include <ctime>

#include <sys/syscall.h>
#include <unistd.h>

#include "support/catch.hpp"

#include "../../tools/rtuwire/line/line_calendar.hpp"
#include "../../tools/support/missed_time.hpp"

#include <rtuwire/port/chrono.hpp>

namespace {

/// For how long this machine has slept, in seconds: only the clock that the kernel counts on while it sleeps shows it.
std::atomic<std::time_t> slept{0};

} // namespace

extern "C" int clock_gettime(clockid_t which, timespec* now) noexcept
{
    auto const result = static_cast<int>(::syscall(SYS_clock_gettime, which, now));
    if (result == 0 and which == CLOCK_BOOTTIME) {
        now->tv_sec += slept;
    }
    return result;
}

using namespace rtuwire;

TEST_CASE("defect: D24 the clock of the ports counts the time in which the machine sleeps")
{
    using namespace std::chrono_literals;
    instant const before = steady_now();
    tool::line_calendar const calendar{1'000'000};
    tool::missed_time pause{1s};
    slept += 5;
    duration const passed = steady_now() - before;
    CHECK(passed >= milliseconds(5'000));
    CHECK(passed < milliseconds(60'000));
    CHECK(pause.is_too_long());
    // What is noted on the line has the calendar's time, before and after.
    std::uint64_t const noted = calendar.of(steady_now());
    CHECK(noted >= 6'000'000);
    CHECK(noted < 60'000'000);
    std::uint64_t const earlier = calendar.of(before);
    CHECK(earlier <= 1'000'000);
    CHECK(earlier > 0);
}

#endif
