// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An order and a set-up of the same drive at once, at each moment of each other: no word goes whose meaning was changed,
// and no motor loses its power to a set-up.
#include "support/catch.hpp"
#include "support/commissioned.hpp"
#include "support/remembered.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>
#include <vector>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>
#include <rtuwire/altivar/procedure/commissioning/release_link.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(200), .retries = 1};
constexpr std::uint16_t cmd = atv320::device::layout.cmd, chcf = 8401, lfr = 8502, io = 3;

/// One drive on a bus, and what was written to it.
template <typename Device> struct hall : test::simulated_bus<bus<4>, Device> {
    using base = test::simulated_bus<bus<4>, Device>;
    station<Device> press{unit_id{3}};
    bool is_io{false};      ///< each bit of the control word is an input of its own
    bool runs_as_io{false}; ///< and one of them was set

    explicit hall(unsigned between_ms) : base{bus<4>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->link().set(
            0, {.with = {.response_timeout = milliseconds(200), .retries = 1}, .least_idle = milliseconds(between_ms)});
        this->idle(milliseconds(50));
        this->disturb([this](std::vector<std::byte>& frame, bool is_request) {
            if (not is_request and frame.size() == 8 and frame[1] == std::byte{6}) {
                note(u16_at(frame, 2), u16_at(frame, 4));
            }
        });
    }
    void note(std::uint16_t address, std::uint16_t word)
    {
        is_io = is_io or (address == chcf and word == io);
        runs_as_io = runs_as_io or (is_io and address == cmd and (word & 3U) != 0);
    }
    bool has_power() { return cia402::has_power(this->drive().state_machine().state()); }

    /// The set-up begins so long after the order; both to their ends, and what a motor does afterwards.
    template <typename Order, typename Arrangement> void run(Order& order, Arrangement& other, std::uint32_t after_ms)
    {
        auto const alone = [&](instant at) { this->link().converse(0, order, at); };
        auto const both = [&](instant at) {
            alone(at);
            this->link().converse(1, other, at);
        };
        base::run(
            alone, [] { return false; }, milliseconds(after_ms));
        REQUIRE(base::run(
            both, [&] { return order.settled() and other.settled(); }, milliseconds(60'000)));
    }
};

} // namespace

TEST_CASE("motion law: L10 no word to run goes behind a set-up that gives the words another meaning")
{
    unsigned running = 0, set = 0;
    for (unsigned const between_ms : {0U, 100U, 300U}) {
        for (std::uint32_t after_ms = 0; after_ms < 2'500; after_ms += 10) {
            INFO("order at each " << between_ms << " ms, set up after " << after_ms << " ms");
            hall<atv320::device> it{between_ms};
            register_block const backwards{std::uint16_t{0xFE0C}}; // -50 Hz, from before
            REQUIRE(it.drive().write(lfr, backwards) == errc::none);
            start go{it.press, 30_Hz, run_direction::forward, milliseconds(8'000)};
            test::remembered<set_channel> by_bits{
                it.press, channel_settings<atv320::device>{}.with<atv320::chcf>(atv320::channel_mode::io)};
            it.run(go, by_bits, after_ms);
            CHECK_FALSE(it.runs_as_io);
            CHECK_FALSE((by_bits.succeeded() and it.has_power()));
            CHECK(go.running() == it.has_power()); // done means that it runs, whatever was set up meanwhile
            running += go.running() ? 1U : 0U;
            set += by_bits.succeeded() ? 1U : 0U;
        }
    }
    CHECK(running > 50);
    CHECK(set > 50);
}

TEST_CASE("motion law: L10 a motor that was started by direct control does not lose its power to a released link")
{
    for (unsigned const between_ms : {0U, 100U}) {
        for (std::uint32_t after_ms = 0; after_ms < 1'500; after_ms += 10) {
            INFO("order at each " << between_ms << " ms, released after " << after_ms << " ms");
            hall<atv28::device> it{between_ms};
            test::remembered<atv28::direct_start> go{it.press, 30_Hz};
            atv28::release_link give{it.press};
            it.run(go, give, after_ms);
            CHECK(go.succeeded() == it.has_power());
        }
    }
}

TEST_CASE("motion law: L10 a motor that was ordered to run between two words of a set-up does not lose its power to it")
{
    unsigned running = 0, behind_the_first = 0;
    for (unsigned const between_ms : {100U, 300U}) {
        for (std::uint32_t after_ms = 0; after_ms < 4'000; after_ms += 20) {
            INFO("set up at each " << between_ms << " ms, order after " << after_ms << " ms");
            hall<atv320::device> it{between_ms};
            it.link().set(1, {.with = {.response_timeout = milliseconds(200), .retries = 1},
                              .least_idle = milliseconds(between_ms)});
            it.link().set(0, {.with = {.response_timeout = milliseconds(200), .retries = 1}});
            constexpr auto both = channel_settings<atv320::device>{}
                                      .with<atv320::chcf>(atv320::channel_mode::sep)
                                      .with<atv320::flo>(count16{131});
            set_channel slow{it.press, both};
            start go{it.press, 30_Hz, run_direction::forward, milliseconds(3'000), test::commissioned()};
            auto const alone = [&](instant at) { it.link().converse(1, slow, at); };
            auto const together = [&](instant at) {
                alone(at);
                it.link().converse(0, go, at);
            };
            it.test::simulated_bus<bus<4>, atv320::device>::run(
                alone, [] { return false; }, milliseconds(after_ms));
            REQUIRE(it.test::simulated_bus<bus<4>, atv320::device>::run(
                together, [&] { return go.settled() and slow.settled(); }, milliseconds(60'000)));
            CHECK(go.running() == it.has_power());
            CHECK(slow.reason().kind != outcome_kind::started_by_terminals);
            running += go.running() ? 1U : 0U;
            behind_the_first += go.running() and slow.written() != 0 and not slow.succeeded() ? 1U : 0U;
        }
    }
    CHECK(running > 100);
    CHECK(behind_the_first > 20);
}
