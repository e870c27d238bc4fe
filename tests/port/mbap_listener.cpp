// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The server's end of Modbus TCP, against plain sockets that say and hear bytes. What a test waits for has been said before.
#include <rtuwire/port/mbap_listener.hpp>

#include <array>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include "support/catch.hpp"
#include "support/soon.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using test::soon;

namespace {

using spoken_bytes = std::vector<std::byte>;

template <typename Bytes> spoken_bytes spoken(Bytes const& from) { return {from.begin(), from.end()}; }

/// A port of this machine that was free a moment ago.
std::uint16_t unused_port()
{
    int const socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof own;
    REQUIRE(::bind(socket, reinterpret_cast<sockaddr*>(&own), sizeof own) == 0);
    REQUIRE(::getsockname(socket, reinterpret_cast<sockaddr*>(&own), &size) == 0);
    ::close(socket);
    return ntohs(own.sin_port);
}

class plain_client {
public:
    explicit plain_client(std::uint16_t port) : socket_{::socket(AF_INET, SOCK_STREAM, 0)}
    {
        sockaddr_in far{};
        far.sin_family = AF_INET;
        far.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        far.sin_port = htons(port);
        timeval const limit{60, 0};
        ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
        REQUIRE(::connect(socket_, reinterpret_cast<sockaddr*>(&far), sizeof far) == 0);
    }
    ~plain_client() { ::close(socket_); }
    plain_client(plain_client const&) = delete;

    void say(byte_view bytes) const { static_cast<void>(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL)); }
    spoken_bytes heard(std::size_t count) const
    {
        spoken_bytes bytes(count);
        return ::recv(socket_, bytes.data(), count, MSG_WAITALL) == static_cast<ssize_t>(count) ? bytes
                                                                                                : spoken_bytes{};
    }
    /// Whether the server has ended the connection, and says nothing before.
    bool is_hung_up_on() const
    {
        std::byte place{};
        ssize_t const count = ::recv(socket_, &place, 1, MSG_DONTWAIT);
        return count == 0 or (count < 0 and errno == ECONNRESET);
    }

private:
    int socket_;
};

struct served {
    std::uint16_t number{unused_port()};
    mbap_listener port{};
    std::array<std::byte, 256> place{};

