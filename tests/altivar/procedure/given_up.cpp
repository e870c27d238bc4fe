// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a procedure says whose limit is over: it claims no fault, no disobedience and no silence that it did not read.
#include <rtuwire/altivar/procedure/outcome.hpp>

#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/sim/bench.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr auto const& layout = atv320::device::layout;
constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr station<atv320::device> drive{unit_id{7}};
constexpr std::uint16_t at_rest = 0x0250, enabled = 0x0237, in_fault = 0x0238, reacting = 0x023F, no_state = 0x0201;

} // namespace

TEST_CASE("a reset whose limit is over is in fault only where a fault was read")
{
    constexpr reset_procedure reset{layout};
    CHECK(does(led(reset, {begun}), late, ends(kind::aborted)));
    CHECK(does(led(reset, {begun, word(no_state)}), late, ends(kind::aborted)));
    constexpr way written{begun, word(in_fault), confirmed, confirmed, confirmed};
    CHECK(does(led(reset, written), late, ends(kind::state_timeout))); // the fault that was read is older
    CHECK(does(led(reset, written), word(in_fault), pauses));
    CHECK(does(led(led(reset, written), {word(in_fault)}), late, reads(layout.lft)));
    CHECK(led(reset, {begun, word(reacting), late, word(21)}).reason().kind == kind::in_fault);
    reset_procedure cleared = led(reset, written);
    CHECK(does(led(cleared, {word(no_state)}), late, ends(kind::state_timeout)));
}

TEST_CASE("a reset that never got the line does not claim a fault")
{
    sim::bench bench{timing, drive};
    reset_fault reset{drive, milliseconds(2'000)};
    bench.link().hold(drive.unit(), bench.now() + milliseconds(30'000));
    auto const told = bench.run(reset);
    CHECK(told.kind == kind::aborted);
    CHECK(told.fault == 0);
}

TEST_CASE("a stop judges the drive by what it read after its word, and only where nothing was lost since")
{
    constexpr stop_procedure ramp{atv12::device::layout, stop_by::ramp};
    constexpr way as_fast{begun, confirmed, words(enabled, 300), pause_over, confirmed, words(enabled, 300)};
    CHECK(does(led(ramp, as_fast), late, ends(kind::state_timeout)));
    stop_procedure const lost = led(led(ramp, as_fast), {pause_over, failed(errc::timed_out)});
    CHECK(does(lost, late, ends(kind::unconfirmed)));
    stop_procedure const refused = led(led(ramp, as_fast), {pause_over, failed(errc::server_device_busy)});
    CHECK(does(refused, late, ends(kind::state_timeout)));
    // A halt reads before its word: the motor was still accelerating then.
    constexpr stop_procedure halt{atv12::device::layout, stop_by::halt};
    constexpr way once_after{begun, words(enabled, 200), word(0x000F), confirmed, words(enabled, 300)};
    CHECK(does(led(halt, once_after), late, ends(kind::unconfirmed)));
    constexpr way twice_after{begun,     words(enabled, 200), word(0x000F), confirmed, words(enabled, 300),
                              confirmed, words(enabled, 300)};
    CHECK(does(led(halt, twice_after), late, ends(kind::state_timeout)));
}

TEST_CASE("a check and a save whose limit is over say that they were given up, not that the drive was silent")
{
    constexpr supervision_procedure check{layout, supervision_options{.beyond = beyond_limits::limit}};
    CHECK(does(led(check, {begun}), late, ends(kind::aborted)));
    constexpr save_procedure save{layout};
    constexpr way saving{begun, word(at_rest), word(0)};
    CHECK(does(led(save, {begun}), late, ends(kind::aborted)));
    CHECK(led(save, {begun, late}).reason().error == errc::none);
    CHECK(does(led(save, saving), late, then(writes(layout.cmi, 0), kind::aborted)));
    save_procedure const waiting = led(led(save, saving), {confirmed});
    CHECK(does(waiting, late, then(writes(layout.cmi, 0), kind::state_timeout)));
    save_procedure const done = led(waiting, {pause_over, word(0)});
    CHECK(does(done, late, writes(layout.cmi, 0)));
    CHECK(led(done, {late, confirmed}).reason().kind == kind::succeeded);
}

TEST_CASE("a cycle whose line is cut while it enables reports the silence, however many misses it tolerates")
{
    for (std::uint8_t misses = 0; misses < 5; ++misses) {
        sim::bench bench{drive_client<1>{timing, {.response_timeout = milliseconds(400)}}, drive};
        cyclic loop{drive,
                    {.period = milliseconds(200), .enable_timeout = milliseconds(1'000), .tolerated_misses = misses}};
        bench.run_for(milliseconds(1'500), loop);
        REQUIRE(loop.run(1'500_rpm));
        bench.cut();
        bench.run_for(milliseconds(20'000), loop);
        INFO(static_cast<int>(misses));
        CHECK_FALSE(loop.control().is_ordered());
        CHECK(loop.control().reason().kind == kind::silent);
        CHECK(loop.control().reason().error == errc::timed_out);
    }
}

TEST_CASE("what dropped a cycle's order is kept when the line is lost later")
{
    sim::bench bench{drive_client<1>{timing}, drive};
    cyclic loop{drive, {.period = milliseconds(100)}};
    bench.run_for(milliseconds(1'500), loop);
    REQUIRE(loop.run(1'500_rpm));
    bench.run_for(milliseconds(2'000), loop);
    REQUIRE(loop.control().is_running());
    bench.drive().press_stop();
    bench.run_for(milliseconds(1'000), loop);
    REQUIRE(loop.control().reason().kind == kind::stop_key);
    bench.cut();
    bench.run_for(milliseconds(20'000), loop);
    CHECK(loop.control().reason().kind == kind::stop_key);
    CHECK(loop.control().reason().error == errc::none);
    bench.cut(false);
    bench.run_for(milliseconds(20'000), loop);
    CHECK(loop.control().reason().kind == kind::stop_key);
}
