// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// RTU frames over TCP, against sockets that the test serves itself: what passes, how connecting ends, and what is said when
// the other end goes.
#include <rtuwire/port/tcp_stream.hpp>

#include <array>
#include <csignal>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include "support/catch.hpp"
#include "support/soon.hpp"

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using test::soon;

namespace {

/// A socket that listens on a port of this machine.
class listener {
public:
    explicit listener(int family = AF_INET, int backlog = 4) : socket_{::socket(family, SOCK_STREAM, 0)}
    {
        sockaddr_in own{};
        own.sin_family = AF_INET;
        own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        sockaddr_in6 own6{};
        own6.sin6_family = AF_INET6;
        own6.sin6_addr = in6addr_loopback;
        is_good_ = (family == AF_INET ? ::bind(socket_, reinterpret_cast<sockaddr*>(&own), sizeof own)
                                      : ::bind(socket_, reinterpret_cast<sockaddr*>(&own6), sizeof own6)) == 0 and
                   ::listen(socket_, backlog) == 0;
        sockaddr_storage got{};
        socklen_t size = sizeof got;
        ::getsockname(socket_, reinterpret_cast<sockaddr*>(&got), &size);
        // The port is in the same place in both.
        port_ = ntohs(reinterpret_cast<sockaddr_in*>(&got)->sin_port);
    }
    ~listener() { close(); }

    bool is_good() const { return is_good_; }
    std::uint16_t port() const { return port_; }
    int accept() const { return ::accept(socket_, nullptr, nullptr); }
    void close()
    {
        if (socket_ >= 0) {
            ::close(std::exchange(socket_, -1));
        }
    }

private:
    int socket_;
    bool is_good_{false};
    std::uint16_t port_{0};
};

/// Both ends of a connection.
struct both_ends {
    listener server{};
    tcp_stream port{};
    int far{-1};
    std::array<std::byte, 300> place{};

    both_ends()
    {
        REQUIRE(port.open("127.0.0.1", server.port()));
        far = server.accept();
        REQUIRE(far >= 0);
    }
    ~both_ends() { hang_up(); }
    both_ends(both_ends const&) = delete;

    void hang_up()
    {
        if (far >= 0) {
            ::close(std::exchange(far, -1));
        }
    }

