// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Start, stop, reset and the rest against simulated drives, over a virtual wire.
#include <rtuwire/altivar/procedure/motion/start.hpp>

#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <algorithm>
#include <cstddef>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;
using transition = cia402::transition;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

/// A client and one drive at address 7.
template <typename Device> struct pair : test::simulated_bus<drive_client<4>, Device> {
    static constexpr station<Device> drive{unit_id{7}};

    pair() : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, patient}}
    {
        this->add(unit_id{7});
        this->idle(milliseconds(20));
    }

    state now_in() { return this->drive_().state_machine().state(); }
    detail::simulated_drive<Device>& drive_() { return test::simulated_bus<drive_client<4>, Device>::drive(0); }

    template <typename Conversation> reason end_of(Conversation conversation)
    {
        CHECK(this->run(conversation));
        return conversation.reason();
    }
    bool started()
    {
        return end_of(start{drive, 50_Hz}).kind == outcome_kind::succeeded and now_in() == state::operation_enabled;
    }
};

template <typename Device> void starts_and_stops()
{
    pair<Device> it;
    auto const& drive = it.drive;
    REQUIRE(it.started());
    auto const taken = it.drive_().state_machine().taken();
    CHECK((taken & 0b11111) == 0b11111);

    it.idle(milliseconds(1'000));
    CHECK(it.end_of(change_reference{drive, 30_Hz}).kind == outcome_kind::succeeded);
    CHECK(it.drive_().word("RFR") == 300);
    CHECK(it.end_of(start{drive, 30_Hz, run_direction::reverse}).kind == outcome_kind::succeeded);
    it.idle(milliseconds(5'000));
    CHECK(it.drive_().motor().frequency() == -30'000);

    constexpr duration limit = milliseconds(30'000);
    CHECK(it.end_of(stop{drive, stop_by::ramp, limit}).kind == outcome_kind::succeeded);
    CHECK(it.now_in() == state::switch_on_disabled);
    CHECK(it.drive_().state_machine().last() == transition::t10);
    CHECK((it.drive_().state_machine().taken() & (1U << 5U)) != 0);

    REQUIRE(it.started());
    it.idle(milliseconds(1'000));
    CHECK(it.end_of(stop{drive, stop_by::quick_stop, limit}).kind == outcome_kind::succeeded);
    CHECK(it.drive_().state_machine().last() == transition::t12);

    REQUIRE(it.started());
    it.idle(milliseconds(1'000));
    CHECK(it.end_of(stop{drive, stop_by::freewheel}).kind == outcome_kind::succeeded);
    CHECK(it.drive_().state_machine().last() == transition::t9);

    REQUIRE(it.started());
    bool const can_halt = Device::layout.halt != 0;
    auto const halted = it.end_of(stop{drive, stop_by::halt, limit});
    CHECK(halted.kind == outcome_kind::succeeded);
    CHECK(halted.is_other_stop != can_halt); // then by its ramp
    CHECK((it.now_in() == state::operation_enabled) == can_halt);
    CHECK(it.drive_().motor().is_at_rest());

    bool const can_brake = Device::layout.dc_injection != 0;
    auto const braked = it.end_of(stop{drive, stop_by::dc_injection});
    CHECK(braked.kind == outcome_kind::succeeded);
    CHECK(braked.is_other_stop != can_brake);
    CHECK(it.end_of(stop{drive}).kind == outcome_kind::succeeded);
    CHECK(it.end_of(stop{drive}).kind == outcome_kind::succeeded);
}

template <typename Device> void meets_a_fault()
{
    pair<Device> it;
    auto const& drive = it.drive;
    REQUIRE(it.started());
    it.drive_().inject_fault(9);
    for (auto const& told : {it.end_of(start{drive, 50_Hz}), it.end_of(stop{drive}),
                             it.end_of(change_reference{drive, 20_Hz}), it.end_of(reset_fault{drive})}) {
        CHECK(told.kind == outcome_kind::in_fault);
        CHECK(told.fault == 9);
    }
    CHECK(it.drive_().word("CMD") == 0);
    it.drive_().clear_cause();
    CHECK(it.end_of(reset_fault{drive}).kind == outcome_kind::succeeded);
    CHECK(it.drive_().state_machine().last() == transition::t15);
    CHECK(it.drive_().word("CMD") == 0);
    CHECK(it.now_in() == state::switch_on_disabled);
    CHECK(it.started());
    CHECK(it.end_of(reset_fault{drive}).kind == outcome_kind::succeeded);
    CHECK(it.now_in() == state::operation_enabled);
    it.drive_().inject_fault(16);
    it.drive_().clear_cause();
    CHECK(it.end_of(reset_fault{drive}).kind == outcome_kind::succeeded);
}

template <typename Device> void is_refused()
{
    pair<Device> it;
    auto const& drive = it.drive;
    it.drive_().set_local(true);
    CHECK(it.end_of(start{drive, 50_Hz}).kind == outcome_kind::local_control);
    it.drive_().set_local(false);
    it.cut(0, true);
    auto const told = it.end_of(start{drive, 50_Hz});
    CHECK(told.kind == outcome_kind::silent);
    CHECK(told.error == errc::timed_out);
    it.cut(0, false);
    REQUIRE(it.started());
    CHECK(it.end_of(save_to_eeprom{drive}).kind == outcome_kind::refused_while_running);
    auto const slow = it.end_of(change_reference{drive, 10_Hz, milliseconds(500)});
    CHECK(slow.kind == outcome_kind::state_timeout);
    CHECK(slow.state == state::operation_enabled);
    CHECK(it.end_of(stop{drive}).kind == outcome_kind::succeeded);
    CHECK(it.end_of(change_reference{drive, 10_Hz}).kind == outcome_kind::aborted);
    it.drive_().press_stop();
    CHECK(it.end_of(save_to_eeprom{drive}).kind == outcome_kind::succeeded);
    CHECK((it.drive_().word("CMI") & 2) == 0);
}

} // namespace

TEST_CASE("every drive starts, turns round and stops, in each of its ways")
{
    test::all_drives::for_each([]<typename Device>() { starts_and_stops<Device>(); });
}

TEST_CASE("every drive tells its fault, and is reset by an edge")
{
    test::all_drives::for_each([]<typename Device>() { meets_a_fault<Device>(); });
}

TEST_CASE("each ending has its reason")
{
    test::all_drives::for_each([]<typename Device>() { is_refused<Device>(); });
}

TEST_CASE("a speed is a reference too, and one outside the limits is said to be")
{
    pair<atv320::device> it;
    CHECK(it.end_of(start{it.drive, 1'500_rpm}).kind == outcome_kind::succeeded);
    it.idle(milliseconds(4'000));
    CHECK(it.drive_().word("RFRD") == 1'500);
    constexpr beyond_limits all_the_same = beyond_limits::limit;
    auto const told = it.end_of(change_reference{it.drive, 1'800_rpm, milliseconds(30'000), all_the_same});
    CHECK(told.kind == outcome_kind::reference_limited);
    CHECK(it.drive_().word("RFRD") == 1'500);
    start again{it.drive, -1'800_rpm, run_direction::forward, milliseconds(3'000), {.beyond = all_the_same}};
    CHECK(it.run(again));
    CHECK(again.reason().kind == outcome_kind::reference_limited);
    CHECK(again.running());
    it.idle(milliseconds(8'000));
    CHECK(it.drive_().motor().frequency() == -50'000);
}

TEST_CASE("a scanner is configured only while the motor stands")
{
    using inputs = scanner_inputs<atv310::eta, atv310::rfrd, atv310::lcr>;
    using outputs = scanner_outputs<atv310::cmd, atv310::lfrd>;
    pair<atv310::device> it;
    CHECK(it.end_of(configure_scanner<inputs, outputs>{it.drive}).kind == outcome_kind::succeeded);
    CHECK(it.drive_().word("NMA3") == 3204);
    CHECK(it.drive_().word("NMA4") == 0);
    REQUIRE(it.started());
    CHECK(it.end_of(configure_scanner<inputs, outputs>{it.drive}).kind == outcome_kind::refused_while_running);
}

TEST_CASE("of what a start writes only the word that runs the motor is its command to run")
{
    test::all_drives::for_each([]<typename Device>() {
        pair<Device> it;
        start go{it.drive, 1.5_Hz}; // 15, a word that would run the motor at another address
        unsigned others = 0, commands = 0;
        it.disturb([&](test::frame_bytes& frame, bool is_request) {
            if (is_request and frame[1] == std::byte{6}) {
                bool const is_control = u16_at(byte_view{frame}, 2) == Device::layout.cmd;
                bool const runs = is_control and (u16_at(byte_view{frame}, 4) & 15U) == 15U;
                CHECK(go.says_run() == runs);
                ++(runs ? commands : others);
            }
        });
        REQUIRE(it.run(go));
        CHECK((commands > 0 and others > 2));
    });
}

TEST_CASE("a start that fails half way takes its command back")
{
    pair<atv12::device> it;
    start run{it.drive, 50_Hz};
    unsigned steps = 0;
    while (not run.settled() and steps < 10'000) {
        it.step([&](instant now) { it.link().converse(run, now); }, milliseconds(10));
        if (it.now_in() == state::switched_on) {
            it.drive_().press_stop();
        }
        ++steps;
    }
    CHECK(run.reason().kind == outcome_kind::stop_key);
    CHECK(it.drive_().word("CMD") != 0x000F);
    CHECK(it.now_in() != state::operation_enabled);
}

TEST_CASE("the longest frames of a procedure are as long as its type says")
{
    std::size_t request = 0, response = 0;
    test::all_drives::for_each([&]<typename Device>() {
        pair<Device> it;
        it.disturb([&](test::frame_bytes& frame, bool is_request) {
            std::size_t& longest = is_request ? request : response;
            longest = std::max(longest, frame.size());
        });
        REQUIRE(it.started());
        CHECK(it.end_of(change_reference{it.drive, 40_Hz}).kind == outcome_kind::succeeded);
        CHECK(it.end_of(stop{it.drive}).kind == outcome_kind::succeeded);
    });
    CHECK(start::longest_frames.request == request);
    CHECK(start::longest_frames.response == response);
}
