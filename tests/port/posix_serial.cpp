// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A serial device of the host, over real pseudo-terminals: what passes, and every failure that can be
// made without hardware.
#include <rtuwire/port/posix_serial.hpp>

#include <array>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <termios.h>
#include <unistd.h>

#include "support/catch.hpp"
#include "support/soon.hpp"

#include <rtuwire/port/pseudo_terminal.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
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

TEST_CASE("a device is behind USB where one of its folders is a USB bus, whatever its name is")
{
    CHECK(is_behind_usb(
        "../../devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2:1.0/ttyUSB0/tty/ttyUSB0")); // FTDI and the like
    CHECK(is_behind_usb("../../devices/pci0000:00/0000:00:14.0/usb3/3-1/3-1.4/3-1.4:1.0/tty/ttyACM0"));
    CHECK(is_behind_usb("../../devices/platform/soc/3f980000.usb/usb1/1-1/1-1.2/1-1.2:1.0/ttyUSB1/tty/ttyUSB1"));
    CHECK(is_behind_usb("../../devices/platform/vhci_hcd.0/usb10/10-1/10-1:1.0/ttyUSB0/tty/ttyUSB0"));
    CHECK_FALSE(is_behind_usb("../../devices/pnp0/00:04/00:04:0/00:04:0.0/tty/ttyS0"));
    CHECK_FALSE(is_behind_usb("../../devices/platform/soc/fe201000.serial/tty/ttyAMA0"));
    CHECK_FALSE(is_behind_usb("../../devices/platform/soc/3f980000.usb/gadget.0/tty/ttyS0")); // none behind it
    CHECK_FALSE(is_behind_usb("../../devices/virtual/tty/usb1"));                             // a name
    CHECK_FALSE(is_behind_usb("../../devices/virtual/usb/tty"));
    CHECK_FALSE(is_behind_usb("../../devices/virtual/usb1a/tty"));
    CHECK_FALSE(is_behind_usb("/usb"));
    CHECK_FALSE(is_behind_usb(""));
}

TEST_CASE("a device is looked up in sysfs by its number")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    descriptor const look{::open(far.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    REQUIRE(look.is_open());
    struct stat info {};
    REQUIRE(::fstat(look.number(), &info) == 0);
    CHECK(device_major(info.st_rdev) == major(info.st_rdev));
    CHECK(device_minor(info.st_rdev) == minor(info.st_rdev));
    constexpr dev_t large = 0x1234'5671'2345ULL;
    CHECK(device_major(large) == major(large));
    CHECK(device_minor(large) == minor(large));
    std::string const folder = "./sysfs" + std::to_string(::getpid());
    std::string const link =
        folder + "/" + std::to_string(major(info.st_rdev)) + ":" + std::to_string(minor(info.st_rdev));
    REQUIRE(::mkdir(folder.c_str(), 0700) == 0);
    CHECK_FALSE(is_usb_device(look.number(), folder)); // no link
    REQUIRE(::symlink("../../devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2:1.0/ttyUSB0/tty/ttyUSB0", link.c_str()) == 0);
    CHECK(is_usb_device(look.number(), folder));
    CHECK_FALSE(is_usb_device(look.number(), folder + "-not-there"));
    CHECK_FALSE(is_usb_device(-1, folder));
    CHECK_FALSE(is_usb_device(look.number())); // a pseudo-terminal is none
    ::unlink(link.c_str());
    ::rmdir(folder.c_str());
}

TEST_CASE("a port tells the times that suit its device")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    auto const is = [&](line_timing const& expected) {
        line_timing const told = port.timing();
        CHECK(told.characters(256) == expected.characters(256));
        CHECK(told.t3_5() == expected.t3_5());
        CHECK(told.frame_end() == expected.frame_end());
        CHECK(told.silence() == expected.silence());
    };
    is(line_timing::host(19'200, character_format::even_8_1));
    REQUIRE(port.open(far.path(), {.bits_per_second = 115'200, .format = character_format::none_8_1}));
    is(line_timing::host(115'200, character_format::none_8_1));
    port.close();
    is(line_timing::host(115'200, character_format::none_8_1));
}

TEST_CASE("control flags are those of the character format")
{
    CHECK((control_flags(character_format::even_8_1) & (PARENB | PARODD | CSTOPB)) == PARENB);
    CHECK((control_flags(character_format::odd_8_1) & (PARENB | PARODD | CSTOPB)) == (PARENB | PARODD));
    CHECK((control_flags(character_format::none_8_1) & (PARENB | PARODD | CSTOPB)) == 0);
    CHECK((control_flags(character_format::none_8_2) & (PARENB | PARODD | CSTOPB)) == CSTOPB);
    CHECK((control_flags(character_format::even_8_2) & (PARENB | PARODD | CSTOPB)) == (PARENB | CSTOPB));
    CHECK((control_flags(character_format::odd_8_2) & (PARENB | PARODD | CSTOPB)) == (PARENB | PARODD | CSTOPB));
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
