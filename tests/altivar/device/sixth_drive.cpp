// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive of one's own, described in one file: what the library does with its five drives it does with this one, and no
// header knows it.
#include "altivar/device/sixth_drive.hpp"

#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/own_file.hpp"

#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <type_traits>

#include <rtuwire/sim.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr line_timing timing{38'400, character_format::even_8_1};
constexpr duration second = milliseconds(1'000);

/// Both forms of the drive, at a unit address that it can have.
using both = test::drive_list<atv99::device, atv99::plain_device>;
template <typename Device> constexpr station<Device> at_41{unit_id{41}};

/// In 0.1 Hz, as its motor turns.
template <typename Bench> int turning(Bench& bench) { return bench.drive().motor().frequency() / 100; }

template <typename Bench, typename Device> void cycles(Bench& bench, cyclic<Device> cycle)
{
    REQUIRE(bench.run_until([&] { return cycle.run(40_Hz); }, second, cycle));
    REQUIRE(bench.run_until([&] { return turning(bench) == 400; }, second * 3, cycle));
    bench.run_for(second, cycle);
    CHECK(cycle.control().is_running());
    CHECK(cycle.speed() == 2'400);

    REQUIRE(cycle.run(setting<atv99::lfr>{20_Hz}, run_direction::reverse));
    REQUIRE(bench.run_until([&] { return turning(bench) == -200; }, second * 3, cycle));

    cycle.stop();
    REQUIRE(bench.run_until([&] { return bench.drive().motor().is_at_rest(); }, second * 3, cycle));
    bench.run_for(second, cycle);
    CHECK(not cycle.control().is_ordered());
    CHECK(cycle.control().reason().kind == outcome_kind::pending);
}

/// A cycle that counts its requests by their functions.
template <typename Device> struct counted_cycle : cyclic<Device> {
    using cyclic<Device>::cyclic;

    std::optional<request_frame> next()
    {
        auto const asked = cyclic<Device>::next();
        if (asked) {
            ++requests[std::to_integer<unsigned>(asked->frame()[1])];
        }
        return asked;
    }

    std::map<unsigned, unsigned> requests{};
};

unsigned lines_of(std::string const& path)
{
    std::ifstream file{path};
    REQUIRE(file);
    unsigned count = 0;
    for (std::string line; std::getline(file, line);) {
        ++count;
    }
    return count;
}

} // namespace

TEST_CASE("a sixth drive is described in less than a hundred lines")
{
    CHECK(lines_of(test::own_file("altivar/device/sixth_drive.hpp")) < 100);
}

TEST_CASE("no drive of the library has a register where the sixth has one of its words")
{
    constexpr drive_layout const& layout = atv99::device::layout;
    test::all_drives::for_each([]<typename Device>() {
        for (std::uint16_t const address : {layout.cmd, layout.eta, layout.lft, layout.cmi, layout.eti, layout.rfr,
                                            atv99::lfr.address, atv99::lfrd.address, atv99::tto.address}) {
            CHECK_FALSE(Device::registers::has_address(address));
        }
    });
}

TEST_CASE("a sixth drive starts, changes its reference, and stops")
{
    both::for_each([]<typename Device>() {
        constexpr station<Device> drive = at_41<Device>;
        sim::bench bench{timing, drive};
        CHECK(bench.run(check_supervision{drive}).kind == outcome_kind::succeeded);
        REQUIRE(bench.run(start{drive, 1'200_rpm}).kind == outcome_kind::succeeded);
        bench.run_for(second);
        CHECK(turning(bench) == 200);
        CHECK(bench.run(change_reference{drive, 30_Hz}).kind == outcome_kind::succeeded);
        bench.run_for(second);
        CHECK(turning(bench) == 300);
        CHECK(bench.run(read<atv99::rfrd>(drive)) == signed_rpm{1'800});
        CHECK(bench.run(stop{drive}).kind == outcome_kind::succeeded);
        CHECK(bench.drive().motor().is_at_rest());
    });
}

TEST_CASE("a sixth drive is watched where its registers stand apart")
{
    constexpr station<atv99::device> drive = at_41<atv99::device>;
    sim::bench bench{timing, drive};
    watch seen{drive};
    REQUIRE(bench.run(start{drive, -1'200_rpm}).kind == outcome_kind::succeeded);
    bench.run_for(second * 2, seen);
    CHECK(seen.state() == cia402::state::operation_enabled);
    CHECK(seen.frequency() == signed_decihertz{-200});
    CHECK(seen.last_fault() == 0);
    bench.drive().inject_fault(18);
    bench.run_for(second, seen);
    CHECK(seen.fault() == 18);
}

TEST_CASE("a sixth drive keeps running by its own cycle")
{
    both::for_each([]<typename Device>() {
        for (bool const by_function_23 : {true, false}) {
            sim::bench bench{timing, at_41<Device>};
            cycles(bench, cyclic{at_41<Device>, {.by_function_23 = by_function_23}});
        }
    });
}

TEST_CASE("its cycle uses the function that the drive names")
{
    both::for_each([]<typename Device>() {
        sim::bench bench{timing, at_41<Device>};
        counted_cycle<Device> cycle{at_41<Device>};
        REQUIRE(bench.run_until([&] { return cycle.run(40_Hz); }, second, cycle));
        REQUIRE(bench.run_until([&] { return cycle.control().is_running(); }, second, cycle));
        cycle.requests.clear();
        bench.run_for(second, cycle);
        bool const is_one = std::is_same_v<Device, atv99::device>;
        CHECK((cycle.requests[23] > 5) == is_one);
        CHECK((cycle.requests[16] > 5) == not is_one);
        CHECK((cycle.requests[23] == 0) == not is_one);
    });
}

TEST_CASE("a scanner of a sixth drive that somebody set otherwise is noticed, and set right")
{
    constexpr station<atv99::device> drive = at_41<atv99::device>;
    sim::bench bench{timing, drive};
    cyclic cycle{drive};
    REQUIRE(bench.run(write<atv99::in3>(drive, count16{atv99::rfr.address})).has_value());
    CHECK_FALSE(bench.run_until([&] { return cycle.run(40_Hz); }, second, cycle));
    CHECK(cycle.control().reason().kind == outcome_kind::misconfigured);

    configure_scanner<scanner_inputs<atv99::rfrd, atv99::rfr, atv99::eta>, scanner_outputs<atv99::lfr, atv99::cmd>> set{
        drive};
    CHECK(bench.run(set).kind == outcome_kind::succeeded);
    CHECK(bench.run_until([&] { return cycle.run(40_Hz); }, second, cycle));
    bench.run_for(second * 2, cycle);
    CHECK(cycle.input(1) == 400);
}

TEST_CASE("a sixth drive stops by itself after its own time-out, and is reset")
{
    constexpr station<atv99::device> drive = at_41<atv99::device>;
    sim::bench bench{timing, drive};
    REQUIRE(bench.run(start{drive, 40_Hz}).kind == outcome_kind::succeeded);
    bench.run_for(milliseconds(1'900));
    CHECK(bench.drive().fault() == 0);
    bench.run_for(milliseconds(200));
    CHECK(bench.drive().fault() == sim::link_fault);
    CHECK(bench.run(read<atv99::lft>(drive)) == count16{sim::link_fault});
    CHECK(bench.run(reset_fault{drive}).kind == outcome_kind::succeeded);
    CHECK(bench.drive().fault() == 0);
    CHECK(bench.run(start{drive, 40_Hz}).kind == outcome_kind::succeeded);
}

TEST_CASE("a sixth drive identifies itself, and is stopped with all others")
{
    constexpr station<atv99::device> drive = at_41<atv99::device>;
    constexpr station<atv320::device> other{unit_id{7}};
    sim::bench bench{timing, drive, other};
    auto const found = bench.run(identify{drive});
    REQUIRE(found);
    byte_view const product = found->product;
    CHECK(std::string(reinterpret_cast<char const*>(product.data()), product.size()) == "ATV99M0");
    REQUIRE(bench.run(start{drive, 40_Hz}).kind == outcome_kind::succeeded);
    broadcast_stop everyone{drive, other};
    CHECK(bench.run(everyone));
    CHECK(everyone.reason(0).kind == outcome_kind::succeeded);
    CHECK(bench.drive().motor().is_at_rest());
}

TEST_CASE("a sixth drive stands in a list beside those of the library")
{
    using mine = drive_list<atv99::device, atv320::device>;
    std::string names;
    mine::for_each([&]<typename Device>() { names += std::string(Device::name.begin(), Device::name.end()) + ' '; });
    CHECK(names == "atv99 atv320 ");
    CHECK(mine::size == 2);
    CHECK(altivar::all_drives::size == 5);
}
