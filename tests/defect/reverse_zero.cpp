// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A reference in reverse that was 0, or became 0 on its way, turned a motor with LSP above 0 forward. Shown by the motor.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <cstdint>
#include <cstdlib>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using test::plant;
using kind = outcome_kind;

namespace {

constexpr std::int32_t slowest = 10'000; ///< LSP, in mHz
constexpr duration long_enough = milliseconds(5'000);

template <typename Device> struct slow_plant : plant<Device> {
    slow_plant() { this->tell(Device::layout.lsp, 100); }

    /// Runs it to its end, and the motor to a speed; false where it turned forward, or the limit was not told.
    template <typename Conversation> bool turns_back_by(Conversation conversation)
    {
        bool const stayed = this->watch(conversation, long_enough).highest <= 0;
        return stayed and this->millihertz() == -slowest and conversation.reason().kind == kind::reference_limited;
    }
};

} // namespace

TEST_CASE("defect: D20 a change of the reference to 0 does not turn a motor round that runs in reverse")
{
    test::all_drives::for_each([]<typename Device>() {
        slow_plant<Device> it;
        it.turn(-30, false);
        CHECK(it.turns_back_by(change_reference{it.drive, 0_Hz}));
        slow_plant<Device> by_bit;
        by_bit.turn(-30, true);
        CHECK(by_bit.turns_back_by(change_reference{by_bit.drive, 0_Hz}));
    });
}

TEST_CASE("defect: D20 a start at 0 in reverse does not turn the motor forward")
{
    test::all_drives::for_each([]<typename Device>() {
        slow_plant<Device> it;
        CHECK(it.turns_back_by(start{it.drive, 0_Hz, run_direction::reverse, test::usual_limit, test::within_limits}));
    });
}

TEST_CASE("defect: D20 a cycle at 0 in reverse does not turn the motor forward")
{
    test::all_drives::for_each([]<typename Device>() {
        slow_plant<Device> it;
        cyclic<Device> loop{it.drive, {.supervision = test::within_limits}};
        it.watch(loop, milliseconds(1'000));
        using at = setting<cycle_layout<Device>::reference>;
        REQUIRE(loop.run(*at::checked(typename at::value_type{0}), run_direction::reverse));
        CHECK(it.watch(loop, long_enough).highest == 0);
        CHECK(it.millihertz() == -slowest);
    });
}

TEST_CASE("defect: D20 a start at 1 or 2 rpm in reverse does not turn the motor forward")
{
    test::all_drives::for_each([]<typename Device>() {
        slow_plant<Device> one, two;
        CHECK(one.turns_back_by(
            start{one.drive, -1_rpm, run_direction::forward, test::usual_limit, test::within_limits}));
        CHECK(
            two.turns_back_by(start{two.drive, 2_rpm, run_direction::reverse, test::usual_limit, test::within_limits}));
    });
}

TEST_CASE("defect: a speed in reverse keeps its sign in the drive's steps of 0.1 Hz")
{
    test::all_drives::for_each([]<typename Device>() {
        // The pairs of poles, or what a hertz is, as the drive is told them: two and one, or 30 and 20 to 100.
        bool const has_nameplate = Device::layout.nsp != 0;
        std::uint16_t const at = has_nameplate ? Device::layout.nsp : Device::layout.sds;
        auto const turns_back = [&]<typename Make>(std::uint16_t scale, Make make, std::int32_t first, bool by_bit) {
            INFO("scale " << scale << ", first " << first << ", by the bit: " << by_bit);
            slow_plant<Device> it;
            it.tell(at, scale);
            if (first != 0) {
                it.turn(first, by_bit);
            }
            auto conversation = make(it.drive);
            it.watch(conversation, long_enough);
            CHECK(conversation.reason().kind == kind::reference_limited);
            CHECK(static_cast<std::int16_t>(it.far().word("LFR")) < 0); // 0 where the sign got lost
            CHECK(std::abs(static_cast<std::int16_t>(it.far().word("LFR"))) <= 3);
        };
        auto const to_zero = [](auto const& drive) { return change_reference{drive, 0_rpm}; };
        auto const to_minus_one = [](auto const& drive) { return change_reference{drive, -1_rpm}; };
        for (unsigned const scale : {has_nameplate ? 1'440U : 30U, has_nameplate ? 2'880U : 100U}) {
            auto const told = static_cast<std::uint16_t>(scale);
            turns_back(told, to_zero, -30, false);
            turns_back(told, to_zero, 30, true);
            turns_back(told, to_minus_one, -30, false);
            turns_back(
                told,
                [](auto const& drive) {
                    return start{drive, -1_rpm};
                },
                -30, false);
        }
        for (unsigned const scale : {has_nameplate ? 1'440U : 30U, has_nameplate ? 2'880U : 20U}) {
            auto const told = static_cast<std::uint16_t>(scale);
            turns_back(
                told,
                [](auto const& drive) {
                    return start{drive, 0_rpm, run_direction::reverse, test::usual_limit, test::within_limits};
                },
                0, false);
            turns_back(
                told,
                [](auto const& drive) {
                    return start{drive, -2_rpm, run_direction::forward, test::usual_limit, test::within_limits};
                },
                0, false);
            slow_plant<Device> it;
            it.tell(at, told);
            cyclic<Device> loop{it.drive, {.supervision = test::within_limits}};
            it.watch(loop, milliseconds(1'000));
            using reference_value = setting<cycle_layout<Device>::reference>;
            REQUIRE(
                loop.run(*reference_value::checked(typename reference_value::value_type{0}), run_direction::reverse));
            it.watch(loop, long_enough);
            CHECK(static_cast<std::int16_t>(it.far().word("LFR")) < 0);
        }
    });
    plant<atv28::device> direct;
    atv28::direct_start go{direct.drive, -1_rpm};
    direct.watch(go, long_enough);
    CHECK(go.running());
    CHECK(static_cast<std::int16_t>(direct.far().word("LFR")) == -1);
}

TEST_CASE("defect: D20 the least word of a reference is no reference forward under the direction bit")
{
    test::all_drives::for_each([]<typename Device>() {
        plant<Device> it;
        it.turn(-30, true);
        change_reference all{it.drive, *setting<Device::speed_reference>::checked(signed_rpm{-32'768}),
                             milliseconds(30'000), beyond_limits::limit};
        CHECK(it.watch(all, long_enough).highest < 0);
        CHECK(it.millihertz() == -50'000);
    });
}
