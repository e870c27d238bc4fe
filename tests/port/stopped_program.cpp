// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A program that is stopped for longer than half of a 32-bit count of microseconds, in a call of its port or before one:
// the clock and the waits are played, in front of the C library.
#if defined(__linux__) && defined(__LP64__)

#include <array>
#include <cerrno>
#include <cstdint>
#include <ctime>
#include <thread>

#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "support/catch.hpp"
#include "support/soon.hpp"

#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/port/pseudo_terminal.hpp>

namespace {

/// What is played: for how long the program was stopped, and what its waits are.
struct played {
    std::int64_t stopped_ns{0};
    std::int64_t stops_in_wait_ns{0}; ///< the next wait is broken off by a signal behind such a stop
    std::int64_t longest_wait_ns{0};
    bool is_on{false};
    int waits{0};
};
thread_local played here{};

constexpr std::int64_t second = 1'000'000'000;
constexpr std::int64_t minute = 60 * second;
constexpr std::int64_t whole_turn = 0x1'0000'0000 * 1'000;

/// Plays until its end.
struct in_play {
    in_play() { here = {.is_on = true}; }
    ~in_play() { here = {}; }
    in_play(in_play const&) = delete;
    in_play& operator=(in_play const&) = delete;
};

} // namespace

extern "C" int clock_gettime(clockid_t which, timespec* now) noexcept
{
    auto const done = static_cast<int>(::syscall(SYS_clock_gettime, which, now));
    if (done == 0 and which == CLOCK_BOOTTIME and here.stopped_ns != 0) {
        std::int64_t const at = now->tv_sec * second + now->tv_nsec + here.stopped_ns;
        now->tv_sec = at / second;
        now->tv_nsec = at % second;
    }
    return done;
}

extern "C" int ppoll(pollfd* watched, nfds_t count, timespec const* limit, sigset_t const* blocked)
{
    timespec own = limit != nullptr ? *limit : timespec{};
    if (here.is_on and limit != nullptr) {
        ++here.waits;
        std::int64_t const length = own.tv_sec * second + own.tv_nsec;
        here.longest_wait_ns = length > here.longest_wait_ns ? length : here.longest_wait_ns;
        if (here.stops_in_wait_ns != 0) {
            here.stopped_ns += here.stops_in_wait_ns;
            here.stops_in_wait_ns = 0;
            errno = EINTR;
            return -1;
        }
        if (length > second) {
            own = {}; // nobody waits for it
        }
    }
    constexpr std::size_t size_of_mask = 8;
    return static_cast<int>(
        ::syscall(SYS_ppoll, watched, count, limit != nullptr ? &own : nullptr, blocked, size_of_mask));
}

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// Pauses behind which the low 32 bits of the clock say that a deadline lies ahead, or that none was.
constexpr std::array<std::int64_t, 5> pauses{36 * minute, 50 * minute, 71 * minute, whole_turn,
                                             whole_turn + 36 * minute};

/// A read of 200 ms of a port to which nobody says anything, behind `before` and with `inside` a stop.
template <typename Port> void check_read(Port& port, std::int64_t before, std::int64_t inside)
{
    in_play const play;
    std::array<std::byte, 8> place{};
    instant const until = port.now() + milliseconds(200);
    here.stopped_ns += before;
    here.stops_in_wait_ns = inside;
    auto const none = port.read(place, until);
    REQUIRE(none);
    CHECK(none->empty());
    CHECK(here.waits == (inside != 0 ? 2 : 1));
    CHECK(here.longest_wait_ns <= (before != 0 ? 0 : second / 5));
}

} // namespace

TEST_CASE("a deadline of the host is over once it has passed, however long ago")
{
    in_play const play;
    instant const until = steady_now() + longest_duration;
    host_deadline const end{until};
    CHECK(end.left() <= longest_duration);
    here.stopped_ns += 34 * minute;
    CHECK(end.left() > milliseconds(30'000));
    CHECK(end.left() <= milliseconds(60'000));
    for (std::int64_t const pause : pauses) {
        here.stopped_ns += pause;
        CHECK(end.left() == duration{});
    }
    // One that has passed already when it is made; and one that a thread makes which has never looked at the clock.
    CHECK(host_deadline{steady_now()}.left() == duration{});
    CHECK(host_deadline{steady_now() - milliseconds(60'000)}.left() == duration{});
    instant const soon = steady_now() + milliseconds(60'000);
    here = {};
    instant const later = steady_now() + milliseconds(60'000);
    duration found{};
    std::thread{[&] { found = host_deadline{later}.left(); }}.join();
    CHECK(found > milliseconds(30'000));
    CHECK(found <= milliseconds(60'000));
    CHECK(soon != later);
}

TEST_CASE(
    "defect: S1 a read waits no longer than it was asked to, where the program is stopped for more than half an hour")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    REQUIRE(port.open(far.path()));
    posix_serial waiting;
    pseudo_terminal other;
    REQUIRE(other.open());
    REQUIRE(waiting.open(other.path(), {.waits_in_read = true}));
    for (std::int64_t const pause : pauses) {
        INFO(pause / minute << " minutes");
        check_read(port, pause, 0);
        check_read(far, pause, 0);
        check_read(waiting, pause, 0);
        check_read(port, 0, pause);
        check_read(far, 0, pause);
    }
}

TEST_CASE(
    "defect: S1 a write that stalls ends at its deadline, where the program is stopped for more than half an hour")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    REQUIRE(port.open(far.path()));
    std::array<std::byte, 256> const block{};
    int blocks = 0;
    while (port.write(block, steady_now() + milliseconds(200)) and
           blocks < 10'000) { // the kernel makes room for a while
        ++blocks;
    }
    REQUIRE(blocks < 10'000);
    for (std::int64_t const pause : pauses) {
        INFO(pause / minute << " minutes");
        for (bool const is_inside : {false, true}) {
            in_play const play;
            instant const until = port.now() + milliseconds(200);
            (is_inside ? here.stops_in_wait_ns : here.stopped_ns) += pause;
            CHECK(port.write(block, until) == errc::transmit_stalled);
            CHECK(here.longest_wait_ns <= (is_inside ? second / 5 : 0));
        }
    }
}

#endif
