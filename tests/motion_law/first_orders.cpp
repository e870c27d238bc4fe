// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A start and a cycle order no drive that would not stop by itself, and a drive that tripped while nobody ordered it.
#include "support/catch.hpp"
#include "support/party_line.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic.hpp>
#include <rtuwire/altivar/direct_control.hpp>
#include <rtuwire/altivar/reset_fault.hpp>
#include <rtuwire/altivar/start.hpp>
#include <rtuwire/client/single_question.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr std::uint16_t sll = 7010, tto = 6005, chcf = 8401, fr1 = 8413, atr = 7122, cmi_28 = 402,
                        atr_28 = 150;

/// A client, a drive, and how many frames were written to it.
template <typename Device> struct bench : test::party_line<drive_client<4>, Device> {
    static constexpr station<Device> drive{unit_id{3}};
    unsigned writes{0};

    bench() : test::party_line<drive_client<4>, Device>{drive_client<4>{test::party_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
        this->disturb([this](std::vector<std::byte>& frame, bool is_request) {
            writes += is_request and frame[1] != std::byte{3} ? 1U : 0U;
        });
    }
    sim::drive<Device>& far() { return this->unit(0).inside(); }
    void set(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        REQUIRE(far().check_write(address, value) == errc::none);
        static_cast<void>(far().write(address, value));
        this->idle(milliseconds(20));
    }
    bool order(cyclic<Device>& loop)
    {
        if constexpr (cycle_words<Device>::has_scanner) {
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
template <typename Device> void refuses(bench<Device>& it, ending how, std::uint16_t address)
{
    INFO(std::string(Device::name.begin(), Device::name.end()) << " register " << address);
    start go{it.drive, 30_Hz};
    REQUIRE(it.run(go));
    CHECK(go.reason().how == how);
    CHECK(go.supervision().address == address);
    cyclic<Device> loop{it.drive};
    for (unsigned moment = 0; moment < 30; ++moment) {
        CHECK_FALSE(it.order(loop));
        it.cycle(loop, milliseconds(50));
    }
    CHECK(loop.control().reason().how == how);
    CHECK(loop.supervision().address == address);
    CHECK(it.writes == 0);
    CHECK(it.far().chart().state() == state::switch_on_disabled);
}
template <typename Device> void refuses_when(std::uint16_t address, std::uint16_t word, ending how)
{
    bench<Device> it;
    it.set(address, word);
    refuses(it, how, address);
}

template <typename Run> void for_later_drives(Run run)
{
    run(atv12::device{});
    run(atv310::device{});
    run(atv310::device_2026{});
    run(atv320::device{});
}

} // namespace

TEST_CASE("motion law: S19 no start and no cycle orders a drive that would run on without its line")
{
    for_later_drives([]<typename Device>(Device) {
        refuses_when<Device>(sll, 0, ending::unsupervised);
        refuses_when<Device>(sll, 4, ending::runs_on_without_link);
        refuses_when<Device>(fr1, 1, ending::other_channel);
    });
    refuses_when<atv320::device>(sll, 5, ending::runs_on_without_link);
    refuses_when<atv320::device>(chcf, 3, ending::not_drive_profile);
    refuses_when<atv28::device>(cmi_28, 0x4000, ending::unsupervised);
}

TEST_CASE("motion law: S19 a direct start is refused as a start is")
{
    bench<atv28::device> it;
    it.set(cmi_28, 0x4000);
    atv28::direct_start go{it.drive, 30_Hz};
    REQUIRE(it.run(go));
    CHECK(go.reason().how == ending::unsupervised);
    CHECK(go.supervision().address == cmi_28);
    CHECK(it.writes == 0);
}

TEST_CASE("motion law: S19 a risk that somebody names is taken")
{
    bench<atv320::device> it;
    it.set(sll, 0);
    supervision_options const risky{.risks = {.accept_unsupervised = true}};
    start go{it.drive, 30_Hz, heading::forward, milliseconds(3'000), risky};
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
    start blind{it.drive, 30_Hz, heading::forward, milliseconds(3'000), supervision_report{}};
    REQUIRE(it.run(blind));
    CHECK(blind.reason().how == ending::unchecked);
    CHECK(it.writes == 0);

    check_supervision safe{it.drive};
    REQUIRE(it.run(safe));
    std::size_t const before = it.questions();
    start go{it.drive, 30_Hz, heading::forward, milliseconds(3'000), safe.report()};
    REQUIRE(it.run(go));
    CHECK(go.running());
    // Four looks, three commands, the reference and the command read back.
    CHECK(it.questions() - before == 9);
}

TEST_CASE("motion law: S28 no start and no cycle orders a drive that would restart by itself")
{
    refuses_when<atv320::device>(atr, 1, ending::restarts_by_itself);
    refuses_when<atv28::device>(atr_28, 1, ending::restarts_by_itself);
}

TEST_CASE("motion law: S36 no start and no cycle orders a drive whose time-out the line cannot keep")
{
    bench<atv320::device> it;
    it.set(tto, 10); // 1 s
    // Thirty slots, 25 ms each, and a unit that is off.
    supervision_options const line{.longest_gap = longest_gap_of(30, milliseconds(25), milliseconds(1'000))};
    start go{it.drive, 30_Hz, heading::forward, milliseconds(3'000), line};
    REQUIRE(it.run(go));
    CHECK(go.reason().how == ending::timeout_too_short);
    CHECK(go.supervision().period.timeout == milliseconds(1'000));
    CHECK(go.supervision().period.shortest_timeout() == milliseconds(5'250));
    cyclic<atv320::device> loop{it.drive, {.supervision = line}};
    it.cycle(loop, milliseconds(1'000));
    CHECK_FALSE(it.order(loop));
    CHECK(loop.control().reason().how == ending::timeout_too_short);
    CHECK(it.writes == 0);
}

TEST_CASE("motion law: S33 a drive that was read once and left alone trips, and no start runs it before a reset")
{
    for_later_drives([]<typename Device>(Device) {
        INFO(std::string(Device::name.begin(), Device::name.end()));
        bench<Device> it;
        single_question contact{it.drive.unit(), read_holding_registers{Device::profile.eta, 1}};
        REQUIRE(it.run(contact));
        it.idle(milliseconds(30'000));
        REQUIRE(it.far().chart().state() == state::fault);
        start go{it.drive, 30_Hz};
        REQUIRE(it.run(go));
        CHECK(go.reason().how == ending::in_fault);
        CHECK(go.reason().fault != 0);
        CHECK(it.writes == 0);
        reset_fault reset{it.drive};
        REQUIRE(it.run(reset));
        CHECK(reset.succeeded());
        CHECK(it.far().chart().state() == state::switch_on_disabled);
        start again{it.drive, 30_Hz};
        REQUIRE(it.run(again));
        CHECK(again.running());
    });
}
