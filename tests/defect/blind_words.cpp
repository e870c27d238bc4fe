// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An ATV320 in its I/O profile, which runs on the words that stop all other drives, is declared to be another drive.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr unit_id unit{3};
constexpr stop_by all_ways[]{stop_by::ramp, stop_by::quick_stop, stop_by::freewheel, stop_by::halt};

/// What the drive is said to be.
template <typename Device> using called = station<Device>;

/// The drive, behind a client that knows nothing of it yet. Bit 0 of its control word is RUN.
template <typename Link> struct in_io_profile : test::simulated_bus<Link, atv320::device> {
    in_io_profile() : test::simulated_bus<Link, atv320::device>{Link{test::bus_timing, patient}}
    {
        this->add(unit);
        this->idle(milliseconds(20));
        tell(atv320::chcf.address, io_profile);
        tell(atv320::lfr.address, 300);
        this->link() = Link{test::bus_timing, patient};
    }

    /// One word, by somebody else than the client under test.
    void tell(std::uint16_t address, std::uint16_t word)
    {
        single_request told{unit, write_single_register{address, word}};
        this->run([&](instant now) { serve(told, now); }, [&] { return told.settled(); }, milliseconds(1'000));
        REQUIRE(told.outcome());
    }
    template <typename Conversation> void serve(Conversation& whom, instant now)
    {
        if constexpr (requires { this->link().converse(std::size_t{0}, whom, now); }) {
            this->link().converse(std::size_t{0}, whom, now);
        } else {
            this->link().converse(whom, now);
        }
    }

    /// Whether the motor turned in this time, while the conversation was served.
    template <typename Conversation> bool turns(Conversation& whom, duration length)
    {
        bool has_turned = false;
        instant const end = this->now() + length;
        while (not reached(this->now(), end)) {
            this->step(
                [&](instant now) {
                    if (not whom.settled()) {
                        serve(whom, now);
                    }
                },
                milliseconds(5));
            has_turned = has_turned or this->drive().motor().frequency() != 0;
        }
        return has_turned;
    }

    void start_by_bit()
    {
        tell(atv320::cmd.address, 0x0001);
        tell(atv320::lfr.address, 300);
        this->idle(milliseconds(2'000));
        this->link() = Link{test::bus_timing, patient};
        REQUIRE(this->drive().motor().frequency() != 0);
    }
};

template <typename Link, typename Device> void stops_in_every_way()
{
    constexpr called<Device> drive{unit};
    for (stop_begin const begin : {stop_begin::at_once, stop_begin::look_first}) {
        for (stop_by const how : all_ways) {
            INFO(static_cast<int>(how) << (begin == stop_begin::at_once ? ", at once" : ", looks first"));
            in_io_profile<Link> at_rest;
            stop rest{drive, how, milliseconds(3'000), begin};
            CHECK_FALSE(at_rest.turns(rest, milliseconds(40'000)));

            in_io_profile<Link> turning;
            turning.start_by_bit();
            stop end{drive, how, milliseconds(3'000), begin};
            static_cast<void>(turning.turns(end, milliseconds(20'000)));
            CHECK(turning.drive().motor().is_at_rest());
            CHECK(end.settled());
            CHECK(end.reason().is_other_stop == (how != stop_by::freewheel));
        }
    }
}

template <typename Link> void stops_whatever_it_is_called()
{
    test::later_drives::for_each([]<typename Device>() { stops_in_every_way<Link, Device>(); });
}

} // namespace

TEST_CASE("defect: D21 no stop runs an ATV320 in its I/O profile, whatever it is called: a client")
{
    stops_whatever_it_is_called<drive_client<4>>();
}

TEST_CASE("defect: D21 no stop runs an ATV320 in its I/O profile, whatever it is called: a host's client")
{
    stops_whatever_it_is_called<host_client>();
}

TEST_CASE("defect: D21 no stop runs an ATV320 in its I/O profile, whatever it is called: a bus")
{
    stops_whatever_it_is_called<bus<2>>();
}

TEST_CASE("defect: D21 a stop of all drives runs none of them, whatever they are called")
{
    in_io_profile<drive_client<4>> it;
    broadcast_stop all{broadcast_stop_options{.limit = milliseconds(3'000)}, called<atv12::device>{unit}};
    CHECK_FALSE(it.turns(all, milliseconds(10'000)));
    CHECK(all.reason(0).is_other_stop);
}
