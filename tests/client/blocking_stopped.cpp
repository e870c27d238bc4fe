// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A host whose program is stopped for more than half an hour in the middle of a pass: in a write, or in a conversation.
#include <rtuwire/client/blocking.hpp>

#include <array>
#include <cstdint>
#include <optional>

#include "support/catch.hpp"

#include <rtuwire/client/bus.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr read_holding_registers request{3201, 1};

constexpr std::uint64_t minute = 60'000'000;
constexpr std::array<std::uint64_t, 6> pauses{36 * minute,  50 * minute, 71 * minute, 71 * minute + 35'000'000,
                                              110 * minute, 140 * minute};

/// A port on which nobody answers, with a clock of 64 bits behind the instants. What it is asked to wait is counted when it
/// is asked.
struct stopping_port {
    std::uint64_t clock{1'000'000};
    std::uint64_t stop_in_write{0};
    std::uint64_t longest_read{0};
    unsigned good_reads{1'000}; ///< before they fail

    instant now() const { return instant{static_cast<std::uint32_t>(clock)}; }
    result<void> write(byte_view bytes, instant)
    {
        clock += timing.characters(bytes.size()).microseconds + stop_in_write;
        stop_in_write = 0;
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        if (good_reads == 0) {
            return errc::device_failed;
        }
        --good_reads;
        std::uint64_t const length = reached(now(), until) ? 0 : (until - now()).microseconds;
        longest_read = length > longest_read ? length : longest_read;
        clock += length + 10;
        return place.first(0);
    }
};

/// Its program is stopped while it says that it has nothing to ask yet.
struct stopped_read : asker {
    stopping_port& port;
    std::uint64_t stop;
    single_request<read_holding_registers> conversation{unit_id{1}, request};

    stopped_read(stopping_port& its_port, std::uint64_t its_stop) : port{its_port}, stop{its_stop} {}
    std::optional<request_frame> next()
    {
        if (stop != 0) {
            port.clock += stop;
            stop = 0;
            return std::nullopt;
        }
        return conversation.next();
    }
    void accept(result<response> const& outcome) { conversation.accept(outcome); }
    bool settled() const { return conversation.settled(); }
    auto outcome() const& { return conversation.outcome(); }
};

/// The passes of a program of its own over a port, each of which may wait for 20 ms.
template <typename Engine, typename Converse>
void check_passes(Engine& link, stopping_port& port, Converse const& converse)
{
    std::array<std::byte, 256> place{};
    for (int pass = 0; pass < 20; ++pass) {
        instant const now = port.now();
        link.advance(now);
        converse(now);
        REQUIRE(finish_pass(link, port, place, now + milliseconds(20)));
        CHECK(port.longest_read <= 20'000);
    }
}

} // namespace

TEST_CASE("defect: S1 the end of a pass waits no longer than it should, however long its write or a conversation took")
{
    for (std::uint64_t const pause : pauses) {
        INFO(pause / minute << " minutes");
        for (bool const is_in_write : {true, false}) {
            stopping_port port;
            port.stop_in_write = is_in_write ? pause : 0;
            client link{timing};
            stopped_read conversation{port, is_in_write ? 0 : pause};
            check_passes(link, port, [&](instant now) { link.converse(conversation, now); });
            stopping_port other;
            other.stop_in_write = is_in_write ? pause : 0;
            bus<1> shared{timing};
            stopped_read slot{other, is_in_write ? 0 : pause};
            check_passes(shared, other, [&](instant now) { shared.converse(0, slot, now); });
        }
    }
}

TEST_CASE("defect: S1 a waiting client waits no longer than it should, however long its write or a conversation took")
{
    for (std::uint64_t const pause : pauses) {
        INFO(pause / minute << " minutes");
        for (bool const is_in_write : {true, false}) {
            stopping_port port;
            port.stop_in_write = is_in_write ? pause : 0;
            blocking_client line{port, timing, {.response_timeout = milliseconds(300), .retries = 0}};
            stopped_read conversation{port, is_in_write ? 0 : pause};
            std::uint64_t const begin = port.clock;
            CHECK(line.run(conversation) == errc::timed_out);
            CHECK(port.longest_read <= 500'000);
            CHECK(port.clock - begin - pause < 2'000'000);
        }
    }
}

TEST_CASE("defect: S1 behind a request that failed, a waiting client waits no longer than it should, however long it "
          "was unused")
{
    for (std::uint64_t const pause : pauses) {
        for (std::uint64_t const unused : pauses) {
            INFO(pause / minute << " minutes, then " << unused / minute);
            stopping_port port;
            port.stop_in_write = pause;
            port.good_reads = 1;
            blocking_client line{port, timing, {.response_timeout = milliseconds(300), .retries = 0}};
            CHECK(line.ask(unit_id{1}, request).error() == errc::device_failed);
            REQUIRE(port.stop_in_write == 0); // it was sent
            port.clock += unused;
            port.good_reads = 1'000;
            CHECK(line.ask(unit_id{1}, request).error() == errc::timed_out);
            CHECK(port.longest_read <= 2'000'000);
        }
    }
}
