// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A serial device of the host, over real pseudo-terminals: what passes, and every failure that can be
// made without hardware.
#include <rtuwire/port/posix_serial.hpp>

#include <array>
#include <string>

#include <termios.h>

#include "support/catch.hpp"
#include "support/soon.hpp"

#include <rtuwire/port/pseudo_terminal.hpp>

using namespace rtuwire;
using test::soon;

namespace {

template <typename From, typename To> void check_all_bytes(From& from, To& to)
{
    std::array<std::byte, 256> sent{};
    for (std::size_t i = 0; i < sent.size(); ++i) {
        sent[i] = to_byte(static_cast<unsigned>(i));
    }
    REQUIRE(from.write(sent, soon()));
    std::array<std::byte, 300> place{};
    std::size_t count = 0;
    while (count < sent.size()) {
        auto const part = to.read(byte_span{place}.subspan(count), soon());
        REQUIRE(part);
        REQUIRE_FALSE(part->empty());
        count += part->size();
    }
    CHECK(same_bytes(byte_view{place}.first(count), sent));
}

errc open_error(std::string const& device, serial_settings const& settings = {})
{
    posix_serial port;
    auto const opened = port.open(device, settings);
    if (not opened) {
        CHECK(port.failure().find(device) == 0);
        CHECK(port.failure().size() > device.size() + 2);
        CHECK_FALSE(port.is_open());
    }
    return opened.error();
}

} // namespace

TEST_CASE("all byte values pass unchanged both ways")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    REQUIRE(port.open(far.path()));
    check_all_bytes(port, far);
    check_all_bytes(far, port);
}

TEST_CASE("reading ends at its deadline with nothing")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    REQUIRE(port.open(far.path()));
    instant const until = steady_now() + milliseconds(20);
    std::array<std::byte, 8> place{};
    auto const bytes = port.read(place, until);
    REQUIRE(bytes);
    CHECK(bytes->empty());
    CHECK(reached(steady_now(), until));
}

TEST_CASE("writing to a device that takes nothing ends at its deadline")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    REQUIRE(port.open(far.path()));
    std::array<std::byte, 4096> const block{};
    result<void> written;
    for (unsigned i = 0; i < 100 and written; ++i) {
        written = port.write(block, steady_now() + milliseconds(20));
    }
    CHECK(written == errc::transmit_stalled);
}

TEST_CASE("a device that is not there, or no serial device, says so with its name")
{
    CHECK(open_error("/dev/rtuwire-does-not-exist") == errc::device_not_found);
    CHECK(open_error("/dev/null") == errc::device_not_serial);
    CHECK(open_error("/") == errc::device_not_serial);
}

TEST_CASE("a bit rate that no line has is refused, and a transceiver that the driver lacks")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    CHECK(open_error(far.path(), {.bits_per_second = 0}) == errc::device_setting_refused);
    CHECK(open_error(far.path(), {.bits_per_second = 49}) == errc::device_setting_refused);
    CHECK(open_error(far.path(), {.rs485 = rs485_mode::required}) == errc::device_setting_refused);
    CHECK(open_error(far.path(), {.rs485 = rs485_mode::if_offered}) == errc::none);
}

TEST_CASE("a device is held exclusively, until it is closed")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    REQUIRE(port.open(far.path()));
    CHECK(open_error(far.path()) == errc::device_in_use);
    port.close();
    CHECK(open_error(far.path()) == errc::none);
}

TEST_CASE("bit rate and stop bits are set on the device")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    // Before the port is: it keeps out everyone but root.
    descriptor const look{::open(far.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    REQUIRE(look.is_open());
    for (std::uint32_t const rate : {1'200U, 4'800U, 9'600U, 19'200U, 38'400U, 115'200U}) {
        posix_serial port;
        REQUIRE(port.open(far.path(), {.bits_per_second = rate, .format = character_format::none_8_2}));
        termios line{};
        REQUIRE(::tcgetattr(look.number(), &line) == 0);
        CHECK(::cfgetospeed(&line) == *speed_code(rate));
        CHECK((line.c_cflag & CSTOPB) != 0);
        CHECK((line.c_lflag & (ICANON | ECHO | ISIG)) == 0);
    }
}

TEST_CASE("control flags are those of the character format")
{
    CHECK((control_flags(character_format::even_8_1) & (PARENB | PARODD | CSTOPB)) == PARENB);
    CHECK((control_flags(character_format::odd_8_1) & (PARENB | PARODD | CSTOPB)) == (PARENB | PARODD));
    CHECK((control_flags(character_format::none_8_1) & (PARENB | PARODD | CSTOPB)) == 0);
    CHECK((control_flags(character_format::none_8_2) & (PARENB | PARODD | CSTOPB)) == CSTOPB);
}

TEST_CASE("a device that vanishes is an error at once, and again")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    REQUIRE(port.open(far.path()));
    far.close();
    std::array<std::byte, 8> place{};
    instant const until = soon();
    CHECK(port.read(place, until) == errc::device_vanished);
    CHECK(port.read(place, until) == errc::device_vanished);
    CHECK(port.write(place, until) == errc::device_vanished);
    CHECK_FALSE(reached(steady_now(), until));
    CHECK(port.failure().find(port.device()) == 0);
}

TEST_CASE("a pseudo-terminal goes on when the program at its far end goes and comes")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    for (unsigned visit = 0; visit < 3; ++visit) {
        posix_serial port;
        REQUIRE(port.open(far.path()));
        check_all_bytes(port, far);
        check_all_bytes(far, port);
    }
}
