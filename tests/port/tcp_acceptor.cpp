// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Connections that are taken, against plain sockets.
#include <rtuwire/port/tcp_acceptor.hpp>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "support/catch.hpp"

using namespace rtuwire;

namespace {

std::uint16_t port_in(std::string const& device)
{
    return static_cast<std::uint16_t>(std::strtoul(device.substr(device.rfind(':') + 1).c_str(), nullptr, 10));
}

/// A socket that is connected there, and the port of its own end.
struct plain_client {
    int socket{::socket(AF_INET, SOCK_STREAM, 0)};
    std::uint16_t own_port{0};

    explicit plain_client(std::uint16_t port)
    {
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        place.sin_port = htons(port);
        REQUIRE(::connect(socket, reinterpret_cast<sockaddr*>(&place), sizeof place) == 0);
        socklen_t size = sizeof place;
        REQUIRE(::getsockname(socket, reinterpret_cast<sockaddr*>(&place), &size) == 0);
        own_port = ntohs(place.sin_port);
    }
    plain_client(plain_client const&) = delete;
    ~plain_client() { ::close(socket); }
};

} // namespace

TEST_CASE("tcp_acceptor: any free port is told, and who comes there is named by his own")
{
    tcp_acceptor at;
    REQUIRE(at.open("127.0.0.1", 0));
    REQUIRE(at.device().starts_with("127.0.0.1:"));
    REQUIRE(port_in(at.device()) != 0);
    CHECK_FALSE(at.accept()); // nobody waits, and it does not either

    plain_client const client{port_in(at.device())};
    pollfd watched{at.descriptor_number(), POLLIN, 0};
    REQUIRE(::poll(&watched, 1, 60'000) == 1);
    auto taken = at.accept();
    REQUIRE(taken);
    CHECK(taken->device() == "127.0.0.1:" + std::to_string(client.own_port));
    CHECK((::fcntl(taken->descriptor_number(), F_GETFD) & FD_CLOEXEC) != 0);
    CHECK((::fcntl(taken->descriptor_number(), F_GETFL) & O_NONBLOCK) != 0);

    at.close(); // takes nothing from who came
    REQUIRE(::send(client.socket, "abc", 3, 0) == 3);
    std::array<std::byte, 8> place{};
    auto const came = taken->read(place, steady_now() + milliseconds(60'000));
    REQUIRE(came);
    CHECK(came->size() == 3);
    CHECK(at.descriptor_number() == -1);
}

TEST_CASE("tcp_acceptor: says where it cannot listen, and why")
{
    tcp_acceptor first;
    REQUIRE(first.open("127.0.0.1", 0));
    tcp_acceptor second;
    CHECK(second.open("127.0.0.1", port_in(first.device())) == errc::device_in_use);
    CHECK(second.failure().starts_with(first.device() + ": cannot listen there: "));
    CHECK(second.descriptor_number() == -1);
    CHECK_FALSE(second.accept());
    CHECK(second.open("192.0.2.1", 1502) == errc::device_not_found); // kept for documents: no machine has it
    CHECK(second.open("no-such-host.invalid", 1502) == errc::device_not_found);
    CHECK(second.failure().starts_with("no-such-host.invalid:1502: cannot listen there: no such host"));
}

TEST_CASE("tcp_acceptor: a number of IPv6 stands in brackets")
{
    tcp_acceptor at;
    if (auto const opened = at.open("::1", 0)) { // where this machine has it
        CHECK(at.device().starts_with("[::1]:"));
    } else {
        CHECK(at.failure().starts_with("[::1]:0: "));
    }
}
