// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A serial port whose driver is that of `fake_driver.cpp`, which is loaded in front of the C library.
#include <rtuwire/port/posix_serial.hpp>

#include <string>
#include <utility>

#include "support/catch.hpp"

#include <rtuwire/port/pseudo_terminal.hpp>

using namespace rtuwire;

namespace {

/// What the driver has now.
struct wiring {
    std::uint32_t flags;
    std::uint32_t before;
    std::uint32_t after;

    static wiring now()
    {
        serial_rs485 found{};
        REQUIRE(::ioctl(-1, TIOCGRS485, &found) == 0);
        return {found.flags, found.delay_rts_before_send, found.delay_rts_after_send};
    }
    bool operator==(wiring const&) const = default;
};

constexpr wiring as_delivered{1 | 4 | 16, 1, 2};

} // namespace

TEST_CASE("defect: D35 the transceiver of a board is as before when its port closes")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    REQUIRE(wiring::now() == as_delivered);
    serial_settings settings{.rs485 = rs485_mode::required};
    {
        posix_serial port;
        REQUIRE(port.open(far.path(), settings));
        CHECK(wiring::now() == as_delivered);
    }
    CHECK(wiring::now() == as_delivered);
    settings.transceiver = {.polarity = rts_polarity::high_to_send, .before_send = milliseconds(3)};
    wiring const changed{1 | 2 | 16, 3, 2};
    {
        posix_serial port;
        REQUIRE(port.open(far.path(), settings));
        CHECK(wiring::now() == changed);
        posix_serial moved{std::move(port)};
        port.close(); // NOLINT(bugprone-use-after-move)
        CHECK(wiring::now() == changed);
        moved.close();
        CHECK(wiring::now() == as_delivered);
        // Opened once more without a word of it, and by a port that takes another's place.
        REQUIRE(moved.open(far.path(), settings));
        CHECK(wiring::now() == changed);
        moved = posix_serial{};
        CHECK(wiring::now() == as_delivered);
    }
}

TEST_CASE("defect: D36 what a driver does not keep to 2 % is refused, and told")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    auto const refusal = [&](std::uint32_t rate) {
        return port.open(far.path(), {.bits_per_second = rate}) ? std::string{}
                                                                : port.failure().substr(far.path().size());
    };
    CHECK(refusal(250'000) == ": the device refuses the line settings (its driver keeps 230400 bit/s, not 250000)");
    CHECK(refusal(1'000'001) == ": the device refuses the line settings (its driver keeps 980000 bit/s, not 1000001)");
    CHECK(refusal(76'800).empty());
    CHECK(refusal(31'250).empty());
    CHECK(refusal(300).empty());
    CHECK(refusal(19'200).empty());
}
