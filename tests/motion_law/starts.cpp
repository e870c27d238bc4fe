// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Starts and changes of the reference, cut between any two frames: the motor never turns otherwise than was asked
// before or is asked now.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/one_in.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using test::cut_after;
using test::plant;
using state = cia402::state;
using bytes = test::frame_bytes;

TEST_CASE("motion law: S17 a start that is cut after any frame turns the motor no other way, and no faster")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const only_answers : {false, true}) {
            for (bool const by_bit : {false, true}) {
                for (std::int32_t const before : {0, 10, -10}) {
                    bool goes_on = true;
                    for (unsigned frames = 0; goes_on; frames += test::one_in(5)) {
                        plant<Device> it;
                        if (before != 0) {
                            it.turn(before, by_bit);
                        }
                        std::int32_t lowest = 0;
                        std::int32_t highest = 0;
                        goes_on = cut_after(it, start{it.drive, 50_Hz}, frames, only_answers, lowest, highest);
                        CHECK(lowest >= std::min(before, 0) * 1'000);
                        CHECK(highest <= 50'000);
                        goes_on = cut_after(it, start{it.drive, 30_Hz, run_direction::reverse}, frames, only_answers,
                                            lowest, highest) or
                                  goes_on;
                        CHECK(lowest >= -30'000);
                        CHECK(highest <= 50'000);
                        goes_on = goes_on and frames < 30;
                    }
                }
            }
        }
    });
}

TEST_CASE("motion law: S17 a drive that runs in reverse by its direction bit turns round by one signed reference")
{
    test::all_drives::for_each([]<typename Device>() {
        plant<Device> it;
        it.turn(-10, true);
        start go{it.drive, 50_Hz};
        REQUIRE(it.run(go));
        CHECK(go.succeeded());
        it.idle(milliseconds(5'000));
        CHECK(it.millihertz() == 50'000);
        change_reference back{it.drive, -20_Hz};
        REQUIRE(it.run(back));
        CHECK(back.succeeded());
        CHECK(it.millihertz() == -20'000);
    });
}

TEST_CASE("motion law: S22 a drive that is switched off and on while a start climbs does not run")
{
    test::all_drives::for_each([]<typename Device>() {
        unsigned ran_before = 0;
        for (unsigned moment = 0; moment < 400; moment += 3) {
            plant<Device> it;
            start go{it.drive, 50_Hz};
            instant const off = it.now() + milliseconds(moment);
            bool was_off = false;
            bool ran = false;
            while (not go.settled()) {
                it.step([&](instant now) { it.link().converse(go, now); }, milliseconds(1));
                if (not was_off and reached(it.now(), off)) {
                    was_off = true;
                    ran = it.far().state_machine().state() == state::operation_enabled;
                    it.far().power_cycle(it.now());
                }
            }
            it.idle(milliseconds(500));
            ran_before += ran ? 1 : 0;
            // Whoever was switched off before the first command is an ordinary drive.
            if (was_off and not go.succeeded()) {
                CHECK(it.far().state_machine().state() != state::operation_enabled);
            }
            if (was_off and ran) {
                CHECK(it.far().state_machine().state() != state::operation_enabled);
            }
        }
        CHECK(ran_before > 0);
    });
}

TEST_CASE("motion law: S24 a reference is reached when the drive runs and says so, not before")
{
    test::all_drives::for_each([]<typename Device>() {
        plant<Device> it;
        start go{it.drive, 30_Hz};
        REQUIRE(it.run(go));
        it.idle(milliseconds(5'000));
        REQUIRE(it.millihertz() == 30'000);
        change_reference faster{it.drive, 45_Hz};
        REQUIRE(it.run(faster));
        CHECK(faster.succeeded());
        CHECK(it.millihertz() == 45'000);

        if constexpr (Device::layout.halt != 0) {
            stop halt{it.drive, stop_by::halt};
            REQUIRE(it.run(halt));
            REQUIRE(halt.succeeded());
            change_reference standing{it.drive, 20_Hz};
            REQUIRE(it.run(standing));
            CHECK(standing.reason().kind == outcome_kind::halted);
            CHECK(it.millihertz() == 0);
        }
    });
}

TEST_CASE("motion law: S24 bit 10 that is still the old reference's is not believed")
{
    plant<atv320::device> it;
    start go{it.drive, 30_Hz};
    REQUIRE(it.run(go));
    it.idle(milliseconds(5'000));
    change_reference back{it.drive, -30_Hz};
    unsigned old_ones = 0;
    it.disturb([&](bytes& frame, bool is_request) {
        // The status word says "reached" for as long as the motor still turns the other way round.
        bool const is_word = not is_request and frame[1] == std::byte{3} and it.millihertz() > 0;
        if (is_word and (frame[4] & std::byte{0x3F}) == std::byte{0x37}) {
            ++old_ones;
            frame = {frame[0], frame[1], frame[2], frame[3] | std::byte{0x04}, frame[4]};
            std::uint16_t const crc = crc16(frame);
            frame.push_back(to_byte(crc));
            frame.push_back(to_byte(crc >> 8U));
        }
    });
    REQUIRE(it.run(back));
    CHECK(old_ones > 3);
    CHECK(back.succeeded());
    CHECK(it.millihertz() == -30'000);
}

TEST_CASE("motion law: S27 a negative reference and reverse at once are refused, and nothing is said to the drive")
{
    plant<atv320::device> it;
    std::size_t const before = it.requests();
    start go{it.drive, -50_Hz, run_direction::reverse};
    REQUIRE(it.run(go));
    CHECK(go.reason().kind == outcome_kind::contradictory);
    CHECK(it.requests() == before);
}

TEST_CASE("motion law: S32 60 Hz under a limit of 50 Hz is limited, never reached")
{
    test::all_drives::for_each([]<typename Device>() {
        plant<Device> it;
        start go{it.drive, 30_Hz};
        REQUIRE(it.run(go));
        it.idle(milliseconds(5'000));
        change_reference over{it.drive, 60_Hz, milliseconds(30'000), beyond_limits::limit};
        REQUIRE(it.run(over));
        CHECK(over.reason().kind == outcome_kind::reference_limited);
        CHECK(it.millihertz() <= 50'000);
        start again{it.drive, 60_Hz, run_direction::forward, milliseconds(3'000), {.beyond = beyond_limits::limit}};
        REQUIRE(it.run(again));
        CHECK(again.reason().kind == outcome_kind::reference_limited);
    });
}
