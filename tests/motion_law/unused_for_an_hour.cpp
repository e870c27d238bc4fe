// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A waiting client that nobody used for up to an hour and more, or for days: the next stop leaves as from a client that is
// new, be its drive there or lost before.
#include "support/catch.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/client/blocking.hpp>
#include <rtuwire/sim/drive/unit.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

using device = atv320::device;
constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr station<device> motor{unit_id{3}};
constexpr std::uint64_t minute = 60'000'000;

/// A port with a simulated drive behind it, in virtual time of 64 bits.
struct drive_port {
    std::uint64_t time{0xFFFF'FFFFU - 3'000'000U};
    sim::unit<device> unit{motor.unit(), timing, instant{static_cast<std::uint32_t>(time)}};
    std::vector<std::uint64_t> departures{};
    bool is_cut{false};
    unsigned lost{0};         ///< how many of the next responses are
    std::uint64_t stopped{0}; ///< how long the program is, before it is given a response
    unsigned in_time{0};      ///< how many come before that one
    bool loses_that{false};   ///< the one before which it was stopped does not come

    drive_port() { pass(100'000); }
    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }

    /// Time in which nobody calls the client. The drive lives through it.
    void pass(std::uint64_t length)
    {
        for (std::uint64_t const end = time + length; time < end;) {
            time = std::min(end, time + 1'000'000);
            unit.advance(now());
        }
    }
    result<void> write(byte_view bytes, instant)
    {
        departures.push_back(time);
        time += timing.characters(bytes.size()).microseconds;
        unit.receive(bytes, now());
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        while (not reached(now(), until)) {
            instant const next = *earlier(unit.poll_deadline(), until);
            time += reached(now(), next) ? 1 : (next - now()).microseconds;
            unit.advance(now());
            if (byte_view const frame = unit.poll_transmit(); not frame.empty()) {
                time += timing.characters(frame.size()).microseconds;
                std::copy(frame.begin(), frame.end(), place.begin());
                std::size_t const size = is_cut or lost > 0 ? 0 : frame.size();
                unit.sent(now());
                lost -= lost > 0 ? 1 : 0;
                bool const is_in_time = size == 0 or in_time > 0;
                in_time -= in_time > 0 ? 1 : 0;
                std::uint64_t const pause = is_in_time ? 0 : std::exchange(stopped, 0);
                pass(pause);
                return place.first(pause != 0 and loses_that ? 0 : size);
            }
        }
        return place.first(0);
    }
};

struct stopped {
    std::uint64_t first_frame_after;
    outcome_kind how;
};

/// A motor was started; nobody used the client for so long, and then it is stopped.
stopped stop_after(std::uint64_t pause, bool was_lost)
{
    drive_port port;
    blocking_client line{port, timing, {.response_timeout = milliseconds(100), .retries = 1}};
    start go{motor, 30_Hz};
    static_cast<void>(line.run(go));
    REQUIRE(go.succeeded());
    port.is_cut = was_lost;
    for (unsigned i = 0; i < 3; ++i) {
        CHECK(line.ask(motor.unit(), read_holding_registers{device::layout.eta, 1}).has_value() != was_lost);
    }
    port.is_cut = false;
    port.pass(pause);
    std::uint64_t const begin = port.time;
    std::size_t const before = port.departures.size();
    stop halt{motor};
    static_cast<void>(line.run(halt));
    REQUIRE(port.departures.size() > before);
    return {port.departures[before] - begin, halt.reason().kind};
}

} // namespace

TEST_CASE("motion law: S45 a stop leaves at once, however long its client was not used")
{
    for (bool const was_lost : {false, true}) {
        // Two minutes are longer than anything that is in force for a drive.
        stopped const usual = stop_after(2 * minute, was_lost);
        CHECK(usual.first_frame_after < 5'000);
        for (std::uint64_t const pause :
             {36 * minute, 40 * minute, 50 * minute, 71 * minute, 71 * minute + 20'000'000, 71 * minute + 34'000'000,
              110 * minute, 142 * minute, 143 * minute, 24 * 60 * minute}) {
            INFO("not used for " << pause / minute << " minutes, " << (was_lost ? "lost" : "not lost") << " before");
            stopped const it = stop_after(pause, was_lost);
            CHECK(it.first_frame_after == usual.first_frame_after);
            CHECK(it.how == usual.how);
        }
    }
}

namespace {

/// How a start and a stop end that follow a read, where the program is stopped for so long before its response, or
/// behind it. The drive trips meanwhile, for nobody reaches it.
std::pair<outcome_kind, outcome_kind> orders_after(std::uint64_t pause, bool is_inside)
{
    drive_port port;
    blocking_client line{port, timing, {.response_timeout = milliseconds(100), .retries = 1}};
    auto const read = [&] {
        port.lost = 1;
        port.stopped = is_inside ? pause : 0;
        CHECK(line.ask(motor.unit(), read_holding_registers{device::layout.eta, 1}));
        port.pass(is_inside ? 0 : pause);
    };
    read();
    start go{motor, 30_Hz};
    static_cast<void>(line.run(go));
    read();
    stop halt{motor};
    static_cast<void>(line.run(halt));
    return {go.reason().kind, halt.reason().kind};
}

} // namespace

TEST_CASE("motion law: S45 a start and a stop after a pause in the middle of a request read their drive")
{
    for (std::uint64_t const pause : {minute, 30 * minute, 36 * minute, 50 * minute, 71 * minute}) {
        INFO("the program was stopped for " << pause / minute << " minutes before a response");
        auto const usual = orders_after(pause, false);
        CHECK(usual.first == outcome_kind::in_fault);
        CHECK(orders_after(pause, true) == usual);
    }
}

namespace {

/// Whether the motor has its power where an order ends whose program was stopped before the n-th response; nothing where there
/// are fewer. What it says must be true.
template <typename Conversation>
std::optional<bool> says_so(drive_port& port, auto& line, Conversation& order, unsigned in_time,
                            std::uint64_t pause = minute / 3)
{
    port.in_time = in_time;
    port.stopped = pause;
    static_cast<void>(line.run(order));
    if (port.stopped != 0) {
        return std::nullopt;
    }
    bool const has_power = cia402::has_power(port.unit.drive().state_machine().state());
    bool const is_done = order.succeeded() or order.reason().kind == outcome_kind::reference_limited;
    CHECK((not is_done or has_power));
    CHECK(order.reason().kind != outcome_kind::pending);
    return has_power;
}

} // namespace

TEST_CASE("motion law: L15 no order is done of a drive that stopped itself while the program was stopped")
{
    unsigned starts = 0, changes = 0;
    bool is_over = false;
    for (; not is_over; ++starts) {
        INFO("start, stopped before response " << starts);
        drive_port port;
        blocking_client line{port, timing, {.response_timeout = milliseconds(100), .retries = 1}};
        start go{motor, 30_Hz};
        auto const has_power = says_so(port, line, go, starts);
        is_over = not has_power;
        CHECK((is_over or go.running() == *has_power));
    }
    CHECK(starts > 15);
    for (is_over = false; not is_over; ++changes) {
        INFO("change, stopped before response " << changes);
        drive_port port;
        blocking_client line{port, timing, {.response_timeout = milliseconds(100), .retries = 1}};
        start go{motor, 30_Hz};
        static_cast<void>(line.run(go));
        REQUIRE(go.running());
        change_reference to{motor, 20_Hz};
        auto const has_power = says_so(port, line, to, changes);
        is_over = not has_power;
        CHECK((is_over or go.running() == *has_power));
    }
    CHECK(changes > 3);
}

namespace {

/// A drive that its line does not stop, and a program that is stopped for longer than it takes for that to be noticed.
struct unwatched {
    std::uint16_t sll;
    supervision_risks accepted;
    std::uint64_t pause;
    bool loses_response; ///< the one before which the program is stopped
    client_options options;
    duration limit;
};

/// A start is done, or its motor has no power, before whichever response the program is stopped; how many of the starts failed.
unsigned failed_starts(unwatched const& how)
{
    constexpr std::uint16_t sll = 7'010, tto = 6'005;
    register_block<1> const reaction{how.sll}, three_seconds{30};
    unsigned failed = 0;
    bool is_over = false;
    for (unsigned in_time = 0; not is_over; ++in_time) {
        INFO("stopped before response " << in_time);
        drive_port port;
        port.loses_that = how.loses_response;
        REQUIRE(port.unit.drive().write(sll, reaction) == errc::none);
        REQUIRE(port.unit.drive().write(tto, three_seconds) == errc::none);
        blocking_client line{port, timing, how.options};
        start go{motor, 30_Hz, run_direction::forward, how.limit, {.risks = how.accepted}};
        auto const has_power = says_so(port, line, go, in_time, how.pause);
        is_over = not has_power;
        failed += is_over or go.succeeded() ? 0U : 1U;
        CHECK((is_over or go.succeeded() == *has_power));
    }
    return failed;
}

} // namespace

TEST_CASE("motion law: L15 a start that failed behind such a stop leaves no motor running that nothing else would stop")
{
    CHECK(failed_starts({.sll = 0,
                         .accepted = {.accept_unsupervised = true},
                         .pause = minute, // longer than any time-out
                         .loses_response = false,
                         .options = {.response_timeout = milliseconds(100), .retries = 1},
                         .limit = milliseconds(3'000)}) > 0);
    // One that looks again, and may give no word any more.
    CHECK(failed_starts({.sll = 5,
                         .accepted = {.accept_running_on = true},
                         .pause = 5'000'000,
                         .loses_response = true,
                         .options = {.response_timeout = milliseconds(100), .retries = 0},
                         .limit = milliseconds(30'000)}) > 0);
}

TEST_CASE("motion law: L4 reads keep no motor running behind a second start that ended while its program was stopped")
{
    drive_port port;
    blocking_client line{port, timing, {.response_timeout = milliseconds(100), .retries = 1}};
    start first{motor, 30_Hz};
    static_cast<void>(line.run(first));
    REQUIRE(first.running());
    port.pass(8'000'000);
    port.stopped =
        5'000'000; // before its first response: longer than its limit, less than the drive's time-out of 10 s
    start second{motor, 20_Hz};
    CHECK(line.run(second).kind == outcome_kind::aborted);
    REQUIRE(cia402::has_power(port.unit.drive().state_machine().state()));
    CHECK_FALSE(first.running());
    CHECK_FALSE(second.running());
    for (unsigned i = 0; i < 60; ++i) {
        static_cast<void>(line.ask(motor.unit(), read_holding_registers{device::layout.eta, 1}));
        port.pass(500'000);
    }
    CHECK_FALSE(cia402::has_power(port.unit.drive().state_machine().state()));
}
