// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What clients send, in pieces of any size: requests, or what is none. Frames, messages and CRCs are made here, by hand.
#include "serve/client_requests.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "serve/client_range.hpp"
#include "serve/metrics_page.hpp"
#include "serve/serve_counts.hpp"
#include "support/catch.hpp"

using namespace std::chrono_literals;
using tool::client_protocol;
using tool::client_requests;
using tool::serve_time;
using tool::served_request;

namespace {

using numbers = std::vector<std::uint8_t>; // bytes

serve_time const begin{std::chrono::hours{1}};

/// Bit by bit, as the specification draws it.
std::uint16_t crc_of(numbers const& bytes)
{
    unsigned crc = 0xFFFF;
    for (std::uint8_t const each : bytes) {
        crc ^= each;
        for (unsigned bit = 0; bit < 8; ++bit) {
            crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xA001U : crc >> 1U;
        }
    }
    return static_cast<std::uint16_t>(crc);
}

numbers frame(numbers bytes)
{
    std::uint16_t const crc = crc_of(bytes);
    bytes.push_back(static_cast<std::uint8_t>(crc & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>(crc >> 8U));
    return bytes;
}

numbers message(std::uint16_t number, numbers const& body)
{
    numbers bytes{static_cast<std::uint8_t>(number >> 8U), static_cast<std::uint8_t>(number & 0xFFU), 0, 0, 0,
                  static_cast<std::uint8_t>(body.size())};
    bytes.insert(bytes.end(), body.begin(), body.end());
    return bytes;
}

/// Puts bytes in; false where there was no room for all.
bool put(client_requests& into, numbers const& bytes, std::size_t first, std::size_t count, serve_time now)
{
    auto const room = into.room();
    if (room.size() < count) {
        return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
        room[i] = std::byte{bytes[first + i]};
    }
    into.add(count, now);
    return true;
}

bool put(client_requests& into, numbers const& bytes, serve_time now) { return put(into, bytes, 0, bytes.size(), now); }

numbers body_of(served_request const& request)
{
    numbers bytes{request.unit};
    for (std::byte const each : request.pdu) {
        bytes.push_back(std::to_integer<std::uint8_t>(each));
    }
    return bytes;
}

numbers drawn_body(std::mt19937& random)
{
    auto const any = [&random] { return static_cast<std::uint8_t>(random()); };
    auto const unit = static_cast<std::uint8_t>(1 + random() % 247);
    if (random() % 2 == 0) {
        return {unit, 3, any(), any(), 0, static_cast<std::uint8_t>(1 + random() % 125)};
    }
    auto const count = static_cast<std::uint8_t>(1 + random() % 100);
    numbers body{unit, 16, any(), any(), 0, count, static_cast<std::uint8_t>(2 * count)};
    for (unsigned i = 0; i < 2U * count; ++i) {
        body.push_back(any());
    }
    return body;
}

} // namespace

TEST_CASE("serve: requests are found whatever the pieces in which they come")
{
    auto const which = GENERATE(client_protocol::mbap, client_protocol::rtu);
    std::mt19937 random{7};
    client_requests from{which};
    std::vector<numbers> sent;
    numbers stream;
    for (std::uint16_t i = 0; i < 2'000; ++i) {
        sent.push_back(drawn_body(random));
        numbers const bytes = which == client_protocol::mbap ? message(i, sent.back()) : frame(sent.back());
        stream.insert(stream.end(), bytes.begin(), bytes.end());
    }
    std::size_t taken = 0;
    serve_time now = begin;
    for (std::size_t at = 0; at < stream.size();) {
        std::size_t const size = std::min({std::size_t{1} + random() % 300, stream.size() - at, from.room().size()});
        REQUIRE(size > 0);
        REQUIRE(put(from, stream, at, size, now));
        at += size;
        now += 3ms;
        while (auto const request = from.take(now)) {
            REQUIRE(taken < sent.size());
            REQUIRE(body_of(*request) == sent[taken]);
            REQUIRE((which == client_protocol::rtu or request->number == taken));
            ++taken;
        }
        REQUIRE_FALSE(from.is_broken());
    }
    CHECK(taken == sent.size());
    CHECK(from.take_dropped() == 0);
    CHECK_FALSE(from.part_ends());
}

TEST_CASE("serve: a request that is not whole has 10 s, in whatever pieces it comes")
{
    auto const which = GENERATE(client_protocol::mbap, client_protocol::rtu);
    client_requests from{which};
    numbers const whole = which == client_protocol::mbap ? message(5, {7, 3, 0, 1, 0, 1}) : frame({7, 3, 0, 1, 0, 1});
    REQUIRE(put(from, whole, 0, 3, begin));
    CHECK_FALSE(from.take(begin));
    CHECK(from.part_ends() == begin + 10s);
    REQUIRE(put(from, whole, 3, 1, begin + 400ms)); // one byte more does not prolong it
    CHECK_FALSE(from.take(begin + 400ms));
    CHECK(from.part_ends() == begin + 10s);
    REQUIRE(put(from, whole, 4, whole.size() - 4, begin + 800ms));
    REQUIRE(from.take(begin + 800ms));
    CHECK_FALSE(from.part_ends());
}

TEST_CASE("serve: half a frame waits for the other, as half a message does, and no silence ends it")
{
    numbers const whole = frame({7, 16, 0, 1, 0, 2, 4, 0, 1, 0, 2});
    for (std::size_t half = 1; half < whole.size(); ++half) {
        CAPTURE(half);
        client_requests from{client_protocol::rtu};
        REQUIRE(put(from, whole, 0, half, begin));
        CHECK_FALSE(from.take(begin + client_requests::silence));
        CHECK_FALSE(from.silence_ends()); // it is looked at once
        CHECK_FALSE(from.take(begin + 9s));
        REQUIRE(put(from, whole, half, whole.size() - half, begin + 9s));
        auto const request = from.take(begin + 9s);
        REQUIRE(request);
        CHECK(body_of(*request) == numbers{7, 16, 0, 1, 0, 2, 4, 0, 1, 0, 2});
        CHECK(from.take_dropped() == 0);
        CHECK_FALSE(from.part_ends());
    }
}

TEST_CASE("serve: who begins anew behind half a frame is heard, in whatever pieces")
{
    numbers const left = frame({7, 16, 0, 1, 0, 2, 4, 0, 1, 0, 2});
    numbers const next = frame({7, 3, 0, 1, 0, 1});
    for (std::size_t half = 1; half < left.size(); ++half) {
        for (std::size_t const piece : {std::size_t{3}, next.size()}) {
            CAPTURE(half, piece);
            client_requests from{client_protocol::rtu};
            REQUIRE(put(from, left, 0, half, begin));
            CHECK_FALSE(from.take(begin + 1s));
            REQUIRE(put(from, next, 0, piece, begin + 2s));
            auto request = from.take(begin + 2s);
            if (piece < next.size()) {
                REQUIRE(put(from, next, piece, next.size() - piece, begin + 2s + 10ms));
                request = from.take(begin + 2s + 10ms);
            }
            REQUIRE(request);
            CHECK(body_of(*request) == numbers{7, 3, 0, 1, 0, 1});
            CHECK(from.take_dropped() == half);
            CHECK_FALSE(from.part_ends());
        }
    }
}

TEST_CASE("serve: what is no Modbus TCP breaks the connection, behind what was")
{
    client_requests from{client_protocol::mbap};
    numbers bytes = message(1, {7, 3, 0, 1, 0, 1});
    numbers const http{'G', 'E', 'T', ' ', '/', ' ', 'H'};
    bytes.insert(bytes.end(), http.begin(), http.end());
    REQUIRE(put(from, bytes, begin));
    CHECK(from.take(begin));
    CHECK_FALSE(from.take(begin));
    CHECK(from.is_broken());
}

TEST_CASE("serve: bytes that are no frame are dropped with silence, and the frame behind it is whole")
{
    client_requests from{client_protocol::rtu};
    numbers damaged = frame({7, 3, 0, 1, 0, 1});
    damaged[2] ^= 1U;
    REQUIRE(put(from, damaged, begin));
    CHECK_FALSE(from.take(begin));
    REQUIRE(from.silence_ends());
    CHECK_FALSE(from.take(*from.silence_ends()));
    CHECK(from.take_dropped() == damaged.size());
    CHECK(from.part_ends() == begin + 10s); // nothing of what it sent was a request yet
    REQUIRE(put(from, frame({7, 3, 0, 1, 0, 1}), begin + 2s));
    CHECK(from.take(begin + 2s));
    CHECK_FALSE(from.part_ends());
    // Who never stops sending what is none fills nothing.
    numbers const noise(100, 0x55);
    for (unsigned i = 0; i < 100; ++i) {
        REQUIRE(put(from, noise, begin + 3s));
        CHECK_FALSE(from.take(begin + 3s));
    }
    CHECK(from.take_dropped() > 9'000);
}

TEST_CASE("serve: a function that is not public ends with silence")
{
    client_requests from{client_protocol::rtu};
    numbers const own = frame({7, 0x41, 1, 2, 3});
    REQUIRE(put(from, own, begin));
    CHECK_FALSE(from.take(begin + 100ms));
    auto const request = from.take(begin + client_requests::silence);
    REQUIRE(request);
    CHECK(body_of(*request) == numbers{7, 0x41, 1, 2, 3});
}

TEST_CASE("serve: an answer has the number of its request, or a CRC")
{
    std::byte const pdu[]{std::byte{0x83}, std::byte{2}};
    auto const bytes_to = [&pdu](client_protocol which) {
        numbers bytes;
        served_request const to{.client = 1, .number = 0xABCD, .unit = 7, .pdu = {std::byte{3}}, .came = begin};
        for (std::byte const each : client_requests{which}.answer(to, pdu)) {
            bytes.push_back(std::to_integer<std::uint8_t>(each));
        }
        return bytes;
    };
    CHECK(bytes_to(client_protocol::mbap) == message(0xABCD, {7, 0x83, 2}));
    CHECK(bytes_to(client_protocol::rtu) == frame({7, 0x83, 2}));
}

TEST_CASE("serve: clients are known by their address")
{
    auto const has = [](std::string const& range, std::string const& host) {
        auto const found = tool::client_range::of(range);
        REQUIRE(found);
        return found->has(host);
    };
    CHECK(has("192.168.1.0/24", "192.168.1.255"));
    CHECK_FALSE(has("192.168.1.0/24", "192.168.2.0"));
    CHECK(has("192.168.1.0/24", "::ffff:192.168.1.7"));
    CHECK(has("10.0.0.7", "10.0.0.7"));
    CHECK_FALSE(has("10.0.0.7", "10.0.0.6"));
    CHECK(has("0.0.0.0/0", "8.8.8.8"));
    CHECK_FALSE(has("0.0.0.0/0", "fd00::1"));
    CHECK(has("fd00::/8", "fdff::1"));
    CHECK_FALSE(has("fd00::/8", "fe00::1"));
    CHECK_FALSE(has("fd00::/8", "253.0.0.1"));
    CHECK(has("10.0.0.4/31", "10.0.0.5"));
    CHECK_FALSE(has("10.0.0.4/31", "10.0.0.6"));
    for (std::string const wrong :
         {"", "192.168.1.7/24", "192.168.1.0/33", "192.168.1/24", "host", "fd00::/129", "10.0.0.0/", "10.0.0.0/-1",
          "10.0.0.0/8 ", "10.0.0.0/8/8", "/24", "/024", "10.0.0.0/024", "10.0.0.0/08", "10.0.0.0/+8", "10.0.0.0/0x8",
          "0.0.0.0/00", "fd00::/008"}) {
        INFO(wrong);
        CHECK_FALSE(tool::client_range::of(wrong));
    }
    auto const reaches = [](std::string const& range, std::string const& host) {
        return tool::client_range::of(range)->can_reach(host);
    };
    for (std::string const four :
         {"10.0.0.0/8", "0.0.0.0/0", "::ffff:10.0.0.0/104", "::ffff:0:0/96", "::/0", "::/64"}) {
        CAPTURE(four);
        CHECK(reaches(four, "0.0.0.0"));
        CHECK(reaches(four, "::ffff:10.0.0.1"));
        CHECK(reaches(four, "::"));
        CHECK(reaches(four, "::1") == (four.ends_with("::/0") or four.ends_with("/64")));
    }
    for (std::string const six : {"fd00::/8", "::1", "fe80::/10", "::/1"}) {
        CAPTURE(six);
        CHECK(reaches(six, "0.0.0.0") == (six == "::/1"));
        CHECK(reaches(six, "192.168.1.7") == (six == "::/1"));
        CHECK(reaches(six, "fe80::1%eth0"));
        CHECK(reaches(six, "0:0::0"));
    }
    for (std::string const here : {"127.0.0.1", "127.0.0.0/8", "127.0.0.0/30", "0.0.0.0/0", "0.0.0.0/1", "::/0"}) {
        CAPTURE(here);
        CHECK(reaches(here, "127.0.0.1"));
        CHECK(reaches(here, "::ffff:127.0.0.1"));
        CHECK(reaches(here, "::1") == (here == "::/0"));
    }
    for (std::string const beyond : {"10.0.0.0/8", "128.0.0.0/1", "192.168.1.7", "fd00::/8", "::2"}) {
        CAPTURE(beyond);
        CHECK_FALSE(reaches(beyond, "127.0.0.1"));
        CHECK_FALSE(reaches(beyond, "127.0.0.2"));
        CHECK_FALSE(reaches(beyond, "::1"));
    }
    CHECK(reaches("::1", "::1"));
    CHECK(tool::is_loopback("127.3.2.1"));
    CHECK(tool::is_loopback("::1"));
    CHECK_FALSE(tool::is_loopback("0.0.0.0"));
    CHECK_FALSE(tool::is_loopback("::"));
    CHECK_FALSE(tool::is_loopback("192.168.1.7"));
    CHECK_FALSE(tool::is_loopback("what is none"));
    CHECK(tool::host_of("192.168.1.7:50123") == "192.168.1.7");
    CHECK(tool::host_of("[fd00::1]:502") == "fd00::1");
    CHECK(tool::host_of("[fe80::1%eth0]:502") == "fe80::1");
}

TEST_CASE("serve: there is one page, and a request for it is short")
{
    unsigned made = 0;
    auto const answer = [&made](std::string const& came) {
        return tool::http_response(came, [&made] {
            ++made;
            return std::string{"x 1\n"};
        });
    };
    CHECK_FALSE(answer("GET /metrics HTTP/1.1\r\nHost: x\r\n"));
    CHECK_FALSE(answer(std::string(4'095, 'a')));
    auto const page = answer("GET /metrics HTTP/1.1\r\nHost: x\r\n\r\n");
    REQUIRE(page);
    CHECK(page->starts_with("HTTP/1.1 200 "));
    CHECK(page->find("\r\nContent-Length: 4\r\n") != std::string::npos);
    CHECK(page->find("Content-Type: text/plain; version=0.0.4") != std::string::npos);
    CHECK(page->ends_with("\r\n\r\nx 1\n"));
    CHECK(made == 1);
    CHECK(answer("GET / HTTP/1.1\r\n\r\n")->starts_with("HTTP/1.1 404 "));
    CHECK(answer("GET /metricsx HTTP/1.1\r\n\r\n")->starts_with("HTTP/1.1 404 "));
    CHECK(answer("POST /metrics HTTP/1.1\r\n\r\n")->starts_with("HTTP/1.1 405 "));
    CHECK(answer("get /metrics HTTP/1.1\r\n\r\n")->starts_with("HTTP/1.1 405 "));
    CHECK(answer("GET /metrics\r\n\r\n")->starts_with("HTTP/1.1 400 "));
    CHECK(answer("\r\n\r\n")->starts_with("HTTP/1.1 400 "));
    CHECK(answer(std::string(4'096, 'a'))->starts_with("HTTP/1.1 431 "));
    CHECK(made == 1);
}

TEST_CASE("serve: figures are text as Prometheus reads it")
{
    tool::serve_counts counts;
    counts.clients = 2;
    counts.is_port_up = true;
    counts.note_request(7, 3);
    counts.note_request(7, 3);
    counts.note_exception(7, 11);
    counts.note_refused("write");
    counts.note_silence(9);
    counts.note_round_trip(7, 250ms);
    counts.note_round_trip(7, 1'500ms);
    std::string const text = counts.text();
    INFO(text);
    for (std::string const line :
         {"rtuwire_serve_clients 2", "rtuwire_serve_port_up 1",
          "rtuwire_serve_requests_total{unit=\"7\",function=\"3\"} 2",
          "rtuwire_serve_exceptions_total{unit=\"7\",code=\"11\"} 1", "rtuwire_serve_refused_total{why=\"write\"} 1",
          "rtuwire_serve_silences_total{unit=\"9\"} 1", "rtuwire_serve_round_trip_seconds_sum{unit=\"7\"} 1.750000",
          "rtuwire_serve_round_trip_seconds_count{unit=\"7\"} 2", "# TYPE rtuwire_serve_requests_total counter"}) {
        INFO(line);
        CHECK(("\n" + text).find("\n" + line + "\n") != std::string::npos);
    }
}

TEST_CASE(
    "serve: a client of the other protocol is known by its bytes, in pieces of any size, and no client of this one is")
{
    struct speech {
        client_protocol port;
        numbers bytes;
        bool is_other;
    };
    numbers const read{1, 3, 3, 0xE8, 0, 10};
    numbers const read_at_0{1, 3, 0, 0, 0, 10}; // protocol 0, and a length: a part of a message
    numbers const two_at_0{1, 3, 0, 0, 0, 2};   // as long as a message of two bytes
    numbers const write{1, 16, 3, 0xE8, 0, 2, 4, 0, 1, 0, 2};
    auto const twice = [](numbers bytes) {
        numbers const once = bytes;
        bytes.insert(bytes.end(), once.begin(), once.end());
        return bytes;
    };
    std::vector<speech> const all{
        {client_protocol::mbap, frame(read), true},
        {client_protocol::mbap, twice(frame(read)), true},
        {client_protocol::mbap, frame(read_at_0), true},
        {client_protocol::mbap, twice(frame(read_at_0)), true},
        {client_protocol::mbap, frame(two_at_0), true},
        {client_protocol::mbap, frame(write), true},
        {client_protocol::mbap, message(0x0103, read), false},
        {client_protocol::mbap, twice(message(0x0103, read_at_0)), false},
        {client_protocol::mbap, {'G', 'E', 'T', ' ', '/', ' ', 'H', 'T', 'T', 'P'}, false},
        {client_protocol::rtu, message(1, read), true},
        {client_protocol::rtu, message(0x0103, read_at_0), true},
        {client_protocol::rtu, twice(message(1, write)), true},
        {client_protocol::rtu, frame(read), false},
        {client_protocol::rtu, twice(frame(read_at_0)), false},
        {client_protocol::rtu, {'G', 'E', 'T', ' ', '/', ' ', 'H', 'T', 'T', 'P'}, false},
        {client_protocol::rtu, {1, 3, 3, 0xE8, 0, 10, 0, 0}, false},
    };
    for (speech const& each : all) {
        for (std::size_t const piece : {std::size_t{1}, std::size_t{7}, std::size_t{512}}) {
            CAPTURE(static_cast<int>(each.port), each.bytes, piece);
            client_requests from{each.port};
            serve_time now = begin;
            for (std::size_t at = 0; at < each.bytes.size(); at += piece) {
                std::size_t const count = std::min(piece, each.bytes.size() - at);
                REQUIRE(put(from, each.bytes, at, count, now));
                while (from.take(now)) {
                }
                now += 1ms;
            }
            now += client_requests::silence;
            while (from.take(now)) {
            }
            CHECK(from.is_other_protocol() == each.is_other);
        }
    }
}
