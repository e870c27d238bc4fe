// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The cycle: the manuals' frames, and what it does when something goes wrong.
#include <rtuwire/altivar/cyclic/cyclic.hpp>

#include "support/catch.hpp"
#include "support/commissioned.hpp"
#include "support/drives.hpp"
#include "support/known_words.hpp"
#include "support/simulated_bus.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/inspection/identify.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_freewheel.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

/// A controller that cycles, and the drive.
template <typename Device> struct running : test::simulated_bus<drive_client<4>, Device> {
    cyclic<Device> loop;

    explicit running(cyclic_options const& options = {}, unit_id address = unit_id{3})
        : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, patient}},
          loop{*station<Device>::checked(address.byte()), options}
    {
        this->add(address);
        this->idle(milliseconds(20));
    }

    void pass(duration length)
    {
        this->run([&](instant now) { this->link().converse(loop, now); }, [] { return false; }, length);
    }
    detail::simulated_drive<Device>& far() { return this->drive(0); }
    state now_in() { return far().state_machine().state(); }

    bool order()
    {
        if constexpr (cycle_layout<Device>::has_scanner) {
            return loop.run(1'500_rpm);
        } else {
            return loop.run(50_Hz);
        }
    }
};

// W12701..W12704 and W12721..W12724.
constexpr auto read_inputs = "03 03 31 9D 00 04 DA F9"_hex;
constexpr auto inputs_as_delivered = "03 03 08 0C 81 21 9C 00 00 00 00 D9 9F"_hex;
constexpr auto read_outputs = "03 03 31 B1 00 04 1B 30"_hex;
constexpr auto outputs_as_delivered = "03 03 08 21 35 21 9A 00 00 00 00 66 15"_hex;

/// The frame that a cycle asks next, and a response to it.
template <typename Device> struct by_hand {
    cyclic<Device> loop;
    instant now{0};

    bool asks(byte_view expected)
    {
        now = now + milliseconds(100);
        loop.advance(now);
        auto const request = loop.next();
        return request and same_bytes(request->frame(), expected);
    }
    /// Answers the requests of the check, up to its last one, the status.
    bool is_checked()
    {
        for (unsigned requests = 0; requests < 14; ++requests) {
            loop.advance(now);
            auto const request = loop.next();
            REQUIRE(request);
            std::uint16_t const address = u16_at(request->frame(), 2);
            std::uint16_t const word = test::commissioned_word(address);
            register_block const one{word};
            std::array<std::byte, 256> buffer{};
            auto const frame = encode_into(buffer, loop.unit(), read_holding_registers_response{one});
            REQUIRE(frame);
            say(*frame);
            if (address == 3201) {
                return true;
            }
        }
        return false;
    }
    /// The scanner as delivered.
    bool checks_scanner()
    {
        bool const asks_inputs = asks(read_inputs);
        say(inputs_as_delivered);
        bool const asks_outputs = asks(read_outputs);
        say(outputs_as_delivered);
        return asks_inputs and asks_outputs and is_checked();
    }

    void say(byte_view frame)
    {
        auto const received = decode_adu(frame);
        REQUIRE(received);
        loop.accept(result<response>{response{received->pdu()}});
    }
};

