// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A port that is not open says so at once, whatever it is asked; nor is one open whose device vanished.
#include <rtuwire/port/posix_serial.hpp>

#include <array>
#include <utility>

#include "support/catch.hpp"
#include "support/soon.hpp"

#include <rtuwire/port/pseudo_terminal.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using test::soon;

namespace {

template <typename Port> void check_is_closed(Port& port)
{
    std::array<std::byte, 8> place{};
    instant const until = soon();
    CHECK(port.read(place, until) == errc::device_not_open);
    CHECK(port.write(place, until) == errc::device_not_open);
    CHECK(port.write({}, until) == errc::device_not_open);
    CHECK_FALSE(reached(steady_now(), until));
}

} // namespace

TEST_CASE("defect: (i) a port that was never opened says so at once")
{
    posix_serial port;
    check_is_closed(port);
    CHECK_FALSE(port.failure().empty());
    pseudo_terminal line;
    check_is_closed(line);
}

TEST_CASE("defect: (i) a port that was closed, or moved from, says so at once")
{
    pseudo_terminal line;
    REQUIRE(line.open());
    posix_serial port;
    REQUIRE(port.open(line.path()));
    // Something is there to read, which goes with the port.
    std::array<std::byte, 3> const bytes{std::byte{1}, std::byte{0xFF}, std::byte{2}};
    REQUIRE(line.write(bytes, soon()));
    std::array<std::byte, 1> place{};
    REQUIRE(port.read(place, soon()));
    posix_serial moved{std::move(port)};
    check_is_closed(port); // NOLINT(bugprone-use-after-move)
    auto const rest = moved.read(place, soon());
    REQUIRE(rest);
    CHECK(to_u8((*rest)[0]) == 0xFF);
    moved.close();
    check_is_closed(moved);
    line.close();
    check_is_closed(line);
}

TEST_CASE("defect: D42 a port whose device vanished is not open, whoever noticed it")
{
    pseudo_terminal line;
    REQUIRE(line.open());
    posix_serial port;
    REQUIRE(port.open(line.path()));
    CHECK(port.is_open());
    // Bytes that came before are still read.
    std::array<std::byte, 3> const bytes{std::byte{1}, std::byte{2}, std::byte{3}};
    REQUIRE(line.write(bytes, soon()));
    std::array<std::byte, 2> place{};
    REQUIRE(port.read(place, soon()));
    CHECK(port.is_open());
    line.close();
    CHECK_FALSE(port.is_open());
    auto const rest = port.read(place, soon());
    REQUIRE(rest);
    CHECK(rest->size() == 1);
    CHECK(port.read(place, soon()) == errc::device_vanished);
    CHECK(port.write(bytes, soon()) == errc::device_vanished);
    CHECK_FALSE(port.is_open());
    // The same port may be opened anew.
    REQUIRE(line.open());
    CHECK(port.open(line.path()));
    CHECK(port.is_open());
}
