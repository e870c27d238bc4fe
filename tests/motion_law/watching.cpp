// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Watching is not commanding: beside another master a watch writes nothing and changes nothing, and tells what is.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/inspection/watch.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/sim/bench.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

template <typename Device> struct watched : test::simulated_bus<client, Device> {
    static constexpr station<Device> drive{unit_id{3}};
    watch<Device> eye{drive, {.period = milliseconds(100)}};
    unsigned requests{0};
    unsigned writes{0};

    watched() : test::simulated_bus<client, Device>{client{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
        this->disturb([this](std::vector<std::byte>& frame, bool is_request) {
            requests += is_request ? 1U : 0U;
            writes += is_request and frame[1] != std::byte{3} ? 1U : 0U;
        });
    }
    detail::simulated_drive<Device>& far() { return this->unit(0).drive(); }

    /// Another master's word, which does not pass this client.
    void other_master(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        REQUIRE(far().check_write(address, value) == errc::none);
        static_cast<void>(far().write(address, value));
    }
    void run_by_other_master(std::int16_t tenths)
    {
        other_master(Device::frequency_reference.address, static_cast<std::uint16_t>(tenths));
        for (std::uint16_t const word : std::array<std::uint16_t, 3>{0x0006, 0x0007, 0x000F}) {
            other_master(Device::layout.cmd, word);
        }
    }
    void look_for(duration length)
    {
        static_cast<void>(
            this->run([this](instant now) { this->link().converse(eye, now); }, [] { return false; }, length));
    }
};

} // namespace