    explicit served(duration idle = milliseconds(60'000)) { REQUIRE(port.open("127.0.0.1", number, {1, 2}, idle)); }

    spoken_bytes read(instant until = soon())
    {
        auto const bytes = port.read(place, until);
        REQUIRE(bytes);
        return spoken(*bytes);
    }
    bool hangs_up_on(plain_client const& client)
    {
        instant const limit = soon();
        while (not client.is_hung_up_on() and not reached(steady_now(), limit)) {
            CHECK(read_nothing().empty());
        }
        return client.is_hung_up_on();
    }
    spoken_bytes read_nothing() { return read(steady_now() + milliseconds(20)); }
};

} // namespace

TEST_CASE("a message is read as a frame, and the response goes to its asker with its number")
{
    served line;
    CHECK(line.port.device() == "mbap://127.0.0.1:" + std::to_string(line.number));
    plain_client const one{line.number};
    plain_client const other{line.number};
    one.say("12 34 00 00 00 06 01 03 00 64 00 01"_hex);
    CHECK(line.read() == spoken("01 03 00 64 00 01 C5 D5"_hex));
    other.say("00 07 00 00 00 06 01 03 00 64 00 01"_hex);
    CHECK(line.read_nothing().empty());                         // one at a time
    CHECK(line.port.write("02 03 02 00 05 3C 47"_hex, soon())); // of a unit that was not asked
    CHECK(line.port.write("01 04 02 00 05 79 33"_hex, soon())); // of another function
    CHECK(line.port.write("01 03 02 00 05 78 47"_hex, soon()));
    CHECK(one.heard(11) == spoken("12 34 00 00 00 05 01 03 02 00 05"_hex));
    CHECK(line.read() == spoken("01 03 00 64 00 01 C5 D5"_hex));
    CHECK(line.port.write("01 83 02 C0 F1"_hex, soon()));
    CHECK(other.heard(9) == spoken("00 07 00 00 00 03 01 83 02"_hex));
}

TEST_CASE("a unit that is not there, or says nothing, is told of by exception 0B, and the next request goes on")
{
    served line;
    plain_client const client{line.number};
    client.say("00 01 00 00 00 06 09 03 00 64 00 01 00 02 00 00 00 06 02 06 00 64 00 01"_hex);
    CHECK_FALSE(line.read().empty()); // that to unit 2; nobody reads the one to unit 9
    CHECK(client.heard(9) == spoken("00 01 00 00 00 03 09 83 0B"_hex));
    client.say("00 03 00 00 00 06 01 03 00 64 00 01"_hex);
    CHECK(line.read() == spoken("01 03 00 64 00 01 C5 D5"_hex));
    CHECK(client.heard(9) == spoken("00 02 00 00 00 03 02 86 0B"_hex));
    CHECK(line.port.write("02 06 00 64 00 01 09 E6"_hex, soon())); // too late
    CHECK(line.port.write("01 03 02 00 05 78 47"_hex, soon()));
    CHECK(client.heard(11) == spoken("00 03 00 00 00 05 01 03 02 00 05"_hex));
}

TEST_CASE("nobody answers what is for all units")
{
    served line;
    plain_client const client{line.number};
    client.say("00 01 00 00 00 06 00 06 00 64 00 01 00 02 00 00 00 06 01 03 00 64 00 01"_hex);
    CHECK(line.read() == spoken("00 06 00 64 00 01 08 04"_hex));
    CHECK(line.read() == spoken("01 03 00 64 00 01 C5 D5"_hex));
    CHECK(line.port.write("01 03 02 00 05 78 47"_hex, soon()));
    CHECK(client.heard(11) == spoken("00 02 00 00 00 05 01 03 02 00 05"_hex));
}

TEST_CASE("who says what is no Modbus TCP is hung up on, and so is the ninth client")
{
    served line;
    plain_client const good{line.number};
    for (spoken_bytes const& wrong : {spoken("01 03 00 64 00 01 C5 D5"_hex), spoken("00 01 00 00 00 01 01"_hex),
                                      spoken_bytes(1'000, std::byte{0xFF})}) {
        plain_client const bad{line.number};
        bad.say(wrong);
        CHECK(line.hangs_up_on(bad));
    }
    std::vector<std::unique_ptr<plain_client>> more;
    for (int i = 0; i < 8; ++i) {
        more.push_back(std::make_unique<plain_client>(line.number));
        CHECK(line.read_nothing().empty());
    }
    CHECK(line.hangs_up_on(*more.back()));
    more.erase(more.begin()); // one goes, with its request under way
    more.front()->say("00 05 00 00 00 06 02 03 00 64 00 01"_hex);
    CHECK_FALSE(line.read().empty());
    more.erase(more.begin());
    CHECK(line.read_nothing().empty());
    CHECK(line.port.write("02 03 02 00 05 3C 47"_hex, soon()));
    plain_client const next{line.number};
    next.say("00 06 00 00 00 06 01 03 00 64 00 01"_hex);
    CHECK(line.read() == spoken("01 03 00 64 00 01 C5 D5"_hex));
    CHECK(line.port.write("01 03 02 00 05 78 47"_hex, soon()));
    CHECK(next.heard(11) == spoken("00 06 00 00 00 05 01 03 02 00 05"_hex));
    good.say("00 07 00 00 00 06 01 03 00 64 00 01"_hex);
    CHECK_FALSE(line.read().empty());
}

TEST_CASE("who holds a place and asks nothing whole gives it to one who comes")
{
    served line{milliseconds(50)};
    std::vector<std::unique_ptr<plain_client>> held;
    for (int i = 0; i < 8; ++i) {
        held.push_back(std::make_unique<plain_client>(line.number));
        CHECK(line.read_nothing().empty());
    }
    auto const asks = [&](plain_client const& client) {
        client.say("00 06 00 00 00 06 01 03 00 64 00 01"_hex);
        CHECK(line.read() == spoken("01 03 00 64 00 01 C5 D5"_hex));
        CHECK(line.port.write("01 03 02 00 05 78 47"_hex, soon()));
        CHECK(client.heard(11) == spoken("00 06 00 00 00 05 01 03 02 00 05"_hex));
    };
    asks(*held[0]);
    held[1]->say("00 06 00 00 00 06 01"_hex); // half of a request is none
    instant const later = steady_now() + milliseconds(60);
    while (not reached(steady_now(), later)) {
        CHECK(line.read_nothing().empty());
    }
    for (std::size_t i = 1; i < 8; ++i) {
        asks(*held[0]); // goes on meanwhile
        held.push_back(std::make_unique<plain_client>(line.number));
        asks(*held.back());
        CHECK(line.hangs_up_on(*held[i]));
    }
    asks(*held[0]);
}

TEST_CASE("an address that is taken or not of this machine is told with its name")
{
    served line;
    mbap_listener second;
    CHECK(second.open("127.0.0.1", line.number, {1}) == errc::device_in_use);
    CHECK(second.failure().find("mbap://127.0.0.1:" + std::to_string(line.number) + ": cannot listen there: ") == 0);
    CHECK(second.open("192.0.2.1", line.number, {1}) == errc::device_not_found); // of documents
    CHECK(second.open("no-such-host.invalid", line.number, {1}) == errc::device_not_found);
}