    /// Breaks the connection instead of ending it.
    void reset()
    {
        linger const at_once{1, 0};
        ::setsockopt(far, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
        hang_up();
    }

    void say(byte_view bytes) const { static_cast<void>(::send(far, bytes.data(), bytes.size(), MSG_NOSIGNAL)); }

    auto ask(duration response_timeout = test::limit)
    {
        blocking_client client{port, line_timing::without_wire(), {.response_timeout = response_timeout, .retries = 0}};
        auto const response = client.ask(unit_id{1}, read_holding_registers{100, 1});
        return response ? errc::none : response.error();
    }
};

struct failure_of_open {
    errc error;
    std::string sentence;
    duration took;
};

failure_of_open opened(std::string const& host, std::uint16_t port, duration limit = test::limit)
{
    tcp_stream stream;
    instant const start = steady_now();
    auto const done = stream.open(host, port, limit);
    CHECK(stream.is_open() == done.has_value());
    return {done.error(), stream.failure(), steady_now() - start};
}

std::string number(std::uint16_t port) { return std::to_string(port); }

} // namespace

TEST_CASE("all byte values pass a connection unchanged both ways")
{
    both_ends line;
    std::array<std::byte, 256> all{};
    for (unsigned i = 0; i < all.size(); ++i) {
        all[i] = to_byte(i);
    }
    REQUIRE(line.port.write(all, soon()));
    std::size_t count = 0;
    while (count < all.size()) {
        ssize_t const part = ::read(line.far, line.place.data() + count, line.place.size() - count);
        REQUIRE(part > 0);
        count += static_cast<std::size_t>(part);
    }
    CHECK(same_bytes(byte_view{line.place}.first(count), all));
    line.say(all);
    count = 0;
    while (count < all.size()) {
        auto const part = line.port.read(byte_span{line.place}.subspan(count), soon());
        REQUIRE(part);
        REQUIRE_FALSE(part->empty());
        count += part->size();
    }
    CHECK(same_bytes(byte_view{line.place}.first(count), all));
}

TEST_CASE("a connection passes small frames on at once, and looks whether the other end lives")
{
    both_ends const line;
    for (auto const& [level, option] :
         {std::pair{int{IPPROTO_TCP}, int{TCP_NODELAY}}, std::pair{int{SOL_SOCKET}, int{SO_KEEPALIVE}}}) {
        int value = 0;
        socklen_t size = sizeof value;
        REQUIRE(::getsockopt(line.port.descriptor_number(), level, option, &value, &size) == 0);
        CHECK(value != 0);
    }
}

TEST_CASE("a client asks over a connection")
{
    both_ends line;
    std::thread answers{[&] {
        // A response in two halves, as a server that packs bytes sends it.
        std::array<std::byte, 8> request{};
        if (::recv(line.far, request.data(), request.size(), MSG_WAITALL) == 8) {
            auto const whole = "01 03 02 12 34 B5 33"_hex;
            static_cast<void>(::send(line.far, whole.data(), 3, MSG_NOSIGNAL));
            ::usleep(20'000);
            static_cast<void>(::send(line.far, whole.data() + 3, 4, MSG_NOSIGNAL));
        }
    }};
    blocking_client client{
        line.port, line_timing::without_wire(milliseconds(5'000)), {.response_timeout = test::limit, .retries = 0}};
    auto const response = client.ask(unit_id{1}, read_holding_registers{100, 1});
    answers.join();
    REQUIRE(response);
    CHECK(response->registers[0] == 0x1234);
}

TEST_CASE("a name and a number of IPv6 are connected to")
{
    listener const four{};
    CHECK(opened("localhost", four.port()).error == errc::none);
    if (listener const six{AF_INET6}; six.is_good()) {
        CHECK(opened("::1", six.port()).error == errc::none);
    }
}

TEST_CASE("a refused connection says who refused")
{
    listener gone{};
    gone.close();
    auto const refused = opened("127.0.0.1", gone.port());
    CHECK(refused.error == errc::device_not_found);
    CHECK(refused.sentence == "127.0.0.1:" + number(gone.port()) + ": no connection (Connection refused)");
    CHECK(opened("::1", gone.port()).sentence.find("[::1]:" + number(gone.port()) + ": ") == 0);
}

TEST_CASE("a host that is silent is given up in time")
{
    // A full queue: further connections are not answered.
    listener const full{AF_INET, 0};
    std::vector<tcp_stream> waiting(4);
    failure_of_open last{};
    for (auto& each : waiting) {
        instant const start = steady_now();
        auto const done = each.open("127.0.0.1", full.port(), milliseconds(150));
        last = {done.error(), each.failure(), steady_now() - start};
    }
    CHECK(last.error == errc::timed_out);
    CHECK(last.took >= milliseconds(150));
    CHECK(last.took < test::limit); // the system would try for two minutes
    CHECK(last.sentence == "127.0.0.1:" + number(full.port()) + ": no connection (Connection timed out)");
}

TEST_CASE("a name that does not exist says so, within the time limit")
{
    auto const none = opened("no-such-host.invalid", 4001, milliseconds(500));
    CHECK((none.error == errc::device_not_found or none.error == errc::timed_out));
    CHECK(none.took < test::limit);
    CHECK(none.sentence.find("no-such-host.invalid:4001: no such host (") == 0);
    CHECK(opened("", 4001).error == errc::device_not_found);
    // No time at all: given up at once, whatever the look-up does behind our back.
    auto const hurried = opened("no-such-host.invalid", 4001, duration{});
    CHECK(hurried.error != errc::none);
    CHECK(hurried.took < test::limit);
}

TEST_CASE("a connection that ends in the middle of a response is an error, not a hang")
{
    both_ends line;
    std::thread far{[&] {
        std::array<std::byte, 8> request{};
        if (::recv(line.far, request.data(), request.size(), MSG_WAITALL) == 8) {
            line.say("01 03 02 12"_hex);
        }
        line.hang_up();
    }};
    CHECK(line.ask() == errc::device_vanished);
    far.join();
    CHECK(line.port.failure() == line.port.device() + ": the connection is gone (closed by the other end)");
    CHECK(line.port.is_open());
    CHECK(line.ask() == errc::device_vanished);
    line.port.close();
    CHECK(line.ask() == errc::device_not_open);
}

TEST_CASE("a connection that ended while idle is noticed by the next request")
{
    both_ends line;
    line.hang_up();
    CHECK(line.ask() == errc::device_vanished);
}

TEST_CASE("writing to a connection that is gone is an error, not a signal")
{
    // Whoever ignores the signal would not see it.
    REQUIRE(std::signal(SIGPIPE, SIG_DFL) != SIG_ERR);
    both_ends line;
    line.reset();
    std::array<std::byte, 8> const frame{};
    result<void> written{};
    for (int i = 0; i < 100 and written; ++i) {
        written = line.port.write(frame, soon());
        ::usleep(1'000);
    }
    CHECK(written == errc::device_vanished);
    CHECK(line.port.write(frame, soon()) == errc::device_vanished);
    both_ends other;
    other.reset();
    CHECK(other.port.read(other.place, soon()).error() == errc::device_vanished);
    CHECK(other.port.failure() == other.port.device() + ": the connection is gone (Connection reset by peer)");
}

TEST_CASE("a response that stays incomplete is no response, and the next exchange is good")
{
    both_ends line;
    auto const whole = "01 03 02 12 34 B5 33"_hex;
    std::thread far{[&] {
        std::array<std::byte, 8> request{};
        for (byte_view const part : {byte_view{whole}.first(4), byte_view{whole}}) {
            if (::recv(line.far, request.data(), request.size(), MSG_WAITALL) == 8) {
                line.say(part);
            }
        }
    }};
    CHECK(line.ask(milliseconds(500)) != errc::none);
    CHECK(line.ask() == errc::none);
    far.join();
}

TEST_CASE("writing to who does not read, and reading from who does not write, end at their deadlines")
{
    both_ends line;
    std::array<std::byte, 65'536> const block{};
    result<void> written{};
    for (int i = 0; i < 1'000 and written; ++i) {
        written = line.port.write(block, steady_now() + milliseconds(20));
    }
    CHECK(written == errc::transmit_stalled);
    instant const until = steady_now() + milliseconds(20);
    auto const bytes = line.port.read(line.place, until);
    REQUIRE(bytes);
    CHECK(bytes->empty());
    CHECK(reached(steady_now(), until));
}

TEST_CASE("a connection never becomes standard input, output or error output")
{
    listener const server{};
    std::array<int, 3> kept{};
    for (int i = 0; i < 3; ++i) {
        kept[static_cast<std::size_t>(i)] = ::fcntl(i, F_DUPFD, 100);
    }
    for (int i = 0; i < 3; ++i) {
        ::close(i);
    }
    tcp_stream port;
    auto const done = port.open("127.0.0.1", server.port());
    int const got = port.descriptor_number();
    port.close();
    for (int i = 0; i < 3; ++i) {
        ::dup2(kept[static_cast<std::size_t>(i)], i);
        ::close(kept[static_cast<std::size_t>(i)]);
    }
    CHECK(done);
    CHECK(got > 2);
}

TEST_CASE("a socket that is connected with itself is told from others")
{
    listener gone{};
    gone.close();
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    own.sin_port = htons(gone.port());
    descriptor const alone{::socket(AF_INET, SOCK_STREAM, 0)};
    REQUIRE(::bind(alone.number(), reinterpret_cast<sockaddr*>(&own), sizeof own) == 0);
    REQUIRE(::connect(alone.number(), reinterpret_cast<sockaddr*>(&own), sizeof own) == 0);
    CHECK(is_connected_with_itself(alone.number()));
    both_ends const line;
    CHECK_FALSE(is_connected_with_itself(line.port.descriptor_number()));
}

TEST_CASE("a connection can be moved")
{
    both_ends line;
    tcp_stream moved{std::move(line.port)};
    CHECK(moved.is_open());
    CHECK(moved.device() == "127.0.0.1:" + number(line.server.port()));
    line.say("42"_hex);
    auto const bytes = moved.read(line.place, soon());
    REQUIRE(bytes);
    CHECK(bytes->size() == 1);
}
