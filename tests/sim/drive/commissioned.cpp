// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a simulated drive holds: as it came to the line, as delivered, after power; and that it takes back all of it.
#include "support/drive_bench.hpp"
#include "support/drives.hpp"

#include <rtuwire/sim/drive/unit.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;
using test::drive_bench;

/// Reads every register and writes the writable ones back as they were read; how often that was refused.
template <typename Device> static unsigned refusals(drive_bench<Device>& it)
{
    unsigned refused = 0;
    Device::registers::for_each([&]<auto const & R>() {
        refused += it.drive().check_read(R.address, 1) == errc::none ? 0U : 1U;
        if (R.mode != access::read_only) {
            std::uint16_t const word = it.word(R.code);
            bool const is_taken = it.tell(R.address, word) == errc::none;
            refused += is_taken and it.word(R.code) == word ? 0U : 1U;
        }
    });
    return refused;
}

template <typename Device> static void takes_back_what_it_shows()
{
    drive_bench<Device> it;
    CHECK(refusals(it) == 0);
    CHECK(it.state() == state::switch_on_disabled);
    REQUIRE(it.tell(Device::layout.cmi, 0x0001) == errc::none);
    it.wait(3'000);
    CHECK(refusals(it) == 0);
    it.cycle_power();
    CHECK(refusals(it) == 0);
}

TEST_CASE("a standing drive takes every word back that it shows, commissioned or as delivered")
{
    test::all_drives::for_each([]<typename Device>() { takes_back_what_it_shows<Device>(); });
}

template <typename Device> static void is_commissioned_and_delivered()
{
    drive_bench<Device> it;
    auto const channels = [&] {
        return it.word("CD1") * 1'000'000 + it.word("FR1") * 1'000 + it.word("CHCF") * 10 + it.word("SLL");
    };
    CHECK(channels() == 10'164'011);
    it.cycle_power();
    CHECK(channels() == 10'164'011);
    it.run(200);
    CHECK(it.frequency() == 20'000);
    it.command(0x0000);
    REQUIRE(it.tell(Device::layout.cmi, 0x0001) == errc::none);
    CHECK(channels() == 1'001'011);
    CHECK(it.word("ADD") == 0);
    CHECK(it.word("TTO") == 100);
    CHECK(it.word("TBR") == 32);
    // The terminals command now: nothing that the line says moves the motor, nor is it refused.
    it.run(200);
    CHECK(it.frequency() == 0);
    CHECK(it.state() == state::switch_on_disabled);
    CHECK((it.eta() & 0x0200) == 0);
    // It was not saved.
    it.cycle_power();
    CHECK(channels() == 10'164'011);
    CHECK(it.word("ADD") == 1);
}

TEST_CASE("a drive comes commissioned; factory settings take the line's control and the address away")
{
    test::later_drives::for_each([]<typename Device>() { is_commissioned_and_delivered<Device>(); });
}
