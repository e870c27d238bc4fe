// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Who asks to be limited is told at which limit the motor turns, and a speed of 1 rpm in reverse is the least step of the
// drive in reverse, whatever a hertz is there.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <cstdint>
#include <cstdlib>

#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using test::plant;
using test::speed;
using test::tenths;
using kind = outcome_kind;

namespace {

constexpr auto forward = run_direction::forward, backward = run_direction::reverse;
constexpr duration long_enough = milliseconds(5'000);

/// What a hertz is, as the drive is told it: two pairs of poles and one; or 30, 100 and 200 rpm.
template <typename Device> void at_each_scale(auto check)
{
    constexpr bool has_nameplate = Device::layout.nsp != 0;
    for (unsigned const scale : {has_nameplate ? 1'440U : 30U, has_nameplate ? 2'880U : 100U, 200U}) {
        if (not has_nameplate or scale != 200) {
            INFO("scale " << scale);
            plant<Device> it;
            it.tell(has_nameplate ? Device::layout.nsp : Device::layout.sds, static_cast<std::uint16_t>(scale));
            check(it);
        }
    }
}

/// The least step in reverse, and it is done.
template <typename Device, typename Conversation> void check_least_step(plant<Device>& it, Conversation conversation)
{
    auto const seen = it.watch(conversation, long_enough);
    CHECK(conversation.reason().kind == kind::succeeded);
    CHECK(seen.highest <= 0);
    CHECK(static_cast<std::int16_t>(it.far().word("LFR")) == -1);
}

} // namespace

TEST_CASE("defect: a start at 1 rpm in reverse that may be limited turns by the drive's least step")
{
    test::all_drives::for_each([]<typename Device>() {
        at_each_scale<Device>([](auto& it) {
            check_least_step(it, start{it.drive, -1_rpm, forward, test::usual_limit, test::within_limits});
        });
        at_each_scale<Device>([](auto& it) {
            check_least_step(it, start{it.drive, 1_rpm, backward, test::usual_limit, test::within_limits});
        });
        at_each_scale<Device>([](auto& it) { // by the report of an earlier check
            check_supervision look{it.drive, test::within_limits};
            static_cast<void>(it.watch(look, long_enough));
            REQUIRE(look.ready());
            check_least_step(it, start{it.drive, -1_rpm, forward, test::usual_limit, look.report()});
        });
        at_each_scale<Device>([](auto& it) {
            check_supervision look{it.drive};
            static_cast<void>(it.watch(look, long_enough));
            check_least_step(it,
                             start{it.drive, -1_rpm, forward, test::usual_limit, look.report(), beyond_limits::limit});
        });
    });
}

TEST_CASE("defect: a cycle at 1 rpm in reverse that may be limited turns by the drive's least step")
{
    test::all_drives::for_each([]<typename Device>() {
        if constexpr (cycle_layout<Device>::is_by_speed) {
            at_each_scale<Device>([](auto& it) {
                cyclic<Device> loop{it.drive, {.supervision = test::within_limits}};
                static_cast<void>(it.watch(loop, milliseconds(1'000)));
                using at = setting<cycle_layout<Device>::reference>;
                REQUIRE(loop.run(*at::checked(typename at::value_type{-1})));
                CHECK(it.watch(loop, long_enough).highest <= 0);
                CHECK(static_cast<std::int16_t>(it.far().word("LFR")) == -1);
            });
        }
    });
}

TEST_CASE("defect: who asks to be limited is told at which limit the motor turns, in Hz and in rpm, either way")
{
    test::all_drives::for_each([]<typename Device>() {
        for (int const sign : {1, -1}) {
            for (bool const is_above : {true, false}) {
                for (bool const is_speed : {true, false}) {
                    for (bool const is_change : {true, false}) {
                        CAPTURE(sign, is_above, is_speed, is_change);
                        plant<Device> it;
                        it.tell(Device::layout.lsp, 100);
                        if (Device::layout.sds != 0) {
                            it.tell(Device::layout.sds, 30);
                        }
                        is_change ? it.turn(sign * 30, false) : void();
                        int const hertz = is_above ? 60 : 5;
                        auto const ends = [&](auto conversation) {
                            static_cast<void>(it.watch(conversation, long_enough));
                            CHECK(conversation.reason().kind == kind::reference_limited);
                            CHECK(conversation.reason().limit == (is_above ? 500 : 100));
                            CHECK(it.millihertz() == sign * (is_above ? 50'000 : 10'000));
                        };
                        reference<Device> const wanted = is_speed
                                                             ? reference<Device>{speed<Device>(sign * hertz * 30)}
                                                             : reference<Device>{tenths<Device>(sign * hertz * 10)};
                        if (is_change) {
                            ends(change_reference{it.drive, wanted, long_enough, beyond_limits::limit});
                        } else {
                            ends(start{it.drive, wanted, forward, test::usual_limit, test::within_limits});
                        }
                    }
                }
            }
        }
        // One that slows down, and is never refused.
        plant<Device> it;
        it.tell(Device::layout.lsp, 100);
        it.turn(-30, false);
        change_reference slower{it.drive, -5_Hz};
        static_cast<void>(it.watch(slower, long_enough));
        CHECK((slower.reason().kind == kind::reference_limited and slower.reason().limit == 100));
        start again{it.drive, -4_Hz};
        static_cast<void>(it.watch(again, long_enough));
        CHECK((again.reason().kind == kind::reference_limited and again.reason().limit == 100));
    });
}
