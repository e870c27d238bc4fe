// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How an order ends that a simulated drive does not carry out: too slow, fallen back, stopped by its key, or given up.
#include <rtuwire/altivar/procedure/outcome.hpp>

#include <utility>

#include "support/catch.hpp"
#include "support/commissioned.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>
#include <rtuwire/altivar/procedure/commissioning/recall_from_eeprom.hpp>
#include <rtuwire/altivar/procedure/commissioning/release_link.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;

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

    detail::simulated_drive<Device>& far() { return test::simulated_bus<drive_client<4>, Device>::drive(0); }
    state now_in() { return far().state_machine().state(); }

    /// Another master's control word.
    void tell(std::uint16_t control)
    {
        register_block<1> const word{control};
        CHECK(far().write(Device::layout.cmd, word) == errc::none);
    }

    template <typename Conversation> reason end_of(Conversation conversation)
    {
        CHECK(this->run(conversation));
        return conversation.reason();
    }
    bool started() { return end_of(start{drive, 50_Hz}).kind == outcome_kind::succeeded; }

    /// How a conversation ends during which this happens once, as soon as the drive is so.
    template <typename Conversation, typename Is, typename Event>
    outcome_kind end_of(Conversation conversation, Is is_so, Event what)
    {
        bool has_happened = false;
        for (unsigned i = 0; i < 20'000 and not conversation.settled(); ++i) {
            this->step([&](instant now) { this->link().converse(conversation, now); }, milliseconds(5));
            if (not has_happened and is_so()) {
                has_happened = true;
                what();
            }
        }
        CHECK(has_happened);
        CHECK(now_in() != state::operation_enabled);
        return conversation.reason().kind;
    }

    /// Why a cycle that runs its drive drops the order when this happens.
    template <typename Event> outcome_kind dropped_by(Event what)
    {
        cyclic loop{drive, {.period = milliseconds(100)}};
        auto const pass = [&](duration length) {
            instant const end = this->now() + length;
            while (not reached(this->now(), end)) {
                this->step([&](instant now) { this->link().converse(loop, now); }, milliseconds(20));
            }
        };
        pass(milliseconds(1'000));
        if constexpr (Device::scanner.words == 0) {
            CHECK(loop.run(50_Hz));
        } else {
            CHECK(loop.run(1'500_rpm));
        }
        pass(milliseconds(2'000));
        CHECK(now_in() == state::operation_enabled);
        what();
        pass(milliseconds(2'000));
        CHECK_FALSE(loop.control().is_ordered());
        CHECK(now_in() != state::operation_enabled);
        return loop.control().reason().kind;
    }
};

} // namespace

TEST_CASE("a drive that takes longer than the limit ends an order as state_timeout")
{
    test::all_drives::for_each([]<typename Device>() {
        pair<Device> it;
        REQUIRE(it.started());
        // From 0 to 40 Hz it takes 2.4 s.
        auto const slow = it.end_of(change_reference{it.drive, 40_Hz, milliseconds(1'000)});
        CHECK(slow.kind == outcome_kind::state_timeout);
        CHECK(slow.state == state::operation_enabled);
    });
}

TEST_CASE("a start whose limit is over ends as state_timeout where it has commanded, and as aborted before")
{
    test::all_drives::for_each([]<typename Device>() {
        unsigned given_up = 0;
        unsigned too_late = 0;
        for (std::uint32_t limit_ms = 0; limit_ms < 200; limit_ms += 5) {
            pair<Device> it;
            auto const before = it.far().state_machine().taken();
            constexpr auto forward = run_direction::forward;
            auto const told = it.end_of(start{it.drive, 50_Hz, forward, milliseconds(limit_ms), test::commissioned()});
            bool const was_commanded = it.far().state_machine().taken() != before;
            given_up += told.kind == outcome_kind::aborted ? 1 : 0;
            too_late += told.kind == outcome_kind::state_timeout ? 1 : 0;
            if (told.kind != outcome_kind::succeeded) {
                bool const is_aborted = told.kind == outcome_kind::aborted;
                CHECK((is_aborted ? not was_commanded : told.kind == outcome_kind::state_timeout));
                CHECK(it.now_in() == state::switch_on_disabled);
            }
        }
        CHECK(given_up > 0);
        CHECK(too_late > 0);
    });
}

TEST_CASE("a check and a start whose drive never answers one read end at their limit with that as their error")
{
    test::all_drives::for_each([]<typename Device>() {
        auto const ends_so = [](auto conversation, std::uint16_t asked) {
            pair<Device> it;
            it.disturb([&](test::frame_bytes& frame, bool is_request) {
                bool const is_asked = is_request and frame.at(1) == std::byte{3} and u16_at(frame, 2) == asked;
                is_asked ? frame.clear() : void();
            });
            reason const why = it.end_of(conversation);
            CHECK(why.kind == outcome_kind::aborted);
            CHECK(why.error == errc::timed_out);
            CHECK(it.now_in() == state::switch_on_disabled);
        };
        station<Device> const& drive = pair<Device>::drive;
        ends_so(start{drive, 50_Hz}, Device::layout.lsp);
        ends_so(check_supervision{drive}, Device::layout.eta);
        if constexpr (std::is_same_v<Device, atv28::device>) {
            ends_so(atv28::direct_start{drive, 50_Hz}, Device::layout.lsp);
        }
    });
}

TEST_CASE("a start that checks its drive anew behind a lost response at its limit has that as its error")
{
    unsigned given_up = 0;
    for (std::uint32_t limit_ms = 400; limit_ms < 900; limit_ms += 13) {
        pair<atv320::device> it;
        it.disturb([&](test::frame_bytes& frame, bool is_request) {
            // CMD and LFR are read before the motor is enabled.
            bool const is_asked = is_request and frame.at(1) == std::byte{3} and u16_at(frame, 2) == 8501;
            is_asked ? frame.clear() : void();
        });
        reason const why = it.end_of(start{it.drive, 50_Hz, run_direction::forward, milliseconds(limit_ms)});
        given_up += why.kind == outcome_kind::aborted ? 1 : 0;
        CHECK((why.kind == outcome_kind::state_timeout or why.error == errc::timed_out));
    }
    CHECK(given_up > 10);
}

TEST_CASE("a limit that is over though each request was answered names no response that was missing")
{
    unsigned given_up = 0, unconfirmed = 0;
    auto const ends_so = [&](auto of, auto&& make) {
        for (std::uint32_t limit_ms = 0; limit_ms < 400; limit_ms += 13) {
            pair<decltype(of)> it;
            std::uint64_t requests = 0, responses = 0;
            it.disturb([&](test::frame_bytes&, bool is_request) { ++(is_request ? requests : responses); });
            reason const why = it.end_of(make(milliseconds(limit_ms)));
            // Behind an order in CMI, which is answered, the drive is silent: the write that clears it has nothing to say.
            CHECK((requests == responses or why.kind == outcome_kind::executed_unconfirmed));
            CHECK(why.error == errc::none);
            given_up += why.kind == outcome_kind::aborted ? 1 : 0;
            unconfirmed += why.kind == outcome_kind::executed_unconfirmed ? 1 : 0;
        }
        CHECK(std::exchange(given_up, 0) > 0);
    };
    using later = atv320::device;
    using old = atv28::device;
    ends_so(later{}, [](duration limit) {
        return set_channel{pair<later>::drive, channel_settings<later>::by_modbus(), {}, limit};
    });
    ends_so(old{}, [](duration limit) { return atv28::release_link{pair<old>::drive, {}, limit}; });
    ends_so(later{}, [](duration limit) {
        return configure_scanner<scanner_inputs<atv320::eta>, scanner_outputs<atv320::cmd>>{pair<later>::drive, limit};
    });
    CHECK(unconfirmed == 0);
    ends_so(old{}, [](duration limit) { return recall_from_eeprom{pair<old>::drive, {}, limit}; });
    CHECK(std::exchange(unconfirmed, 0) > 0);
    ends_so(later{}, [](duration limit) {
        return restore_factory_settings{pair<later>::drive, losing_control_and_address{}, {}, limit};
    });
    CHECK(unconfirmed > 0);
}

TEST_CASE("a drive that another master brings down ends an order as fell_back")
{
    test::all_drives::for_each([]<typename Device>() {
        pair<Device> it;
        auto const removed = [&] { it.tell(0x0000); };
        auto const is_on = [&] { return it.now_in() == state::switched_on; };
        CHECK(it.end_of(start{it.drive, 50_Hz}, is_on, removed) == outcome_kind::fell_back);
        REQUIRE(it.started());
        auto const is_changed = [&] { return it.far().word("LFR") == 400; };
        CHECK(it.end_of(change_reference{it.drive, 40_Hz}, is_changed, removed) == outcome_kind::fell_back);
        CHECK(it.dropped_by(removed) == outcome_kind::fell_back);
    });
}

TEST_CASE("a drive whose STOP key is pressed ends an order as stop_key")
{
    test::all_drives::for_each([]<typename Device>() {
        pair<Device> it;
        auto const pressed = [&] { it.far().press_stop(); };
        auto const is_on = [&] { return it.now_in() == state::switched_on; };
        CHECK(it.end_of(start{it.drive, 50_Hz}, is_on, pressed) == outcome_kind::stop_key);
        REQUIRE(it.started());
        auto const is_changed = [&] { return it.far().word("LFR") == 400; };
        CHECK(it.end_of(change_reference{it.drive, 40_Hz}, is_changed, pressed) == outcome_kind::stop_key);
        // The drive shows the key until it runs again.
        CHECK(it.end_of(change_reference{it.drive, 40_Hz}).kind == outcome_kind::stop_key);
        CHECK(it.dropped_by(pressed) == outcome_kind::stop_key);
    });
}

TEST_CASE("a start whose command is not the one in the drive ends as overwritten")
{
    test::all_drives::for_each([]<typename Device>() {
        pair<Device> it;
        auto const is_ordered = [&] { return it.now_in() == state::switched_on and it.far().word("LFR") == 500; };
        auto const replaced = [&] { it.tell(0x0006); };
        CHECK(it.end_of(start{it.drive, 50_Hz}, is_ordered, replaced) == outcome_kind::overwritten);
    });
    pair<atv28::device> it;
    auto const is_ordered = [&] { return it.far().word("LFR") == 500; };
    auto const replaced = [&] { it.tell(0x0006); };
    CHECK(it.end_of(atv28::direct_start{it.drive, 50_Hz}, is_ordered, replaced) == outcome_kind::overwritten);
}

TEST_CASE("an order that cannot be carried out ends as aborted")
{
    test::all_drives::for_each([]<typename Device>() {
        pair<Device> it;
        auto const standing = it.end_of(change_reference{it.drive, 40_Hz});
        CHECK(standing.kind == outcome_kind::aborted);
        CHECK(standing.state == state::switch_on_disabled);
        CHECK(it.far().word("LFR") != 400);
    });
    pair<atv320::device> later;
    set_channel const channel{later.drive, channel_settings<atv320::device>::by_modbus(), {}, milliseconds(20)};
    CHECK(later.end_of(channel).kind == outcome_kind::aborted);
    pair<atv28::device> old;
    CHECK(old.end_of(atv28::release_link{old.drive, {}, milliseconds(20)}).kind == outcome_kind::aborted);
    atv28::direct_start const hasty{old.drive, 50_Hz, milliseconds(20)};
    CHECK(old.end_of(hasty).kind == outcome_kind::aborted);
    CHECK(old.now_in() == state::switch_on_disabled);
}
