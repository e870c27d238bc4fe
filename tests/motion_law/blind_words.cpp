// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Nothing blind rests on what was only declared: what a client has read of a drive's control words, how long that
// holds, and what is sent where it does not.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 0};
constexpr unit_id unit{3};
constexpr std::uint16_t none = 0xFFFF;

/// A client and a drive; the first two requests that wrote a control word, of either family.
template <typename Device> struct hall : test::simulated_bus<drive_client<4>, Device> {
    std::pair<std::uint16_t, std::uint16_t> first{none, none}; ///< address and word
    std::pair<std::uint16_t, std::uint16_t> second{none, none};
    unsigned lost{0}; ///< so many of the next requests

    hall() : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, patient}}
    {
        this->add(unit);
        this->idle(milliseconds(20));
        this->disturb([this](test::frame_bytes& frame, bool is_request) {
            if (not is_request) {
                return;
            }
            if (frame.size() == 8 and frame[1] == std::byte{6}) {
                std::pair const told{u16_at(byte_view{frame}, 2), u16_at(byte_view{frame}, 4)};
                if (told.first == 8501 or told.first == 400) {
                    (first.first == none ? first : second) = second.first == none ? told : second;
                }
            }
            if (lost != 0) {
                --lost;
                frame.clear();
            }
        });
    }

    /// Runs at 30 Hz, by this client.
    void starts()
    {
        start go{station<Device>{unit}, 30_Hz};
        REQUIRE(this->run(go));
        REQUIRE(go.succeeded());
        this->idle(milliseconds(1'500));
        forget();
    }
    void forget() { first = second = {none, none}; }

    /// The word that a stop sends first.
    template <typename Declared = Device>
    std::uint16_t word_of(stop_by how = stop_by::ramp, stop_begin begin = stop_begin::at_once)
    {
        forget();
        rest = stop{station<Declared>{unit}, how, milliseconds(30'000), begin};
        REQUIRE(this->run(rest));
        return first.second;
    }
    /// One request of somebody who commands no motor.
    template <typename Request> void ask(Request const& request)
    {
        single_request told{unit, request};
        REQUIRE(this->run(told));
    }
    bool has_power() { return cia402::has_power(this->drive().state_machine().state()); }

    stop rest{station<Device>{unit}};
};

} // namespace

TEST_CASE("motion law: S41 who has not read what a drive's words mean lets it coast, and is told so")
{
    test::all_drives::for_each([]<typename Device>() {
        hall<Device> it;
        bool const is_old = Device::layout.cmd == 400;
        it.starts();
        it.link() = drive_client<4>{test::bus_timing, patient}; // one that has just begun
        CHECK(it.word_of(stop_by::ramp) == (is_old ? 7 : 0));
        CHECK(it.rest.succeeded());
        CHECK(it.rest.reason().is_other_stop == not is_old);
        CHECK_FALSE(it.has_power());
    });
}

TEST_CASE("motion law: S41 a start, a cycle and a check read it, and the stop behind them is the one asked for")
{
    test::all_drives::for_each([]<typename Device>() {
        for (auto const& [how, word] :
             {std::pair{stop_by::ramp, 7}, std::pair{stop_by::quick_stop, 2}, std::pair{stop_by::freewheel, 0}}) {
            hall<Device> it;
            it.starts();
            CHECK(it.word_of(how) == word);
            CHECK_FALSE(it.rest.reason().is_other_stop);
            CHECK(it.word_of(how) == word); // and again, at rest
        }
        hall<Device> checked;
        checked.starts();
        checked.link() = drive_client<4>{test::bus_timing, patient};
        check_supervision check{station<Device>{unit}};
        REQUIRE(checked.run(check));
        CHECK(checked.word_of() == 7);

        hall<Device> cycled;
        cyclic<Device> loop{station<Device>{unit}, {.period = milliseconds(50)}};
        cycled.run([&](instant now) { cycled.link().converse(loop, now); }, [] { return false; }, milliseconds(1'000));
        REQUIRE_FALSE(loop.link_lost());
        CHECK(cycled.word_of() == 7);
    });
}

TEST_CASE("motion law: S41 what was read holds until a request has no response, or the unit is lost")
{
    test::later_drives::for_each([]<typename Device>() {
        hall<Device> it;
        it.starts();
        it.ask(read_holding_registers{3201, 1}); // answered
        it.lost = 1;
        it.ask(read_holding_registers{3201, 1}); // tolerated, and the drive may have been without power
        CHECK(it.word_of() == 0);                // a read would take the missing response, should it come late
        it.starts();
        it.ask(read_holding_registers{3201, 1});
        it.lost = 1;
        it.ask(read_holding_registers{3201, 1});
        it.idle(milliseconds(1'500)); // it could not come any more
        CHECK(it.word_of() == 7);     // behind a look
        it.starts();
        it.lost = 2;
        it.ask(read_holding_registers{3201, 1});
        it.ask(read_holding_registers{3201, 1});
        CHECK(it.word_of() == 0);
        CHECK(it.rest.reason().is_other_stop);
        it.starts(); // and is read anew
        CHECK(it.word_of() == 7);
        it.lost = 1; // at rest one is enough: whatever answers there next
        it.ask(read_holding_registers{3201, 1});
        CHECK(it.word_of() == 0);
    });
}

TEST_CASE("motion law: S41 what was read holds until CHCF is written, by whatever function, and no other register")
{
    hall<atv320::device> it;
    auto const word_after = [&](auto const& request) {
        it.starts();
        it.ask(request);
        return it.word_of();
    };
    register_block<2> const two{2, 2};
    register_block<3> const three{10, 2, 2};
    CHECK(word_after(write_single_register{8401, 1}) == 0);
    CHECK(word_after(write_single_register{8400, 1}) == 7);
    CHECK(word_after(write_single_register{8402, 1}) == 7);
    CHECK(word_after(write_multiple_registers{8401, two}) == 0);
    CHECK(word_after(write_multiple_registers{8399, three}) == 0);
    CHECK(word_after(write_multiple_registers{8399, two}) == 7);
    CHECK(word_after(write_multiple_registers{8402, two}) == 7);
    CHECK(word_after(read_write_multiple_registers{3201, 1, 8400, two}) == 0);
    CHECK(word_after(read_write_multiple_registers{8401, 1, 8502, two}) == 7);
    CHECK(word_after(read_holding_registers{8401, 1}) == 7);

    it.starts();
    single_request everyone{broadcast, write_single_register{8401, 1}};
    REQUIRE(it.run(everyone));
    CHECK(it.word_of() == 0);
}

TEST_CASE("motion law: S41 a stop that looks first sends the word asked for, or 0000")
{
    test::later_drives::for_each([]<typename Device>() {
        for (auto const& [how, word] : {std::pair{stop_by::ramp, 7}, std::pair{stop_by::quick_stop, 2}}) {
            hall<Device> it;
            it.starts();
            it.link() = drive_client<4>{test::bus_timing, patient};
            CHECK(it.word_of(how, stop_begin::look_first) == word);
            CHECK_FALSE(it.rest.reason().is_other_stop);
        }
        hall<Device> silent;
        silent.starts();
        silent.link() = drive_client<4>{test::bus_timing, {.response_timeout = milliseconds(1'000), .retries = 2}};
        silent.lost = 1;
        instant const begin = silent.now();
        stop rest{station<Device>{unit}, stop_by::ramp, milliseconds(30'000), stop_begin::look_first};
        REQUIRE(silent.run([&](instant now) { silent.link().converse(rest, now); },
                           [&] { return silent.first.first != none; }, milliseconds(2'000)));
        CHECK(silent.first.second == 0);
        CHECK(silent.now() - begin < milliseconds(130)); // a look, and the frames' own time
    });
}

TEST_CASE("motion law: S41 a drive of the other family gets 0000 once where that has its words, then nothing")
{
    hall<atv28::device> old;
    old.starts();
    CHECK(old.word_of<atv320::device>() == 0);
    CHECK(old.first == std::pair<std::uint16_t, std::uint16_t>{8501, 0});
    CHECK(old.second == std::pair<std::uint16_t, std::uint16_t>{400, 0});
    CHECK(old.rest.reason().kind == outcome_kind::other_family);
    CHECK(old.rest.reason().error == errc::none); // it was taken
    CHECK(old.rest.reason().is_other_stop);
    CHECK_FALSE(old.has_power());
    CHECK(old.link().is_held(unit));

    hall<atv320::device> late;
    late.starts();
    CHECK(late.word_of<atv28::device>() == 7);
    CHECK(late.first == std::pair<std::uint16_t, std::uint16_t>{400, 7});
    CHECK(late.second == std::pair<std::uint16_t, std::uint16_t>{8501, 0});
    CHECK(late.rest.reason().kind == outcome_kind::other_family);
    CHECK_FALSE(late.has_power());
    CHECK(late.link().is_held(unit));
    late.idle(milliseconds(31'100));
    CHECK_FALSE(late.link().is_held(unit));
}

TEST_CASE("motion law: S41 everyone coasts where one that is ordered, and not named, was not read")
{
    hall<atv320::device> it;
    it.add(unit_id{4});
    it.starts();
    start go{station<atv320::device>{unit_id{4}}, 30_Hz};
    REQUIRE(it.run(go));
    it.forget();
    single_request told{unit_id{4}, write_single_register{8401, 1}};
    REQUIRE(it.run(told));
    broadcast_stop all{station<atv320::device>{unit}};
    REQUIRE(it.run(all));
    CHECK(it.first == std::pair<std::uint16_t, std::uint16_t>{8501, 0});
    CHECK(all.reason(0).is_other_stop);
    CHECK_FALSE(it.has_power());
}
