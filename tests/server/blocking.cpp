// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One pass of a server over a port that is played by hand.
#include <rtuwire/server/blocking.hpp>

#include <algorithm>
#include <vector>

#include "support/catch.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/banks.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr auto request = "07 03 00 64 00 01 C5 B3"_hex;
constexpr auto the_response = "07 03 02 12 34 3D 33"_hex;

/// Has a request ready, or nothing, and a clock that jumps to what is waited for.
struct played_port {
    std::vector<std::byte> input{};
    std::vector<std::byte> sent{};
    duration for_writing{};
    instant clock{0xFFFF'FF00U};
    errc read_error{errc::none};
    errc write_error{errc::none};

    [[nodiscard]] instant now() const { return clock; }
    result<void> write(byte_view bytes, instant until)
    {
        for_writing = until - clock;
        sent.assign(bytes.begin(), bytes.end());
        return write_error == errc::none ? result<void>{} : result<void>{write_error};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        if (read_error != errc::none) {
            return read_error;
        }
        if (input.empty()) {
            clock = until;
            return place.first(0);
        }
        std::size_t const count = input.size();
        std::copy(input.begin(), input.end(), place.begin());
        input.clear();
        return place.first(count);
    }
};

struct station_of_one {
    played_port port{};
    server node{unit_id{7}, timing};
    word_bank<1> bank{100};

    station_of_one() { static_cast<void>(bank.set(100, 0x1234)); }

    /// Until the line was silent for long enough: a server that starts listens first.
    void settle() { static_cast<void>(pass(milliseconds(50))); }
    result<void> pass(duration time_limit) { return serve_once(node, port, bank, time_limit); }
    /// One pass takes the request in, the next one answers when the line has been silent behind it.
    result<void> is_asked()
    {
        port.input.assign(request.begin(), request.end());
        static_cast<void>(pass(milliseconds(50)));
        return pass(milliseconds(50));
    }
};

} // namespace

TEST_CASE(
    "a request that lies in the port is answered behind a silence, and may take a second more to send than it has to")
{
    station_of_one it;
    it.settle();
    instant const before = it.port.clock;
    CHECK(it.is_asked());
    CHECK(it.port.clock - before == timing.t3_5());
    CHECK(it.port.sent == std::vector<std::byte>(the_response.begin(), the_response.end()));
    CHECK(it.port.for_writing == milliseconds(1'200) + timing.characters(the_response.size()));
}

TEST_CASE("a port that sends at the speed of a slow line has the time that the longest response takes")
{
    for (std::uint32_t const rate : {300U, 1'200U, 2'400U}) {
        INFO(rate << " bit/s");
        played_port port;
        server node{unit_id{7}, line_timing{rate, character_format::even_8_1}};
        word_bank<125> bank;
        auto const asked = encode(unit_id{7}, read_holding_registers{.start = 0, .count = 125});
        REQUIRE(asked);
        static_cast<void>(serve_once(node, port, bank, milliseconds(500)));
        byte_view const bytes = *asked;
        port.input.assign(bytes.begin(), bytes.end());
        for (int passes = 0; passes < 3; ++passes) {
            REQUIRE(serve_once(node, port, bank, milliseconds(1'000)));
        }
        REQUIRE(port.sent.size() == 255);
        std::uint64_t const bits = 255U * 11U;
        CHECK(port.for_writing.microseconds > bits * 1'000'000U / rate);
    }
}

namespace {

/// Takes its time to give its registers.
struct slow_bank : word_bank<1> {
    played_port* port;
    duration time;

    slow_bank(played_port& of, duration takes) : word_bank<1>{100}, port{&of}, time{takes} {}
    errc read(std::uint16_t start, std::size_t count, byte_writer& out)
    {
        port->clock = port->clock + time;
        return word_bank<1>::read(start, count, out);
    }
};

} // namespace

TEST_CASE("a bank that takes longer than the silence before a response is answered for at once")
{
    for (duration const takes : {milliseconds(1), milliseconds(15), milliseconds(90)}) {
        INFO("takes " << takes.microseconds << " us");
        station_of_one it;
        it.settle();
        slow_bank slow{it.port, takes};
        it.port.input.assign(request.begin(), request.end());
        instant const before = it.port.clock;
        for (int passes = 0; passes < 3 and it.port.sent.empty(); ++passes) {
            REQUIRE(serve_once(it.node, it.port, slow, milliseconds(1'000)));
        }
        CHECK(it.port.sent.size() == 7);
        CHECK(it.port.clock - before == (takes < timing.t3_5() ? timing.t3_5() : takes));
    }
}

TEST_CASE("a program that is slow between passes has its response sent before it waits")
{
    station_of_one it;
    it.settle();
    it.port.input.assign(request.begin(), request.end());
    REQUIRE(it.pass(milliseconds(1'000)));
    it.port.clock = it.port.clock + milliseconds(20);
    it.port.read_error = errc::device_failed; // nothing is read before
    CHECK(it.pass(milliseconds(1'000)) == errc::device_failed);
    CHECK(it.port.sent == std::vector<std::byte>(the_response.begin(), the_response.end()));
}

TEST_CASE("a pass in which nobody asks ends with its patience, and sends nothing")
{
    station_of_one it;
    it.settle();
    instant const before = it.port.clock;
    CHECK(it.pass(milliseconds(80)));
    CHECK(it.port.clock - before == milliseconds(80));
    CHECK(it.port.sent.empty());
}

TEST_CASE("what the port says of its failure is what the pass returns")
{
    station_of_one deaf;
    deaf.port.read_error = errc::device_vanished;
    CHECK(deaf.pass(milliseconds(50)) == errc::device_vanished);
    station_of_one mute;
    mute.settle();
    mute.port.write_error = errc::device_failed;
    CHECK(mute.is_asked() == errc::device_failed);
}

TEST_CASE("a server of several units knows its banks, and answers from the one that is asked")
{
    played_port port;
    word_bank<1> other{100}, asked{100};
    static_cast<void>(asked.set(100, 0x1234));
    auto node = server::for_units(timing, bank_at{unit_id{6}, other}, bank_at{unit_id{7}, asked});
    static_cast<void>(serve_once(node, port, milliseconds(50)));
    port.input.assign(request.begin(), request.end());
    for (int pass = 0; pass < 2; ++pass) {
        CHECK(serve_once(node, port, milliseconds(50)));
    }
    CHECK(port.sent == std::vector<std::byte>(the_response.begin(), the_response.end()));
    port.read_error = errc::device_vanished;
    CHECK(serve_once(node, port, milliseconds(50)) == errc::device_vanished);
}
