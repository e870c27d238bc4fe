// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stops that a blocking client runs over a port which fails: their word is sent where the port can send at all, and they end
// by their own limit.
#include <rtuwire/client/blocking.hpp>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/drive_port.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_freewheel.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using altivar::outcome_kind;
using altivar::stop_by;

namespace {

using device = altivar::atv320::device;
constexpr station<device> drive{unit_id{3}};

/// A drive's port of which so many of the next reads or writes fail, and whose program is stopped in one of the next calls.
struct failing_port : test::drive_port<device> {
    unsigned good_reads{0}; ///< before the bad ones
    unsigned bad_reads{0};
    unsigned bad_writes{0};
    errc why{errc::device_failed};
    duration longest_write{};
    bool has_stale{false};
    unsigned calls_to_stop{0};
    duration stop{};

    instant now()
    {
        if (calls_to_stop != 0 and --calls_to_stop == 0) {
            clock = clock + stop;
        }
        return clock;
    }
    result<void> write(byte_view bytes, instant until)
    {
        duration const given = until - clock;
        longest_write = given > longest_write ? given : longest_write;
        if (bad_writes == 0) {
            return drive_port::write(bytes, until);
        }
        --bad_writes;
        if (why == errc::transmit_stalled) {
            clock = until;
        }
        far.advance(clock);
        return why;
    }
    result<byte_span> read(byte_span place, instant until)
    {
        if (std::exchange(has_stale, false)) {
            std::fill_n(place.begin(), 5, std::byte{3});
            return place.first(5);
        }
        if (bad_reads == 0 or good_reads != 0) {
            good_reads -= good_reads != 0 ? 1U : 0U;
            return drive_port::read(place, until);
        }
        --bad_reads;
        clock = clock + microseconds(20);
        far.advance(clock);
        return why;
    }

    /// Whether the last frame that was sent is a word that stops.
    bool says() const { return not sent.empty() and sent.back()[1] == std::byte{6}; }

    void wait(duration length)
    {
        for (instant const end = clock + length; not reached(clock, end); clock = clock + milliseconds(1)) {
            far.advance(clock);
        }
    }
};

constexpr unsigned for_ever = 1'000'000'000;

/// A port and a client whose drive runs by its order.
struct running {
    failing_port port{};
    blocking_client<failing_port> line;
    altivar::start go; // made by the constructor: Clang 14 would make code of a constant here