TEST_CASE("defect: D24 a watch has lost its link, too, where another conversation's miss silences its unit")
{
    // What the watch says may be older than its rounds allow by one read's time and no more.
    constexpr duration limit = milliseconds(4'100);
    test::all_drives::for_each([limit]<typename Device>() {
        for (bool const is_paused : {false, true}) {
            INFO("the client " << (is_paused ? "pauses for an hour" : "goes on"));
            sim::bench it{bus<2>{test::bus_timing, {.response_timeout = milliseconds(300), .retries = 0}},
                          station<Device>{unit_id{3}}};
            start go{station<Device>{unit_id{3}}, 40_Hz};
            watch<Device> eye{station<Device>{unit_id{3}}};
            word_read other{unit_id{3}, Device::layout.rfr};
            while (not go.settled()) {
                it.pass(go, eye);
            }
            auto const look_for = [&](duration length) {
                for (instant const end = it.now() + length; not reached(it.now(), end);) {
                    if (other.settled()) {
                        other.again();
                    }
                    it.pass(other, eye);
                    if (eye.link_lost()) {
                        return;
                    }
                }
            };
            look_for(milliseconds(10'000));
            REQUIRE(go.running());
            REQUIRE_FALSE(eye.link_lost());
            it.cut();
            instant const cut = it.now();
            if (is_paused) {
                it.run_for(milliseconds(30 * 60 * 1'000));
                it.run_for(milliseconds(30 * 60 * 1'000));
                it.pass(other, eye);
            } else {
                look_for(milliseconds(60'000));
                CHECK(it.now() - cut < limit);
            }
            CHECK(eye.link_lost());
            it.cut(false);
            for (unsigned i = 0; i < 60'000 and eye.link_lost(); ++i) {
                it.pass(other, eye);
                it.run_for(milliseconds(1));
            }
            CHECK_FALSE(eye.link_lost());
            CHECK(eye.state() != state::operation_enabled);
        }
    });
}

TEST_CASE("motion law: S21 watching writes nothing")
{
    test::all_drives::for_each([]<typename Device>() {
        watched<Device> it;
        it.run_by_other_master(-250);
        it.look_for(milliseconds(5'000));
        std::uint32_t const taken = it.far().state_machine().taken();
        std::uint16_t const reference = it.far().word("LFR");
        unsigned changes = 0;
        // The other master keeps its word up; the watch looks between, for 20 s.
        for (unsigned i = 0; i < 200; ++i) {
            it.other_master(Device::layout.cmd, 0x000F);
            it.look_for(milliseconds(100));
            changes += it.far().state_machine().state() != state::operation_enabled ? 1U : 0U;
        }
        CHECK(it.writes == 0);
        CHECK(changes == 0);
        CHECK(it.far().state_machine().taken() == taken);
        CHECK(it.far().word("LFR") == reference);
        CHECK(it.far().motor().frequency() == -25'000);
        CHECK(it.requests > 200);
        CHECK(it.eye.state() == state::operation_enabled);
        CHECK(it.eye.frequency() == signed_decihertz{-250});
        CHECK(it.eye.fault() == 0);
        CHECK_FALSE(it.eye.link_lost());
        CHECK(it.eye.rounds() > 100);
        CHECK(it.eye.error() == errc::none);
    });
}

TEST_CASE("a watch tells of a fault, and keeps what it saw while the line is cut")
{
    test::all_drives::for_each([]<typename Device>() {
        watched<Device> it;
        CHECK(it.eye.link_lost());
        CHECK(it.eye.state() == state::unknown);
        CHECK(it.eye.error() == errc::busy);
        it.run_by_other_master(250);
        it.look_for(milliseconds(5'000));
        CHECK(it.eye.frequency() == signed_decihertz{250});
        it.far().inject_fault(9);
        it.look_for(milliseconds(5'000));
        CHECK(it.eye.state() == state::fault);
        CHECK(it.eye.fault() == 9);
        CHECK(it.eye.frequency() == signed_decihertz{0});
        it.far().clear_cause();
        it.other_master(Device::layout.cmd, 0x0000);
        it.other_master(Device::layout.cmd, 0x0080);
        it.look_for(milliseconds(1'000));
        CHECK(it.eye.fault() == 0);
        std::uint32_t const rounds = it.eye.rounds();
        it.cut(0, true);
        it.look_for(milliseconds(10'000));
        CHECK(it.eye.link_lost());
        CHECK(it.eye.error() == errc::timed_out);
        CHECK(it.eye.rounds() == rounds);
        CHECK(it.eye.state() == state::switch_on_disabled);
        it.cut(0, false);
        it.look_for(milliseconds(60'000));
        CHECK_FALSE(it.eye.link_lost());
        CHECK(it.writes == 0);
    });
}

TEST_CASE("a watch asks two requests a period, and no more")
{
    watched<atv320::device> it;
    it.look_for(milliseconds(100)); // the first round
    it.requests = 0;
    it.look_for(milliseconds(10'000));
    // A period begins where the round before it ended: about 25 ms for two exchanges.
    CHECK(it.requests <= 200);
    CHECK(it.requests >= 140);
}

namespace {

/// A watch by hand.
template <typename Device> struct by_hand {
    watch<Device> eye{station<Device>{unit_id{3}}};
    instant now{0xFFFF'0000U};

    /// A round whose two responses hold these words.
    void hear(std::vector<std::uint16_t> const& first, std::vector<std::uint16_t> const& second)
    {
        wait();
        for (auto const& words : {first, second}) {
            REQUIRE(eye.next());
            std::vector<std::byte> pdu{std::byte{3}, to_byte(static_cast<unsigned>(2 * words.size()))};
            for (std::uint16_t const word : words) {
                pdu.push_back(to_byte(word >> 8U));
                pdu.push_back(to_byte(word));
            }
            eye.accept(response{pdu});
        }
    }
    void miss(unsigned rounds)
    {
        for (unsigned i = 0; i < rounds; ++i) {
            wait();
            REQUIRE(eye.next());
            eye.accept(errc::timed_out);
        }
    }
    void wait()
    {
        now = now + milliseconds(500);
        eye.advance(now);
    }
};

} // namespace

TEST_CASE("a watch bears one round that fails, and none that fails behind it")
{
    by_hand<atv320::device> it;
    CHECK_FALSE(it.eye.next());
    CHECK_FALSE(it.eye.poll_deadline());
    it.eye.advance(it.now);
    CHECK(it.eye.next());
    CHECK_FALSE(it.eye.poll_deadline());
    it.hear({0x0237, 250}, {0});
    CHECK(it.eye.poll_deadline() == it.now + milliseconds(500));
    CHECK_FALSE(it.eye.next());
    it.eye.advance(it.now + microseconds(499'999));
    CHECK_FALSE(it.eye.next());
    CHECK(it.eye.rounds() == 1);
    CHECK_FALSE(it.eye.link_lost());
    for (unsigned i = 0; i < 2; ++i) {
        it.miss(1);
        CHECK_FALSE(it.eye.link_lost());
        CHECK(it.eye.error() == errc::timed_out);
        it.miss(1);
        CHECK(it.eye.link_lost());
        it.miss(300);
        CHECK(it.eye.link_lost());
        it.hear({0x0237, 250}, {0});
        CHECK_FALSE(it.eye.link_lost());
        CHECK(it.eye.error() == errc::none);
        CHECK(it.eye.rounds() == 2 + i);
    }
}

TEST_CASE("a watch tells a tenth of a hertz in reverse, of a drive that shows sizes as well")
{
    by_hand<atv28::device> it;
    it.hear({5, 0x8227}, {1});
    CHECK(it.eye.frequency() == signed_decihertz{-1});
    CHECK(it.eye.last_fault() == 5);
    CHECK(it.eye.fault() == 0);
    it.hear({5, 0x0227}, {1});
    CHECK(it.eye.frequency() == signed_decihertz{1});
}

TEST_CASE("a watch takes no response of another length")
{
    watch<atv320::device> eye{station<atv320::device>{unit_id{3}}};
    eye.advance(instant{0});
    REQUIRE(eye.next());
    std::array<std::byte, 4> const short_pdu{std::byte{3}, std::byte{2}, std::byte{2}, std::byte{0x37}};
    eye.accept(response{short_pdu});
    CHECK(eye.error() == errc::wrong_length);
    CHECK(eye.state() == state::unknown);
    CHECK(eye.rounds() == 0);
    CHECK_FALSE(eye.next());
    CHECK(eye.poll_deadline() == instant{500'000});
}
