// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a drive with all its parameters keeps of the moments of its last faults.
#include <rtuwire/sim/drive/drive.hpp>

#include "sim/drive/whole/whole_drives.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

/// A fault at a reference in 0.1 Hz, and its reset.
template <typename Device> void trip_at(test::drive_bench<Device>& it, std::int16_t tenths, std::uint16_t code)
{
    it.run(tenths);
    it.drive().inject_fault(code);
    it.wait(2'000);
    it.drive().clear_cause();
    REQUIRE(it.command(0x0000) == errc::none);
    REQUIRE(it.command(0x0080) == errc::none);
    it.wait(100);
}

} // namespace

TEST_CASE("an ATV320 keeps what it did at each of its last nine faults")
{
    test::drive_bench<atv320::full_device> it;
    trip_at(it, 200, 9);
    CHECK(it.word("DP0") == 9);
    CHECK(it.word("EP0") == 0x0637); // operation enabled, at its reference, by the line
    CHECK(it.word("CMP0") == 0x000F);
    CHECK(it.word("HS1") == 0);
    CHECK(it.number("RFP0") == 200);
    CHECK(it.number("LCP0") > 0);
    CHECK(it.word("ULP0") == 4'000);
    CHECK(it.number("OTP0") > 0);
    CHECK(it.word("SFP0") == it.word("SFR") * 100);
    CHECK(it.word("IP0") != 0);
    CHECK(it.word("FNB") == 1);
    for (std::uint16_t code = 16; code < 24; ++code) {
        trip_at(it, static_cast<std::int16_t>(-20 * code), code);
    }
    CHECK(it.word("DP0") == 23);
    CHECK(it.number("RFP0") == -460);
    CHECK(it.word("EP0") == 0x8637);
    CHECK(it.word("DP1") == 22);
    CHECK(it.number("RFP1") == -440);
    CHECK(it.word("HS1") == 4); // running
    CHECK(it.word("DP8") == 9);
    CHECK(it.number("RFP8") == 200);
    CHECK(it.word("EP8") == 0x0637);
    CHECK(it.word("FNB") == 9);
}

TEST_CASE("an ATV12 keeps the state of its most recent fault, and all of those before")
{
    test::drive_bench<atv12::full_device> it;
    trip_at(it, 300, 9);
    CHECK(it.word("DP0") == 9);
    // Switched on, no quick stop, by the line, a run order, the command by Modbus.
    CHECK(it.word("EP0") == 0x402B);
    CHECK(it.number("RFP1") == 0);
    trip_at(it, -100, 18);
    CHECK(it.word("EP0") == 0xC03B); // in reverse, and the reference, too
    CHECK(it.word("DP1") == 9);
    CHECK(it.word("EP1") == 0x402B);
    CHECK(it.number("RFP1") == 300);
    CHECK(it.number("LCP1") > 0);
    CHECK(it.word("ULP1") == 400);
    it.cycle_power();
    trip_at(it, 100, 5);
    CHECK(it.number("RFP1") == 0);
}

TEST_CASE("an ATV310 keeps the codes of its last five faults")
{
    test::drive_bench<atv310::full_device> it;
    for (std::uint16_t const code : std::array<std::uint16_t, 6>{9, 16, 17, 18, 19, 20}) {
        trip_at(it, 100, code);
    }
    CHECK(it.word("DP0") == 20);
    CHECK(it.word("DP4") == 16);
}
