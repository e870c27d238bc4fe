// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A serial device whose `read` waits by the terminal's timer, over real pseudo-terminals: what passes, when a wait ends, and
// every failure that the other way of waiting reports. Then what a driver says when low latency is asked for.
#include <rtuwire/port/posix_serial.hpp>

#include <array>
#include <atomic>
#include <csignal>
#include <string>
#include <thread>

#include <sys/time.h>
#include <termios.h>

#include "support/catch.hpp"
#include "support/soon.hpp"

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/port/pseudo_terminal.hpp>
#include <rtuwire/server/blocking.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using test::soon;

namespace {

constexpr serial_settings waiting{.waits_in_read = true};

/// Both ends of a line, the device with its timer.
struct both_ends {
    pseudo_terminal far;
    posix_serial port;
    std::array<std::byte, 300> place{};

    both_ends()
    {
        REQUIRE(far.open());
        REQUIRE(port.open(far.path(), waiting));
    }

    /// What a read that has so long gives.
    result<byte_span> read(duration length) { return port.read(place, steady_now() + length); }
};

/// A read with nothing to read takes what it should: no time is too short, and of three the shortest is not too long, or of
/// many, where other programs make it longer.
void check_empty_reads(both_ends& line, duration wanted, duration most)
{
    duration shortest = test::limit;
    for (int i = 0; i < 3 or (i < 30 and shortest >= most); ++i) {
        instant const start = steady_now();
        auto const bytes = line.read(wanted);
        duration const found = steady_now() - start;
        REQUIRE(bytes);
        CHECK(bytes->empty());
        CHECK(found >= wanted);
        shortest = found < shortest ? found : shortest;
    }
    INFO("busy? The shortest of many waits is too long");
    CHECK(shortest < most);
}

} // namespace

TEST_CASE("all byte values pass unchanged where read waits")
{
    both_ends line;
    for (unsigned each = 0; each < 256; ++each) {
        std::array<std::byte, 1> const sent{to_byte(each)};
        REQUIRE(line.far.write(sent, soon()));
        auto const got = line.port.read(line.place, soon());
        REQUIRE(got);
        CHECK(same_bytes(*got, sent));
        REQUIRE(line.port.write(sent, soon()));
        auto const back = line.far.read(line.place, soon());
        REQUIRE(back);
        CHECK(same_bytes(*back, sent));
    }
}

