// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Who commands a simulated drive, what a lost link and a halt do, by the settings that say so.
#include "support/drive_bench.hpp"
#include "support/drives.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;
using test::drive_bench;

namespace {

constexpr std::uint16_t sll = 7010, chcf = 8401, fr1 = 8413, cd1 = 8423, flo = 8431, stt = 11201, tto = 6005,
                        lsp = 3105;

/// A drive whose channels are set so, its analog input at 10 Hz, after somebody ordered 20 Hz over the line.
template <typename Device> struct channel_trial {
    drive_bench<Device> it;

    channel_trial(std::uint16_t mode, std::uint16_t reference, std::uint16_t command)
    {
        it.drive().set_analog_reference(10'000);
        REQUIRE(it.tell(chcf, mode) == errc::none);
        REQUIRE(it.tell(fr1, reference) == errc::none);
        REQUIRE(it.tell(cd1, command) == errc::none);
        it.run(200);
    }
    std::int32_t frequency() const { return it.frequency(); }
    bool is_remote() const { return (it.eta() & 0x0200) != 0; }
};

template <typename Device> void channels_count()
{
    using trial = channel_trial<Device>;
    // Together: the reference's channel commands, whatever CD1 says.
    CHECK(trial(1, 164, 10).frequency() == 20'000);
    CHECK(trial(1, 164, 1).frequency() == 20'000);
    CHECK(trial(1, 1, 10).frequency() == 0);
    CHECK(not trial(1, 1, 10).is_remote());
    // Apart.
    CHECK(trial(2, 164, 10).frequency() == 20'000);
    CHECK(trial(2, 1, 10).frequency() == 10'000);
    CHECK(trial(2, 1, 10).is_remote());
    CHECK(trial(2, 164, 1).frequency() == 0);
    CHECK(not trial(2, 164, 1).is_remote());
}

/// The frequency and the state after the link was lost at 40 Hz: 0.2 s later, and in the end.
struct after_loss {
    std::int32_t soon;
    std::int32_t last;
    state ends_in;
    bool operator==(after_loss const&) const = default;
};
template <typename Device> after_loss lose(std::uint16_t reaction, std::uint16_t stop_mode)
{
    drive_bench<Device> it;
    REQUIRE(it.tell(tto, 100) == errc::none);
    REQUIRE(it.tell(sll, reaction) == errc::none);
    REQUIRE(it.tell(stt, stop_mode) == errc::none);
    it.run(400);
    it.drive().note_contact();
    it.wait(10'000);
    it.wait(200);
    std::int32_t const soon = it.frequency();
    it.wait(5'000);
    return {soon, it.frequency(), it.state()};
}

/// The frequency 0.2 s after bit 8 at 40 Hz, in operation still.
template <typename Device> std::int32_t halt(std::uint16_t stop_mode)
{
    drive_bench<Device> it;
    REQUIRE(it.tell(stt, stop_mode) == errc::none);
    it.run(400);
    it.command(0x010F);
    it.wait(200);
    CHECK(it.state() == state::operation_enabled);
    return it.frequency();
}

/// 3 s from 50 Hz to 0 are 3.3 Hz in 0.2 s; a fast stop takes a quarter of that time.
constexpr std::int32_t on_the_ramp = 36'667, on_a_fast_ramp = 26'667;

} // namespace

TEST_CASE("CHCF, CD1 and FR1 say who commands and who refers")
{
    test::later_drives::for_each([]<typename Device>() { channels_count<Device>(); });
}

TEST_CASE("in the I/O profile of an ATV320 bit 0 of the command word is RUN")
{
    drive_bench<atv320::device> it;
    REQUIRE(it.tell(chcf, 3) == errc::none);
    it.refer(200);
    it.command(0x0006);
    it.wait(3'000);
    CHECK(it.frequency() == 0);
    it.command(0x0007); // which stops a drive in any other profile
    it.wait(3'000);
    CHECK(it.frequency() == 20'000);
    it.command(0x0000);
    it.wait(3'000);
    CHECK(it.frequency() == 0);
}

TEST_CASE("FLO gives the command to the terminals while its input says so, and back to a drive "
          "that stands")
{
    drive_bench<atv12::device> it;
    it.drive().set_analog_reference(10'000);
    it.drive().set_input(2, true);
    it.run(200);
    CHECK(it.frequency() == 20'000); // not assigned
    it.command(0x0000);
    it.drive().set_input(2, false);
    REQUIRE(it.tell(flo, 130) == errc::none);
    it.run(200);
    it.drive().set_input(2, true);
    CHECK(it.frequency() == 0);
    CHECK((it.eta() & 0x0200) == 0);
    it.command(0x000F);
    it.wait(1'000);
    CHECK(it.frequency() == 0);
    it.drive().set_input(1, true);
    it.wait(2'000);
    CHECK(it.frequency() == 10'000);
    it.drive().set_input(2, false);
    it.wait(1'000);
    CHECK(it.frequency() == 0);
    CHECK(it.state() == state::switch_on_disabled);
}

TEST_CASE("a channel that changes under a closed run input starts the motor")
{
    drive_bench<atv320::device> it;
    it.drive().set_analog_reference(10'000);
    it.drive().set_input(1, true);
    it.wait(1'000);
    CHECK(it.frequency() == 0);
    REQUIRE(it.tell(fr1, 1) == errc::none);
    it.wait(2'000);
    CHECK(it.frequency() == 10'000);
}

TEST_CASE("SLL says what a lost link does, and STT what a stop is")
{
    using newer = atv320::device;
    after_loss const runs_on{40'000, 40'000, state::operation_enabled};
    CHECK(lose<newer>(0, 0) == runs_on);
    CHECK(lose<newer>(5, 0) == runs_on);
    CHECK(lose<newer>(1, 0) == after_loss{0, 0, state::fault});
    CHECK(lose<newer>(2, 0) == after_loss{on_the_ramp, 0, state::switch_on_disabled});
    CHECK(lose<newer>(2, 1) == after_loss{on_a_fast_ramp, 0, state::switch_on_disabled});
    CHECK(lose<newer>(2, 2) == after_loss{0, 0, state::switch_on_disabled});
    CHECK(lose<newer>(4, 0) == after_loss{on_the_ramp, 0, state::operation_enabled});
    CHECK(lose<newer>(6, 0) == after_loss{on_the_ramp, 0, state::fault});
    CHECK(lose<newer>(7, 0) == after_loss{on_a_fast_ramp, 0, state::fault});
    CHECK(lose<newer>(8, 0) == after_loss{0, 0, state::fault});
    CHECK(lose<atv12::device>(0, 0) == runs_on);
    CHECK(lose<atv12::device>(1, 0) == after_loss{0, 0, state::fault});
    CHECK(lose<atv12::device>(4, 0) == after_loss{on_the_ramp, 0, state::operation_enabled});
}

TEST_CASE("a drive that fell back to a speed goes on as it was told when the link is there again")
{
    drive_bench<atv12::device> it;
    REQUIRE(it.tell(sll, 4) == errc::none);
    it.run(400);
    it.drive().note_contact();
    it.wait(10'000);
    it.wait(5'000);
    CHECK(it.frequency() == 0);
    it.drive().note_contact();
    it.wait(5'000);
    CHECK(it.frequency() == 40'000);
}

TEST_CASE("a halt stops as STT says, in operation")
{
    CHECK(halt<atv320::device>(0) == on_the_ramp);
    CHECK(halt<atv320::device>(1) == on_a_fast_ramp);
    CHECK(halt<atv320::device>(2) == 0);
    CHECK(halt<atv320::device>(3) == 0);
    CHECK(halt<atv310::device>(0) == on_the_ramp);
    CHECK(halt<atv310::device>(8) == on_a_fast_ramp);
    CHECK(halt<atv310::device>(13) == 0);
}

TEST_CASE("TTO outside 0.1 to 30 s is refused")
{
    drive_bench<atv310::device> it;
    CHECK(it.tell(tto, 0) == errc::illegal_data_value);
    CHECK(it.tell(tto, 301) == errc::illegal_data_value);
    CHECK(it.tell(tto, 1) == errc::none);
    CHECK(it.tell(tto, 300) == errc::none);
}

TEST_CASE("LSP counts for a reference of 0, in the direction that is asked for")
{
    drive_bench<atv320::device> it;
    REQUIRE(it.tell(lsp, 50) == errc::none);
    it.run(0);
    CHECK(it.frequency() == 5'000);
    it.command(0x080F);
    it.wait(4'000);
    CHECK(it.frequency() == -5'000);
    CHECK((it.eta() & 0x8800) == 0x8800);
    it.refer(200);
    it.wait(4'000);
    CHECK(it.frequency() == -20'000);
    it.refer(-200);
    it.wait(6'000);
    CHECK(it.frequency() == 20'000);
}

TEST_CASE("a speed that is less than a step of LFR has a direction, too")
{
    test::all_drives::for_each([]<typename Device>() {
        for (std::uint16_t const bit : std::array<std::uint16_t, 2>{0x0000, 0x0800}) {
            for (int const rpm : {-1, -2, 1, 2}) {
                drive_bench<Device> it;
                REQUIRE(it.tell(Device::layout.direct_control != 0 ? 251 : lsp, 50) == errc::none);
                it.run(0);
                REQUIRE(it.tell(Device::speed_reference.address, static_cast<std::uint16_t>(rpm)) == errc::none);
                REQUIRE(it.command(static_cast<std::uint16_t>(0x000F | bit)) == errc::none);
                it.wait(6'000);
                bool const is_reverse = (rpm < 0) != (bit != 0);
                CHECK(it.frequency() == (is_reverse ? -5'000 : 5'000));
                CHECK((it.eta() & 0x8800) == (is_reverse ? 0x8800 : 0x0800));
                REQUIRE(it.refer(0) == errc::none); // another sign is forgotten
                it.wait(6'000);
                CHECK(it.frequency() == (bit != 0 ? -5'000 : 5'000));
            }
        }
    });
}

TEST_CASE("a speed that stands in for the reference of a lost link has the direction of that reference")
{
    constexpr std::uint16_t falls_back = 4;
    for (bool const by_bit : {false, true}) {
        drive_bench<atv320::device> it;
        REQUIRE(it.tell(sll, falls_back) == errc::none);
        REQUIRE(it.tell(lsp, 50) == errc::none);
        REQUIRE(it.tell(tto, 50) == errc::none);
        it.run(by_bit ? 300 : -300);
        REQUIRE(it.command(by_bit ? 0x080F : 0x000F) == errc::none);
        it.drive().note_contact();
        it.wait(4'000);
        REQUIRE(it.frequency() == -30'000);
        it.wait(5'001);
        it.wait(4'000);
        CHECK(it.frequency() == -5'000);
    }
}
