// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A reference above HSP, known only at run time: no word of it reaches the drive, and its order does not say that it runs.
#include "motion_law/plant.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using test::plant;

namespace {

/// A drive at 50 Hz at most, 1500 rpm; counts the writes to it.
template <typename Device> struct limited_plant : plant<Device> {
    unsigned writes{0};

    void count_writes()
    {
        writes = 0;
        this->disturb([this](test::frame_bytes const& frame, bool is_request) {
            writes += is_request and frame[1] == std::byte{6} ? 1U : 0U;
        });
    }
};

template <typename Device> auto at_run_time(std::int16_t tenths)
{
    return *setting<Device::frequency_reference>::checked(signed_decihertz{tenths});
}

} // namespace

TEST_CASE("defect: D25 a start above HSP sends nothing, and does not say that the motor runs")
{
    test::all_drives::for_each([]<typename Device>() {
        for (std::int16_t const tenths : {std::int16_t{501}, std::int16_t{5'990}, std::int16_t{-501}}) {
            limited_plant<Device> it;
            it.count_writes();
            start go{it.drive, at_run_time<Device>(tenths)};
            static_cast<void>(it.watch(go, milliseconds(5'000)));
            CHECK(go.settled());
            CHECK_FALSE(go.running());
            CHECK(it.writes == 0);
            CHECK(it.millihertz() == 0);
        }
    });
}

TEST_CASE("defect: D25 a change of the reference to one above HSP sends nothing")
{
    test::all_drives::for_each([]<typename Device>() {
        limited_plant<Device> it;
        it.turn(30, false);
        it.count_writes();
        change_reference faster{it.drive, at_run_time<Device>(5'990)};
        static_cast<void>(it.watch(faster, milliseconds(5'000)));
        CHECK(it.writes == 0);
        CHECK(it.millihertz() == 30'000);
    });
}

TEST_CASE("defect: D25 a cycle takes no order above HSP")
{
    test::all_drives::for_each([]<typename Device>() {
        limited_plant<Device> it;
        cyclic<Device> loop{it.drive};
        static_cast<void>(it.watch(loop, milliseconds(1'000)));
        using at = setting<cycle_layout<Device>::reference>;
        for (std::int16_t const steps : {std::int16_t{7'000}, std::int16_t{-7'000}}) {
            CHECK_FALSE(loop.run(*at::checked(typename at::value_type{steps}))); // 700 Hz, or 7000 rpm
            CHECK(loop.control().reason().kind == outcome_kind::above_hsp);
            static_cast<void>(it.watch(loop, milliseconds(2'000)));
            CHECK(it.millihertz() == 0);
        }
    });
}

TEST_CASE("defect: D25 700 Hz, which the table of an ATV12 allows, is refused by the drive's own limit")
{
    limited_plant<atv12::device> it;
    it.count_writes();
    start go{it.drive, *setting<atv12::lfr>::checked(700 * 1_Hz)};
    static_cast<void>(it.watch(go, milliseconds(5'000)));
    CHECK_FALSE(go.running());
    CHECK(it.writes == 0);
}