TEST_CASE("the terminal's timer is set where read waits, and only there")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    descriptor const look{::open(far.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    for (bool const waits : {true, false, true}) {
        posix_serial port;
        REQUIRE(port.open(far.path(), {.waits_in_read = waits}));
        termios line{};
        REQUIRE(::tcgetattr(look.number(), &line) == 0);
        CHECK(line.c_cc[VMIN] == 0);
        CHECK(line.c_cc[VTIME] == (waits ? 1 : 0));
        // What a signal handler writes to stays non-blocking.
        CHECK((::fcntl(port.descriptor_number(), F_GETFL) & O_NONBLOCK) != 0);
    }
}

TEST_CASE("a wait for nothing ends at its deadline, be it shorter or longer than the terminal's timer")
{
    both_ends line;
    for (std::int64_t const length : {0, 1, 20, 99, 119, 120, 130, 250}) {
        duration const wanted = milliseconds(length);
        CAPTURE(length);
        check_empty_reads(line, wanted, wanted + milliseconds(15));
    }
}

TEST_CASE("bytes end a wait as they come, within the terminal's timer and after it")
{
    both_ends line;
    for (std::int64_t const late : {30, 150, 320}) {
        CAPTURE(late);
        instant const start = steady_now();
        std::thread unit{[&] {
            std::this_thread::sleep_for(to_chrono(milliseconds(late)));
            static_cast<void>(line.far.write("01 02"_hex, soon()));
        }};
        auto const bytes = line.read(test::limit);
        duration const found = steady_now() - start;
        unit.join();
        REQUIRE(bytes);
        CHECK(same_bytes(*bytes, "01 02"_hex));
        CHECK(found >= milliseconds(late));
        CHECK(found < test::limit);
    }
}

TEST_CASE("writing ends at its deadline where read waits")
{
    both_ends line;
    std::array<std::byte, 4096> const block{};
    result<void> written;
    for (unsigned i = 0; i < 100 and written; ++i) {
        written = line.port.write(block, steady_now() + milliseconds(20));
    }
    CHECK(written == errc::transmit_stalled);
}

TEST_CASE("a device that vanishes ends a wait in read with an error, and each one after it")
{
    both_ends line;
    std::thread hand{[&] {
        std::this_thread::sleep_for(to_chrono(milliseconds(30)));
        line.far.close();
    }};
    instant const until = soon();
    CHECK(line.port.read(line.place, until) == errc::device_vanished);
    hand.join();
    CHECK(line.port.read(line.place, until) == errc::device_vanished);
    CHECK(line.port.write(line.place, until) == errc::device_vanished);
    CHECK_FALSE(reached(steady_now(), until));
    CHECK(line.port.failure().find(line.port.device()) == 0);
}

#ifdef TIOCVHANGUP
TEST_CASE("a device whose driver hangs up, as when an adapter is pulled, ends a wait in read with an error")
{
    both_ends line;
    std::atomic<bool> may{true};
    std::thread hand{[&] {
        std::this_thread::sleep_for(to_chrono(milliseconds(30)));
        may = ::ioctl(line.port.descriptor_number(), TIOCVHANGUP) == 0;
        if (not may) {
            line.far.close(); // only root may hang up
        }
    }};
    instant const until = soon();
    CHECK(line.port.read(line.place, until) == errc::device_vanished);
    hand.join();
    CHECK(line.port.read(line.place, until) == errc::device_vanished);
    CHECK_FALSE(reached(steady_now(), until));
}
#endif

TEST_CASE("a device that read waits at is held exclusively, until it is closed")
{
    both_ends line;
    posix_serial other;
    CHECK(other.open(line.far.path(), waiting) == errc::device_in_use);
    CHECK(other.open(line.far.path()) == errc::device_in_use);
    posix_serial moved{std::move(line.port)};
    CHECK(other.open(line.far.path(), waiting) == errc::device_in_use);
    moved.close();
    CHECK(other.open(line.far.path(), waiting));
    CHECK(other.open("/dev/rtuwire-does-not-exist", waiting) == errc::device_not_found);
    CHECK(other.open("/dev/null", waiting) == errc::device_not_serial);
}

TEST_CASE("signals that do not restart system calls hold up no deadline")
{
    both_ends line;
    struct sigaction action {};
    struct sigaction before {};
    action.sa_handler = [](int) {};
    REQUIRE(::sigaction(SIGALRM, &action, &before) == 0);
    itimerval const often{{0, 7'000}, {0, 7'000}};
    REQUIRE(::setitimer(ITIMER_REAL, &often, nullptr) == 0);
    check_empty_reads(line, milliseconds(150), milliseconds(250));
    itimerval const never{};
    ::setitimer(ITIMER_REAL, &never, nullptr);
    ::sigaction(SIGALRM, &before, nullptr);
}

TEST_CASE("a late response of an earlier request is not taken for one where read waits")
{
    both_ends line;
    constexpr line_timing timing = line_timing::without_wire();
    blocking_client client{line.port, timing};
    std::atomic<bool> is_over{false};
    std::thread unit{[&] {
        server node{unit_id{1}, timing};
        word_bank<4> bank;
        static_cast<void>(bank.set(0, 1));
        while (not is_over and serve_once(node, line.far, bank, milliseconds(50))) {
        }
    }};
    std::this_thread::sleep_for(to_chrono(milliseconds(100))); // a server listens when its line was silent once
    // Of the same function and size: 7 where the unit has 1.
    REQUIRE(line.far.write("01 03 02 00 07 F9 86"_hex, soon()));
    auto const response = client.ask(unit_id{1}, read_holding_registers{.start = 0, .count = 1});
    is_over = true;
    unit.join();
    REQUIRE(response);
    CHECK(response->registers[0] == 1);
}

#if defined(TIOCGSERIAL) && defined(ASYNC_LOW_LATENCY)
namespace {

/// A driver that knows the two calls, or not, and keeps the flag, or not.
struct driver {
    bool gets{true};
    bool sets{true};
    bool keeps{true};
    int flags{0x40};

    bool operator()(unsigned long request, serial_struct& place)
    {
        bool const is_get = request == TIOCGSERIAL;
        if (is_get and gets) {
            place.flags = flags;
        } else if (not is_get and sets and keeps) {
            flags = place.flags;
        }
        return is_get ? gets : sets;
    }
};

} // namespace

TEST_CASE("whether a driver has low latency is what it says after it was asked")
{
    constexpr auto flag = static_cast<int>(ASYNC_LOW_LATENCY);
    driver takes;
    CHECK(set_low_latency(takes));
    CHECK(takes.flags == (0x40 | flag));
    CHECK_FALSE(set_low_latency(driver{.gets = false}));
    CHECK_FALSE(set_low_latency(driver{.sets = false}));
    CHECK_FALSE(set_low_latency(driver{.keeps = false}));
}
#endif

TEST_CASE("a pseudo-terminal has no low latency to offer, nor has a port that is not open")
{
    posix_serial closed;
    CHECK_FALSE(closed.has_low_latency());
    both_ends line;
    CHECK_FALSE(line.port.has_low_latency());
}
