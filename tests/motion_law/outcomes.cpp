// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An outcome reaches only the conversation that asked: what happened to motors where it did not. Simulated drives,
// on a line on which time passes; what counts is what the motor does, not what a conversation says of it.
#include "support/catch.hpp"
#include "support/simulated_bus.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_freewheel.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/client/bus.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

using device = atv320::device;
constexpr station<device> drive{unit_id{1}};
constexpr station<device> other_drive{unit_id{2}};
constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr std::uint16_t factory_settings = 0x0001;

/// A poll of one register, as a program's panel does it: begun again once it has its value.
struct panel {
    unit_id unit;
    std::uint16_t address;
    std::optional<single_request<read_holding_registers>> ask{};
    std::vector<std::uint16_t> values{};
    unsigned failures{0};
    unsigned dropped{0}; ///< it stayed away, and was told so

    panel(unit_id of, std::uint16_t at) : unit{of}, address{at} { begin(); }
    void begin() { ask.emplace(unit, read_holding_registers{address, 1}); }
    void take()
    {
        if (not ask->settled()) {
            return;
        }
        auto const outcome = ask->outcome();
        if (outcome) {
            values.push_back(u16_at(outcome->pdu(), 2));
        } else if (outcome.error() == errc::cancelled) {
            ++dropped;
        } else {
            ++failures;
        }
    }
};

/// A client with up to two drives. `Link` may be a bus.
template <typename Link> struct plant : test::simulated_bus<Link, device> {
    using base = test::simulated_bus<Link, device>;

    explicit plant(std::size_t drives = 1) : base{Link{test::bus_timing, patient}}
    {
        for (std::size_t i = 0; i < drives; ++i) {
            this->add(*unit_id::checked(static_cast<std::uint32_t>(i + 1)));
        }
        this->idle(milliseconds(20));
    }

    std::int32_t hertz(std::size_t index = 0) { return this->drive(index).motor().frequency() / 1'000; }
    state state_of(std::size_t index = 0) { return this->drive(index).state_machine().state(); }

    /// One pass in which this is done, and at most so long a sleep.
    template <typename Act> void pass(Act act) { this->step(act, milliseconds(5)); }
};

/// Lets the request of one conversation leave and its response come, so that the outcome is there, taken by nobody.
template <typename Link, typename ComeBy> void leave_an_outcome(plant<Link>& it, ComeBy come_by)
{
    std::size_t const asked = it.requests();
    std::size_t const answered = it.answers(0);
    while (it.requests() == asked) {
        it.pass(come_by);
    }
    for (unsigned i = 0; i < 20; ++i) {
        it.pass([](instant) {});
    }
    REQUIRE(it.answers(0) == answered + 1);
}

} // namespace