template <typename Device> void runs_a_drive()
{
    running<Device> it;
    CHECK_FALSE(it.order());
    CHECK(it.loop.link_lost());
    it.pass(milliseconds(500));
    CHECK_FALSE(it.loop.link_lost());
    CHECK(it.now_in() == state::switch_on_disabled);
    CHECK(it.order());
    it.pass(milliseconds(6'000));
    CHECK(it.now_in() == state::operation_enabled);
    CHECK(it.loop.control().is_running());
    CHECK(it.loop.speed() == 1'500);
    it.loop.stop();
    it.pass(milliseconds(6'000));
    CHECK(it.now_in() == state::switch_on_disabled);
    CHECK(it.loop.speed() == 0);
}

template <typename Device> void never_resumes()
{
    running<Device> it;
    it.pass(milliseconds(500));
    REQUIRE(it.order());
    it.pass(milliseconds(5'000));
    REQUIRE(it.now_in() == state::operation_enabled);

    it.cut(0, true);
    it.pass(milliseconds(11'000));
    CHECK(it.loop.link_lost());
    CHECK(it.loop.control().reason().kind == outcome_kind::silent);
    CHECK(it.now_in() == state::fault);
    CHECK_FALSE(it.order());
    it.cut(0, false);
    it.pass(milliseconds(28'000)); // nothing was said to it for its longest time-out and a second
    CHECK_FALSE(it.loop.link_lost());
    CHECK(it.now_in() == state::fault);
    CHECK(it.loop.control().reason().fault == 5);
    CHECK_FALSE(it.order());
    it.loop.reset_fault();
    it.pass(milliseconds(2'000));
    CHECK(it.now_in() == state::switch_on_disabled);
    CHECK(it.order());
    it.pass(milliseconds(2'000));
    CHECK(it.now_in() == state::operation_enabled);

    it.far().press_stop();
    it.pass(milliseconds(5'000));
    CHECK(it.now_in() != state::operation_enabled);
    CHECK(it.loop.control().reason().kind == outcome_kind::stop_key);
    CHECK(it.order());
    it.pass(milliseconds(2'000));
    CHECK(it.now_in() == state::operation_enabled);

    it.far().set_local(true);
    it.pass(milliseconds(1'000));
    it.far().set_local(false);
    it.pass(milliseconds(5'000));
    CHECK(it.now_in() != state::operation_enabled);
    CHECK(it.order());
    it.pass(milliseconds(2'000));
    it.far().inject_fault(9);
    it.far().clear_cause();
    it.pass(milliseconds(2'000));
    CHECK(it.loop.control().reason().fault == 9);
    it.loop.reset_fault();
    it.pass(milliseconds(5'000));
    CHECK(it.now_in() == state::switch_on_disabled);
}

/// A controller dies while its motor runs, and another takes its place at once.
template <typename Device> void comes_back()
{
    running<Device> it;
    it.pass(milliseconds(500));
    REQUIRE(it.order());
    it.pass(milliseconds(5'000));
    REQUIRE(it.far().motor().frequency() == 50'000);

    it.loop = cyclic<Device>{*station<Device>::checked(3)};
    it.link().cancel(it.now());
    it.pass(milliseconds(1'000));
    CHECK_FALSE(it.loop.control().is_ordered());
    CHECK(it.far().motor().frequency() < 50'000);
    it.pass(milliseconds(8'000));
    CHECK(it.far().motor().is_at_rest());
    CHECK(it.now_in() != state::operation_enabled);
    it.pass(milliseconds(20'000));
    CHECK(it.far().motor().is_at_rest());
}

} // namespace

TEST_CASE("a controller that comes back brings a running motor down, and never starts it by itself")
{
    test::all_drives::for_each([]<typename Device>() { comes_back<Device>(); });
}

TEST_CASE("the application example by function 23, frame by frame")
{
    by_hand<atv310::device> it{cyclic{station<atv310::device>{unit_id{3}}}};
    CHECK(it.asks("03 03 0C 81 00 01 D6 90"_hex));
    it.say("03 03 02 02 50 C0 D8"_hex);
    CHECK(it.asks("03 03 1B D1 00 01 D3 35"_hex));
    it.say("03 03 02 00 00 C1 84"_hex);
    CHECK(it.checks_scanner());
    CHECK(it.loop.run(1'500_rpm));
    CHECK(it.asks("03 17 31 C5 00 04 31 D9 00 04 08 00 06 05 DC 00 00 00 00 0A C8"_hex));
    it.say("03 17 08 02 31 00 00 00 00 00 00 7F 35"_hex);
    CHECK(it.asks("03 17 31 C5 00 04 31 D9 00 04 08 00 07 05 DC 00 00 00 00 1A 08"_hex));
    it.say("03 17 08 02 33 00 00 00 00 00 00 5C F5"_hex);
    CHECK(it.asks("03 03 21 35 00 01 9F DA"_hex)); // the control word still is the one written last
    it.say("03 03 02 00 07 80 46"_hex);
    CHECK(it.asks("03 17 31 C5 00 04 31 D9 00 04 08 00 0F 05 DC 00 00 00 00 93 C8"_hex));
    it.say("03 17 08 02 37 05 DC 00 00 00 00 C8 B3"_hex);
    CHECK(it.loop.speed() == 1'500);
    CHECK(it.loop.control().is_running());
}

namespace {

/// A cycle of an ATV310 that has told its drive to switch on.
by_hand<atv310::device> told_to_switch_on()
{
    by_hand<atv310::device> it{cyclic{station<atv310::device>{unit_id{3}}}};
    REQUIRE(it.asks("03 03 0C 81 00 01 D6 90"_hex));
    it.say("03 03 02 02 50 C0 D8"_hex);
    REQUIRE(it.asks("03 03 1B D1 00 01 D3 35"_hex));
    it.say("03 03 02 00 00 C1 84"_hex);
    REQUIRE(it.checks_scanner());
    REQUIRE(it.loop.run(1'500_rpm));
    REQUIRE(it.asks("03 17 31 C5 00 04 31 D9 00 04 08 00 06 05 DC 00 00 00 00 0A C8"_hex));
    it.say("03 17 08 02 31 00 00 00 00 00 00 7F 35"_hex);
    REQUIRE(it.asks("03 17 31 C5 00 04 31 D9 00 04 08 00 07 05 DC 00 00 00 00 1A 08"_hex));
    it.say("03 17 08 02 33 00 00 00 00 00 00 5C F5"_hex);
    return it;
}

} // namespace

TEST_CASE("a drive whose control word is not the one written last is not told to run")
{
    auto it = told_to_switch_on();
    REQUIRE(it.asks("03 03 21 35 00 01 9F DA"_hex));
    it.say("03 03 02 00 00 C1 84"_hex); // it lost its power, or somebody else wrote
    CHECK(it.loop.control().reason().kind == outcome_kind::overwritten);
    CHECK_FALSE(it.loop.control().is_ordered());
    CHECK(it.asks("03 06 21 35 00 00 92 1A"_hex));
    it.say("03 06 21 35 00 00 92 1A"_hex);
    CHECK(it.asks("03 03 0C 81 00 01 D6 90"_hex)); // all that an order relies on is read anew
}

TEST_CASE("an exchange on the way up that is not answered is followed by a look, not by the next word")
{
    auto it = told_to_switch_on();
    REQUIRE(it.asks("03 03 21 35 00 01 9F DA"_hex));
    it.loop.accept(errc::timed_out);
    CHECK(it.loop.control().is_ordered());
    CHECK(it.asks("03 03 0C 81 00 01 D6 90"_hex));
}

TEST_CASE("a halt is looked for before it is said, and said right behind the look")
{
    auto it = told_to_switch_on();
    REQUIRE(it.asks("03 03 21 35 00 01 9F DA"_hex));
    it.say("03 03 02 00 07 80 46"_hex);
    REQUIRE(it.asks("03 17 31 C5 00 04 31 D9 00 04 08 00 0F 05 DC 00 00 00 00 93 C8"_hex));
    it.say("03 17 08 02 37 05 DC 00 00 00 00 C8 B3"_hex);
    it.loop = test::with_known_words(it.loop);
    it.loop.stop(stop_by::halt);
    CHECK(it.asks("03 03 31 C5 00 04 5B 2A"_hex));
    it.say("03 03 08 02 37 05 DC 00 00 00 00 88 F3"_hex);
    CHECK(it.asks("03 06 21 35 01 0F D3 8E"_hex));
}

TEST_CASE("the application example by functions 03 and 16, frame by frame")
{
    by_hand<atv12::device> it{cyclic{station<atv12::device>{unit_id{3}}, {.by_function_23 = false}}};
    CHECK(it.asks("03 03 0C 81 00 01 D6 90"_hex));
    it.say("03 03 02 02 33 80 F1"_hex);
    CHECK(it.asks("03 03 1B D1 00 01 D3 35"_hex));
    it.say("03 03 02 00 00 C1 84"_hex);
    CHECK(it.checks_scanner());
    CHECK(it.asks("03 03 31 C5 00 04 5B 2A"_hex));
    it.say("03 03 08 02 33 00 00 00 00 00 00 1C B5"_hex);
    CHECK(it.loop.run(1'500_rpm));
    CHECK(it.asks("03 10 31 D9 00 04 08 00 07 05 DC 00 00 00 00 0E EE"_hex));
    it.say("03 10 31 D9 00 04 1F 2F"_hex);
    CHECK(it.asks("03 03 31 C5 00 04 5B 2A"_hex));
    it.say("03 03 08 02 33 00 00 00 00 00 00 1C B5"_hex);
    CHECK(it.asks("03 03 21 35 00 01 9F DA"_hex));
    it.say("03 03 02 00 07 80 46"_hex);
    CHECK(it.asks("03 10 31 D9 00 04 08 00 0F 05 DC 00 00 00 00 87 2E"_hex));
    it.say("03 10 31 D9 00 04 1F 2F"_hex);
    CHECK(it.asks("03 03 31 C5 00 04 5B 2A"_hex));
}

TEST_CASE("every drive is kept running in a cycle")
{
    test::all_drives::for_each([]<typename Device>() { runs_a_drive<Device>(); });
}

TEST_CASE("no drive is made to run again after a loss, a fault, a stop key or local control")
{
    test::all_drives::for_each([]<typename Device>() { never_resumes<Device>(); });
}

TEST_CASE("the period never exceeds a third of the drive's time-out")
{
    running<atv320::device> it{{.period = milliseconds(9'000)}};
    register_block const nine{9};
    REQUIRE(it.far().check_write(6005, nine) == errc::none);
    it.far().write(6005, nine);
    it.pass(milliseconds(2'000));
    REQUIRE(it.order());
    it.pass(milliseconds(20'000));
    CHECK(it.now_in() == state::operation_enabled);
}

TEST_CASE("output words beyond the second are the user's, where they are")
{
    running<atv320::device> it;
    it.loop.set_output(0, 0xFFFF);
    it.loop.set_output(2, 7);
    it.loop.set_output(99, 7);
    it.pass(milliseconds(1'000));
    CHECK(it.far().word("NC3") == 7);
    CHECK(it.far().word("NC1") == 0);
    CHECK(it.loop.input(0) == it.far().word("ETA"));
    CHECK(it.loop.input(99) == 0);
}

TEST_CASE("nothing is written through a scanner that holds other words")
{
    running<atv320::device> it;
    auto const set = [&](std::uint16_t address, std::uint16_t word) {
        register_block const value{word};
        REQUIRE(it.far().check_write(address, value) == errc::none);
        it.far().write(address, value);
    };
    set(12'723, 9'001); // output word 3 is ACC
    it.pass(milliseconds(2'000));
    CHECK(it.loop.control().reason().kind == outcome_kind::misconfigured);
    CHECK_FALSE(it.order());
    CHECK(it.far().word("ACC") == 30);
    it.loop.set_output(2, 40);
    it.pass(milliseconds(2'000));
    CHECK(it.far().word("ACC") == 40);
    CHECK(it.order());
    it.pass(milliseconds(2'000));
    CHECK(it.now_in() == state::operation_enabled);

    // The cable is off while somebody maps another register: the cycle finds out before it writes.
    it.cut(0, true);
    it.pass(milliseconds(1'000));
    it.far().press_stop();
    set(12'722, 8'503);
    it.cut(0, false);
    it.pass(milliseconds(4'000));
    CHECK(it.loop.link_lost());
    CHECK_FALSE(it.order());
    CHECK(it.loop.control().reason().kind == outcome_kind::misconfigured);
    CHECK(it.far().word("PISP") == 0);
}

TEST_CASE("a scanner that reads or writes another word first is found out too")
{
    for (std::uint16_t const slot : {std::uint16_t{12'701}, std::uint16_t{12'721}}) {
        running<atv320::device> it;
        register_block const other{9'001};
        REQUIRE(it.far().check_write(slot, other) == errc::none);
        it.far().write(slot, other);
        it.pass(milliseconds(2'000));
        CHECK(it.loop.control().reason().kind == outcome_kind::misconfigured);
    }
}

TEST_CASE("a cycle has a deadline between its exchanges only")
{
    by_hand<atv320::device> it{cyclic<atv320::device>{station<atv320::device>{unit_id{3}}}};
    CHECK_FALSE(it.loop.poll_deadline());
    it.loop.advance(it.now);
    CHECK_FALSE(it.loop.poll_deadline()); // it is due now
    REQUIRE(it.loop.next());
    it.loop.accept(errc::timed_out);
    REQUIRE(it.loop.poll_deadline());
    CHECK(it.now - *it.loop.poll_deadline() != duration{});
}

TEST_CASE("a drive says who it is")
{
    test::simulated_bus<drive_client<4>, atv320::device> line{drive_client<4>{test::bus_timing, patient}};
    line.add(unit_id{7});
    line.idle(milliseconds(20));
    identify<atv320::device> who{station<atv320::device>{unit_id{7}}};
    REQUIRE(line.run(who));
    REQUIRE(who.outcome());
    CHECK(who.outcome()->product == byte_view{"41 54 56 33 32 30 55 30 37 4D 32 42"_hex});

    test::simulated_bus<drive_client<4>, atv28::device> old{drive_client<4>{test::bus_timing, patient}};
    old.add(unit_id{7});
    old.idle(milliseconds(20));
    identify<atv28::device> words{station<atv28::device>{unit_id{7}}};
    REQUIRE(old.run(words));
    CHECK(words.outcome());
    CHECK(words.latest().get<atv28::inv>() == deciamperes{23});
}

TEST_CASE("everybody stops at one word")
{
    test::simulated_bus<drive_client<4>, atv320::device> line{drive_client<4>{test::bus_timing, patient}};
    line.add(unit_id{7});
    line.add(unit_id{8});
    line.idle(milliseconds(20));
    for (std::size_t i = 0; i < 2; ++i) {
        for (register_block<1> const command : {0x0006, 0x0007, 0x000F}) {
            line.drive(i).write(8501, command);
        }
        REQUIRE(line.drive(i).state_machine().state() == state::operation_enabled);
    }
    auto all = broadcast_freewheel<atv320::device>();
    CHECK(line.run(all));
    CHECK(line.drive(0).state_machine().state() == state::switch_on_disabled);
    CHECK(line.drive(1).state_machine().state() == state::switch_on_disabled);
    auto const unsent = broadcast_freewheel<atv320::device>();
    CHECK(same_bytes(unsent.next()->frame(), "00 06 21 35 00 00 92 29"_hex));
}

TEST_CASE("an order that a drive does not follow is dropped in time")
{
    by_hand<atv12::device> it{cyclic{station<atv12::device>{unit_id{3}}, {.enable_timeout = milliseconds(350)}}};
    REQUIRE(it.asks("03 03 0C 81 00 01 D6 90"_hex));
    CHECK_FALSE(it.loop.poll_deadline());
    it.say("03 03 02 02 50 C0 D8"_hex);
    REQUIRE(it.asks("03 03 1B D1 00 01 D3 35"_hex));
    it.say("03 03 02 00 00 C1 84"_hex);
    REQUIRE(it.checks_scanner());
    REQUIRE(it.loop.run(1'500_rpm, run_direction::reverse));
    it.loop.advance(it.now); // the visit from which the limit counts
    CHECK(it.loop.control().is_ordered());
    it.now = it.now + milliseconds(400);
    it.loop.advance(it.now);
    CHECK_FALSE(it.loop.control().is_ordered());
    CHECK(it.loop.control().reason().kind == outcome_kind::state_timeout);
}

TEST_CASE("a fault reset that is asked for in each pass resets the fault")
{
    running<atv320::device> it;
    it.pass(milliseconds(1'000));
    CHECK_FALSE(it.loop.reset_fault()); // there is none
    it.far().inject_fault(9);
    it.pass(milliseconds(500));
    REQUIRE(it.now_in() == state::fault);
    it.far().clear_cause();
    it.run(
        [&](instant now) {
            it.link().converse(it.loop, now);
            it.loop.reset_fault();
        },
        [] { return false; }, milliseconds(2'000));
    CHECK(it.now_in() == state::switch_on_disabled);
    CHECK_FALSE(it.loop.reset_fault());
}
