// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client behind a USB adapter: as fast as one that waits for no silence where the line is faster than the adapter, and as
// patient as ever where it is not.
#include "../../bench/hosts/adapter_port.hpp"

#include "support/catch.hpp"

using namespace rtuwire;
using namespace rtuwire::bench;

namespace {

constexpr unsigned transactions = 100;

/// Hands each row of the table to `look`.
template <typename Look> void each_row(std::initializer_list<std::uint32_t> rates, Look look)
{
    for (std::uint32_t const rate : rates) {
        for (unsigned const latency : {16U, 4U, 1U}) {
            for (auto const timer : {sim::usb_timer::from_first_byte, sim::usb_timer::from_last_packet}) {
                for (unsigned const registers : {1U, 4U, 28U, 29U, 63U, 125U}) { // 28: 61 bytes, 29: 63
                    for (unsigned const takes : {0U, 300U, 2'000U}) {
                        INFO(rate << " bit/s, " << latency << " ms, timer " << unsigned(timer) << ", " << registers
                                  << " registers, a unit that takes " << takes << " us");
                        look(adapter_setting{rate, milliseconds(latency), timer, static_cast<std::uint16_t>(registers),
                                             microseconds(takes)});
                    }
                }
            }
        }
    }
}

} // namespace

TEST_CASE("behind a USB adapter a client that is told nothing is as fast as one that waits for no silence")
{
    each_row({57'600, 115'200, 1'000'000}, [](adapter_setting const& how) {
        adapter_port ours{how};
        adapter_port ideal{how};
        double const own = by_rtuwire(ours, how, transactions, ours.timing());
        REQUIRE(own > 0);
        CHECK(own <= 1.05 * by_ideal(ideal, how, transactions));
    });
}

TEST_CASE("behind a USB adapter a client lets its line rest for t3.5 up to 38 400 bit/s")
{
    each_row({9'600, 19'200, 38'400}, [](adapter_setting const& how) {
        adapter_port port{how};
        REQUIRE(by_rtuwire(port, how, 20, port.timing()) > 0);
        CHECK(port.shortest_rest() >= port.timing().t3_5());
    });
}

TEST_CASE("a client that is given other times than the port's keeps them")
{
    adapter_setting const how{115'200, milliseconds(1), sim::usb_timer::from_last_packet, 4};
    adapter_port port{how};
    line_timing const told = line_timing::host(115'200, character_format::even_8_1);
    REQUIRE(by_rtuwire(port, how, transactions, told) > 0);
    CHECK(port.shortest_rest() >= told.t3_5());
    adapter_port by_rate{how};
    REQUIRE(by_rtuwire(by_rate, how, transactions, told.with_silence(microseconds(500))) > 0);
    CHECK(by_rate.shortest_rest() >= microseconds(500));
    CHECK(by_rate.shortest_rest() < told.t3_5());
}

TEST_CASE("a client that is given no times takes those of its port")
{
    adapter_setting const how{115'200, milliseconds(4), sim::usb_timer::from_first_byte, 4};
    adapter_port told{how};
    adapter_port untold{how};
    double const expected = by_rtuwire(told, how, 1, told.timing());
    blocking_client line{untold};
    instant const begin = untold.now();
    REQUIRE(line.ask(untold.unit, read_holding_registers{.start = 0, .count = 4}));
    CHECK(double((untold.now() - begin).microseconds) == expected);
    blocking_client impatient{untold, {.response_timeout = milliseconds(1), .retries = 0}};
    CHECK(impatient.ask(untold.unit, read_holding_registers{.start = 0, .count = 1}).error() == errc::timed_out);
}
