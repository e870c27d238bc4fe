// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a host buffered before a request, and a program that is stopped while it takes that away: the line is no more jammed
// for it.
#include <rtuwire/client/blocking.hpp>

#include <algorithm>
#include <cstddef>

#include "support/catch.hpp"
#include "support/drive_port.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;

namespace {

using device = altivar::atv320::device;
constexpr station<device> drive{unit_id{3}};

/// A drive's port, in which some old bytes lie, to be read so many at a time, in reads before which the program is stopped.
struct old_port : test::drive_port<device> {
    std::size_t old{0};
    std::size_t at_once{256};
    bool comes_again{false};
    duration pause{};
    unsigned pauses{0};

    result<byte_span> read(byte_span place, instant until)
    {
        clock = clock + microseconds(50);
        if (pauses != 0) {
            --pauses;
            clock = clock + pause;
        }
        if (old == 0) {
            return drive_port::read(place, until);
        }
        std::size_t const count = std::min({old, at_once, place.size()});
        std::fill_n(place.begin(), count, std::byte{0x55});
        old -= comes_again ? 0 : count;
        return place.first(count);
    }
};

constexpr duration none{};

} // namespace

TEST_CASE("defect: S1 a stop is sent although its program was stopped over old input, whatever the response time-out")
{
    for (duration const timeout : {none, milliseconds(50), milliseconds(1'000)}) {
        for (duration const pause :
             {milliseconds(60), milliseconds(1'100), milliseconds(5'000), milliseconds(34 * 60'000)}) {
            for (unsigned const pauses : {1U, 2U, 16U}) {
                INFO("time-out " << timeout.microseconds << " us, " << pauses << " pauses of " << pause.microseconds);
                old_port port;
                blocking_client line{port, port.timing, {.response_timeout = timeout}};
                port.old = pauses == 1 ? 7 : 4'096; // a frame, or all that a terminal buffers
                port.pause = pause;
                port.pauses = pauses;
                altivar::stop rest{drive};
                auto const ended = line.run(rest);
                CHECK(ended.error != errc::bus_jam);
                CHECK_FALSE(port.sent.empty());
                CHECK((timeout == none or ended.kind == altivar::outcome_kind::succeeded));
            }
        }
    }
}

TEST_CASE("input that never ends is a jam for as long as the port has to send")
{
    for (std::size_t const at_once : {1U, 256U}) {
        for (duration const timeout : {none, milliseconds(50), milliseconds(1'000)}) {
            old_port port;
            port.old = 1;
            port.comes_again = true;
            port.at_once = at_once;
            blocking_client line{port, port.timing, {.response_timeout = timeout}};
            instant const begin = port.clock;
            CHECK(line.run(altivar::stop{drive}).error == errc::bus_jam);
            CHECK(port.sent.empty());
            CHECK(port.clock - begin <= milliseconds(1'001));
            port.old = 0;
            CHECK((timeout == none or line.run(altivar::stop{drive}).kind == altivar::outcome_kind::succeeded));
        }
    }
}
