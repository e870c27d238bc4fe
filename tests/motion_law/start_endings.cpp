// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How a start ends that fails behind its command to run: it has time to bring the motor to rest, and does it on the ramp.
#include "support/catch.hpp"
#include "support/commissioned.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>
#include <vector>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/core/crc16.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using device = atv320::device;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 0};
constexpr station<device> press{unit_id{3}};
constexpr std::uint16_t cmd = device::layout.cmd;

/// A drive and its client, and the control words that were said.
struct hall : test::simulated_bus<drive_client<>, device> {
    std::vector<std::uint16_t> words{};

    hall() : test::simulated_bus<drive_client<>, device>{drive_client<>{test::bus_timing, patient}}
    {
        add(press.unit());
        idle(milliseconds(20));
    }
    void note(std::vector<std::byte> const& frame)
    {
        if (frame[1] == std::byte{6} and u16_at(frame, 2) == cmd) {
            words.push_back(u16_at(frame, 4));
        }
    }
    static void refuse(std::vector<std::byte>& frame)
    {
        frame = {frame[0], frame[1] | std::byte{0x80}, std::byte{6}};
        std::uint16_t const crc = crc16(frame);
        frame.push_back(to_byte(crc));
        frame.push_back(to_byte(crc >> 8U));
    }
};

} // namespace

TEST_CASE("motion law: L9 a start that takes back what it gave is not cut short by its limit")
{
    constexpr duration limit = milliseconds(3'000);
    hall it;
    start first{press, 50_Hz};
    REQUIRE(it.run(first));
    it.idle(milliseconds(5'000));
    // The look behind the command to run is refused once; from there the motor comes down on a ramp of 3 s.
    bool was_refused = false;
    it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
        if (is_request) {
            it.note(frame);
        } else if (not it.words.empty() and frame[1] == std::byte{3} and not was_refused) {
            was_refused = true;
            hall::refuse(frame);
        }
    });
    instant const begun = it.now();
    start next{press, 40_Hz, run_direction::forward, limit, test::commissioned()};
    REQUIRE(it.run(next));
    REQUIRE(was_refused);
    CHECK_FALSE(next.running());
    CHECK(it.now() - begun > limit);
    CHECK(it.drive().motor().frequency() == 0);
    CHECK(it.drive().state_machine().state() == cia402::state::switch_on_disabled);
}

TEST_CASE("motion law: L9 a motor that may run loses its power where its command was not answered: its unit is lost")
{
    hall it;
    bool is_told = false;
    it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
        if (is_request) {
            it.note(frame);
            is_told = is_told or (not it.words.empty() and it.words.back() == 0x000F);
        } else if (is_told) {
            frame.clear();
        }
    });
    start go{press, 50_Hz, run_direction::forward, milliseconds(3'000), test::commissioned()};
    REQUIRE(it.run(go));
    REQUIRE(it.words.size() > 3);
    CHECK(it.words[2] == 0x000F);
    CHECK(it.words[3] == 0x0000); // what was read of its words holds no longer
    CHECK(go.reason().is_other_stop);
}

TEST_CASE("motion law: L8 a drive that shows later that it runs is not told to stop by its own start")
{
    hall it;
    int late_looks = 2;
    it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
        if (is_request) {
            return it.note(frame);
        }
        bool const is_told = not it.words.empty() and it.words.back() == 0x000F;
        bool const is_look = u16_at(it.request(), 2) == device::layout.eta;
        if (is_told and is_look and late_looks-- > 0) { // still "switched on"
            frame = {frame[0], frame[1], std::byte{2}, std::byte{2}, std::byte{0x33}};
            std::uint16_t const crc = crc16(frame);
            frame.push_back(to_byte(crc));
            frame.push_back(to_byte(crc >> 8U));
        }
    });
    start go{press, 50_Hz, run_direction::forward, milliseconds(3'000), test::commissioned()};
    REQUIRE(it.run(go));
    CHECK(go.running());
    CHECK(it.link().motor_orders().is_ordered(press.unit().byte())); // a loss would stop it
    CHECK(it.words == std::vector<std::uint16_t>{0x0006, 0x0007, 0x000F});
}
