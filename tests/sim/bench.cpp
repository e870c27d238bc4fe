// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The test bench: conversations run to their end, alone and side by side, over good lines and bad ones.
#include <rtuwire/sim/bench.hpp>

#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/inspection/watch.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr station<atv320::device> drive{unit_id{7}};
constexpr station<atv28::device> old{unit_id{9}};

constexpr bool reads_a_register_of_a_bank()
{
    word_bank<8> registers{};
    static_cast<void>(registers.set(3, 1'500));
    sim::bench bench{timing, bank_at{unit_id{3}, registers}};
    single_request ask{unit_id{3}, read_holding_registers{.start = 3, .count = 1}};
    auto const response = bench.run(ask)->to<read_holding_registers>();
    return response and response->registers[0] == 1'500;
}
PROOF("a register of a bank is read over a simulated line", reads_a_register_of_a_bank)

/// 8 bytes asked, t3.5, 7 bytes said, t3.5: on a silent line nothing else takes time.
constexpr bool takes_the_time_of_the_line()
{
    word_bank<8> registers{};
    sim::bench bench{timing, bank_at{unit_id{3}, registers}};
    bench.run_for(milliseconds(100));
    instant const begin = bench.now();
    single_request ask{unit_id{3}, read_holding_registers{.start = 3, .count = 1}};
    static_cast<void>(bench.run(ask));
    return bench.now() - begin == timing.characters(8 + 7) + timing.t3_5() * 2;
}
PROOF("a transaction takes the time of its bytes and of the silences behind them", takes_the_time_of_the_line)

} // namespace

TEST_CASE("a simulated drive is read, started and stopped")
{
    sim::bench bench{timing, drive};
    CHECK(bench.run(write<atv320::tto>(drive, 20_s)).has_value());
    CHECK(bench.run(read<atv320::tto>(drive)) == deciseconds{200});
    CHECK(bench.run(single_request{drive.unit(), read_holding_registers{1, 1}}) == errc::illegal_data_address);
    CHECK(bench.run(start{drive, 50_Hz}).kind == outcome_kind::succeeded);
    CHECK(cia402::has_power(bench.drive().state_machine().state()));
    bench.run_for(milliseconds(2'000));
    CHECK(bench.drive().motor().frequency() > 0);
    CHECK(bench.run(stop{drive}).kind == outcome_kind::succeeded);
    CHECK(bench.drive().motor().is_at_rest());
}

TEST_CASE("what has ended begins anew where it can")
{
    sim::bench bench{timing, drive};
    poller<read_plan<atv320::device, atv320::eta, atv320::rfr>> panel{drive};
    REQUIRE(bench.run(panel));
    instant const first = bench.now();
    REQUIRE(bench.run(panel));
    CHECK(bench.now() != first);
    single_request<read_holding_registers> wrong{unit_id{7}, read_holding_registers{.start = 1, .count = 0}};
    CHECK(bench.run(wrong).error() == errc::invalid_quantity); // it never leaves
}

/// A conversation of one's own that ends, and cannot begin anew.
struct once_only : finite_conversation {
    static std::optional<request_frame> next() { return std::nullopt; }
    constexpr void accept(result<response> const&) {}
    void end() { settle(errc::none); }
};

TEST_CASE("an order that has ended is run anew; what cannot begin anew is not run, and tells no earlier success")
{
    sim::bench bench{timing, drive};
    stop order{drive};
    REQUIRE(bench.run(order).kind == outcome_kind::succeeded);
    instant const before = bench.now();
    CHECK(bench.run(order).kind == outcome_kind::succeeded);
    CHECK(bench.now() != before);
    once_only own;
    own.end();
    instant const again = bench.now();
    CHECK(bench.run(own).error() == errc::used_already);
    CHECK_FALSE(bench.run(order, own));
    CHECK(bench.now() == again);
}

TEST_CASE("conversations side by side take turns, on a client and on a bus")
{
    sim::bench few{host_client{timing}, drive, old};
    auto first = read<atv320::eta>(drive);
    auto second = read<atv28::eta>(old);
    auto third = read<atv320::rfr>(drive);
    CHECK(few.run(first, second, third));
    CHECK(first.outcome());
    CHECK(second.outcome());
    CHECK(third.outcome());

    sim::bench on_a_bus{bus<2>{timing}, drive, old};
    auto again = read<atv320::eta>(drive);
    auto other = read<atv28::eta>(old);
    CHECK(on_a_bus.run(again, other));
    CHECK(again.outcome());
    CHECK(other.outcome());
}

TEST_CASE("what never ends is run for a time, or until something is so")
{
    sim::bench bench{timing, drive};
    cyclic loop{drive};
    watch eye{drive};
    CHECK(bench.run_until([&] { return not loop.link_lost(); }, milliseconds(5'000), loop));
    CHECK(loop.run(1'500_rpm));
    CHECK(bench.run_until([&] { return loop.control().is_running(); }, milliseconds(5'000), loop, eye));
    unsigned passes = 0;
    instant const begin = bench.now();
    bench.run_for(milliseconds(1'000), loop, [&](instant) { ++passes; });
    CHECK(passes > 20);
    CHECK(passes < 1'000); // from deadline to deadline, not step by step
    CHECK((bench.now() - begin).microseconds / 1'000 == 1'000);
    CHECK_FALSE(bench.run_until([&] { return bench.drive().fault() != 0; }, milliseconds(100), loop));
}

TEST_CASE("a conversation that the limit cuts says that it has not ended")
{
    sim::bench bench{timing, drive};
    bench.cut();
    auto const cut = bench.run(read<atv320::eta>(drive), milliseconds(50));
    CHECK(cut.error() == read<atv320::eta>(drive).outcome().error());
    CHECK(bench.run(start{drive, 50_Hz}, milliseconds(50)).kind == outcome_kind::pending);
    auto const silent = bench.run(read<atv320::eta>(drive));
    CHECK(silent.error() == errc::timed_out);
    bench.cut<0>(false);
    CHECK(bench.run(read<atv320::eta>(drive)));
}

TEST_CASE("faults of the line: what a damaged frame costs is asked once more")
{
    sim::bench bench{host_client{timing, {.response_timeout = milliseconds(200), .retries = 3}}, drive};
    bench.wire().set_faults(1, {.lost = 1'000'000});
    CHECK(bench.run(read<atv320::eta>(drive)).error() == errc::timed_out);
    bench.wire().set_faults(1, {.bit_errors = 5'000});
    unsigned read_well = 0;
    for (unsigned i = 0; i < 100; ++i) {
        read_well += bench.run(read<atv320::eta>(drive)).has_value() ? 1U : 0U;
    }
    CHECK(read_well > 90);
    bench.wire().set_faults({.is_cut = true});
    CHECK(bench.run(read<atv320::eta>(drive)).error() == errc::timed_out);
}

TEST_CASE("the same calls take the same time")
{
    auto const length = [] {
        sim::bench bench{timing, drive};
        bench.wire().set_faults({.bit_errors = 3'000, .glitches = 100'000});
        for (unsigned i = 0; i < 20; ++i) {
            static_cast<void>(bench.run(read<atv320::eta>(drive)));
        }
        return bench.now();
    };
    CHECK(length() == length());
}

TEST_CASE("a pass jumps to what is due next, 20 ms at most")
{
    sim::bench bench{timing, drive};
    for (unsigned i = 0; i < 1'000; ++i) {
        instant const before = bench.now();
        bench.pass();
        CHECK((bench.now() - before).microseconds > 0);
        CHECK(bench.now() - before <= milliseconds(20));
    }
    CHECK(reached(bench.now(), instant{10'000'000}));
}

TEST_CASE("a stop of all units is run to its end, and a limit above half the clock's range is waited for")
{
    sim::bench bench{drive_client<2>{timing}, drive, old};
    start go{drive, 30_Hz};
    REQUIRE(bench.run(go).kind == outcome_kind::succeeded);
    broadcast_stop all{drive, old};
    CHECK(bench.run(all));
    CHECK(all.succeeded());
    broadcast_stop again{drive, old};
    CHECK_FALSE(bench.run(again, milliseconds(1)));
    constexpr duration forty_minutes{40U * 60U * 1'000'000U};
    instant const begin = bench.now();
    bench.run_for(forty_minutes);
    CHECK(bench.now() - begin >= forty_minutes);
    CHECK((bench.now() - begin).microseconds < forty_minutes.microseconds + 1'000'000);
}
