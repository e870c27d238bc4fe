// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The switching of a transceiver by the kernel: what a driver has is read first, only what was asked for is changed, and
// all of it is put back. The flags are those of Linux, linux/serial.h.
#include <rtuwire/port/transceiver.hpp>

#include <algorithm>
#include <cerrno>
#include <string>
#include <vector>

#include "support/catch.hpp"

#ifdef TIOCSRS485

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr std::uint32_t enabled = 1, high_on_send = 2, high_after_send = 4, receives = 16, terminates = 32;

/// A driver that keeps what it can.
struct driver {
    serial_rs485 has{};
    std::uint32_t cannot{0};    ///< flags that it drops
    std::uint32_t longest{100}; ///< milliseconds
    bool gets{true};
    bool sets{true};
    std::vector<unsigned long> calls{};

    bool operator()(unsigned long request, serial_rs485& settings)
    {
        calls.push_back(request);
        bool const is_get = request == TIOCGRS485;
        if (not(is_get ? gets : sets)) {
            errno = ENOTTY;
            return false;
        }
        if (is_get) {
            settings = has;
            return true;
        }
        has = settings;
        has.flags &= ~cannot;
        has.delay_rts_before_send = std::min(settings.delay_rts_before_send, longest);
        has.delay_rts_after_send = std::min(settings.delay_rts_after_send, longest);
        return true;
    }
    bool is(std::uint32_t flags, std::uint32_t before, std::uint32_t after) const
    {
        return has.flags == flags and has.delay_rts_before_send == before and has.delay_rts_after_send == after;
    }
};

serial_rs485 board(std::uint32_t flags, std::uint32_t before, std::uint32_t after)
{
    serial_rs485 settings{};
    settings.flags = flags;
    settings.delay_rts_before_send = before;
    settings.delay_rts_after_send = after;
    return settings;
}

/// A board whose device tree has set all of it (W23).
constexpr std::uint32_t inverted = enabled | high_after_send | receives;

} // namespace

TEST_CASE("defect: D35 what a board has set is left as it is")
{
    for (rs485_mode const mode : {rs485_mode::leave, rs485_mode::if_offered, rs485_mode::required}) {
        driver kernel{.has = board(inverted, 1, 2)};
        transceiver_control control;
        std::string why;
        CHECK(control.set(kernel, mode, {}, why));
        CHECK(kernel.is(inverted, 1, 2));
        CHECK_FALSE(control.is_changed());
        control.restore(kernel);
        CHECK(kernel.is(inverted, 1, 2));
        // Nothing to change: nothing is set, be it for a moment.
        CHECK(std::find(kernel.calls.begin(), kernel.calls.end(), TIOCSRS485) == kernel.calls.end());
    }
}

TEST_CASE("defect: D35 of what a board has, only what was asked for is changed, and put back")
{
    struct change {
        transceiver_settings asked;
        std::uint32_t flags, before, after;
    };
    change const changes[] = {
        {{.polarity = rts_polarity::high_to_send}, enabled | high_on_send | receives | terminates, 1, 2},
        {{.before_send = milliseconds(5)}, inverted | terminates, 5, 2},
        {{.after_send = microseconds(1)}, inverted | terminates, 1, 1},
        {{.after_send = milliseconds(0)}, inverted | terminates, 1, 0},
        {{.receives_while_sending = false}, enabled | high_after_send | terminates, 1, 2},
    };
    for (change const& each : changes) {
        driver kernel{.has = board(inverted | terminates, 1, 2)};
        transceiver_control control;
        std::string why;
        CHECK(control.set(kernel, rs485_mode::required, each.asked, why));
        CHECK(kernel.is(each.flags, each.before, each.after));
        CHECK(kernel.calls.front() == TIOCGRS485);
        CHECK(control.is_changed());
        control.restore(kernel);
        CHECK(kernel.is(inverted | terminates, 1, 2));
        control.restore(kernel);
        CHECK(kernel.calls.size() == 4); // get, set, look, put back: once
    }
}

TEST_CASE("defect: D35 a driver that does not switch yet has RTS high to send, and stops switching at the end")
{
    driver kernel{.has = board(0, 0, 7)};
    transceiver_control control;
    std::string why;
    CHECK(control.set(kernel, rs485_mode::if_offered, {}, why));
    CHECK(kernel.is(enabled | high_on_send, 0, 7));
    control.restore(kernel);
    CHECK(kernel.is(0, 0, 7));
}

TEST_CASE("defect: D35 a refusal says what the driver kept")
{
    auto const refusal = [](driver kernel, transceiver_settings const& asked,
                            rs485_mode mode = rs485_mode::required) -> std::string {
        serial_rs485 const before = kernel.has;
        transceiver_control control;
        std::string why;
        bool const is_set = control.set(kernel, mode, asked, why).has_value();
        control.restore(kernel);
        CHECK(kernel.is(before.flags, before.delay_rts_before_send, before.delay_rts_after_send));
        return is_set ? "" : why;
    };
    CHECK(refusal({.longest = 3}, {.before_send = milliseconds(5)}) ==
          "its driver keeps 3 ms before sending, not 5 ms");
    CHECK(refusal({.longest = 0}, {.after_send = milliseconds(2)}, rs485_mode::if_offered) ==
          "its driver keeps 0 ms after sending, not 2 ms");
    CHECK(refusal({.cannot = receives}, {.receives_while_sending = true}) ==
          "its driver does not receive while it sends");
    CHECK(refusal({.cannot = high_after_send}, {.polarity = rts_polarity::low_to_send}) ==
          "its driver does not keep RTS low to send");
    CHECK(refusal({.cannot = enabled}, {}) == "its driver does not switch an RS-485 transceiver");
    std::string const no_way = refusal({.sets = false}, {});
    CHECK(no_way.find("its driver does not switch an RS-485 transceiver so (") == 0);
    CHECK(refusal({.gets = false}, {}) == no_way);
    // What is not offered need not be, where it is not required; what a driver has switched on is.
    CHECK(refusal({.cannot = enabled}, {}, rs485_mode::if_offered).empty());
    CHECK(refusal({.sets = false}, {}, rs485_mode::if_offered).empty());
    CHECK(refusal({.gets = false}, {}, rs485_mode::if_offered).empty());
    CHECK(refusal({.has = board(inverted, 1, 2), .sets = false}, {.after_send = milliseconds(0)},
                  rs485_mode::if_offered) == no_way);
}

#endif
