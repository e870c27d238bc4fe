// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stopping everyone, on a line where frames collide: what counts is that every motor loses its power.
#include "support/catch.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "motion_law/colliding_line.hpp"
#include "support/drives.hpp"
#include "support/one_in.hpp"
#include "support/simulated_bus.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr station<atv320::device> press{unit_id{1}};
constexpr station<atv320::device> mixer{unit_id{2}};
constexpr station<atv28::device> fan{unit_id{3}};
constexpr station<atv320::device> absent{unit_id{9}};
constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr client_options slow{.response_timeout = milliseconds(1'000), .retries = 2};

/// Two later drives and an older one on a bus, running.
struct hall : test::colliding_line<bus<6>, atv320::device, atv320::device, atv28::device> {
    using base = test::colliding_line<bus<6>, atv320::device, atv320::device, atv28::device>;

    explicit hall(client_options const& options = patient)
        : base{bus<6>{test::colliding_timing, options}, press, mixer, fan}
    {
        run_for(milliseconds(20));
    }

    auto& first() { return unit<0>(); }
    auto& second() { return unit<1>(); }
    auto& old() { return unit<2>(); }

    template <typename Conversation> void bring_up(std::size_t slot, Conversation& conversation)
    {
        run_until([&] { return conversation.settled(); }, milliseconds(5'000),
                  [&](instant at) { link().converse(slot, conversation, at); });
        REQUIRE(conversation.running());
    }

    template <typename Unit> static bool has_power(Unit const& unit)
    {
        return cia402::has_power(unit.drive().state_machine().state());
    }
    bool has_any_power() { return has_power(first()) or has_power(second()) or has_power(old()); }
};

} // namespace

TEST_CASE("motion law: S13 everyone is stopped while a start climbs and a cycle runs: no motor has power afterwards")
{
    unsigned moments = 0;
    for (std::uint32_t after_ms = 0; after_ms < 600; after_ms += 2 * test::one_in(7)) {
        INFO("stopped " << after_ms << " ms after the orders");
        hall it;
        cyclic<atv320::device> loop{mixer, {.period = milliseconds(50)}};
        auto const cycle = [&](instant at) { it.link().converse(0, loop, at); };
        it.run_for(milliseconds(600), cycle);
        REQUIRE(loop.run(1'200_rpm));
        start go{press, 50_Hz};
        start old{fan, 30_Hz};
        auto const work = [&](instant at) {
            cycle(at);
            it.link().converse(1, go, at);
            it.link().converse(2, old, at);
        };
        it.run_for(milliseconds(after_ms), work);
        broadcast_stop all{press, mixer, fan};
        bool is_done = false;
        it.run_for(milliseconds(20'000), [&](instant at) {
            it.link().run_urgent(all, at);
            is_done = is_done or all.succeeded();
            work(at);
        });
        REQUIRE(all.settled());
        CHECK_FALSE(it.has_any_power());
        CHECK(is_done);
        // Neither does what was ordered before come back, nor does a stray command to run start anybody.
        it.run_for(milliseconds(5'000), work);
        CHECK_FALSE(it.has_any_power());
        CHECK_FALSE(loop.control().is_ordered());
        // A new order is taken.
        CHECK(loop.run(1'200_rpm));
        it.run_for(milliseconds(2'000), work);
        CHECK(it.second().drive().state_machine().state() == state::operation_enabled);
        ++moments;
    }
    CHECK(moments >= 300 / test::one_in(7));
}

TEST_CASE("motion law: S14 the broadcast that stops leaves at once behind a question to a unit that is off")
{
    for (std::uint32_t after_ms = 1; after_ms < 900; after_ms += 30) {
        INFO("stopped " << after_ms << " ms after the request");
        hall it{slow};
        start go{press, 50_Hz};
        it.bring_up(1, go);
        single_request request{absent.unit(), read_holding_registers{3'201, 1}};
        auto const ask = [&](instant at) {
            if (not request.settled()) {
                it.link().converse(0, request, at);
            }
        };
        it.run_for(milliseconds(after_ms), ask);
        REQUIRE_FALSE(request.settled());
        broadcast_stop all{press, mixer, fan};
        instant const asked = it.now();
        std::size_t const before = it.wire().spoken();
        it.run_until([&] { return it.wire().spoken() != before; }, milliseconds(500),
                     [&](instant at) {
                         it.link().run_urgent(all, at);
                         ask(at);
                     });
        // A request that is leaving leaves whole, and the line is silent for t3.5.
        CHECK(it.wire().spoke_at() - asked < milliseconds(10));
        it.run_for(milliseconds(400), [&](instant at) { it.link().run_urgent(all, at); });
        CHECK_FALSE(hall::has_power(it.first()));
        // Its asker was told.
        it.run_for(milliseconds(20), ask);
        CHECK(request.outcome().error() == errc::cancelled);
    }
}

TEST_CASE("motion law: S14 an answer that is arriving is let in, and one that an ATV28 owes is waited for")
{
    hall it{slow};
    it.old().latency = milliseconds(300);
    start go{press, 50_Hz};
    it.bring_up(1, go);
    single_request request{fan.unit(), read_holding_registers{atv28::device::layout.eta, 1}};
    auto const ask = [&](instant at) { it.link().converse(0, request, at); };
    for (bool const cuts : {false, true}) {
        INFO("cuts an ATV28 short: " << cuts);
        request.again();
        it.run_for(milliseconds(100), ask);
        REQUIRE_FALSE(request.settled());
        broadcast_stop all{broadcast_stop_options{.cuts_short = cuts}, press, mixer, fan};
        instant const asked = it.now();
        std::size_t const before = it.wire().spoken();
        it.run_until([&] { return it.wire().spoken() != before; }, milliseconds(900),
                     [&](instant at) {
                         it.link().run_urgent(all, at);
                         ask(at);
                     });
        duration const waited = it.wire().spoke_at() - asked;
        CHECK((waited < milliseconds(10)) == cuts);
        CHECK(waited < milliseconds(260)); // 300 ms and a response of 7 bytes, of which 100 ms are over
        it.run_for(milliseconds(8'000), [&](instant at) { it.link().run_urgent(all, at); });
        CHECK(all.settled());
        CHECK_FALSE(it.has_any_power());
    }
}

TEST_CASE("motion law: S14 the broadcast never speaks into an answer that has begun, and the asker gets it")
{
    unsigned arrived = 0;
    for (std::uint32_t after = 0; after < 40; ++after) {
        INFO(after << " half milliseconds after the request");
        hall it{slow};
        single_request request{mixer.unit(), read_holding_registers{3'201, 1}};
        it.run_for(microseconds(500 * after + 1), [&](instant at) { it.link().converse(0, request, at); });
        broadcast_stop all{press, mixer};
        it.run_for(milliseconds(60), [&](instant at) {
            it.link().run_urgent(all, at);
            if (not request.settled()) {
                it.link().converse(0, request, at);
            }
        });
        CHECK(it.wire().spoke_over() == 0);
        arrived += request.outcome().has_value() ? 1U : 0U;
    }
    // The request takes 4.6 ms, the silence behind it 2, the response 4.
    CHECK(arrived > 10);
    CHECK(arrived < 40);
}

TEST_CASE("motion law: S13 a drive that is not among those to stop loses its order, too, and gets none before the end")
{
    hall it;
    cyclic<atv320::device> loop{mixer, {.period = milliseconds(50)}};
    auto const cycle = [&](instant at) { it.link().converse(0, loop, at); };
    it.run_for(milliseconds(600), cycle);
    REQUIRE(loop.run(1'200_rpm));
    it.run_for(milliseconds(3'000), cycle);
    REQUIRE(hall::has_power(it.second()));
    start turn{fan, 30_Hz};
    it.bring_up(1, turn);
    // The 8501 of an ATV320 stops the pump as well; what counts is that nothing brings it up again.
    broadcast_stop all{broadcast_stop_options{.left_out = atv320::device::layout.cmd}, fan};
    bool was_refused = false;
    it.run_until([&] { return all.settled(); }, milliseconds(20'000),
                 [&](instant at) {
                     it.link().run_urgent(all, at);
                     cycle(at);
                     was_refused = was_refused or not loop.control().is_ordered();
                     if (not all.settled() and not loop.control().is_ordered() and not hall::has_power(it.second())) {
                         loop.run(1'200_rpm); // too early
                     }
                 });
    CHECK(all.reason(0).kind == outcome_kind::succeeded);
    CHECK(was_refused);
    // Nobody waited for the pump: it may not be read without power yet, and stays off after it.
    it.run_for(milliseconds(10'000), cycle);
    CHECK_FALSE(hall::has_power(it.second()));
    CHECK_FALSE(it.link().is_ordered(mixer.unit()));
}

TEST_CASE("motion law: S38 a family is left out of the broadcasts, and its drives are stopped one by one")
{
    hall it;
    start go{press, 50_Hz};
    start turn{fan, 30_Hz};
    it.bring_up(1, go);
    it.bring_up(2, turn);
    // Something else on the line has its register 400, and must not be written there.
    broadcast_stop all{broadcast_stop_options{.left_out = atv28::device::layout.cmd}, press, fan};
    bool writes_400 = false;
    bool writes_8501 = false;
    it.run_until([&] { return all.settled(); }, milliseconds(20'000),
                 [&](instant at) {
                     it.link().run_urgent(all, at);
                     if (auto const next = all.next(); next and next->frame()[0] == std::byte{0}) {
                         writes_400 = writes_400 or u16_at(next->frame(), 2) == 400;
                         writes_8501 = writes_8501 or u16_at(next->frame(), 2) == 8'501;
                     }
                 });
    CHECK(all.succeeded());
    CHECK_FALSE(writes_400);
    CHECK(writes_8501);
    CHECK_FALSE(it.has_any_power());
}

namespace {

/// The addresses that a stop of everyone writes to in its first round; how long until no motor has power.
struct told_everyone {
    std::vector<unsigned> addresses;
    bool is_off_at_once;
};

/// Of a bus that ordered one drive of each family, or two of one, to run; the stop names one.
template <typename Ordered>
told_everyone tell(auto const& named, station<Ordered> const& unnamed, std::uint16_t left_out = 0)
{
    hall it;
    start go{named, 30_Hz};
    start other{unnamed, 30_Hz};
    it.bring_up(1, go);
    it.bring_up(2, other);
    broadcast_stop all{broadcast_stop_options{.left_out = left_out}, named};
    told_everyone told{};
    instant const asked = it.now();
    it.run_until([&] { return not it.has_any_power(); }, milliseconds(20'000),
                 [&](instant at) {
                     it.link().run_urgent(all, at);
                     auto const next = all.is_urgent() ? all.next() : std::nullopt;
                     unsigned const address = next ? u16_at(next->frame(), 2) : 0;
                     if (address != 0 and
                         std::find(told.addresses.begin(), told.addresses.end(), address) == told.addresses.end()) {
                         told.addresses.push_back(address);
                     }
                 });
    told.is_off_at_once = not it.has_any_power() and it.now() - asked < milliseconds(300);
    return told;
}

} // namespace

TEST_CASE("motion law: L5 a drive that is ordered and not named hears the broadcasts of its family, too")
{
    using addresses = std::vector<unsigned>;
    told_everyone const of_later = tell(press, fan);
    CHECK(of_later.addresses == addresses{8'501, 400});
    CHECK(of_later.is_off_at_once);
    told_everyone const of_older = tell(fan, press);
    CHECK(of_older.addresses == addresses{400, 8'501});
    CHECK(of_older.is_off_at_once);
    // Where the unnamed one was read to be of the same family, nothing is written to the other's register.
    CHECK(tell(press, mixer).addresses == addresses{8'501});
    // What is left out is left out for it, too; without another address the broadcasts go to it alone.
    CHECK(tell(press, fan, 400).addresses == addresses{8'501});
    CHECK(tell(press, fan, 8'501).addresses == addresses{400});
}

namespace {

/// The word of the first broadcast to a drive that runs, of a client that has checked it or not.
template <typename Device> unsigned broadcast_word(bool is_checked, bool freewheel = false)
{
    constexpr station<Device> drive{unit_id{3}};
    test::simulated_bus<drive_client<4>, Device> it{drive_client<4>{test::bus_timing, {}}};
    it.add(drive.unit());
    it.idle(milliseconds(20));
    start go{drive, 30_Hz};
    REQUIRE(it.run(go));
    REQUIRE(go.succeeded());
    if (not is_checked) {
        it.link() = drive_client<4>{test::bus_timing, {}}; // one that has just begun
    }
    unsigned word = 0xFFFF;
    it.disturb([&](auto& frame, bool is_request) {
        if (is_request and frame[0] == std::byte{0} and word == 0xFFFF) {
            word = u16_at(byte_view{frame}, 4);
        }
    });
    broadcast_stop all{broadcast_stop_options{.freewheel = freewheel}, drive};
    REQUIRE(it.run(all));
    CHECK(all.succeeded());
    CHECK(all.reason(0).is_other_stop == (word == 0 and not freewheel));
    return word;
}

} // namespace

TEST_CASE("motion law: L5 everyone is told 0002, or 0000 where a drive's words were not read or freewheel is asked for")
{
    test::later_drives::for_each([]<typename Device>() {
        CHECK(broadcast_word<Device>(false) == 0x0000);
        CHECK(broadcast_word<Device>(true) == 0x0002);
        CHECK(broadcast_word<Device>(true, true) == 0x0000);
    });
    CHECK(broadcast_word<atv28::device>(false) == 0x0002); // no other family has that control word
    CHECK(broadcast_word<atv28::device>(true, true) == 0x0000);
}
