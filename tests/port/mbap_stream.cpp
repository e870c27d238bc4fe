// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Modbus TCP as a port of frames, against a far end that says byte by byte what the test wants. The bytes are those of the
// specification (Messaging on TCP/IP 1.0b, 3.1.3), written down here.
#include <rtuwire/port/mbap_stream.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include "support/catch.hpp"
#include "support/soon.hpp"

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/raw.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using test::soon;

namespace {

using mbap_bytes = std::vector<std::byte>;

template <typename Bytes> mbap_bytes bytes_in(Bytes const& from) { return {from.begin(), from.end()}; }

/// The far end of one connection.
class mbap_far_end {
public:
    mbap_far_end()
    {
        listening_ = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in own{};
        own.sin_family = AF_INET;
        own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof own;
        REQUIRE(::bind(listening_, reinterpret_cast<sockaddr*>(&own), sizeof own) == 0);
        REQUIRE(::listen(listening_, 1) == 0);
        REQUIRE(::getsockname(listening_, reinterpret_cast<sockaddr*>(&own), &size) == 0);
        REQUIRE(port.open("127.0.0.1", ntohs(own.sin_port)));
        far_ = ::accept(listening_, nullptr, nullptr);
        REQUIRE(far_ >= 0);
        timeval const limit{60, 0}; // a test that fails ends
        ::setsockopt(far_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
        int const at_once = 1;
        ::setsockopt(far_, IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
    }
    ~mbap_far_end()
    {
        hang_up();
        ::close(listening_);
    }
    mbap_far_end(mbap_far_end const&) = delete;

    void say(byte_view bytes) const { static_cast<void>(::send(far_, bytes.data(), bytes.size(), MSG_NOSIGNAL)); }
    void hang_up()
    {
        if (far_ >= 0) {
            ::close(std::exchange(far_, -1));
        }
    }

    /// What came, of so many bytes.
    mbap_bytes heard(std::size_t count) const
    {
        mbap_bytes bytes(count);
        bool const is_whole = ::recv(far_, bytes.data(), count, MSG_WAITALL) == static_cast<ssize_t>(count);
        return is_whole ? bytes : mbap_bytes{};
    }

    /// Asks unit 1 for register 100, while the far end does what it does once the request has come.
    result<std::uint16_t> ask(std::function<void()> const& does, duration timeout = test::limit)
    {
        std::thread far{[&] {
            last = heard(12);
            does();
        }};
        blocking_client client{port, {.response_timeout = timeout, .retries = 0}};
        auto const response = client.ask(unit_id{1}, read_holding_registers{100, 1});
        far.join();
        return response ? result<std::uint16_t>{(*response).registers[0]} : response.error();
    }

    mbap_stream port{};
    mbap_bytes last{};

private:
    int listening_{-1};
    int far_{-1};
};

} // namespace

TEST_CASE("a request goes with a header in place of its CRC, and so does its response come")
{
    mbap_far_end line;
    CHECK(line.ask([&] { line.say("00 01 00 00 00 05 01 03 02 12 34"_hex); }) == std::uint16_t{0x1234});
    CHECK(line.last == bytes_in("00 01 00 00 00 06 01 03 00 64 00 01"_hex));
    CHECK(line.ask([&] { line.say("00 02 00 00 00 05 01 03 02 56 78"_hex); }) == std::uint16_t{0x5678});
    CHECK(line.last == bytes_in("00 02 00 00 00 06 01 03 00 64 00 01"_hex));
    CHECK(line.ask([&] { line.say("00 03 00 00 00 03 01 83 0B"_hex); }) == errc::gateway_target_failed_to_respond);
    CHECK(line.port.dropped().late == 0);
    CHECK(line.port.dropped().unknown == 0);
}

TEST_CASE("a response is taken in pieces of any size, and out of a lump")
{
    mbap_far_end line;
    auto const first = "00 01 00 00 00 05 01 03 02 12 34"_hex;
    CHECK(line.ask([&] {
        for (std::byte const each : first) {
            line.say({&each, 1});
            ::usleep(500);
        }
    }) == std::uint16_t{0x1234});
    // Its own, and in the same lump another one with its number: the first counts.
    CHECK(line.ask([&] { line.say("00 02 00 00 00 05 01 03 02 56 78 00 02 00 00 00 05 01 03 02 9A BC"_hex); }) ==
          std::uint16_t{0x5678});
    CHECK(line.ask([&] { line.say("00 03 00 00 00 05 01 03 02 00 01"_hex); }) == std::uint16_t{1});
    CHECK(line.port.dropped().unknown == 1);
}

TEST_CASE("a late response is never taken for another's, and nobody waits for it")
{
    mbap_far_end line;
    for (int i = 0; i < 2; ++i) {
        CHECK(line.ask([] {}, milliseconds(30)) == errc::timed_out);
    }
    CHECK(line.ask([&] {
        line.say(
            "00 01 00 00 00 05 01 03 02 00 01 00 03 00 00 00 05 01 03 02 00 03 00 02 00 00 00 05 01 03 02 00 02"_hex);
    }) == std::uint16_t{3});
    CHECK(line.ask([&] { line.say("00 04 00 00 00 05 01 03 02 00 04"_hex); }) == std::uint16_t{4});
    CHECK(line.port.dropped().late == 2);
    CHECK(line.port.dropped().latest >= milliseconds(30));
    // Twice, and with a number that was never sent.
    CHECK(line.ask([&] {
        line.say(
            "00 04 00 00 00 05 01 03 02 00 09 12 34 00 00 00 05 01 03 02 00 09 00 05 00 00 00 05 01 03 02 00 05"_hex);
    }) == std::uint16_t{5});
    CHECK(line.port.dropped().unknown == 2);
    CHECK(line.port.dropped().late == 2);
}

TEST_CASE("what came before a request was sent is no response to it, though it has the number")
{
    mbap_far_end line;
    line.say("00 01 00 00 00 05 01 03 02 DE AD 00 02 00 00 00 05 01 03 02 DE AD"_hex);
    auto const request = encode(unit_id{1}, read_holding_registers{100, 1});
    REQUIRE(line.port.write(*request, line.port.now() + test::limit));
    CHECK(line.port.dropped().unknown == 2);
    line.say("00 01 00 00 00 05 01 03 02 00 01"_hex);
    std::array<std::byte, max_adu_size> place{};
    auto const bytes = line.port.read(place, line.port.now() + test::limit);
    REQUIRE(bytes);
    REQUIRE(bytes->size() == 7);
    CHECK((*bytes)[4] == std::byte{1});
}

TEST_CASE("messages without end keep nobody from his clock: a read ends behind some of them")
{
    mbap_far_end line;
    auto const request = encode(unit_id{1}, read_holding_registers{100, 1});
    REQUIRE(line.port.write(*request, line.port.now() + test::limit));
    constexpr std::uint32_t strange = 2'000;
    for (std::uint32_t i = 0; i < strange; ++i) {
        line.say("12 34 00 00 00 05 01 03 02 DE AD"_hex);
    }
    line.say("00 01 00 00 00 05 01 03 02 00 01"_hex);
    std::array<std::byte, max_adu_size> place{};
    std::uint32_t most = 0;
    byte_view frame{};
    while (frame.empty() and line.port.dropped().unknown <= strange) {
        std::uint32_t const before = line.port.dropped().unknown;
        auto const bytes = line.port.read(place, line.port.now() + test::limit);
        REQUIRE(bytes);
        frame = *bytes;
        most = std::max(most, line.port.dropped().unknown - before);
    }
    CHECK(frame.size() == 7);
    CHECK(line.port.dropped().unknown == strange);
    CHECK(most < 100);
}

TEST_CASE("a response of another unit is none, though it has the number")
{
    mbap_far_end line;
    CHECK(line.ask([&] { line.say("00 01 00 00 00 05 02 03 02 00 01"_hex); }, milliseconds(50)) == errc::timed_out);
    CHECK(line.port.dropped().other_unit == 1);
    CHECK(line.port.dropped().unit == 2);
    CHECK(line.ask([&] { line.say("00 02 00 00 00 05 FF 03 02 00 01 00 02 00 00 00 05 01 03 02 00 02"_hex); }) ==
          std::uint16_t{2});
    CHECK(line.port.dropped().other_unit == 2);
}

TEST_CASE("what is no Modbus TCP ends the connection's use, with the bytes")
{
    struct wrong_bytes {
        mbap_bytes bytes;
        std::string says;
    };
    for (wrong_bytes const& each : {
             wrong_bytes{bytes_in("01 03 02 12 34 B5 33"_hex), "its protocol is not 0: 01 03 02 12 34 B5 33"},
             wrong_bytes{bytes_in("01 83 02 C0 F1"_hex), "its protocol is not 0: 01 83 02 C0 F1"},
             wrong_bytes{bytes_in("00 01 00 01 00 05 01 03 02 12 34"_hex), "its protocol is not 0: 00 01 00 01"},
             wrong_bytes{bytes_in("00 01 00 00 00 01 01"_hex), "its length is not 2 to 254: 00 01 00 00 00 01 01"},
             wrong_bytes{bytes_in("00 01 00 00 00 00"_hex), "its length is not 2 to 254: 00 01"},
             wrong_bytes{bytes_in("00 01 00 00 00 FF 01 03"_hex), "its length is not 2 to 254: 00 01"},
             wrong_bytes{bytes_in("00 01 00 00 01 05 01 03"_hex), "its length is not 2 to 254: 00 01"},
         }) {
        mbap_far_end line;
        CHECK(line.ask([&] { line.say(each.bytes); }) == errc::device_failed);
        CAPTURE(line.port.failure());
        CHECK(line.port.failure().find(line.port.device() + ": what came is no Modbus TCP: " + each.says) == 0);
        // Nothing behind it is read any more, but a word that stops a motor still leaves.
        line.say("00 02 00 00 00 05 01 03 02 12 34"_hex);
        std::array<std::byte, 256> place{};
        CHECK(line.port.read(place, soon()).error() == errc::device_failed);
        CHECK(line.port.write("01 06 21 35 00 00 93 F8"_hex, soon()));
        CHECK(line.heard(12) == bytes_in("00 02 00 00 00 06 01 06 21 35 00 00"_hex));
    }
}

TEST_CASE("an end of the connection inside a message is told with it")
{
    mbap_far_end line;
    CHECK(line.ask([&] {
        line.say("00 01 00 00 00 05 01"_hex);
        line.hang_up();
    }) == errc::device_vanished);
    CHECK(line.port.failure() == line.port.device() +
                                     ": the connection is gone (closed by the other end), in the middle "
                                     "of a message of which 7 bytes had come");
    mbap_far_end other;
    CHECK(other.ask([&] { other.hang_up(); }) == errc::device_vanished);
    CHECK(other.port.failure() == other.port.device() + ": the connection is gone (closed by the other end)");
}

TEST_CASE("what is no frame is not sent")
{
    mbap_far_end line;
    CHECK(line.port.write("01 03 00 64 00 01 C5 D6"_hex, soon()) == errc::crc_mismatch);
    CHECK(line.port.write("01 03 00"_hex, soon()) == errc::frame_too_short);
    CHECK(line.port.write(mbap_bytes(257), soon()) == errc::frame_too_long);
    CHECK(line.ask([&] { line.say("00 01 00 00 00 05 01 03 02 12 34"_hex); }) == std::uint16_t{0x1234});
    CHECK(line.last == bytes_in("00 01 00 00 00 06 01 03 00 64 00 01"_hex)); // the first
    line.port.close();
    CHECK(line.port.write("01 03 00 64 00 01 C5 D5"_hex, soon()) == errc::device_not_open);
}

TEST_CASE("a response that is shorter or longer than it says is told as that")
{
    mbap_far_end line;
    for (auto const& [message, size] : {std::pair{bytes_in("00 01 00 00 00 04 01 03 02 12"_hex), 6U},
                                        std::pair{bytes_in("00 02 00 00 00 06 01 03 02 12 34 56"_hex), 8U}}) {
        std::thread far{[&line, &said = message] {
            line.heard(12);
            line.say(said);
        }};
        blocking_client client{line.port, {.response_timeout = milliseconds(300), .retries = 0}};
        auto const response = client.ask(unit_id{1}, read_holding_registers{100, 1});
        far.join();
        CHECK(response.error() == errc::wrong_length);
        REQUIRE(client.refused());
        CHECK(client.refused()->bytes.size() == size);
        CHECK(client.refused()->due == 7);
    }
}

TEST_CASE("the longest response comes whole, and in parts where there is little room, through a move as well")
{
    mbap_far_end line;
    mbap_bytes message = bytes_in("00 01 00 00 00 FD 01 03 FA"_hex);
    for (unsigned i = 0; i < 250; ++i) {
        message.push_back(static_cast<std::byte>(i));
    }
    std::thread far{[&] {
        line.last = line.heard(12);
        line.say(message);
    }};
    REQUIRE(line.port.write("01 03 00 00 00 7D 85 EB"_hex, soon()));
    std::array<std::byte, 7> place{};
    auto part = line.port.read(place, soon());
    mbap_stream port{std::move(line.port)};
    mbap_bytes frame;
    while (part and not part->empty() and frame.size() + part->size() < 255) {
        frame.insert(frame.end(), part->begin(), part->end());
        part = port.read(place, soon());
    }
    far.join();
    REQUIRE(part);
    frame.insert(frame.end(), part->begin(), part->end());
    REQUIRE(frame.size() == 255);
    CHECK(std::equal(message.begin() + 6, message.end(), frame.begin()));
    CHECK(check_frame(frame) == errc::none);
    instant const until = steady_now() + milliseconds(10);
    auto const nothing = port.read(place, until);
    REQUIRE(nothing);
    CHECK(nothing->empty());
    CHECK(reached(steady_now(), until));
}

TEST_CASE("bytes of a connection are the same messages however they are cut")
{
    auto const stream = "00 01 00 00 00 05 01 03 02 12 34 FF FF 00 00 00 02 07 80 00 00 00 00 00 03 09 83 02"_hex;
    for (std::size_t size = 1; size <= stream.size(); ++size) {
        mbap_cutter cutter;
        std::vector<std::pair<unsigned, mbap_bytes>> found;
        for (std::size_t at = 0; at < stream.size(); at += size) {
            byte_view const part = byte_view{stream}.subspan(at, std::min(size, stream.size() - at));
            REQUIRE(cutter.room().size() >= part.size());
            std::copy(part.begin(), part.end(), cutter.room().begin());
            cutter.add(part.size());
            for (; auto const message = cutter.first(); cutter.drop_first()) {
                found.emplace_back(message->number, bytes_in(message->body));
            }
        }
        CHECK(found == std::vector<std::pair<unsigned, mbap_bytes>>{{1, bytes_in("01 03 02 12 34"_hex)},
                                                                    {0xFFFF, bytes_in("07 80"_hex)},
                                                                    {0, bytes_in("09 83 02"_hex)}});
        CHECK(cutter.bytes().empty());
        CHECK(cutter.fault() == mbap_fault::none);
    }
}

TEST_CASE("a message has a body of 2 to 254 bytes, and the room that it needs")
{
    std::array<std::byte, max_mbap_size> place{};
    CHECK(write_mbap(place, {1, mbap_bytes(1)}).error() == errc::frame_too_short);
    CHECK(write_mbap(place, {1, mbap_bytes(255)}).error() == errc::frame_too_long);
    CHECK(write_mbap(byte_span{place}.first(11), {1, mbap_bytes(6)}).error() == errc::buffer_too_small);
    auto const longest = write_mbap(place, {0x1234, mbap_bytes(254)});
    REQUIRE(longest);
    CHECK(longest->size() == 260);
    CHECK(bytes_in(longest->first(6)) == bytes_in("12 34 00 00 00 FE"_hex));
}

TEST_CASE("a client keeps no unit from being asked where responses have numbers, but for a pause")
{
    for (bool const has_numbers : {true, false}) {
        host_client client{has_numbers ? line_timing::numbered() : line_timing::without_wire(),
                           {.response_timeout = milliseconds(100), .late_response = milliseconds(500), .retries = 0}};
        single_request first{unit_id{1}, read_holding_registers{100, 1}};
        single_request second{unit_id{1}, read_holding_registers{200, 1}};
        instant now{0};
        auto const pass = [&](auto& conversation) {
            client.advance(now);
            client.converse(conversation, now);
            if (not client.poll_transmit().empty()) {
                client.sent(now);
                return true;
            }
            return false;
        };
        for (; not pass(first) and now.microseconds < 1'000'000; now = now + milliseconds(1)) {
        }
        for (; not first.settled() and now.microseconds < 1'000'000; now = now + milliseconds(1)) {
            static_cast<void>(pass(first));
        }
        CHECK(first.outcome().error() == errc::timed_out);
        instant const ended = now;
        for (; not pass(second) and now.microseconds < 2'000'000; now = now + milliseconds(1)) {
        }
        CHECK((now - ended < milliseconds(5)) == has_numbers);
    }
}
