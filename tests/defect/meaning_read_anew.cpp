// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A drive that was read to be in its I/O profile gets no word of a stop but 0000, whatever was read of it before.
#include "defect/powered_drive.hpp"
#include "support/catch.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr duration limit = milliseconds(3'000);

/// Behind the power cycle each control word with bit 0 runs the motor.
struct restored : test::taken_over {
    unsigned others{0}; ///< control words other than 0000

    void cycle_power() { drive().power_cycle(now()); }
    outcome_kind checked()
    {
        check_supervision look{drive_at};
        finish(look);
        return look.reason().kind;
    }
    template <typename Conversation> void has_only_0000(Conversation&& what)
    {
        requests_of_unit.clear();
        finish(what);
        for (written const& each : requests_of_unit) {
            others += each.function == 6 and each.address == atv320::cmd.address and each.word != 0 ? 1U : 0U;
        }
        CHECK(others == 0);
        CHECK(fastest == 0);
    }
};

} // namespace

TEST_CASE("defect: a check that reads the I/O profile ends what was read before: the next stop says 0000")
{
    for (stop_by const way : {stop_by::ramp, stop_by::quick_stop, stop_by::halt, stop_by::freewheel}) {
        restored it;
        it.cycle_power();
        CHECK(it.checked() == outcome_kind::not_drive_profile);
        it.has_only_0000(stop{it.drive_at, way, limit});
        it.has_only_0000(stop{it.drive_at, way, limit});
    }
}

TEST_CASE("defect: a start that is refused for the I/O profile leaves no stop with another word than 0000")
{
    restored it;
    it.cycle_power();
    start go{it.drive_at, 30_Hz};
    it.has_only_0000(go);
    CHECK(go.reason().kind == outcome_kind::not_drive_profile);
    it.has_only_0000(stop{it.drive_at, stop_by::ramp, limit});
}

TEST_CASE("defect: the look of a stop that finds the I/O profile counts for the next stop, too")
{
    restored it;
    it.idle(milliseconds(700));
    it.cycle_power();
    for (int i = 0; i < 2; ++i) {
        it.has_only_0000(stop{it.drive_at, stop_by::ramp, limit});
    }
}

TEST_CASE("defect: a stop of all behind a check that read the I/O profile, or a long silence, goes on with 0000")
{
    for (bool const looks : {false, true}) {
        for (std::uint32_t const silence : {0U, 1'500U}) {
            if (silence == 0 and not looks) {
                continue; // nothing told of the power cycle: its first words are the quick stop
            }
            INFO("silence " << silence << " ms, looks " << looks);
            restored it;
            it.cycle_power();
            if (looks) {
                CHECK(it.checked() == outcome_kind::not_drive_profile);
            }
            it.idle(milliseconds(silence));
            it.has_only_0000(broadcast_stop{it.drive_at});
        }
    }
}
