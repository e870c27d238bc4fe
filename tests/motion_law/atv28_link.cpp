// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An ATV28 whose link is released, whose settings are recalled, and that is run by direct words: no terminal and no
// stray word starts its motor by them.
#include "support/catch.hpp"
#include "support/simulated_bus.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <rtuwire/altivar/procedure/commissioning/recall_from_eeprom.hpp>
#include <rtuwire/altivar/procedure/commissioning/release_link.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using namespace rtuwire::altivar::atv28;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr std::uint16_t cmd_at = 400, lfr_at = 401, cmi_at = 402, acc_at = 252;

/// A client and an ATV28, its potentiometer at 30 Hz; all that is written; the n-th frame lost where one is asked for.
struct bench : test::simulated_bus<drive_client<4>, device> {
    static constexpr station<device> drive{unit_id{3}};
    std::vector<std::pair<std::uint16_t, std::uint16_t>> writes;
    unsigned frames{0};
    unsigned lost_frame{0};         ///< from 1 on, requests and responses; 0: none
    bool is_cut_from_it{false};     ///< and all that follow
    bool has_ever_said_more{false}; ///< than 0000, to the drive

    bench() : test::simulated_bus<drive_client<4>, device>{drive_client<4>{test::bus_timing, patient}}
    {
        add(unit_id{3});
        idle(milliseconds(20));
        far().set_analog_reference(30'000);
        disturb([this](std::vector<std::byte>& frame, bool is_request) {
            ++frames;
            if (is_request and frame[1] == std::byte{6}) {
                writes.emplace_back(u16_at(byte_view{frame}, 2), u16_at(byte_view{frame}, 4));
            }
            if (lost_frame != 0 and (frames == lost_frame or (is_cut_from_it and frames > lost_frame))) {
                frame.clear();
            }
        });
    }
    detail::simulated_drive<device>& far() { return unit(0).drive(); }
    bool has_power() { return cia402::has_power(far().state_machine().state()); }
    bool is_by_link() { return (far().word("ETI") & 0x4000) != 0; }
    void tell(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        REQUIRE(far().check_write(address, value) == errc::none);
        static_cast<void>(far().write(address, value));
        idle(milliseconds(50));
    }
    void close(std::size_t input)
    {
        far().set_input(input, true);
        idle(milliseconds(50));
    }
    /// The line commands it, as it does not after power-up.
    bench& taken()
    {
        tell(cmd_at, 0);
        REQUIRE(is_by_link());
        return *this;
    }
    reason told(auto conversation)
    {
        writes.clear();
        frames = 0;
        REQUIRE(run(conversation));
        return conversation.reason();
    }
};

} // namespace

