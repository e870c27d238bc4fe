// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A simulated drive, word by word.
#include <rtuwire/sim/drive/drive.hpp>

#include "support/drives.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

/// A drive and its clock; a word written or read at a time.
template <typename Device> struct bench {
    instant now{0xFFFF'0000};
    detail::simulated_drive<Device> drive{now};

    constexpr bench() { wait(10); }

    constexpr void wait(std::uint32_t time_ms)
    {
        now = now + milliseconds(time_ms);
        drive.advance(now);
    }
    constexpr errc tell(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        errc const wrong = drive.check_write(address, value);
        return wrong == errc::none ? drive.write(address, value) : wrong;
    }
    constexpr errc command(std::uint16_t word) { return tell(Device::layout.cmd, word); }
    constexpr std::uint16_t eta() const { return drive.word("ETA"); }
    constexpr cia402::state state() const { return cia402::decode(eta()); }
    constexpr cia402::transition last() const { return drive.state_machine().last(); }

    /// In operation at a reference of 50.0 Hz, at rest.
    constexpr void enable()
    {
        tell(Device::frequency_reference.address, 500);
        command(0x0006);
        command(0x0007);
        command(0x000F);
    }
};

} // namespace

using state = cia402::state;
using transition = cia402::transition;

template <typename Device> static void walks_the_chart()
{
    bench<Device> it;
    CHECK(it.last() == transition::t1);
    CHECK(it.state() == state::switch_on_disabled);
    auto const goes = [&](std::uint16_t word, transition number, state to) {
        it.command(word);
        CHECK(it.last() == number);
        CHECK(it.state() == to);
    };
    goes(0x0006, transition::t2, state::ready_to_switch_on);
    goes(0x0007, transition::t3, state::switched_on);
    goes(0x0006, transition::t6, state::ready_to_switch_on);
    goes(0x0000, transition::t7, state::switch_on_disabled);
    it.command(0x0006);
    goes(0x0002, transition::t7, state::switch_on_disabled);
    it.command(0x0006);
    it.command(0x0007);
    goes(0x0000, transition::t10, state::switch_on_disabled);
    it.command(0x0006);
    it.command(0x0007);
    goes(0x000F, transition::t4, state::operation_enabled);
    goes(0x0006, transition::t8, state::ready_to_switch_on);
    it.command(0x0007);
    it.command(0x000F);
    goes(0x0000, transition::t9, state::switch_on_disabled);
    it.enable();
    it.wait(1'000);
    goes(0x0002, transition::t11, state::quick_stop_active);
    it.wait(2'000);
    if (Device::layout.state_machine.quick_stop_waits) {
        CHECK(it.state() == state::quick_stop_active);
        it.command(0x0000);
    }
    CHECK(it.last() == transition::t12);
    CHECK(it.state() == state::switch_on_disabled);
    it.enable();
    it.wait(1'000);
    it.command(0x0007);
    CHECK(it.state() == state::operation_enabled);
    it.wait(3'000);
    CHECK(it.last() == transition::t5);
    CHECK(it.state() == state::switched_on);
    it.drive.inject_fault(9);
    CHECK(it.last() == transition::t13);
    CHECK(it.state() == state::fault_reaction_active);
    it.wait(10);
    CHECK(it.last() == transition::t14);
    CHECK(it.state() == state::fault);
    it.command(0x0080);
    CHECK(it.state() == state::fault);
    it.drive.clear_cause();
    it.command(0x0080);
    CHECK(it.state() == state::fault);
    it.command(0x0000);
    goes(0x0080, transition::t15, state::switch_on_disabled);
    it.command(0x0006);
    it.command(0x000F);
    bool const has_3b = Device::layout.state_machine.enables_from_ready;
    CHECK(it.last() == (has_3b ? transition::t3b : transition::t4));
    CHECK(it.state() == state::operation_enabled);
    std::uint32_t const all = 0xFFFF;
    CHECK((it.drive.state_machine().taken() & all) == all);
}

TEST_CASE("each drive goes along every arrow of its chart")
{
    test::all_drives::for_each([]<typename Device>() { walks_the_chart<Device>(); });
}

/// Lower bytes as the manuals print them; the ATV28 has bit 4 low while there is power.
template <typename Device> static void shows_what_is_printed(std::uint16_t power)
{
    auto const lower = [](auto const& it) { return it.eta() & 0xFF; };
    bench<Device> it;
    CHECK(lower(it) == (0x40 | power));
    it.command(0x0006);
    CHECK(lower(it) == (0x21 | power));
    it.command(0x0007);
    CHECK(lower(it) == (0x23 | power));
    it.enable();
    CHECK(lower(it) == (0x27 | power));
    it.drive.inject_fault(9);
    it.wait(10);
    CHECK(lower(it) == (0x28 | power));
    it.drive.clear_cause();
    it.command(0x0000);
    it.command(0x0080);
    CHECK(lower(it) == (0x40 | power));
    it.enable();
    it.wait(1'000);
    it.command(0x0002);
    CHECK(lower(it) == (0x07 | power));
    it.drive.inject_fault(9);
    it.wait(10);
    CHECK(lower(it) == (0x08 | power));
    it.drive.clear_cause();
    it.command(0x0000);
    it.command(0x0080);
    it.drive.inject_fault(9);
    it.wait(10);
    CHECK(lower(it) == (0x28 | power));
}

TEST_CASE("status words are those that the manuals print")
{
    test::later_drives::for_each([]<typename Device>() { shows_what_is_printed<Device>(0x10); });
    shows_what_is_printed<atv28::device>(0x00);
}

TEST_CASE("the motor follows its ramp, both ways")
{
    bench<atv320::device> it;
    it.enable();
    CHECK(it.eta() == 0x0237);
    it.wait(1'500);
    CHECK(it.drive.word("RFR") == 250);
    CHECK(it.drive.word("HMIS") == 5);
    it.wait(1'500);
    CHECK(it.drive.word("RFR") == 500);
    CHECK(it.drive.word("RFRD") == 1'500);
    it.wait(1);
    CHECK(it.eta() == 0x0637);
    CHECK(it.drive.word("LCR") > 10);
    it.command(0x080F);
    it.wait(6'001);
    CHECK(static_cast<std::int16_t>(it.drive.word("RFR")) == -500);
    CHECK(it.eta() == 0x8637);
    it.command(0x090F);
    it.wait(3'001);
    CHECK(it.drive.word("RFR") == 0);
    CHECK(it.state() == state::operation_enabled);
}

TEST_CASE("steps of any size lead to the same speed")
{
    bench<atv12::device> fine;
    bench<atv12::device> coarse;
    fine.tell(9001, 600);
    coarse.tell(9001, 600);
    fine.enable();
    coarse.enable();
    for (unsigned step = 0; step < 30'000; ++step) {
        fine.wait(1);
    }
    coarse.wait(30'000);
    CHECK(fine.drive.word("RFR") == 250);
    CHECK(coarse.drive.word("RFR") == 250);
}

TEST_CASE("a reference outside LSP..HSP is cut and shown so")
{
    bench<atv320::device> it;
    it.tell(3105, 100);
    it.enable();
    it.tell(8602, 1'800);
    it.wait(6'000);
    CHECK(it.drive.word("RFR") == 500);
    CHECK((it.eta() & 0x0C00) == 0x0C00);
    it.tell(8602, 30);
    it.wait(6'000);
    CHECK(it.drive.word("RFR") == 100);
    CHECK((it.eta() & 0x0800) != 0);
    it.tell(8602, 600);
    it.wait(6'000);
    CHECK(it.drive.word("RFR") == 200);
    CHECK((it.eta() & 0x0C00) == 0x0400);
}

TEST_CASE("a configuration is refused in operation, and takes a drive back from switched on")
{
    bench<atv12::device> it;
    it.enable();
    CHECK(it.tell(6001, 3) == errc::server_device_failure);
    CHECK(it.tell(9001, 20) == errc::none);
    it.command(0x0007);
    it.wait(1);
    CHECK(it.state() == state::switched_on);
    CHECK(it.tell(6001, 3) == errc::none);
    CHECK(it.state() == state::switch_on_disabled);
    CHECK(it.last() == transition::t10);
    it.command(0x0006);
    CHECK(it.tell(6001, 4) == errc::none);
    CHECK(it.state() == state::ready_to_switch_on);
}

TEST_CASE("what does not exist, cannot be written or does not fit is refused, and nothing changes")
{
    bench<atv320::device> it;
    CHECK(it.drive.check_read(3201, 5) == errc::none);
    CHECK(it.drive.check_read(1, 1) == errc::illegal_data_address);
    CHECK(it.drive.check_read(65535, 2) == errc::illegal_data_address);
    CHECK(it.tell(3201, 1) == errc::illegal_data_address);
    CHECK(it.tell(6001, 248) == errc::illegal_data_value);
    CHECK(it.tell(3104, 601) == errc::illegal_data_value);
    CHECK(it.tell(3104, 600) == errc::none);
    CHECK(it.tell(3105, 601) == errc::illegal_data_value);
    register_block const both{40, 9'000};
    CHECK(it.drive.check_write(3104, both) == errc::illegal_data_value);
    CHECK(it.drive.word("HSP") == 600);
}

TEST_CASE("a lost link trips the drive, and needs a reset")
{
    bench<atv320::device> it;
    it.drive.note_contact();
    it.enable();
    it.wait(9'999);
    CHECK(it.state() == state::operation_enabled);
    it.wait(1);
    it.wait(1);
    CHECK(it.state() == state::fault);
    CHECK(it.drive.word("LFT") == 5);
    CHECK(it.drive.word("CMD") == 0);
    CHECK(it.drive.motor().is_at_rest());
    it.drive.note_contact();
    it.enable();
    CHECK(it.state() == state::fault);
    it.command(0x0080);
    CHECK(it.state() == state::switch_on_disabled);
    CHECK(it.drive.word("LFT") == 5);
}

TEST_CASE("a drive that ignores the loss runs on; an ATV28 does when CMI says so")
{
    bench<atv12::device> it;
    it.tell(7010, 0);
    it.drive.note_contact();
    it.enable();
    it.wait(60'000);
    CHECK(it.state() == state::operation_enabled);

    bench<atv28::device> old;
    old.drive.note_contact();
    old.enable();
    old.wait(6'999);
    CHECK(old.state() == state::operation_enabled);
    old.wait(2);
    old.wait(1);
    CHECK(old.state() == state::fault);

    bench<atv28::device> alone;
    alone.tell(402, 0x4000);
    alone.drive.note_contact();
    alone.enable();
    alone.wait(60'000);
    CHECK(alone.state() == state::operation_enabled);
}

TEST_CASE("local control and the STOP key take the command away")
{
    bench<atv320::device> it;
    it.enable();
    it.wait(1'000);
    it.drive.set_local(true);
    CHECK(it.state() == state::switch_on_disabled);
    CHECK((it.eta() & 0x0200) == 0);
    it.enable();
    CHECK(it.state() == state::switch_on_disabled);
    it.drive.set_local(false);
    CHECK(it.state() == state::switch_on_disabled);
    it.enable();
    CHECK(it.state() == state::operation_enabled);
    it.drive.press_stop();
    CHECK(it.state() == state::switch_on_disabled);
    CHECK((it.eta() & 0x4000) != 0);
    it.wait(1'000);
    CHECK(it.state() == state::switch_on_disabled);

    bench<atv28::device> old;
    old.drive.set_local(true);
    CHECK(old.command(0x0006) == errc::server_device_failure);
    CHECK(old.tell(252, 50) == errc::none);
}

TEST_CASE("the scanner maps what its addresses say, live")
{
    bench<atv310::device> it;
    it.tell(12763, 0);
    it.tell(12761, 0x0006);
    it.tell(12761, 0x0007);
    it.tell(12762, 1'500);
    it.tell(12761, 0x000F);
    it.wait(3'001);
    CHECK(it.drive.word("NM1") == 0x0637);
    CHECK(it.drive.word("NM2") == 1'500);
    CHECK(it.drive.word("NM3") == 0);
    it.command(0x0000);
    CHECK(it.tell(12703, 3202) == errc::none);
    CHECK(it.tell(12724, 9001) == errc::none);
    it.tell(12764, 77);
    CHECK(it.drive.word("ACC") == 77);
    CHECK(it.drive.word("NM3") == 0);
    it.tell(12724, 3201);
    it.tell(12764, 0xFFFF);
    CHECK(it.drive.word("NC4") == 0xFFFF);
    CHECK(it.state() == state::switch_on_disabled);
}

TEST_CASE("what is not saved is lost with the power")
{
    bench<atv12::device> it;
    it.tell(9001, 55);
    it.tell(8504, 0x0002);
    it.tell(8504, 0x0000);
    it.tell(9002, 66);
    it.drive.power_cycle(it.now);
    CHECK(it.drive.word("ACC") == 55);
    CHECK(it.drive.word("DEC") == 30);
    CHECK(it.drive.word("CMD") == 0);

    bench<atv28::device> old;
    old.tell(252, 55);
    old.tell(402, 0x0002);
    CHECK(old.drive.word("CMI") == 0);
    old.tell(252, 77);
    old.tell(402, 0x0004);
    CHECK(old.drive.word("ACC") == 55);
    old.tell(402, 0x0001);
    CHECK(old.drive.word("ACC") == 30);
}

TEST_CASE("the ATV28 obeys direct commands, and shows mains by a low bit 4")
{
    bench<atv28::device> it;
    CHECK(it.eta() == 0x0240);
    it.tell(401, 400);
    it.command(0x800A);
    CHECK(it.state() == state::operation_enabled);
    it.wait(3'000);
    CHECK(it.drive.word("RFR") == 400);
    CHECK(it.drive.word("RFRD") == 1'200);
    it.command(0x880A);
    it.wait(6'000);
    CHECK((it.eta() & 0x8000) != 0);
    for (std::uint32_t const stop : {0x900AU, 0xA00AU, 0xC00AU}) {
        it.command(0x800A);
        it.wait(6'000);
        CHECK(it.drive.word("RFR") == 400);
        it.command(static_cast<std::uint16_t>(stop));
        it.wait(800);
        CHECK((it.drive.word("RFR") == 0) == (stop != 0x900A));
        it.wait(2'200);
        CHECK(it.drive.word("RFR") == 0);
    }
}

TEST_CASE("a simulated hour is a few calculations")
{
    bench<atv320::device> it;
    it.enable();
    for (unsigned second = 0; second < 3'600; ++second) {
        it.drive.note_contact();
        it.wait(1'000);
    }
    CHECK(it.drive.word("RFR") == 500);
    CHECK(it.drive.word("THR") > 50);
    CHECK(it.drive.word("THR") < 200);
}
