// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A drive that was read to be in its I/O profile gets no word of a stop but 0000, whatever was read of it before.
#include "support/catch.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/sim.hpp>

namespace {

using namespace rtuwire;
using namespace rtuwire::altivar;

constexpr station<atv320::device> drive{unit_id{7}};
constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr std::uint16_t chcf = 8401, io = 3, together = 1;

/// A line with a drive whose I/O profile is saved, and that was checked in its drive profile: behind a power cycle each control
/// word with bit 0 lets its motor run at LSP.
struct restored {
    decltype(sim::bench{timing, drive}) line{timing, drive};
    bool has_run{false};

    restored()
    {
        REQUIRE(line.run(write<atv320::lsp>(drive, 10_Hz)));
        set(io);
        save_to_eeprom save{drive};
        REQUIRE(line.run(save).kind == outcome_kind::succeeded);
        set(together);
        REQUIRE(checked() == outcome_kind::succeeded);
    }

    void set(std::uint16_t profile)
    {
        single_request write{drive.unit(), write_single_register{.address = chcf, .value = profile}};
        REQUIRE(line.run(write));
    }
    outcome_kind checked()
    {
        check_supervision look{drive};
        return line.run(look).kind;
    }
    void cycle_power() { line.drive().power_cycle(line.now()); }

    template <typename Conversation> void run(Conversation& what, duration limit)
    {
        line.run_until([&] { return what.settled(); }, limit, what,
                       [&](instant) { has_run = has_run or not line.drive().motor().is_at_rest(); });
        CHECK(what.settled());
        CHECK_FALSE(has_run);
    }
};

} // namespace

TEST_CASE("defect: a check that reads the I/O profile ends what was read before: the next stop says 0000")
{
    for (stop_by const way : {stop_by::ramp, stop_by::quick_stop, stop_by::halt, stop_by::freewheel}) {
        restored it;
        it.cycle_power();
        CHECK(it.checked() == outcome_kind::not_drive_profile);
        stop rest{drive, way, milliseconds(3'000)};
        it.run(rest, milliseconds(10'000));
        stop again{drive, way, milliseconds(3'000)};
        it.run(again, milliseconds(10'000));
    }
}

TEST_CASE("defect: a start that is refused for the I/O profile leaves no stop with another word than 0000")
{
    restored it;
    it.cycle_power();
    start go{drive, 30_Hz};
    it.run(go, milliseconds(10'000));
    CHECK(go.reason().kind == outcome_kind::not_drive_profile);
    stop rest{drive, stop_by::ramp, milliseconds(3'000)};
    it.run(rest, milliseconds(10'000));
}

TEST_CASE("defect: the look of a stop that finds the I/O profile counts for the next stop, too")
{
    restored it;
    it.line.run_for(milliseconds(700));
    it.cycle_power();
    for (int i = 0; i < 2; ++i) {
        stop rest{drive, stop_by::ramp, milliseconds(3'000)};
        it.run(rest, milliseconds(10'000));
    }
}

TEST_CASE("defect: a stop of all behind a check that read the I/O profile goes on with 0000 as it began")
{
    for (std::uint32_t const silence : {0U, 1'500U}) {
        for (bool const looks : {false, true}) {
            restored it;
            if (silence == 0 and not looks) {
                continue; // nothing told of the power cycle: its first words are the quick stop
            }
            it.cycle_power();
            if (looks) {
                CHECK(it.checked() == outcome_kind::not_drive_profile);
            }
            it.line.run_for(milliseconds(silence));
            unsigned others = 0;
            broadcast_stop everyone{drive};
            it.line.run_until([&] { return everyone.settled(); }, milliseconds(40'000), everyone,
                              [&](instant) { others += it.line.drive().word(atv320::cmd.code) != 0 ? 1U : 0U; });
            CHECK((everyone.settled() and others == 0));
        }
    }
}
