// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// D28: a program that was not scheduled for longer than the drive's time-out has lost its drive, whatever the drive did
// meanwhile: nothing but a new order makes the motor run on.
#include "defect/long_pauses.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/one_in.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/sim/bench.hpp>
#include <rtuwire/sim/drive/unit.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr unit_id address{3};

/// A program with a cycle, and its drive; both in virtual time of 64 bits. What the drive responds while the program does
/// not run lies in its receiver.
template <typename Device> struct sleeper {
    std::uint64_t time{0xFFFF'FFFFU - 9'000'000U};
    sim::unit<Device> unit{address, timing, instant{static_cast<std::uint32_t>(time)}};
    drive_client<2> link{timing, {.response_timeout = milliseconds(100), .retries = 1}};
    cyclic<Device> loop;
    std::vector<std::byte> received{};
    std::uint16_t last_address{0}; ///< of the last request
    std::uint32_t behind{0};       ///< the program's clock

    explicit sleeper(supervision_risks const& risks, duration period = milliseconds(100))
        : loop{station<Device>{address}, cyclic_options{.period = period,
                                                        .supervision = {.risks = risks},
                                                        .enable_timeout = milliseconds(100'000)}}
    {
        sleep(100'000);
    }
    instant now() const { return instant{static_cast<std::uint32_t>(time)}; }
    instant clock() const { return now() - microseconds(behind); }

    void let_drive_live()
    {
        unit.advance(now());
        if (byte_view const frame = unit.poll_transmit(); not frame.empty()) {
            received.insert(received.end(), frame.begin(), frame.end());
            time += timing.characters(frame.size()).microseconds;
            unit.sent(now());
        }
    }
    void sleep(std::uint64_t length)
    {
        std::uint64_t const end = time + length;
        while (time < end) {
            time = std::min(end, time + (length > 60'000'000 ? 1'000'000U : 1'000U));
            let_drive_live();
        }
    }
    void work(std::uint64_t length)
    {
        for (std::uint64_t const end = time + length; time < end; time += 1'000) {
            let_drive_live();
            if (not received.empty()) {
                link.receive(received, clock());
                received.clear();
            }
            link.advance(clock());
            link.converse(loop, clock());
            byte_view const frame = link.poll_transmit();
            if (not frame.empty()) {
                last_address = u16_at(frame, 2);
                unit.receive(frame, now());
                time += timing.characters(frame.size()).microseconds;
                link.sent(clock());
            }
        }
    }
    bool order()
    {
        if constexpr (cycle_layout<Device>::has_scanner) {
            return loop.run(900_rpm);
        } else {
            return loop.run(30_Hz);
        }
    }
    std::int32_t speed() { return std::abs(unit.drive().motor().frequency()); }
    bool has_power() { return cia402::has_power(unit.drive().state_machine().state()); }
    void set(std::uint16_t reg, std::uint16_t word)
    {
        if (reg != 0) {
            register_block<1> const value{word};
            unit.drive().write(reg, value);
        }
    }
};

/// The drive's reaction to a lost link, and what its user accepts for it.
struct reaction {
    std::uint16_t sll;
    std::uint64_t shortest_pause; ///< longer than the time-out of such a drive, 1 s, or the longest of any drive
    supervision_risks risks{};
};
constexpr reaction reactions[]{{1, 1'200'000},
                               {2, 1'200'000},
                               {6, 1'200'000},
                               {4, 1'200'000, {.accept_running_on = true}},
                               {5, 1'200'000, {.accept_running_on = true}},
                               {0, 30'200'000, {.accept_unsupervised = true}}};

template <typename Device> void sleeps(reaction const& how, std::uint64_t pause, std::uint64_t after)
{
    sleeper<Device> it{how.risks};
    safeguard_layout const& at = Device::layout.safeguards;
    it.set(at.sll, how.sll);
    it.set(at.tto, 10);
    if (at.nto != 0 and how.sll == 0) {
        it.set(Device::layout.cmi, at.nto);
    }
    it.work(600'000);
    REQUIRE(it.order());
    it.work(5'000'000 + after);
    REQUIRE(it.speed() == 30'000);
    it.sleep(pause);
    std::int32_t most = it.speed();
    bool has_sped_up = false;
    bool was_ordered = false;
    for (unsigned i = 0; i < 800; ++i) {
        it.work(10'000);
        has_sped_up = has_sped_up or it.speed() > most;
        most = it.speed();
        was_ordered = was_ordered or it.loop.control().is_ordered();
    }
    CHECK_FALSE(has_sped_up);
    CHECK_FALSE(was_ordered);
    CHECK_FALSE(it.has_power());
    CHECK(it.loop.control().reason().kind == outcome_kind::silent);
}

} // namespace

TEST_CASE("defect: D28 a program that slept longer than the drive's time-out has no order left, whatever SLL")
{
    test::all_drives::for_each([]<typename Device>() {
        constexpr bool has_sll = Device::layout.safeguards.sll != 0;
        for (reaction const& each : reactions) {
            if (not has_sll and each.sll > 1) {
                continue;
            }
            INFO("SLL " << each.sll);
            std::uint64_t const shortest = has_sll or each.sll == 0 ? each.shortest_pause : 7'200'000;
            // The program falls asleep between two exchanges, while one is under way, and with the response in its receiver.
            for (std::uint64_t after = 0; after < 130'000; after += 11'000 * test::one_in(5)) {
                INFO("after " << after << " us");
                sleeps<Device>(each, shortest, after);
            }
            for (std::uint64_t const pause : test::long_pauses) {
                INFO("for " << pause / test::minute << " minutes");
                sleeps<Device>(each, pause, 0);
                sleeps<Device>(each, pause, 33'000);
            }
        }
    });
}

TEST_CASE("defect: D28 a shorter sleep, and a clock that is a little behind, lose nothing")
{
    test::all_drives::for_each([]<typename Device>() {
        sleeper<Device> it{{}};
        it.work(600'000);
        REQUIRE(it.order());
        it.work(5'000'000);
        for (std::uint64_t after = 0; after < 130'000; after += 11'000) {
            it.work(after);
            it.sleep(5'000'000); // of 7 s, or 10 s as delivered
            it.work(500'000);
            REQUIRE(it.loop.control().is_ordered());
            it.behind = 40'000 - it.behind;
            it.work(500'000);
            REQUIRE(it.loop.control().is_ordered());
            REQUIRE(it.speed() == 30'000);
        }
    });
}

namespace {

/// A cycle without an order slept; an order that it gets before it runs again rests on what was read before.
template <typename Device> void stands(std::uint64_t pause, bool is_early)
{
    sleeper<Device> it{{}};
    it.work(650'000);
    it.sleep(pause);
    if (is_early) {
        CHECK(it.order());
    }
    it.work(2'000);
    CHECK(it.last_address == (is_early ? Device::layout.cmd : Device::layout.eta));
    CHECK_FALSE(it.loop.control().is_ordered());
    CHECK_FALSE(it.order());
    it.work(2'000'000);
    CHECK_FALSE(it.has_power());
}

} // namespace

TEST_CASE("defect: D28 a drive that stood is checked anew before it gets an order")
{
    test::all_drives::for_each([]<typename Device>() {
        for (std::uint64_t const pause : test::long_pauses) {
            INFO("for " << pause / test::minute << " minutes");
            stands<Device>(pause, false);
            stands<Device>(pause, true);
        }
    });
}

TEST_CASE("defect: D28 a cycle with a long period does not lose a drive without a time-out by it")
{
    test::all_drives::for_each([]<typename Device>() {
        sleeper<Device> it{{.accept_unsupervised = true}, milliseconds(60'000)};
        safeguard_layout const& at = Device::layout.safeguards;
        it.set(at.sll, 0);
        if (at.nto != 0) {
            it.set(Device::layout.cmi, at.nto);
        }
        it.work(600'000);
        REQUIRE(it.order());
        it.work(120'000'000);
        CHECK(it.loop.control().is_ordered());
        CHECK(it.speed() == 30'000);
    });
}

TEST_CASE("defect: D24 an order given before the first visit after a pause has all its time to be followed")
{
    test::all_drives::for_each([]<typename Device>() {
        for (unsigned const seconds : {0U, 2U, 4U}) {
            INFO(seconds << " s");
            sim::bench it{bus<1>{timing}, station<Device>{address}};
            cyclic<Device> loop{station<Device>{address}, {.enable_timeout = milliseconds(1'500)}};
            it.run_until([&] { return not loop.link_lost(); }, milliseconds(5'000), loop);
            it.run_for(milliseconds(1'000), loop);
            it.run_for(milliseconds(1'000 * seconds));
            bool is_taken = false;
            if constexpr (cycle_layout<Device>::has_scanner) {
                is_taken = loop.run(900_rpm);
            } else {
                is_taken = loop.run(30_Hz);
            }
            REQUIRE(is_taken);
            it.run_for(milliseconds(1'000), loop);
            CHECK(loop.control().is_ordered());
            CHECK(loop.control().is_running());
        }
    });
}
