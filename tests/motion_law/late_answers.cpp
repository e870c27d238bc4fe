// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive that answers everything, in its order, and each request later than all times of its client: an answer that comes
// may be that to an earlier request. Nothing is said of the motor by such a one.
#include "motion_law/late_line.hpp"

#include <optional>
#include <random>

#include "support/drives.hpp"
#include "support/one_in.hpp"

#include <rtuwire/altivar/atv320_parameters.hpp>
#include <rtuwire/altivar/maintenance/restore.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/inspection/watch.hpp>
#include <rtuwire/altivar/procedure/motion/reset_fault.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

using draw = std::mt19937;

std::uint32_t below(draw& from, std::uint32_t most) { return static_cast<std::uint32_t>(from() % most); }

client_options options_of(draw& from)
{
    constexpr std::uint32_t timeouts[]{40, 100, 250};
    return {.response_timeout = milliseconds(timeouts[below(from, 3)]),
            .late_response = milliseconds(20 + below(from, 60)),
            .retries = static_cast<std::uint8_t>(below(from, 3))};
}

/// From just behind all times on to twelve times as long.
lateness lateness_of(draw& from, client_options const& options)
{
    std::uint32_t const times = (options.response_timeout.microseconds + options.late_response.microseconds) / 1'000;
    std::uint32_t const all = times + 2 + below(from, below(from, 2) == 0 ? times : 11 * times);
    std::uint32_t const there = below(from, 3) * all / 2;
    return {.there = milliseconds(there), .back = milliseconds(all - there)};
}

