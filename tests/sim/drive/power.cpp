// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a simulated drive forgets with its power, what its EEPROM takes, and when a change of its line counts.
#include "support/drive_bench.hpp"

#include <array>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/sim/drive/unit.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;
using test::drive_bench;

namespace {

/// A unit on a line of its own; one exchange at a time.
template <typename Device> class wire {
public:
    wire()
    {
        pause(20);
        pause(20);
    }

    sim::unit<Device>& unit() { return unit_; }
    void pause(std::uint32_t time_ms)
    {
        now_ = now_ + milliseconds(time_ms);
        unit_.advance(now_);
    }

    /// The size of the response to a read or a write by function 06; 0 for silence.
    std::size_t ask(std::uint8_t to, std::uint8_t function, std::uint16_t address, std::uint16_t word)
    {
        std::array<std::byte, 8> frame{};
        byte_writer out{frame};
        out.u8(to);
        out.u8(function);
        out.u16(address);
        out.u16(word);
        std::uint16_t const crc = crc16(out.written());
        out.u8(crc);
        out.u8(std::uint32_t{crc} >> 8U);
        unit_.receive(frame, now_);
        pause(5);
        pause(5);
        std::size_t const size = unit_.poll_transmit().size();
        unit_.sent(now_);
        pause(20);
        return size;
    }
    bool reads(std::uint8_t to) { return ask(to, 3, Device::layout.eta, 1) == 7; }
    bool writes(std::uint8_t to, std::uint16_t address, std::uint16_t word) { return ask(to, 6, address, word) == 8; }

private:
    static constexpr line_timing timing{19'200, character_format::even_8_1};
    instant now_{0};
    sim::unit<Device> unit_{unit_id{1}, timing, now_};
};

} // namespace

TEST_CASE("a power cycle forgets commands, their edges and the scanner's words")
{
    drive_bench<atv320::device> it;
    REQUIRE(it.tell(12724, 9001) == errc::none); // NCA4: ACC
    REQUIRE(it.tell(8504, 0x0002) == errc::none);
    REQUIRE(it.tell(8504, 0x0000) == errc::none);
    it.run(300);
    it.tell(12764, 44);
    it.tell(12761, 0x000F);
    it.cycle_power();
    for (literal const code : std::array<literal, 7>{"CMD", "LFR", "LFRD", "CMI", "NC1", "NC2", "NC4"}) {
        CHECK(it.word(code) == 0);
    }
    CHECK(it.word("NCA4") == 9001);
    CHECK(it.frequency() == 0);
    CHECK(it.state() == state::switch_on_disabled);
}

TEST_CASE("the edge of a reset is not remembered beyond the power")
{
    drive_bench<atv12::device> it;
    it.command(0x0080);
    it.cycle_power();
    it.drive().inject_fault(9);
    it.wait(10);
    it.drive().clear_cause();
    it.command(0x0080);
    CHECK(it.state() == state::switch_on_disabled);
}

TEST_CASE("a drive whose STOP key is held runs for nobody")
{
    drive_bench<atv320::device> it;
    it.run(200);
    it.drive().hold_stop(true);
    CHECK(it.frequency() == 0);
    it.run(200);
    CHECK(it.frequency() == 0);
    CHECK(it.state() == state::switch_on_disabled);
    CHECK((it.eta() & 0x4000) != 0);
    it.drive().hold_stop(false);
    CHECK((it.eta() & 0x4000) != 0);
    it.run(200);
    CHECK(it.frequency() == 20'000);
    CHECK((it.eta() & 0x4000) == 0);
}

TEST_CASE("the EEPROM's writes are counted, and ETI shows it at work")
{
    drive_bench<atv12::device> it;
    CHECK(it.drive().eeprom_writes() == 0);
    it.tell(8504, 0x0002);
    CHECK((it.word("ETI") & 1) == 1);
    it.tell(8504, 0x0000);
    it.wait(200);
    CHECK((it.word("ETI") & 1) == 0);
    it.tell(8504, 0x0002);
    CHECK(it.drive().eeprom_writes() == 2);
    it.run(200);
    it.tell(8504, 0x0002); // not in operation
    CHECK(it.drive().eeprom_writes() == 2);
}

TEST_CASE("an ATV28 at work on its EEPROM answers the order and is silent for two seconds")
{
    wire<atv28::device> line;
    CHECK(line.reads(1));
    CHECK(line.writes(1, 402, 0x0002));
    line.pause(1'800);
    CHECK(not line.reads(1));
    line.pause(200);
    CHECK(line.reads(1));
    CHECK(line.unit().drive().eeprom_writes() == 1);

    wire<atv12::device> later;
    CHECK(later.writes(1, 8504, 0x0002));
    CHECK(later.reads(1));
}

TEST_CASE("a new address counts behind the response that has the old one")
{
    wire<atv320::device> line;
    CHECK(line.writes(1, 6001, 9));
    CHECK(not line.reads(1));
    CHECK(line.reads(9));
    // It was not saved.
    line.unit().drive().power_cycle(instant{1'000'000});
    line.pause(1'000);
    CHECK(line.reads(1));
    CHECK(line.writes(1, 8504, 0x0001)); // factory settings: no address at all
    CHECK(not line.reads(1));
    CHECK(line.ask(0, 6, 9001, 77) == 0);
    CHECK(line.unit().drive().word("ACC") == 77); // broadcasts are executed
}

TEST_CASE("a new rate counts at once, on an ATV28 at the next power-up")
{
    wire<atv12::device> line;
    CHECK(line.writes(1, 6003, 28));
    CHECK(not line.reads(1));

    wire<atv12::device> other_format;
    CHECK(other_format.writes(1, 6004, 4));
    CHECK(not other_format.reads(1));

    wire<atv28::device> old;
    CHECK(old.writes(1, 16, 7));
    CHECK(old.reads(1));
    CHECK(old.writes(1, 402, 0x0002));
    old.pause(3'000);
    CHECK(old.reads(1));
    old.unit().drive().power_cycle(instant{4'000'000});
    old.pause(1'000);
    CHECK(not old.reads(1));
}
