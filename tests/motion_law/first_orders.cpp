// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A start and a cycle order no drive that would not stop by itself, and a drive that tripped while nobody ordered it.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr std::uint16_t sll = 7010, tto = 6005, chcf = 8401, fr1 = 8413, atr = 7122, cmi_28 = 402, atr_28 = 150;

/// A client, a drive, and how many frames were written to it.
template <typename Device> struct bench : test::simulated_bus<drive_client<4>, Device> {
    static constexpr station<Device> drive{unit_id{3}};
    unsigned writes{0};

    bench() : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
        this->disturb([this](std::vector<std::byte>& frame, bool is_request) {
            writes += is_request and frame[1] != std::byte{3} ? 1U : 0U;
        });
    }
    detail::simulated_drive<Device>& far() { return this->unit(0).drive(); }
    void set(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        REQUIRE(far().check_write(address, value) == errc::none);
        static_cast<void>(far().write(address, value));
        this->idle(milliseconds(20));
    }
    bool order(cyclic<Device>& loop)
    {
        if constexpr (cycle_layout<Device>::has_scanner) {
            return loop.run(1'200_rpm);
        } else {
            return loop.run(40_Hz);
        }
    }
    void cycle(cyclic<Device>& loop, duration length)
    {
        this->run([&](instant now) { this->link().converse(loop, now); }, [] { return false; }, length);
    }
};

/// Neither a start nor a cycle orders this drive, and nothing is written to it.
template <typename Device> void refuses(bench<Device>& it, outcome_kind how, std::uint16_t address)
{
    INFO(std::string(Device::name.begin(), Device::name.end()) << " register " << address);
    start go{it.drive, 30_Hz};
    REQUIRE(it.run(go));
    CHECK(go.reason().kind == how);
    CHECK(go.supervision().address == address);
    cyclic<Device> loop{it.drive};
    for (unsigned moment = 0; moment < 30; ++moment) {
        CHECK_FALSE(it.order(loop));
        it.cycle(loop, milliseconds(50));
    }
    CHECK(loop.control().reason().kind == how);
    CHECK(loop.supervision().address == address);
    CHECK(it.writes == 0);
    CHECK(it.far().state_machine().state() == state::switch_on_disabled);
}
template <typename Device> void refuses_when(std::uint16_t address, std::uint16_t word, outcome_kind how)
{
    bench<Device> it;
    it.set(address, word);
    refuses(it, how, address);
}

} // namespace

TEST_CASE("motion law: S19 no start and no cycle orders a drive that would run on without its line")
{
    test::later_drives::for_each([]<typename Device>() {
        refuses_when<Device>(sll, 0, outcome_kind::unsupervised);
        refuses_when<Device>(sll, 4, outcome_kind::runs_on_without_link);
        refuses_when<Device>(fr1, 1, outcome_kind::other_channel);
    });
    refuses_when<atv320::device>(sll, 5, outcome_kind::runs_on_without_link);
    refuses_when<atv320::device>(chcf, 3, outcome_kind::not_drive_profile);
    refuses_when<atv28::device>(cmi_28, 0x4000, outcome_kind::unsupervised);
}

TEST_CASE("motion law: S19 a direct start is refused as a start is")
{
    bench<atv28::device> it;
    it.set(cmi_28, 0x4000);
    atv28::direct_start go{it.drive, 30_Hz};
    REQUIRE(it.run(go));
    CHECK(go.reason().kind == outcome_kind::unsupervised);
    CHECK(go.supervision().address == cmi_28);
    CHECK(it.writes == 0);
}

TEST_CASE("motion law: S19 a risk that somebody names is taken")
{
    bench<atv320::device> it;
    it.set(sll, 0);
    supervision_options const risky{.risks = {.accept_unsupervised = true}};
    start go{it.drive, 30_Hz, run_direction::forward, milliseconds(3'000), risky};
    REQUIRE(it.run(go));
    CHECK(go.running());
    CHECK(go.supervision().accepted.accept_unsupervised);
    cyclic<atv320::device> loop{it.drive, {.supervision = risky}};
    it.cycle(loop, milliseconds(500));
    CHECK(it.order(loop));
}

TEST_CASE("motion law: S19 a report that nobody filled orders nothing, and one that did saves the reads")
{
    bench<atv320::device> it;
    start blind{it.drive, 30_Hz, run_direction::forward, milliseconds(3'000), supervision_report{}};
    REQUIRE(it.run(blind));
    CHECK(blind.reason().kind == outcome_kind::unchecked);
    CHECK(it.writes == 0);

    check_supervision safe{it.drive};
    REQUIRE(it.run(safe));
    std::size_t const before = it.requests();
    start go{it.drive, 30_Hz, run_direction::forward, milliseconds(3'000), safe.report()};
    REQUIRE(it.run(go));
    CHECK(go.running());
    // Four looks, three commands, CHCF, the reference, and it with the command read back twice.
    CHECK(it.requests() - before == 11);
}

TEST_CASE("motion law: S28 no start and no cycle orders a drive that would restart by itself")
{
    refuses_when<atv320::device>(atr, 1, outcome_kind::restarts_by_itself);
    refuses_when<atv28::device>(atr_28, 1, outcome_kind::restarts_by_itself);
}

TEST_CASE("motion law: S36 no start and no cycle orders a drive whose time-out the line cannot keep")
{
    bench<atv320::device> it;
    it.set(tto, 10); // 1 s
    // Thirty slots, 25 ms each, and a unit that is off.
    supervision_options const line{.longest_gap = longest_gap_of(30, milliseconds(25), milliseconds(1'000))};
    start go{it.drive, 30_Hz, run_direction::forward, milliseconds(3'000), line};
    REQUIRE(it.run(go));
    CHECK(go.reason().kind == outcome_kind::timeout_too_short);
    CHECK(go.supervision().period.timeout == milliseconds(1'000));
    CHECK(go.supervision().period.shortest_timeout() == milliseconds(5'250));
    cyclic<atv320::device> loop{it.drive, {.supervision = line}};
    it.cycle(loop, milliseconds(1'000));
    CHECK_FALSE(it.order(loop));
    CHECK(loop.control().reason().kind == outcome_kind::timeout_too_short);
    CHECK(it.writes == 0);
}

TEST_CASE("motion law: S33 a drive that was read once and left alone trips, and no start runs it before a reset")
{
    test::later_drives::for_each([]<typename Device>() {
        bench<Device> it;
        single_request contact{it.drive.unit(), read_holding_registers{Device::layout.eta, 1}};
        REQUIRE(it.run(contact));
        it.idle(milliseconds(30'000));
        REQUIRE(it.far().state_machine().state() == state::fault);
        start go{it.drive, 30_Hz};
        REQUIRE(it.run(go));
        CHECK(go.reason().kind == outcome_kind::in_fault);
        CHECK(go.reason().fault != 0);
        CHECK(it.writes == 0);
        reset_fault reset{it.drive};
        REQUIRE(it.run(reset));
        CHECK(reset.succeeded());
        CHECK(it.far().state_machine().state() == state::switch_on_disabled);
        start again{it.drive, 30_Hz};
        REQUIRE(it.run(again));
        CHECK(again.running());
    });
}