/// Reads one register or two, which nobody is there any more to wait for.
template <typename Device> void ask_in_vain(late_line<Device>& it, std::uint16_t address, std::uint16_t count)
{
    single_request asked{it.drive.unit(), read_holding_registers{address, count}};
    it.run_late(milliseconds(20'000), asked);
}

/// What was asked before, of a motor at rest.
template <typename Device> void ask_at_rest(late_line<Device>& it, draw& from)
{
    drive_layout const& layout = Device::layout;
    for (unsigned left = below(from, 4); left != 0; --left) {
        switch (below(from, 4)) {
        case 0: ask_in_vain(it, layout.eta, 1); break;
        case 1: ask_in_vain(it, layout.lft, 1); break;
        case 2: ask_in_vain(it, layout.rfr, 1); break;
        default: ask_in_vain(it, layout.eta, 2); break;
        }
    }
}

/// How often it was said that it is done, and how often that was wrong.
struct tally {
    unsigned done{0};
    unsigned wrong{0};
};

/// Another master runs the motor, which stood when something was asked; or this client did, and it is asked since then.
template <typename Device> void let_run(late_line<Device>& it, draw& from, lateness late)
{
    if (below(from, 2) == 0) {
        it.be_late(late);
        ask_at_rest(it, from);
        it.run_motor(static_cast<std::uint16_t>(100 + below(from, 400)));
        it.idle_late(milliseconds(below(from, 1'500)));
        return;
    }
    start go{it.drive, 40_Hz};
    it.run_late(milliseconds(10'000), go);
    REQUIRE(go.succeeded());
    it.idle_late(milliseconds(2'000));
    it.be_late(late);
    if (below(from, 2) == 0) { // its asker is gone before any answer
        single_request asked{it.drive.unit(), read_holding_registers{Device::layout.lft, 1}};
        it.run_late(milliseconds(below(from, 300)), asked);
    }
}

template <typename Device> void stop_once(std::uint32_t seed, stop_by mode, tally& of)
{
    draw from{seed};
    client_options const options = options_of(from);
    late_line<Device> it{options};
    it.set_ramps(10, static_cast<std::uint16_t>(20 + below(from, 600)));
    let_run(it, from, lateness_of(from, options));
    bool const has_watch = below(from, 2) == 0;
    watch<Device> beside{it.drive, {.period = milliseconds(40 + below(from, 400))}};
    stop rest{it.drive, mode, milliseconds(2'000 + below(from, 60'000))};
    bool const has_ended = has_watch ? it.run_late(
                                           milliseconds(180'000), [] {}, rest, beside)
                                     : it.run_late(milliseconds(180'000), rest);
    CHECK(has_ended);
    of.done += rest.succeeded() ? 1U : 0U;
    bool const may_coast = mode == stop_by::freewheel or rest.reason().is_other_stop;
    bool const may_have_power = mode == stop_by::halt and not may_coast;
    bool const is_wrong =
        rest.succeeded() and ((it.turns() and not may_coast) or (it.has_power() and not may_have_power));
    of.wrong += is_wrong ? 1U : 0U;
    if (is_wrong) {
        UNSCOPED_INFO("seed " << seed << ", mode " << static_cast<int>(mode) << ", at " << it.far().motor().frequency()
                              << " mHz");
    }
}

template <typename Device> void reset_once(std::uint32_t seed, tally& of)
{
    draw from{seed};
    client_options const options = options_of(from);
    late_line<Device> it{options};
    it.be_late(lateness_of(from, options));
    bool const has_polls = below(from, 2) == 0; // of one register each, or rounds of a watch
    watch<Device> beside{it.drive, {.period = milliseconds(40 + below(from, 400))}};
    if (has_polls) {
        ask_in_vain(it, Device::layout.lft, 1);
        ask_in_vain(it, Device::layout.eta, 1);
    } else {
        instant const end = it.now() + milliseconds(300 + below(from, 2'000));
        it.run_until(end, beside);
    }
    constexpr std::uint16_t overcurrent = 9;
    it.far().inject_fault(overcurrent);
    if (below(from, 3) == 0) {
        it.far().clear_cause();
    }
    reset_fault reset{it.drive, milliseconds(1'000 + below(from, 30'000))};
    CHECK(it.run_late(milliseconds(120'000), reset));
    of.done += reset.succeeded() ? 1U : 0U;
    bool const is_wrong = reset.succeeded() and cia402::is_in_fault(it.far().state_machine().state());
    of.wrong += is_wrong ? 1U : 0U;
    if (is_wrong) {
        UNSCOPED_INFO("seed " << seed);
    }
}

/// A drive that does not supervise its link: no start may run it.
template <typename Device> void start_once(std::uint32_t seed, tally& of)
{
    draw from{seed};
    client_options const options = options_of(from);
    late_line<Device> it{options};
    safeguard_layout const& its = Device::layout.safeguards;
    bool const is_supervised = below(from, 2) == 0;
    bool const is_prompt = below(from, 4) == 0;
    if (not is_supervised) {
        its.sll != 0 ? it.tell(its.sll, 0) : it.tell(Device::layout.cmi, its.nto);
    }
    it.be_late(is_prompt ? lateness{} : lateness_of(from, options));
    for (unsigned left = below(from, 4); left != 0; --left) {
        ask_in_vain(it, its.chcf != 0 ? its.chcf : Device::layout.cmd, 1);
    }
    bool has_run = false;
    start go{it.drive, 30_Hz, run_direction::forward, milliseconds(3'000 + below(from, 60'000))};
    CHECK(it.run_late(
        milliseconds(200'000), [&] { has_run = has_run or it.has_power(); }, go));
    of.done += go.succeeded() ? 1U : 0U;
    bool const is_wrong = (has_run and not is_supervised) or (go.succeeded() and not it.has_power());
    of.wrong += is_wrong ? 1U : 0U;
    if (is_wrong) {
        UNSCOPED_INFO("seed " << seed << (is_supervised ? "" : ", not supervised"));
    }
}

/// Of one ramp: no word is written to a drive whose motor turns.
void restore_once(std::uint32_t seed, tally& of)
{
    using device = atv320::device;
    draw from{seed};
    client_options options = options_of(from);
    options.retries = static_cast<std::uint8_t>(1 + below(from, 3));
    late_line<device> it{options};
    it.set_ramps(10, 200);
    it.be_late(below(from, 4) == 0 ? lateness{} : lateness_of(from, options));
    ask_at_rest(it, from);
    bool const runs = below(from, 3) != 0;
    if (runs) {
        it.run_motor(300);
        it.idle_late(milliseconds(below(from, 1'500)));
    }
    auto const wanted = [inr = it.far().word("INR")](parameter const& row) -> std::optional<std::uint16_t> {
        return row.code == "ACC"   ? std::optional<std::uint16_t>{37}
               : row.code == "INR" ? std::optional{inr}
                                   : std::nullopt;
    };
    auto const report = [](parameter_group const&, parameter const&, restore_report const&) {};
    restore back{it.drive,
                 atv320::parameters,
                 wanted_settings{drive_family::of("ATV320"), wanted},
                 report,
                 {.with_inferred = true}};
    bool was_written = false;
    it.run_late(
        milliseconds(600'000), [&] { was_written = was_written or (it.turns() and it.far().word("ACC") == 37); }, back);
    of.done += back.reason().kind == outcome_kind::succeeded ? 1U : 0U;
    bool const is_wrong = was_written or (back.reason().kind == outcome_kind::succeeded and it.turns());
    of.wrong += is_wrong ? 1U : 0U;
    if (is_wrong) {
        UNSCOPED_INFO("seed " << seed);
    }
}

} // namespace

TEST_CASE("late answers: a restore writes nothing to a drive whose motor turns")
{
    tally of;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        restore_once(seed, of);
    }
    CHECK(of.wrong == 0);
    CHECK(of.done > 5); // else it shows nothing
}

TEST_CASE("late answers: a reset never says that a drive is without a fault which has one")
{
    test::all_drives::for_each([]<typename Device>() {
        tally of;
        for (std::uint32_t seed = 1; seed <= 300; seed += one_in(9)) {
            reset_once<Device>(seed, of);
        }
        CHECK(of.wrong == 0);
        CHECK(of.done > 5 / one_in(9)); // else it shows nothing
    });
}

TEST_CASE("late answers: a start runs no motor that its check would refuse, and says of none that it runs which stands")
{
    test::all_drives::for_each([]<typename Device>() {
        tally of;
        for (std::uint32_t seed = 1; seed <= 200; ++seed) {
            start_once<Device>(seed, of);
        }
        CHECK(of.wrong == 0);
        CHECK(of.done > 5); // else it shows nothing
    });
}

TEST_CASE("late answers: a stop never says that a motor stands which turns")
{
    test::all_drives::for_each([]<typename Device>() {
        for (stop_by const mode :
             {stop_by::ramp, stop_by::freewheel, stop_by::quick_stop, stop_by::halt, stop_by::dc_injection}) {
            tally of;
            for (std::uint32_t seed = 1; seed <= 150; seed += one_in(9)) {
                stop_once<Device>(seed, mode, of);
            }
            INFO("mode " << static_cast<int>(mode));
            CHECK(of.wrong == 0);
            CHECK(of.done > 10 / one_in(9)); // else it shows nothing
        }
    });
}
