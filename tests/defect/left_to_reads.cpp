// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A motor whose order another one replaced, which then was refused, and which the reads of those who command kept running
// for ever: nobody's `running()` was true. Shown by the motor.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/remembered.hpp"

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using test::plant;

namespace {

constexpr auto forward = run_direction::forward;

/// A motor that a start has run, whose order a second start replaced that is above HSP.
template <typename Device> struct replaced_plant : plant<Device> {
    start first;
    test::remembered<start> second;

    explicit replaced_plant(bool is_reverse)
        : first{this->drive, *setting<Device::frequency_reference>::checked(signed_decihertz{tenths(300, is_reverse)})},
          second{this->drive, *setting<Device::frequency_reference>::checked(signed_decihertz{tenths(600, is_reverse)})}
    {
        static_cast<void>(this->watch(first, milliseconds(6'000)));
        REQUIRE(first.running());
        REQUIRE(this->millihertz() == (is_reverse ? -30'000 : 30'000));
    }
    static constexpr std::int16_t tenths(int size, bool is_reverse)
    {
        return static_cast<std::int16_t>(is_reverse ? -size : size);
    }

    void replace()
    {
        static_cast<void>(this->watch(second, milliseconds(500)));
        REQUIRE(second.reason().kind == outcome_kind::above_hsp);
        REQUIRE_FALSE(first.running());
    }
    /// Runs a conversation again and again, in pauses of 100 ms. Whether the motor stops by its own time-out, or by a word.
    template <typename Conversation> bool stands_behind(Conversation& again)
    {
        for (unsigned pass = 0; pass < 400 and this->millihertz() != 0; ++pass) {
            again.again();
            static_cast<void>(this->watch(again, milliseconds(100)));
        }
        return this->millihertz() == 0;
    }
};

} // namespace

TEST_CASE("defect: a start that is run again and again and refused keeps no motor running that it took over")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const is_reverse : {false, true}) {
            replaced_plant<Device> it{is_reverse};
            it.replace();
            CHECK(it.stands_behind(it.second));
        }
    });
}

TEST_CASE("defect: a reset that is run again and again keeps no motor running that nobody holds")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const is_reverse : {false, true}) {
            replaced_plant<Device> it{is_reverse};
            it.replace();
            reset_fault reset{it.drive};
            CHECK(it.stands_behind(reset));
        }
    });
}

TEST_CASE("defect: a change of the reference that is refused again and again keeps no motor running that nobody holds")
{
    test::all_drives::for_each([]<typename Device>() {
        replaced_plant<Device> it{false};
        it.replace();
        change_reference faster{it.drive, 60_Hz};
        CHECK(it.stands_behind(faster));
    });
}

TEST_CASE("motion law: a cycle whose order is refused behind its first visit keeps no motor running that it took over")
{
    for (bool const is_reverse : {false, true}) {
        plant<atv320::device> it;
        cyclic<atv320::device> loop{it.drive};
        static_cast<void>(it.watch(loop, milliseconds(1'000)));
        REQUIRE(loop.supervision().finding == outcome_kind::succeeded);
        it.tell(atv320::atr.address, 1); // found by the next check
        auto const at = is_reverse ? -30_Hz : 30_Hz;
        start go{it.drive,
                 *setting<atv320::lfr>::checked(at),
                 forward,
                 test::usual_limit,
                 {.risks = {.accept_automatic_restart = true}}};
        static_cast<void>(it.watch(go, milliseconds(6'000)));
        REQUIRE(go.running());
        REQUIRE(loop.run(*setting<cycle_layout<atv320::device>::reference>::checked(signed_rpm{std::int16_t{600}})));
        static_cast<void>(it.watch(loop, milliseconds(1'000)));
        CHECK_FALSE(go.running());
        CHECK_FALSE(loop.control().is_ordered());
        CHECK(loop.control().reason().kind == outcome_kind::restarts_by_itself);
        static_cast<void>(it.watch(loop, milliseconds(40'000)));
        CHECK(it.millihertz() == 0);
    }
}