    explicit running(client_options const& options = {}) : line{port, port.timing, options}, go{drive, 30_Hz}
    {
        REQUIRE(line.run(go).kind == outcome_kind::succeeded);
        REQUIRE(port.has_power());
        port.sent.clear();
    }
};

/// What one run gives where every read fails.
template <typename Stop> void check_blind(Stop&& stop)
{
    running it;
    it.port.bad_reads = for_ever;
    instant const begin = it.port.clock;
    static_cast<void>(it.line.run(stop));
    CHECK(it.port.clock - begin < milliseconds(1'500));
    it.port.wait(milliseconds(10'000));
    CHECK_FALSE(it.port.has_power());
    CHECK(it.port.says());
}

} // namespace

TEST_CASE("a stop goes on where one read before its word fails")
{
    running it;
    it.port.bad_reads = 1;
    CHECK(it.line.run(altivar::stop{drive}).kind == outcome_kind::succeeded);
    CHECK_FALSE(it.port.has_power());
    CHECK_FALSE(it.go.running());
}

TEST_CASE("a stop's word is sent where nothing can be read, and the port's error told")
{
    for (stop_by const mode : {stop_by::ramp, stop_by::freewheel, stop_by::quick_stop, stop_by::halt}) {
        INFO(static_cast<int>(mode));
        running it;
        it.port.bad_reads = for_ever;
        altivar::stop rest{drive, mode};
        CHECK(it.line.run(rest).error == errc::device_failed);
        CHECK_FALSE(it.port.sent.empty());
        it.port.wait(milliseconds(10'000));
        CHECK_FALSE(it.port.far.drive().state_machine().state() == cia402::state::operation_enabled);
    }
    check_blind(altivar::stop{drive, stop_by::freewheel});
    check_blind(altivar::broadcast_stop{altivar::broadcast_stop_options{.freewheel = true}, drive});
    check_blind(altivar::broadcast_freewheel<device>());
}

/// The same where its program is stopped in one of the calls, too, or the first writes stall.
template <typename Stop> void check_late(char const* name, Stop const& stop)
{
    INFO(name);
    for (duration const pause : {milliseconds(1'100), milliseconds(34 * 60'000)}) {
        for (unsigned call = 1; call <= 20; ++call) {
            INFO("a pause of " << pause.microseconds << " us in call " << call);
            running it;
            it.port.bad_reads = for_ever;
            it.port.calls_to_stop = call;
            it.port.stop = pause;
            Stop now = stop;
            static_cast<void>(it.line.run(now));
            CHECK(it.port.says());
        }
    }
    for (unsigned const writes : {1U, 2U}) {
        INFO(writes << " writes stall");
        running it{{.response_timeout = milliseconds(700)}}; // for 2 s, a lost unit has words
        it.port.why = errc::transmit_stalled;
        it.port.bad_reads = for_ever;
        it.port.bad_writes = writes;
        Stop now = stop;
        instant const begin = it.port.clock;
        static_cast<void>(it.line.run(now));
        INFO((it.port.clock - begin).microseconds << " us, bad writes left " << it.port.bad_writes << " sent "
                                                  << it.port.sent.size());
        CHECK(it.port.says());
    }
}

TEST_CASE("defect: S1 a stop's word is sent where nothing can be read, however long its program was stopped or writes "
          "stalled")
{
    using altivar::stop_begin;
    check_late("stop{drive}", altivar::stop{drive});
    check_late("stop{drive, stop_by::freewheel}", altivar::stop{drive, stop_by::freewheel});
    check_late("stop{drive, stop_by::halt}", altivar::stop{drive, stop_by::halt});
    check_late("look first", altivar::stop{drive, stop_by::ramp, milliseconds(3'000), stop_begin::look_first});
    check_late("broadcast_stop{drive}", altivar::broadcast_stop{drive});
}

TEST_CASE("defect: S1 a broadcast that frees is sent behind a stale frame, however long its program was stopped")
{
    for (duration const pause : {milliseconds(300), milliseconds(2'000), milliseconds(34 * 60'000)}) {
        for (unsigned call = 1; call <= 12; ++call) {
            INFO("a pause of " << pause.microseconds << " us in call " << call);
            running it{{.response_timeout = milliseconds(100)}};
            it.port.has_stale = true;
            it.port.calls_to_stop = call;
            it.port.stop = pause;
            CHECK(it.line.run(altivar::broadcast_freewheel<device>()).error() == errc::none);
            CHECK(it.port.says());
        }
    }
}

TEST_CASE("what stops nothing is not sent where the port's reads fail before it")
{
    running it;
    it.port.bad_reads = 1;
    CHECK(it.line.run(altivar::start{drive, 20_Hz}).error == errc::device_failed);
    CHECK(it.port.sent.empty());
}

TEST_CASE("one write that stalls or fails ends no stop")
{
    for (errc const why : {errc::transmit_stalled, errc::device_failed}) {
        for (unsigned const writes : {1U, 5U}) {
            running it;
            it.port.why = why;
            it.port.bad_writes = writes;
            auto const ended = it.line.run(altivar::stop{drive});
            CHECK_FALSE(it.port.sent.empty());
            CHECK_FALSE(it.port.has_power());
            // Behind several that stalled its drive has ended the run by itself.
            CHECK((writes == 1 ? ended.kind == outcome_kind::succeeded : ended.error == errc::none));
        }
    }
}

TEST_CASE("one write that fails ends no stop whose program was stopped for longer than its limit")
{
    for (unsigned call = 1; call <= 8; ++call) {
        INFO("its program was stopped in call " << call);
        running it;
        it.port.bad_writes = 1;
        it.port.calls_to_stop = call;
        it.port.stop = milliseconds(3'000); // the drive's time-out is 10 s
        static_cast<void>(it.line.run(altivar::stop{drive, stop_by::ramp, milliseconds(2'000)}));
        CHECK(it.port.commands(0x0000) + it.port.commands(0x0007) != 0);
        CHECK_FALSE(it.port.has_power());
    }
}

TEST_CASE("one write that stalls or fails ends no broadcast that frees")
{
    for (errc const why : {errc::transmit_stalled, errc::device_failed}) {
        running it;
        it.port.why = why;
        it.port.bad_writes = 1;
        static_cast<void>(it.line.run(altivar::broadcast_freewheel<device>()));
        CHECK(it.port.says());
    }
}

TEST_CASE("a stop ends by its limit where no write is taken, whatever the response time-out, and tells that")
{
    for (duration const timeout : {milliseconds(100), milliseconds(1'000), milliseconds(30 * 60'000)}) {
        INFO(timeout.microseconds / 1'000);
        running it{{.response_timeout = timeout}};
        it.port.why = errc::transmit_stalled;
        it.port.bad_writes = for_ever;
        instant const begin = it.port.clock;
        altivar::stop rest{drive};
        auto const ended = it.line.run(rest);
        CHECK(ended.kind == outcome_kind::silent);
        CHECK(ended.error == errc::transmit_stalled);
        CHECK(it.port.clock - begin >= milliseconds(29'000));
        CHECK(it.port.clock - begin < milliseconds(33'000));
        CHECK(it.port.longest_write <= milliseconds(1'200));
        // And another one is possible when the port works.
        it.port.bad_writes = 0;
        it.port.sent.clear();
        CHECK(it.line.run(rest).error == errc::none);
        CHECK_FALSE(it.port.sent.empty());
    }
}

TEST_CASE("defect: S1 a stop that the port's error left under way sends its word in each run, also behind its limit")
{
    auto const check = [](auto const& stop) {
        for (unsigned call = 1; call <= 12; ++call) {
            INFO("its program was stopped in call " << call);
            running it;
            it.port.bad_reads = for_ever;
            it.port.calls_to_stop = call;
            it.port.stop = milliseconds(50 * 60'000);
            auto rest = stop;
            static_cast<void>(it.line.run(rest));
            REQUIRE(it.port.says());
            for (duration const pause : {milliseconds(10), milliseconds(5'000), milliseconds(35'000)}) {
                INFO(pause.microseconds);
                it.port.wait(pause);
                it.port.sent.clear();
                static_cast<void>(it.line.run(rest));
                CHECK(it.port.says());
            }
        }
    };
    check(altivar::stop{drive});
    check(altivar::stop{drive, stop_by::halt});
    check(altivar::broadcast_stop{drive});
    check(altivar::broadcast_freewheel<device>());
}

TEST_CASE("a start that the port's error left under way is ordered anew by its next run, with its whole check")
{
    auto const reads_before_its_word = [](failing_port const& port) {
        auto const is_write = [](auto const& frame) { return frame[1] != std::byte{3}; };
        return std::vector(port.sent.begin(), std::find_if(port.sent.begin(), port.sent.end(), is_write));
    };
    failing_port usual{};
    blocking_client<failing_port> usual_line{usual, usual.timing};
    REQUIRE(usual_line.run(altivar::start{drive, 30_Hz}).kind == outcome_kind::succeeded);
    auto const whole_check = reads_before_its_word(usual);
    REQUIRE(whole_check.size() > 5);
    unsigned left_under_way = 0;
    for (unsigned reads = 1; reads < 60; ++reads) {
        INFO("read " << reads << " fails");
        failing_port port{};
        port.good_reads = reads;
        port.bad_reads = 1;
        blocking_client<failing_port> line{port, port.timing};
        altivar::start go{drive, 30_Hz};
        static_cast<void>(line.run(go));
        if (port.bad_reads != 0 or go.settled() or port.has_power()) {
            continue;
        }
        ++left_under_way;
        port.sent.clear();
        CHECK(line.run(go).kind == outcome_kind::succeeded);
        CHECK(reads_before_its_word(port) == whole_check);
    }
    CHECK(left_under_way > 0);
}

TEST_CASE("a stop ends at once where the device is gone")
{
    for (errc const why : {errc::device_vanished, errc::device_not_open}) {
        running it;
        it.port.why = why;
        it.port.bad_reads = it.port.bad_writes = for_ever;
        instant const begin = it.port.clock;
        CHECK(it.line.run(altivar::stop{drive}).error == why);
        CHECK(it.port.clock - begin < milliseconds(50));
    }
}

TEST_CASE("a stop that was given up holds its unit until a waiting client releases it")
{
    for (bool const is_of_all : {false, true}) {
        running it;
        CHECK(it.line.is_ordered(unit_id{3}));
        CHECK_FALSE(it.line.is_ordered(unit_id{4}));
        REQUIRE(it.line.run(altivar::stop{drive}).kind == outcome_kind::succeeded); // else the unit would be lost
        it.port.bad_reads = for_ever;
        if (is_of_all) {
            static_cast<void>(
                it.line.run(altivar::broadcast_stop{altivar::broadcast_stop_options{.freewheel = true}, drive}));
        } else {
            static_cast<void>(it.line.run(altivar::stop{drive}));
        }
        it.port.bad_reads = 0;
        it.port.wait(milliseconds(3'000));
        CHECK(it.line.run(altivar::start{drive, 20_Hz}).kind == outcome_kind::overruled);
        if (is_of_all) {
            it.line.release_all();
        } else {
            it.line.release(unit_id{3});
        }
        CHECK(it.line.run(altivar::start{drive, 20_Hz}).kind == outcome_kind::succeeded);
        CHECK(it.line.is_ordered(unit_id{3}));
        CHECK(it.line.run(altivar::stop{drive}).kind == outcome_kind::succeeded);
        CHECK_FALSE(it.line.is_ordered(unit_id{3}));
    }
}
