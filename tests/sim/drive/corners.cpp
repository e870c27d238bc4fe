// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A simulated drive at the edges of its settings, and a line at the edges of its memory.
#include <rtuwire/sim/drive/drive.hpp>

#include "support/catch.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/sim/line/line.hpp>
#include <rtuwire/sim/line/usb_adapter.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

/// A drive, its clock, and words by their addresses.
template <typename Device> struct workbench {
    instant now{0};
    detail::simulated_drive<Device> drive{now};

    workbench() { wait(10); }

    void wait(std::uint32_t time_ms)
    {
        now = now + milliseconds(time_ms);
        drive.advance(now);
    }
    errc tell(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        errc const wrong = drive.check_write(address, value);
        return wrong == errc::none ? drive.write(address, value) : wrong;
    }
    void run(std::uint16_t frequency)
    {
        tell(Device::frequency_reference.address, frequency);
        for (std::uint32_t const word : {0x0006U, 0x0007U, 0x000FU}) {
            tell(Device::layout.cmd, static_cast<std::uint16_t>(word));
        }
    }
    state now_in() const { return drive.state_machine().state(); }
};

constexpr auto frame = "01 03 0C 81 00 01 D7 72"_hex;

} // namespace

TEST_CASE("ramps of no time, and in each of their steps")
{
    workbench<atv320::device> it;
    it.tell(9001, 0);
    it.tell(9002, 0);
    it.run(500);
    it.wait(1);
    CHECK(it.drive.word("RFR") == 500);
    it.tell(8501, 0x080F);
    it.wait(1);
    CHECK(it.drive.motor().frequency() == -50'000);
    for (std::uint16_t const inr : {std::uint16_t{0}, std::uint16_t{2}}) {
        workbench<atv320::device> other;
        REQUIRE(other.tell(9020, inr) == errc::none);
        other.tell(9001, 10);
        other.run(500);
        other.wait(50);
        CHECK((other.drive.word("RFR") > 100) == (inr == 0));
    }
}

namespace {

/// The thermal state, in percent, behind a full turn of the clock at so much current of 0.1 A.
constexpr std::int32_t heat_of(std::int32_t current, std::int32_t protection)
{
    detail::simulated_motor shaft;
    shaft.inject(duration{0xFFFF'FFFF}, {.rated_current = current, .protection = protection});
    return shaft.thermal_state();
}
// A turn is 71.6 minutes, of a time constant of 10: 87.7 % by the model's 1/(1 + 600 s/t).
static_assert(heat_of(20, 20) == 87);
static_assert(heat_of(199, 20) > 8'600);
static_assert(heat_of(200, 20) > heat_of(199, 20));
static_assert(heat_of(32'767, 1) == heat_of(200, 20)); // ten times the rated current, and more, heats alike

} // namespace

TEST_CASE("a motor without a nameplate turns all the same")
{
    workbench<atv320::device> it;
    it.tell(9604, 0); // NSP
    it.tell(9603, 0); // NCR
    it.tell(9622, 0); // ITH
    it.run(300);
    it.wait(5'000);
    CHECK(it.drive.word("RFR") == 300);
    CHECK(it.drive.word("LCR") == 0);
    CHECK(it.drive.word("RFRD") == 1'800);
    it.tell(9604, 24'000);
    it.wait(10);
    CHECK(it.drive.word("RFRD") == 1'800);
}

TEST_CASE("a lost link is answered as SLL says")
{
    auto const after_loss = [](std::uint16_t reaction) {
        workbench<atv320::device> it;
        it.tell(6005, 10);
        REQUIRE(it.tell(7010, reaction) == errc::none);
        it.run(500);
        it.drive.note_contact();
        it.wait(900);
        it.wait(200);
        it.wait(100);
        return it.now_in();
    };
    CHECK(after_loss(0) == state::operation_enabled);
    CHECK(after_loss(1) == state::fault);
    CHECK(after_loss(6) == state::fault_reaction_active);
    CHECK(after_loss(4) == state::operation_enabled);
    CHECK(after_loss(5) == state::operation_enabled);
}

TEST_CASE("a configuration write takes a drive that is switched on back, and is refused while it runs")
{
    workbench<atv12::device> it;
    it.tell(8501, 0x0006);
    it.tell(8501, 0x0007);
    REQUIRE(it.now_in() == state::switched_on);
    CHECK(it.tell(6005, 50) == errc::none);
    CHECK(it.now_in() == state::switch_on_disabled);
    it.run(300);
    CHECK(it.tell(6005, 60) == errc::server_device_failure);
    CHECK(it.drive.word("TTO") == 50);
}

TEST_CASE("an ATV28 in fault does not obey a direct command, nor one without its enabling bits")
{
    workbench<atv28::device> it;
    it.drive.inject_fault(9);
    it.drive.inject_fault(5); // the first one counts
    it.wait(10);
    CHECK(it.tell(400, 0x800A) == errc::none);
    CHECK(it.now_in() == state::fault);
    CHECK(it.drive.word("LFT") == 9);
    it.drive.clear_cause();
    it.tell(400, 0);
    it.tell(400, 0x80);
    it.tell(400, 0x800A);
    CHECK(it.now_in() == state::operation_enabled);
    it.tell(400, 0x8000);
    CHECK(it.now_in() == state::switch_on_disabled);
    it.tell(47, 0); // SDS
    it.tell(603, 1'500);
    it.wait(10);
    CHECK(it.drive.word("RFRD") == 0);
}

TEST_CASE("a drive in fault obeys no direct word, and trips once")
{
    detail::state_machine state_machine{atv28::device::layout.state_machine};
    state_machine.power_up();
    state_machine.enable_directly();
    CHECK(state_machine.state() == state::not_ready_to_switch_on);
    state_machine.initialised();
    state_machine.trip();
    CHECK(state_machine.state() == state::fault_reaction_active);
    state_machine.trip();
    state_machine.enable_directly();
    CHECK(state_machine.state() == state::fault_reaction_active);
    state_machine.at_rest();
    state_machine.trip();
    CHECK(state_machine.state() == state::fault);
}

TEST_CASE("the place of no register takes nothing and gives 0")
{
    using registers = detail::image<atv28::device>;
    registers image;
    image.put_word(registers::nowhere, 5);
    CHECK(image.get(registers::nowhere) == 0);
    CHECK(registers::at_address(0x1'0000) == registers::nowhere);
    CHECK(registers::at_address(0xFFFF) == registers::nowhere);
    std::size_t const reference = registers::at("LFR");
    image.put_word(reference, 0xFFFF);
    CHECK(image.get_signed(reference) == -1);
}

TEST_CASE("settings that a drive never has give no division by zero")
{
    detail::image<atv320::device> image;
    detail::parameters<atv320::device> const set{image};
    image.put(detail::image<atv320::device>::at("FRS"), 0);
    CHECK(set.motor().rated_frequency == 50'000);
    image.put(detail::image<atv320::device>::at("NSP"), 30'000);
    CHECK(set.to_rpm(50'000) == 3'000);
    detail::image<atv28::device> old;
    old.put(detail::image<atv28::device>::at("SDS"), 0);
    CHECK(detail::parameters<atv28::device>{old}.to_millihertz(1'500) == 0);
}

TEST_CASE("bits beyond the end of a waveform are idle, and cannot be changed")
{
    detail::waveform wave;
    wave.flip(detail::waveform::capacity);
    wave.lay(detail::waveform::capacity - 8, 0, 16);
    CHECK(wave.size() == 0);
    CHECK(wave.bits_from(detail::waveform::capacity) == 0xFFFF);
    wave.flip(detail::waveform::capacity - 1);
    CHECK(wave.bits_from(detail::waveform::capacity - 1) == 0xFFFE);
    CHECK(wave.size() == detail::waveform::capacity);
}

TEST_CASE("a scanner drops what its target would refuse")
{
    workbench<atv320::device> it;
    REQUIRE(it.tell(12723, 9'001) == errc::none);
    REQUIRE(it.tell(12724, 3'201) == errc::none);
    REQUIRE(it.tell(12725, 6'005) == errc::none);
    CHECK(it.tell(12763, 77) == errc::none);
    CHECK(it.drive.word("ACC") == 77);
    CHECK(it.tell(12764, 77) == errc::none);
    CHECK(it.tell(12765, 9'999) == errc::none);
    CHECK(it.drive.word("TTO") != 9'999);
}

TEST_CASE("a line forgets what its memory has no room for")
{
    sim::line wire{19'200, character_format::odd_8_1, 1};
    instant now{0};
    for (unsigned i = 0; i < 300; ++i) {
        wire.transmit(i % 8, frame, now + milliseconds(5 * i)); // and nobody listens
    }
    unsigned heard = 0;
    while (wire.receive(now + milliseconds(10'000))) {
        ++heard;
    }
    CHECK(heard > 500);
    CHECK(heard < 300 * frame.size());
    sim::line_faults noisy;
    noisy.bit_errors = 1'000'000;
    wire.set_faults(noisy);
    wire.transmit(0, frame, now + milliseconds(20'000));
    unsigned damaged = 0;
    while (auto const next = wire.receive(now + milliseconds(30'000))) {
        damaged += next->is_damaged ? 1U : 0U;
    }
    CHECK(damaged > 0);
}

TEST_CASE("an adapter that nobody empties keeps what it has room for")
{
    sim::usb_adapter adapter;
    for (unsigned i = 0; i < 100; ++i) {
        adapter.take(std::byte{2}, instant{0});
    }
    CHECK(adapter.give(instant{0}).size() == 62);
}
