// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// References beyond LSP and HSP: what is refused, what is limited because the user asked for that, and what is never
// refused because it slows a motor down. Judged by the motor and by the frames.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using test::plant;
using test::speed;
using test::tenths;
using kind = outcome_kind;

namespace {

constexpr auto forward = run_direction::forward, backward = run_direction::reverse;
constexpr duration usual = milliseconds(3'000), long_enough = milliseconds(5'000);

/// A drive with LSP 10 Hz and HSP 50 Hz, whose motor has two pairs of poles; counts what is sent to it.
template <typename Device> struct limited_plant : plant<Device> {
    unsigned writes{0};
    unsigned requests{0};
    std::uint16_t refuses{0}; ///< to be read: the address of a register, with exception 02

    limited_plant()
    {
        this->tell(Device::layout.lsp, 100);
        if (Device::layout.sds != 0) {
            this->tell(Device::layout.sds, 30);
        }
    }
    void count()
    {
        writes = requests = 0;
        this->disturb([this, is_refused = false](test::frame_bytes& frame, bool is_request) mutable {
            if (is_request) {
                writes += frame[1] == std::byte{6} ? 1U : 0U;
                ++requests;
                is_refused = refuses != 0 and frame[1] == std::byte{3} and u16_at(byte_view{frame}, 2) == refuses;
            } else if (is_refused) {
                frame = {frame[0], std::byte{0x83}, std::byte{2}};
                std::uint16_t const crc = crc16(frame);
                frame.push_back(to_byte(crc));
                frame.push_back(to_byte(crc >> 8U));
            }
        });
    }

    /// Runs it to its end, and the motor to its speed.
    template <typename Conversation> reason end_of(Conversation conversation)
    {
        count();
        static_cast<void>(this->watch(conversation, long_enough));
        REQUIRE(conversation.settled());
        return conversation.reason();
    }
};

} // namespace

