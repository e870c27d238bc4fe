// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit that misses a request that comes too soon behind its response: the silence before a request may be as long as the
// time allowed for a response, or longer, and one unit may want a pause that the others do not.
#include "client_line.hpp"

#include "support/catch.hpp"
#include "support/server_on_a_line.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::test;

namespace {

constexpr line_timing meters{9'600, character_format::none_8_1};
constexpr std::uint64_t second = 1'000'000;
constexpr std::uint64_t turn = 20'000;  ///< from a request to its response
constexpr std::uint64_t little = 1'000; ///< what a program may be late by

constexpr duration pauses[]{milliseconds(400), milliseconds(999), milliseconds(1'000), milliseconds(1'001),
                            milliseconds(5'000)};

/// A line on which each unit answers, and when each answer had come.
template <typename Link> struct meter_line : scripted_line<Link> {
    std::vector<std::uint64_t> answered{};

    explicit meter_line(Link const& made, line_timing const& timing) : scripted_line<Link>{made, timing}
    {
        this->heard = [this](frame_bytes const& frame) {
            frame_bytes const said = response_to(frame);
            this->say(turn, said);
            answered.push_back(this->time() + turn + this->length_of(said.size()));
        };
    }

    /// The shortest time from an answer to the next request of those that `is_meant`, and the longest.
    template <typename Meant> std::pair<std::uint64_t, std::uint64_t> gaps(Meant is_meant) const
    {
        std::pair<std::uint64_t, std::uint64_t> found{~std::uint64_t{0}, 0};
        std::optional<std::uint64_t> before;
        for (std::size_t i = 0; i < this->departures.size(); ++i) {
            if (not is_meant(this->departures[i].frame)) {
                continue;
            }
            if (before) {
                found.first = std::min(found.first, this->departures[i].begin - *before);
                found.second = std::max(found.second, this->departures[i].begin - *before);
            }
            before = i < answered.size() ? std::optional{answered[i]} : std::nullopt;
        }
        return found;
    }
};

series reads(unsigned unit, unsigned count)
{
    return series{[=](unsigned) { return read_of(unit, 3201); }, count};
}
auto of_unit(unsigned unit)
{
    return [=](frame_bytes const& frame) { return at(frame, 0) == unit; };
}

/// A port with a clock of its own and a unit behind it that answers.
struct meter_port {
    std::uint64_t time{0xFFFF'FFFFU - 3 * second};
    std::vector<std::uint64_t> departures{};
    std::vector<std::uint64_t> answered{};
    frame_bytes coming{};
    bool is_there{true};

    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    result<void> write(byte_view bytes, instant)
    {
        departures.push_back(time);
        time += meters.characters(bytes.size()).microseconds;
        if (is_there) {
            coming = response_to(frame_bytes(bytes.begin(), bytes.end()));
            answered.push_back(time + turn + meters.characters(coming.size()).microseconds);
        }
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        auto const left = static_cast<std::int32_t>(until.microseconds - now().microseconds);
        std::uint64_t const end = time + static_cast<std::uint64_t>(std::max(left, 0));
        if (coming.empty() or answered.back() > end) {
            time = end;
            return place.first(0);
        }
        time = std::max(time, answered.back());
        std::copy(coming.begin(), coming.end(), place.begin());
        return place.first(std::exchange(coming, {}).size());
    }
};

constexpr read_holding_registers request{3201, 1};

} // namespace

TEST_CASE("defect: D34 a request waits for the silence before it outside of its own time")
{
    for (duration const pause : pauses) {
        INFO("silence " << pause.microseconds << " us");
        line_timing const timing = meters.with_silence(pause);
        meter_line<client> line{client{timing}, timing};
        series meter = reads(1, 3);
        line.run(60 * second, [&](instant now) { line.link.converse(meter, now); });
        CHECK(meter.number == 3);
        CHECK(meter.answered == 3);
        CHECK(meter.last == errc::none);
        auto const gaps = line.gaps(of_unit(1));
        CHECK(gaps.first >= pause.microseconds);
        CHECK(gaps.second <= pause.microseconds + little);
        CHECK(line.spinning <= 2);
    }
}

TEST_CASE("defect: D34 a bus waits for it, too, whatever unit is next")
{
    for (duration const pause : pauses) {
        INFO("silence " << pause.microseconds << " us");
        line_timing const timing = meters.with_silence(pause);
        meter_line<bus<2>> line{bus<2>{timing}, timing};
        series units[]{reads(1, 3), reads(2, 3)};
        line.run(60 * second, [&](instant now) {
            line.link.converse(0, units[0], now);
            line.link.converse(1, units[1], now);
        });
        CHECK(units[0].answered == 3);
        CHECK(units[1].answered == 3);
        auto const gaps = line.gaps([](frame_bytes const&) { return true; });
        CHECK(gaps.first >= pause.microseconds);
        CHECK(gaps.second <= pause.microseconds + little);
    }
}

TEST_CASE("defect: D34 a waiting client waits for it, counted from the last byte and not from the call")
{
    for (duration const pause : pauses) {
        INFO("silence " << pause.microseconds << " us");
        meter_port port;
        blocking_client line{port, meters.with_silence(pause)};
        for (int i = 0; i < 3; ++i) {
            CHECK(line.ask(unit_id{1}, request));
            port.time += 300'000; // the program does something else
        }
        REQUIRE(port.departures.size() == 3);
        for (std::size_t i = 1; i < 3; ++i) {
            std::uint64_t const gap = port.departures[i] - port.answered[i - 1];
            CHECK(gap >= pause.microseconds);
            CHECK(gap <= pause.microseconds + little);
        }
    }
}

TEST_CASE("defect: D34 silence is no jam, and damage is told, however long the silence before a request")
{
    constexpr client_options quick{.response_timeout = milliseconds(200), .retries = 1};
    for (duration const pause : pauses) {
        INFO("silence " << pause.microseconds << " us");
        line_timing const timing = meters.with_silence(pause);
        scripted_line<client> empty{client{timing, quick}, timing};
        series nobody = reads(1, 1);
        empty.run(60 * second, [&](instant now) { empty.link.converse(nobody, now); });
        CHECK(nobody.number == 1);
        CHECK(nobody.last == errc::timed_out);
        CHECK(empty.departures.size() == 2);

        scripted_line<client> faulty{client{timing, quick}, timing};
        faulty.heard = [&](frame_bytes const& frame) {
            frame_bytes said = response_to(frame);
            said.back() ^= std::byte{1};
            faulty.say(turn, said);
        };
        series noisy = reads(1, 1);
        faulty.run(60 * second, [&](instant now) { faulty.link.converse(noisy, now); });
        CHECK(noisy.number == 1);
        CHECK(noisy.last == errc::crc_mismatch);

        meter_port port;
        port.is_there = false;
        blocking_client waits{port, timing, quick};
        CHECK(waits.ask(unit_id{1}, request) == errc::timed_out);
    }
}

TEST_CASE("defect: D34 others may talk for no longer than a response may take, and then the silence is waited for")
{
    for (bool const ends : {false, true}) {
        line_timing const timing = meters.with_silence(milliseconds(1'000));
        meter_line<client> line{client{timing}, timing};
        std::uint64_t const begin = line.time();
        constexpr std::uint64_t step = 300'000;
        for (std::uint64_t after = 1; after < (ends ? 900'000 : 3 * second); after += step) {
            line.arrive(begin + after, {std::byte{0x55}});
        }
        series meter = reads(1, 1);
        line.run(1, [](instant) {}); // the first of them has come
        line.run(10 * second, [&](instant now) { line.link.converse(meter, now); });
        CHECK(meter.number == 1);
        CHECK(meter.last == (ends ? errc::none : errc::bus_jam));
    }
}

TEST_CASE("defect: D34 the pause of one unit costs another nothing, and holds for repetitions")
{
    constexpr std::uint64_t pause = 700'000;
    constexpr retry_policy slow{.pause = milliseconds(700)};
    for (bool const is_damaged : {false, true}) {
        meter_line<client> line{client{meters}, meters};
        series units[]{reads(1, 3), reads(2, 60)};
        std::function<void(frame_bytes const&)> const answers = line.heard;
        unsigned asked = 0;
        if (is_damaged) {
            line.heard = [&](frame_bytes const& frame) {
                if (at(frame, 0) == 1 and asked++ % 2 == 0) {
                    frame_bytes said = response_to(frame);
                    said.back() ^= std::byte{1};
                    line.say(turn, said);
                    line.answered.push_back(line.time() + turn + line.length_of(said.size()));
                } else {
                    answers(frame);
                }
            };
        }
        std::uint64_t const begin = line.time();
        line.run(60 * second, [&](instant now) {
            line.link.converse(units[0], now, slow);
            line.link.converse(units[1], now);
        });
        CHECK(units[0].answered == 3);
        CHECK(units[1].answered == 60);
        auto const gaps = line.gaps(of_unit(1));
        CHECK(gaps.first >= pause);
        CHECK(gaps.second <= pause + 2 * (turn + line.length_of(20)));
        if (not is_damaged) { // a repetition has the line until it has left
            CHECK(line.departures.back().begin - begin < 60 * 3 * turn);
        }
    }
}

TEST_CASE("defect: D34 a slot's unit has its pause, and a stop does not wait for one")
{
    constexpr std::uint64_t pause = 700'000;
    meter_line<bus<2>> line{bus<2>{meters}, meters};
    line.link.set(0, {.with = {.pause = milliseconds(700)}});
    series units[]{reads(1, 3), reads(2, 60)};
    line.run(60 * second, [&](instant now) {
        line.link.converse(0, units[0], now);
        line.link.converse(1, units[1], now);
    });
    CHECK(units[0].answered == 3);
    CHECK(units[1].answered == 60);
    auto const gaps = line.gaps(of_unit(1));
    CHECK(gaps.first >= pause);
    CHECK(gaps.second <= pause + 2 * (turn + line.length_of(20)));
}

TEST_CASE("defect: D34 a busy unit has its pause before the request is repeated")
{
    meter_line<client> line{client{meters}, meters};
    std::function<void(frame_bytes const&)> const answers = line.heard;
    line.heard = [&](frame_bytes const& frame) {
        if (line.departures.size() == 1) {
            line.say(turn, framed({1, 0x83, 6}));
            line.answered.push_back(line.time() + turn + line.length_of(5));
        } else {
            answers(frame);
        }
    };
    series meter = reads(1, 2);
    line.run(60 * second, [&](instant now) { line.link.converse(meter, now, {.pause = milliseconds(700)}); });
    CHECK(meter.answered == 2);
    CHECK(line.departures.size() == 3);
    CHECK(line.gaps(of_unit(1)).first >= 700'000);
}

TEST_CASE("defect: D34 a server waits for the silence before its response")
{
    constexpr duration silence = milliseconds(1'000);
    server_on_a_line<> unit{meters.with_silence(silence)};
    unit.sleep(silence);
    unit.hear(read_of(1, 0));
    instant const asked = unit.now;
    CHECK(unit.node.poll_transmit().empty());
    for (int i = 0; i < 10; ++i) {
        REQUIRE(unit.node.poll_deadline().has_value());
        unit.pass(*unit.node.poll_deadline() - unit.now);
        if (not unit.node.poll_transmit().empty()) {
            CHECK(unit.now == asked + silence);
            return;
        }
    }
    FAIL("no response");
}
