// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Linux runs a line at any rate that its driver can: also at those without a code in POSIX, which were refused as if there
// were none. What the kernel has is read by its own header.
#include <rtuwire/port/posix_serial.hpp>

#include <cstddef>
#include <string>

#include "support/catch.hpp"

#include "defect/kernel_rate.hpp"

#include <rtuwire/port/pseudo_terminal.hpp>

#ifdef __linux__

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// A second look at a device, from before a port keeps out everyone but root.
descriptor look_at(std::string const& device)
{
    return descriptor{::open(device.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
}

/// An emulator of programs may lack these calls of the kernel: it takes the rates that have a code.
bool takes_any(descriptor const& look)
{
    bool const takes = test::line_of(look.number()).output_rate != 0;
    if (not takes) {
        WARN("no termios2: not a kernel");
    }
    return takes;
}

} // namespace

TEST_CASE("defect: D36 a port opens at any rate, and again at a usual one")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    descriptor const look = look_at(far.path());
    REQUIRE(look.is_open());
    if (not takes_any(look)) {
        return;
    }
    for (std::uint32_t const rate : {65U, 300U, 600U, 1'800U, 9'600U, 31'250U, 76'800U, 115'200U, 250'000U, 12'345U}) {
        CAPTURE(rate);
        auto const format = rate == 300      ? character_format::even_8_1
                            : rate == 31'250 ? character_format::odd_8_2
                                             : character_format::none_8_1;
        posix_serial port;
        REQUIRE(port.open(far.path(), {.bits_per_second = rate, .format = format}));
        auto const kernel = test::line_of(look.number());
        CHECK(kernel.output_rate == rate);
        CHECK(kernel.input_rate == rate);
        CHECK(kernel.has_two_stop_bits == (rate == 31'250));
        // The rest is as at a usual rate.
        termios line{};
        REQUIRE(::tcgetattr(look.number(), &line) == 0);
        CHECK(line.c_iflag == (INPCK | PARMRK));
        CHECK((line.c_cflag & (CSIZE | CREAD | CLOCAL)) == (CS8 | CREAD | CLOCAL));
        CHECK((line.c_lflag & (ICANON | ECHO | ISIG)) == 0);
    }
}

TEST_CASE("defect: D36 an open that is refused puts back a rate without a code")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    descriptor const look = look_at(far.path());
    REQUIRE(look.is_open());
    if (not takes_any(look)) {
        return;
    }
    for (std::uint32_t const rate : {31'250U, 250'000U, 9'600U}) {
        REQUIRE(test::set_rate(look.number(), rate));
        for (std::uint32_t const asked : {76'800U, 19'200U}) {
            posix_serial port;
            CHECK(port.open(far.path(), {.bits_per_second = asked, .rs485 = rs485_mode::required}) ==
                  errc::device_setting_refused);
            CHECK(test::line_of(look.number()).output_rate == rate);
            CHECK(test::line_of(look.number()).input_rate == rate);
        }
    }
}

TEST_CASE("defect: D36 a rate that no line has is refused by its number")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    for (std::uint32_t const none : {49U, 64U}) {
        CHECK(port.open(far.path(), {.bits_per_second = none}) == errc::device_setting_refused);
        CHECK(port.failure() == far.path() + ": the device refuses the line settings (" + std::to_string(none) +
                                    " bit/s are no rate of this system)");
    }
    CHECK(is_bit_rate(65) == takes_any_rate);
}

TEST_CASE("the kernel's structure and numbers are those of its header")
{
    auto const kernel = test::kernel_numbers();
    CHECK(sizeof(kernel_line) == kernel.size);
    CHECK(offsetof(kernel_line, output_rate) == kernel.output_rate_at);
    CHECK(offsetof(kernel_line, input_rate) == kernel.input_rate_at);
    CHECK(offsetof(kernel_line, control_characters) == kernel.control_characters_at);
    CHECK(get_kernel_line == kernel.get);
    CHECK(set_kernel_line == kernel.set);
    CHECK(kernel_line::rate_bits == kernel.rate_bits);
    CHECK(kernel_line::any_rate == kernel.any_rate);
    CHECK(kernel_line::input_shift == kernel.input_shift);
}

TEST_CASE("a rate is kept where it is within 2 %")
{
    CHECK(is_near_rate(250'000, 250'000));
    CHECK(is_near_rate(245'000, 250'000));
    CHECK(is_near_rate(255'000, 250'000));
    CHECK_FALSE(is_near_rate(244'999, 250'000));
    CHECK_FALSE(is_near_rate(255'001, 250'000));
    CHECK_FALSE(is_near_rate(0, 300));
    CHECK_FALSE(is_near_rate(4'000'000'000, 300));
}

#endif