TEST_CASE("motion law: S43 a start at rest gets no reference beyond the limits, in Hz and in rpm, either way")
{
    test::all_drives::for_each([]<typename Device>() {
        limited_plant<Device> it;
        for (run_direction const way : {forward, backward}) {
            for (int const sign : {1, -1}) {
                if (way == backward and sign < 0) {
                    continue;
                }
                for (auto const& [over, under] : {std::pair{501, 99}, std::pair{5'990, 0}}) {
                    reason const above = it.end_of(start{it.drive, tenths<Device>(sign * over), way});
                    CHECK(above == reason{kind::above_hsp, errc::none, above.state, 0, false, 500});
                    CHECK((it.writes == 0 and it.requests == 2)); // the status and HSP
                    reason const below = it.end_of(start{it.drive, tenths<Device>(sign * under), way});
                    CHECK(below == reason{kind::below_lsp, errc::none, below.state, 0, false, 100});
                    CHECK((it.writes == 0 and it.requests == 3));
                }
                reason const fast = it.end_of(start{it.drive, speed<Device>(sign * 1'501), way});
                CHECK((fast.kind == kind::above_hsp and fast.limit == 500 and it.writes == 0));
                CHECK(it.requests == (Device::layout.sds != 0 ? 4 : 5)); // FRS and NSP, or SDS
                CHECK(it.end_of(start{it.drive, speed<Device>(sign * 299), way}).kind == kind::below_lsp);
                CHECK((it.writes == 0 and it.millihertz() == 0));
            }
        }
        // At the limits it runs, as ordered.
        for (int const count : {500, -500, 100, -100}) {
            limited_plant<Device> at;
            CHECK(at.end_of(start{at.drive, tenths<Device>(count)}).kind == kind::succeeded);
            CHECK(at.millihertz() == count * 100);
        }
        for (int const count : {1'500, -1'500, 300, -300}) {
            limited_plant<Device> at;
            CHECK(at.end_of(start{at.drive, speed<Device>(count)}).kind == kind::succeeded);
        }
    });
}

TEST_CASE("motion law: S43 who asks to be limited is, at HSP and at LSP, and reads neither")
{
    test::all_drives::for_each([]<typename Device>() {
        for (int const sign : {1, -1}) {
            for (auto const& [count, turns] : {std::pair{5'990, 50'000}, std::pair{10, 10'000}}) {
                limited_plant<Device> it;
                it.refuses = Device::layout.hsp;
                start go{it.drive, tenths<Device>(sign * count), forward, usual, {.beyond = beyond_limits::limit}};
                CHECK(it.end_of(go).kind == kind::reference_limited);
                CHECK(it.millihertz() == sign * turns);
                change_reference over{it.drive, tenths<Device>(sign * 600), long_enough, beyond_limits::limit};
                CHECK(it.end_of(over).kind == kind::reference_limited);
                CHECK(it.millihertz() == sign * 50'000);
            }
        }
    });
}

TEST_CASE("motion law: S43 a motor that runs gets no reference above HSP, and keeps its own")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const by_bit : {false, true}) {
            for (int const sign : {1, -1}) {
                limited_plant<Device> it;
                it.turn(sign * 30, by_bit);
                for (int const wanted : {501, -501, 5'990, -5'990}) {
                    reason const refused = it.end_of(change_reference{it.drive, tenths<Device>(wanted)});
                    CHECK((refused.kind == kind::above_hsp and refused.limit == 500));
                    CHECK((it.writes == 0 and it.requests == 4)); // status, control word, reference, HSP
                    CHECK(it.end_of(change_reference{it.drive, speed<Device>(wanted * 3)}).kind == kind::above_hsp);
                    CHECK(it.writes == 0);
                    CHECK(it.end_of(start{it.drive, tenths<Device>(wanted)}).kind == kind::above_hsp);
                    CHECK(it.writes == 0);
                    CHECK(it.millihertz() == sign * 30'000);
                }
            }
        }
    });
}

TEST_CASE("motion law: S43 slowing down is never refused, whatever the limits are and whoever does not tell them")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const by_bit : {false, true}) {
            for (int const sign : {1, -1}) {
                limited_plant<Device> it;
                it.turn(sign * 45, by_bit);
                it.tell(Device::layout.hsp, 200); // lowered while it runs
                it.refuses = Device::layout.hsp;
                CHECK(it.end_of(change_reference{it.drive, tenths<Device>(sign * 400)}).kind ==
                      kind::reference_limited);
                CHECK(it.millihertz() == sign * 20'000);
                CHECK(it.end_of(change_reference{it.drive, tenths<Device>(sign * 150)}).kind == kind::succeeded);
                CHECK(it.millihertz() == sign * 15'000);
                CHECK(it.end_of(change_reference{it.drive, tenths<Device>(sign * 50)}).kind == kind::reference_limited);
                CHECK(it.millihertz() == sign * 10'000); // LSP, with its sign
                // Faster again: it would have to know HSP.
                CHECK(it.end_of(change_reference{it.drive, tenths<Device>(sign * 60)}).kind == kind::unknown_register);
                CHECK(it.writes == 0);
                it.refuses = 0;
                CHECK(it.end_of(change_reference{it.drive, tenths<Device>(sign * 201)}).kind == kind::above_hsp);
                CHECK(it.end_of(change_reference{it.drive, tenths<Device>(sign * 200)}).kind == kind::succeeded);
            }
        }
        // A start of a motor that runs slows it down, too.
        limited_plant<Device> it;
        it.turn(45, false);
        it.tell(Device::layout.hsp, 200);
        CHECK(it.end_of(start{it.drive, 40_Hz}).kind == kind::reference_limited);
        CHECK(it.end_of(start{it.drive, 41_Hz}).kind == kind::above_hsp);
        CHECK(it.writes == 0);
    });
}

TEST_CASE(
    "motion law: S43 a drive that does not tell its limits is not started, unless that risk is accepted by its name")
{
    test::all_drives::for_each([]<typename Device>() {
        for (std::uint16_t const lacking : {Device::layout.hsp, Device::layout.lsp}) {
            limited_plant<Device> it;
            it.refuses = lacking;
            CHECK(it.end_of(start{it.drive, 30_Hz}).kind == kind::unknown_register);
            CHECK(it.writes == 0);
            supervision_options const accepted{.risks = {.accept_unknown_registers = true}};
            CHECK(it.end_of(start{it.drive, 30_Hz, forward, usual, accepted}).kind == kind::succeeded);
        }
    });
}

TEST_CASE("motion law: S43 a report of an earlier check refuses as the check would, unless its user asks to be limited")
{
    test::all_drives::for_each([]<typename Device>() {
        limited_plant<Device> it;
        check_supervision look{it.drive};
        static_cast<void>(it.watch(look, long_enough));
        REQUIRE(look.ready());
        CHECK((look.report().limits.lowest == 100 and look.report().limits.highest == 500));
        auto const judged = [&](reference<Device> what) { return look.report().limits.judge(what.write(), true); };
        CHECK((judged(299_rpm) == kind::below_lsp and judged(300_rpm) == kind::succeeded));
        CHECK((judged(1'500_rpm) == kind::succeeded and judged(1'501_rpm) == kind::above_hsp));
        CHECK(it.end_of(start{it.drive, 60_Hz, forward, usual, look.report()}).kind == kind::above_hsp);
        CHECK(it.end_of(start{it.drive, 1'600_rpm, forward, usual, look.report()}).kind == kind::above_hsp);
        CHECK(it.requests == 1);
        start const limited{it.drive, 60_Hz, forward, usual, look.report(), beyond_limits::limit};
        CHECK(it.end_of(limited).kind == kind::reference_limited);
    });
}

TEST_CASE("motion law: S43 a direct start keeps to the limits, too")
{
    limited_plant<atv28::device> it;
    CHECK(it.end_of(atv28::direct_start{it.drive, tenths<atv28::device>(501)}).kind == kind::above_hsp);
    CHECK(it.end_of(atv28::direct_start{it.drive, -9_Hz}).kind == kind::below_lsp);
    CHECK((it.writes == 0 and it.millihertz() == 0));
}