TEST_CASE("the words of direct control are those of the bulletin")
{
    // Bits 15, 3 and 1, and one more: 12 ramp, 13 DC injection, 14 fast stop; 8 with 15 releases.
    CHECK(direct_run == (1U << 15U | 1U << 3U | 1U << 1U));
    CHECK(direct_ramp_stop == 36'874);
    CHECK(direct_dc_stop == 40'970);
    CHECK(direct_fast_stop == 49'162);
    CHECK(link_released == (1U << 15U | 1U << 8U));
    CHECK(link_activated == 1U << 15U);
}

TEST_CASE("an ATV28 is released and taken back while it stands")
{
    bench it;
    it.taken();
    CHECK(it.told(release_link{it.drive}).kind == outcome_kind::succeeded);
    CHECK_FALSE(it.is_by_link());
    it.close(1);
    CHECK(it.has_power());
    // Whoever runs it at its terminals is not cut short.
    CHECK(it.told(activate_link{it.drive}).kind == outcome_kind::refused_while_running);
    CHECK(it.writes.empty());
    it.far().set_input(1, false);
    it.idle(milliseconds(5'000));
    CHECK(it.told(activate_link{it.drive}).kind == outcome_kind::succeeded);
    CHECK(it.is_by_link());
    it.close(1);
    CHECK_FALSE(it.has_power());
    // A run input that starts nothing, say because of the STOP key, keeps nobody from taking it.
    bench held;
    held.far().hold_stop(true);
    held.close(1);
    REQUIRE_FALSE(held.is_by_link());
    CHECK(held.told(activate_link{held.drive}).kind == outcome_kind::succeeded);
}

TEST_CASE("motion law: S29 an ATV28 is not released under a closed run input")
{
    {
        bench it;
        it.taken().close(1);
        REQUIRE_FALSE(it.has_power());
        it.tell(cmd_at, 0x8100);
        it.idle(milliseconds(1'000));
        REQUIRE(it.has_power());
        CHECK(it.far().motor().frequency() != 0);
    }
    for (std::size_t const input : {1U, 2U}) {
        bench it;
        it.taken().close(input);
        CHECK(it.told(release_link{it.drive}).kind == outcome_kind::run_input_closed);
        CHECK(it.writes.empty());
        CHECK(it.is_by_link());
        CHECK_FALSE(it.has_power());
    }
}

TEST_CASE("motion law: S29 an ATV28 that starts although its inputs were open is stopped again")
{
    bench it;
    it.taken();
    release_link conversation{it.drive};
    bool is_closed = false;
    while (not conversation.settled()) {
        it.step([&](instant now) { it.link().converse(conversation, now); }, milliseconds(5));
        if (not is_closed and not it.writes.empty()) {
            is_closed = true;
            it.far().set_input(1, true);
        }
    }
    CHECK(conversation.reason().kind == outcome_kind::started_by_terminals);
    it.idle(milliseconds(5'000));
    CHECK_FALSE(it.has_power());
    CHECK(it.is_by_link());
}

TEST_CASE("motion law: S29 an ATV28 whose answer to its release is lost, and whose limit passes, is stopped again, too")
{
    // The limit: long after the two attempts; while the second waits for its response; in the wait before the look.
    for (unsigned const limit_ms : {3'000U, 150U, 60U}) {
        for (bool const is_lost : {false, true}) {
            INFO(limit_ms << " ms, response " << (is_lost ? "lost" : "heard"));
            bench it;
            it.taken();
            bool is_closed = false;
            it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
                bool const is_release = frame[1] == std::byte{6} and u16_at(byte_view{frame}, 4) == 0x8100;
                if (is_release and is_request and not is_closed) {
                    is_closed = true;
                    it.far().set_input(1, true); // just then
                } else if (is_release and not is_request and is_lost) {
                    frame.clear();
                }
            });
            release_link conversation{it.drive, {}, milliseconds(limit_ms)};
            REQUIRE(it.run(conversation));
            CHECK(is_closed);
            CHECK(conversation.reason().kind == outcome_kind::started_by_terminals);
            it.idle(milliseconds(5'000));
            CHECK_FALSE(it.has_power());
            CHECK(it.is_by_link());
        }
    }
}

TEST_CASE("an ATV28 is not released while it runs, in a fault, or by a forced-local drive's leave")
{
    bench running;
    start go{running.drive, 20_Hz};
    REQUIRE(running.run(go));
    CHECK(running.told(release_link{running.drive}).kind == outcome_kind::refused_while_running);
    bench faulty;
    faulty.taken();
    faulty.far().inject_fault(9);
    faulty.idle(milliseconds(500));
    CHECK(faulty.told(release_link{faulty.drive}).kind == outcome_kind::in_fault);
    bench local;
    local.far().set_local(true);
    local.idle(milliseconds(50));
    CHECK(local.told(activate_link{local.drive}).kind == outcome_kind::refused);
    CHECK_FALSE(local.is_by_link());
}

TEST_CASE("a direct start runs at its reference, either way, and a direct stop leaves it locked")
{
    for (bool const is_reverse : {false, true}) {
        for (direct_stop_by const how :
             {direct_stop_by::ramp, direct_stop_by::dc_injection, direct_stop_by::fast_stop}) {
            bench it;
            constexpr reference<device> forward = 20_Hz, backward = -20_Hz;
            auto const at = is_reverse ? backward : forward;
            REQUIRE(it.told(direct_start{it.drive, at}).kind == outcome_kind::succeeded);
            CHECK(it.writes.back() == std::pair<std::uint16_t, std::uint16_t>{cmd_at, 0x800A});
            it.idle(milliseconds(5'000));
            CHECK(it.far().motor().frequency() == (is_reverse ? -20'000 : 20'000));
            reason const rest = it.told(direct_stop{it.drive, how});
            CHECK(rest.kind == outcome_kind::succeeded);
            CHECK_FALSE(rest.is_other_stop);
            CHECK(it.writes.front().second == (how == direct_stop_by::ramp           ? 0x900A
                                               : how == direct_stop_by::dc_injection ? 0xA00A
                                                                                     : 0xC00A));
            CHECK(it.far().state_machine().state() == state::switch_on_disabled);
        }
    }
}

TEST_CASE("an ordinary stop stops a drive that was started directly")
{
    for (stop_by const how : {stop_by::ramp, stop_by::freewheel, stop_by::quick_stop}) {
        bench it;
        REQUIRE(it.told(direct_start{it.drive, -20_Hz}).kind == outcome_kind::succeeded);
        it.idle(milliseconds(5'000));
        CHECK(it.told(stop{it.drive, how}).kind == outcome_kind::succeeded);
        CHECK(it.far().state_machine().state() == state::switch_on_disabled);
        // Nothing stands there that would run it again.
        it.tell(cmd_at, 0x000F);
        CHECK_FALSE(it.has_power());
    }
}

TEST_CASE("motion law: S1 a direct start checks the reference that stands in the drive before its word")
{
    bench it;
    it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
        it.has_ever_said_more =
            it.has_ever_said_more or (is_request and frame[1] == std::byte{6} and
                                      u16_at(byte_view{frame}, 2) == cmd_at and u16_at(byte_view{frame}, 4) != 0);
        // Another master's reference comes right behind ours.
        if (not is_request and frame[1] == std::byte{6} and u16_at(byte_view{frame}, 2) == lfr_at) {
            register_block const value{std::uint16_t{500}};
            static_cast<void>(it.far().write(lfr_at, value));
        }
    });
    CHECK(it.told(direct_start{it.drive, 10_Hz}).kind == outcome_kind::not_taken);
    it.idle(milliseconds(1'000));
    CHECK_FALSE(it.has_power());
    CHECK_FALSE(it.has_ever_said_more);
}

TEST_CASE("motion law: S22 a drive whose power comes back while it is started directly stands")
{
    unsigned started = 0;
    for (unsigned at = 1; at <= 30; ++at) {
        bench it;
        direct_start conversation{it.drive, 20_Hz};
        bool was_off = false;
        while (not conversation.settled()) {
            it.step([&](instant now) { it.link().converse(conversation, now); }, milliseconds(5));
            if (not was_off and it.frames == at) {
                was_off = true;
                it.far().power_cycle(it.now());
            }
        }
        it.idle(milliseconds(1'000));
        // Told of power or of a stop; never of a run that is none.
        CHECK(conversation.running() == it.has_power());
        started += conversation.running() ? 1U : 0U;
    }
    CHECK(started < 20);
}

TEST_CASE("motion law: S17 cut after any of its frames, a direct start leaves the motor at rest or "
          "as asked")
{
    for (unsigned at = 1; at <= 32; ++at) {
        bench it;
        it.tell(lfr_at, 500); // somebody's reference of before
        it.lost_frame = at;
        it.is_cut_from_it = true;
        static_cast<void>(it.told(direct_start{it.drive, -10_Hz}));
        it.idle(milliseconds(3'000));
        std::int32_t const turns = it.far().motor().frequency();
        INFO(at << ": " << turns);
        CHECK((turns <= 0 and turns >= -10'000));
    }
    // One frame lost: it stands afterwards, or runs as asked and says so.
    for (unsigned at = 1; at <= 32; ++at) {
        bench it;
        it.lost_frame = at;
        reason const how = it.told(direct_start{it.drive, -10_Hz});
        it.idle(milliseconds(5'000));
        INFO(at);
        CHECK((how.kind == outcome_kind::succeeded) == it.has_power());
    }
}

TEST_CASE("a direct start is refused where the drive runs, and in local control")
{
    bench it;
    start go{it.drive, 20_Hz};
    REQUIRE(it.run(go));
    CHECK(it.told(direct_start{it.drive, 10_Hz}).kind == outcome_kind::refused_while_running);
    CHECK(it.writes.empty());
    bench local;
    local.far().set_local(true);
    local.idle(milliseconds(50));
    CHECK(local.told(direct_start{local.drive, 10_Hz}).kind == outcome_kind::local_control);
    CHECK(local.writes.empty());
    bench limited;
    auto const above = *setting<lfr>::checked(signed_decihertz{600}); // HSP is 50 Hz
    CHECK(limited.told(direct_start{limited.drive, above}).kind == outcome_kind::above_hsp);
    CHECK(limited.writes.empty());
    direct_start const all_the_same{limited.drive, above, milliseconds(3'000), {.beyond = beyond_limits::limit}};
    CHECK(limited.told(all_the_same).kind == outcome_kind::reference_limited);
}

TEST_CASE("a recall brings back what was saved, and is refused where it could move something")
{
    bench it;
    it.taken();
    it.tell(acc_at, 77);
    CHECK(it.told(save_to_eeprom{it.drive}).kind == outcome_kind::succeeded);
    it.tell(acc_at, 99);
    it.tell(cmi_at, 0x4010);
    CHECK(it.told(recall_from_eeprom{it.drive}).kind == outcome_kind::succeeded);
    CHECK(it.far().word("ACC") == 77);
    CHECK(it.writes.front() == std::pair<std::uint16_t, std::uint16_t>{cmi_at, 0x4014});
    CHECK(it.far().word("CMI") == 0x4010);

    // CMI keeps its bit 14: nobody watches the link.
    supervision_options unwatched;
    unwatched.risks.accept_unsupervised = true;
    reference<device> const slow = 20_Hz;
    start go{it.drive, slow, run_direction::forward, milliseconds(3'000), unwatched};
    REQUIRE(it.run(go));
    REQUIRE(go.running());
    it.tell(acc_at, 99);
    CHECK(it.told(recall_from_eeprom{it.drive}).kind == outcome_kind::refused_while_running);
    CHECK(it.far().word("ACC") == 99);

    bench closed;
    closed.taken().close(1);
    CHECK(closed.told(recall_from_eeprom{closed.drive}).kind == outcome_kind::run_input_closed);
    // The stop input of three-wire control, closed as a rule: what is recalled may be two-wire control.
    bench three_wire;
    three_wire.tell(6, 1);
    three_wire.taken().close(1);
    CHECK(three_wire.told(recall_from_eeprom{three_wire.drive}).kind == outcome_kind::run_input_closed);
    bench gone;
    gone.taken();
    gone.cut(0, true);
    CHECK(gone.told(recall_from_eeprom{gone.drive}).kind == outcome_kind::silent);
}

TEST_CASE("a recall gives no other order again, and does not leave its own where the drive did not "
          "take it")
{
    bench it;
    it.taken();
    bool is_reading = false;
    unsigned reads = 0;
    std::vector<std::uint16_t> orders;
    it.disturb([&](std::vector<std::byte>& frame, bool is_request) {
        bool const is_cmi = is_request and u16_at(byte_view{frame}, 2) == cmi_at;
        if (is_cmi and frame[1] == std::byte{6}) {
            orders.push_back(u16_at(byte_view{frame}, 4));
        }
        if (not is_request and is_reading) {
            // First somebody's save that stands there, then our recall that was not taken.
            ++reads;
            std::byte const low = reads == 1 ? std::byte{0x02} : std::byte{0x04};
            frame = {frame[0], frame[1], frame[2], std::byte{0}, low};
            std::uint16_t const crc = crc16(frame);
            frame.push_back(to_byte(crc));
            frame.push_back(to_byte(crc >> 8U));
        }
        is_reading = is_cmi and frame[1] == std::byte{3};
    });
    CHECK(it.told(recall_from_eeprom{it.drive}).kind == outcome_kind::not_taken);
    CHECK(orders == std::vector<std::uint16_t>{0x0004, 0x0000});
}