TEST_CASE("motion law: S1 a poll's answer is not a start's: the motor runs at the reference that "
          "was asked for")
{
    plant<drive_client<4>> it;
    start before{drive, 1'400_rpm};
    REQUIRE(it.run(before));
    stop rest{drive};
    REQUIRE(it.run(rest));
    REQUIRE(it.drive().word("LFRD") == 1'400);
    panel status{drive.unit(), device::layout.eta};
    leave_an_outcome(it, [&](instant now) { it.link().converse(*status.ask, now); });
    start go{drive, 100_rpm};
    REQUIRE(it.run(go));
    CHECK(go.succeeded());
    it.idle(milliseconds(5'000));
    CHECK(it.drive().word("LFRD") == 100);
    CHECK((it.drive().word("RFRD") + 1) / 2 == 50); // 99 or 100: the frequency has steps
}

TEST_CASE("motion law: S1 wherever the poll stands when the start begins")
{
    for (std::uint32_t after = 0; after <= 30; ++after) {
        INFO("begun " << after << " passes after the poll");
        plant<drive_client<4>> it;
        start before{drive, 1'400_rpm};
        REQUIRE(it.run(before));
        stop rest{drive};
        REQUIRE(it.run(rest));
        panel status{drive.unit(), device::layout.eta};
        for (std::uint32_t i = 0; i < after; ++i) {
            it.pass([&](instant now) { it.link().converse(*status.ask, now); });
        }
        start go{drive, 100_rpm};
        REQUIRE(it.run(go));
        CHECK(go.succeeded());
        it.idle(milliseconds(5'000));
        CHECK((it.drive().word("RFRD") + 1) / 2 == 50); // 99 or 100: the frequency has steps
    }
}

TEST_CASE("motion law: S2 a poll's answer is not a save's: nothing is written to CMI but the order "
          "to save")
{
    for (std::uint32_t after = 0; after <= 30; ++after) {
        INFO("begun " << after << " passes after the poll");
        plant<drive_client<4>> it;
        // A ramp that factory settings would take away.
        auto ramp = write_with_step<deciseconds, atv320::acc>(drive, 7.7_s);
        REQUIRE(it.run(ramp));
        // Ready to switch on, its status is 0231h: bit 0 is the order for factory settings.
        single_request get_ready{drive.unit(), write_single_register{device::layout.cmd, 0x0006}};
        REQUIRE(it.run(get_ready));
        REQUIRE((it.drive().word("ETA") & factory_settings) != 0);
        panel status{drive.unit(), device::layout.eta};
        for (std::uint32_t i = 0; i < after; ++i) {
            it.pass([&](instant now) { it.link().converse(*status.ask, now); });
        }
        save_to_eeprom save{drive};
        bool wrote_factory = false;
        bool const is_over =
            it.run([&](instant now) { it.link().converse(save, now); },
                   [&] {
                       byte_view const sent = it.request();
                       bool const is_write =
                           sent.size() == 8 and to_u8(sent[1]) == 6 and u16_at(sent, 2) == device::layout.cmi;
                       wrote_factory = wrote_factory or (is_write and (u16_at(sent, 4) & factory_settings) != 0);
                       return save.settled();
                   },
                   milliseconds(60'000));
        REQUIRE(is_over);
        CHECK(save.succeeded());
        CHECK_FALSE(wrote_factory);
        CHECK(it.drive().word("ACC") == 77);
    }
}

TEST_CASE("motion law: S3 a poll's answer is not a stop's: where the line fails the stop does not "
          "succeed")
{
    plant<drive_client<4>> it;
    start go{drive, 50_Hz};
    REQUIRE(it.run(go));
    it.idle(milliseconds(4'000));
    REQUIRE(it.hertz() == 50);
    panel fault{drive.unit(), device::layout.lft};
    leave_an_outcome(it, [&](instant now) { it.link().converse(*fault.ask, now); });
    it.cut(0, true);
    stop halt{drive, stop_by::ramp, milliseconds(3'000)};
    REQUIRE(it.run(halt));
    // Within a time in which the drive does not stop by itself.
    REQUIRE(it.hertz() == 50);
    CHECK_FALSE(halt.succeeded());
}

TEST_CASE("motion law: S3 the same in one slot of a bus")
{
    plant<bus<2>> it{2};
    start go{drive, 50_Hz};
    REQUIRE(it.run([&](instant now) { it.link().converse(0, go, now); }, [&] { return go.settled(); },
                   milliseconds(10'000)));
    it.idle(milliseconds(4'000));
    REQUIRE(it.hertz() == 50);
    panel fault{drive.unit(), device::layout.lft};
    leave_an_outcome(it, [&](instant now) { it.link().converse(0, *fault.ask, now); });
    it.cut(0, true);
    stop halt{drive};
    bool has_ended_while_running = false;
    REQUIRE(it.run([&](instant now) { it.link().converse(0, halt, now); },
                   [&] {
                       has_ended_while_running = has_ended_while_running or (halt.succeeded() and it.hertz() != 0);
                       return halt.settled();
                   },
                   milliseconds(60'000)));
    CHECK_FALSE(has_ended_while_running);
    CHECK_FALSE(halt.succeeded());
}

TEST_CASE("motion law: S4 a start behind a cancelled start ends with its own outcome")
{
    for (std::uint32_t after = 0; after <= 40; ++after) {
        INFO("cancelled after " << after << " passes");
        plant<drive_client<4>> it;
        start first{drive, 50_Hz};
        for (std::uint32_t i = 0; i < after; ++i) {
            it.pass([&](instant now) { it.link().converse(first, now); });
        }
        it.link().cancel(it.now());
        start second{drive, 30_Hz};
        REQUIRE(it.run(second));
        CHECK(second.succeeded());
        CHECK(second.reason().error == errc::none);
        it.idle(milliseconds(5'000));
        CHECK(it.hertz() == 30);
    }
}

TEST_CASE("motion law: S4 a stop behind a cancelled poll ends with its own outcome")
{
    for (std::uint32_t after = 0; after <= 15; ++after) {
        INFO("cancelled after " << after << " passes");
        plant<drive_client<4>> it;
        start go{drive, 50_Hz};
        REQUIRE(it.run(go));
        it.idle(milliseconds(3'000));
        panel status{drive.unit(), device::layout.eta};
        for (std::uint32_t i = 0; i < after; ++i) {
            it.pass([&](instant now) { it.link().converse(*status.ask, now); });
        }
        it.link().cancel(it.now());
        stop halt{drive};
        REQUIRE(it.run(halt));
        CHECK(halt.succeeded());
        CHECK(it.drive().motor().is_at_rest());
    }
}

TEST_CASE("motion law: S5 the empty outcome of a broadcast is never an exchange of a cycle")
{
    for (std::uint32_t after = 1; after <= 30; ++after) {
        INFO("the cycle comes by " << after << " passes after the broadcast");
        plant<drive_client<4>> it;
        auto everyone = broadcast_freewheel<device>();
        for (std::uint32_t i = 0; i < after; ++i) {
            it.pass([&](instant now) { it.link().converse(everyone, now); });
        }
        cyclic<device> cycle{drive};
        // At first hand the conversation holds nothing that a drive has said.
        std::size_t const before = it.answers(0);
        bool has_heard_nothing = true;
        instant const end = it.now() + milliseconds(3'000);
        while (not reached(it.now(), end)) {
            it.pass([&](instant now) { it.link().converse(cycle, now); });
            bool const is_heard = it.answers(0) > before;
            has_heard_nothing = has_heard_nothing and (is_heard or cycle.link_lost());
        }
        CHECK(has_heard_nothing);
        CHECK_FALSE(cycle.link_lost());
        CHECK(cycle.input(0) == it.drive().word("ETA"));
    }
}

namespace {

/// Asks in a place of the stack that is used for something else at once.
template <typename Link> [[gnu::noinline]] void ask_and_give_up(plant<Link>& it)
{
    single_request local{unit_id{1}, read_holding_registers{3201, 1}};
    it.link().advance(it.now());
    it.link().converse(local, it.now());
}

[[gnu::noinline]] unsigned use_the_stack()
{
    std::array<unsigned, 256> waste{};
    unsigned* volatile place = waste.data();
    for (unsigned i = 0; i < waste.size(); ++i) {
        place[i] = 0x5A;
    }
    return place[17];
}

} // namespace

TEST_CASE("motion law: S6 the question of a function that gave it up leaves as it was asked, or "
          "not at all")
{
    plant<drive_client<4>> it;
    ask_and_give_up(it);
    CHECK(use_the_stack() == 0x5A);
    byte_view const sent = it.link().poll_transmit();
    single_request const asked{unit_id{1}, read_holding_registers{3201, 1}};
    auto same = asked;
    bool const is_as_asked = sent.empty() or same_bytes(sent, same.next()->frame());
    CHECK(is_as_asked);
}

TEST_CASE("motion law: S6 the same where it lived on the heap, and where it waits for a busy line")
{
    for (bool const is_busy : {false, true}) {
        plant<drive_client<4>> it;
        if (is_busy) {
            std::array<std::byte, 1> const noise{};
            it.link().receive(noise, it.now());
        }
        auto conversation =
            std::make_unique<single_request<read_holding_registers>>(unit_id{1}, read_holding_registers{3201, 1});
        it.link().advance(it.now());
        it.link().converse(*conversation, it.now());
        byte_view const asked = conversation->next()->frame();
        std::vector<std::byte> const frame{asked.begin(), asked.end()};
        conversation.reset();
        for (unsigned i = 0; i < 200; ++i) {
            instant const now = it.now() + milliseconds(i);
            it.link().advance(now);
            byte_view const sent = it.link().poll_transmit();
            if (not sent.empty()) {
                CHECK(same_bytes(sent, frame));
            }
        }
    }
}

TEST_CASE("motion law: S6 two conversations that take turns on one client get their own values")
{
    plant<drive_client<4>> it;
    panel one{drive.unit(), 3201};
    panel other{drive.unit(), 9001};
    auto ramp = write_with_step<deciseconds, atv320::acc>(drive, 7.7_s);
    REQUIRE(it.run(ramp));
    std::uint16_t const status = it.drive().word("ETA");
    REQUIRE(status != 77);
    // Turn by turn, and each for some passes.
    for (unsigned const turn : {1U, 2U, 3U, 7U, 20U}) {
        for (unsigned i = 0; i < 600; ++i) {
            panel& mine = i / turn % 2 == 0 ? one : other;
            it.pass([&](instant now) { it.link().converse(*mine.ask, now); });
            if (mine.ask->settled()) {
                mine.take();
                mine.begin();
            }
        }
    }
    CHECK(one.values.size() > 20);
    CHECK(other.values.size() > 20);
    CHECK(one.failures == 0);
    CHECK(other.failures == 0);
    bool const is_one_right =
        std::all_of(one.values.begin(), one.values.end(), [&](std::uint16_t value) { return value == status; });
    bool const is_other_right =
        std::all_of(other.values.begin(), other.values.end(), [&](std::uint16_t value) { return value == 77; });
    CHECK(is_one_right);
    CHECK(is_other_right);
}

TEST_CASE("motion law: S15 a slot dropped with its question in flight stops no other, and no drive trips")
{
    for (std::uint32_t after = 1; after <= 20; ++after) {
        INFO("dropped after " << after << " passes");
        plant<bus<3>> it{2};
        cyclic<device> cycle{other_drive};
        panel status{drive.unit(), device::layout.eta};
        bool is_ordered = false;
        auto const serve = [&](instant now) {
            it.link().converse(1, cycle, now);
            is_ordered = is_ordered or cycle.run(1'200_rpm);
        };
        instant end = it.now() + milliseconds(5'000);
        while (not reached(it.now(), end)) {
            it.pass(serve);
        }
        REQUIRE(it.hertz(1) == 40);
        for (std::uint32_t i = 0; i < after; ++i) {
            it.pass([&](instant now) {
                it.link().converse(0, *status.ask, now);
                serve(now);
            });
        }
        std::size_t const before = it.requests();
        end = it.now() + milliseconds(30'000);
        while (not reached(it.now(), end)) {
            it.pass(serve);
        }
        // One exchange in 100 ms.
        CHECK(it.requests() - before > 250);
        CHECK(it.state_of(1) == state::operation_enabled);
        CHECK(it.hertz(1) == 40);
    }
}

TEST_CASE("motion law: S15 an urgent broadcast dropped after its frame left stops no other")
{
    for (std::uint32_t after = 1; after <= 12; ++after) {
        INFO("dropped after " << after << " passes");
        plant<bus<2>> it{2};
        cyclic<device> cycle{other_drive};
        auto const serve = [&](instant now) { it.link().converse(0, cycle, now); };
        instant end = it.now() + milliseconds(2'000);
        while (not reached(it.now(), end)) {
            it.pass(serve);
        }
        auto everyone = broadcast_freewheel<device>();
        for (std::uint32_t i = 0; i < after; ++i) {
            it.pass([&](instant now) {
                it.link().run_urgent(everyone, now);
                serve(now);
            });
        }
        std::size_t const before = it.requests();
        end = it.now() + milliseconds(30'000);
        while (not reached(it.now(), end)) {
            it.pass(serve);
        }
        CHECK(it.requests() - before > 250);
        CHECK_FALSE(cycle.link_lost());
    }
}
