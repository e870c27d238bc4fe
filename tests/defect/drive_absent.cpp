// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive that was without power while nobody looked: what was read of it before counts no longer. An ATV320 comes back in its
// saved I/O profile, in which the words of most stops are RUN.
#include "defect/powered_drive.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

using test::quick;
using test::taken_over;
constexpr unit_id unit = test::powered_unit;
constexpr stop_by ways[]{stop_by::ramp, stop_by::quick_stop, stop_by::halt, stop_by::freewheel};

template <typename Device> using hall = test::powered_drive<Device>;

} // namespace

TEST_CASE("defect: no stop runs a drive that was switched off and on while nobody asked")
{
    for (stop_begin const begin : {stop_begin::at_once, stop_begin::look_first}) {
        for (stop_by const how : ways) {
            INFO(static_cast<int>(how) << (begin == stop_begin::at_once ? ", at once" : ", looks first"));
            taken_over it;
            it.idle(milliseconds(5'000));
            it.drive().power_cycle(it.now());
            it.idle(milliseconds(5'000));
            stop rest{it.drive_at, how, milliseconds(5'000), begin};
            it.finish(rest);
            it.idle(milliseconds(2'000));
            CHECK(it.fastest == 0);
            CHECK(it.drive().motor().frequency() == 0);
            CHECK(rest.succeeded());
        }
    }
}

TEST_CASE("defect: no stop of all units runs a drive that was switched off and on while nobody asked")
{
    taken_over it;
    it.idle(milliseconds(5'000));
    it.drive().power_cycle(it.now());
    it.idle(milliseconds(5'000));
    broadcast_stop all{it.drive_at};
    it.finish(all);
    CHECK(it.fastest == 0);
    REQUIRE_FALSE(it.requests_of_unit.empty());
    CHECK(it.requests_of_unit.front().word == 0);
}

TEST_CASE("defect: a stop of all units goes on as it began, however long its broadcasts take")
{
    hall<atv320::device> it{{.response_timeout = milliseconds(1'000), .retries = 2}};
    start go{it.drive_at, 30_Hz};
    it.finish(go);
    it.poll(milliseconds(3'000), milliseconds(300));
    broadcast_stop all{it.drive_at};
    it.finish(all);
    unsigned words = 0;
    for (auto const& each : it.requests_of_unit) {
        bool const is_word = each.function == 6;
        words += is_word ? 1U : 0U;
        CHECK((not is_word or words > 3 or each.word == 2));
    }
    CHECK(words >= 3);
}

TEST_CASE("defect: no stop runs a drive whose power cycle one request's repetitions have covered")
{
    for (stop_by const how : ways) {
        taken_over it{{.response_timeout = milliseconds(1'000), .retries = 2}};
        it.poll(milliseconds(2'000), milliseconds(200));
        it.drive().power_cycle(it.now());
        it.is_off = true;
        single_request look{unit, read_holding_registers{atv320::eta.address, 1}};
        it.pass(look, milliseconds(1'500));
        it.is_off = false;
        it.finish(look);
        REQUIRE(look.outcome());
        it.poll(milliseconds(1'000), milliseconds(200));
        stop rest{it.drive_at, how, milliseconds(5'000)};
        it.finish(rest);
        CHECK(it.fastest == 0);
        CHECK(rest.succeeded());
    }
}

TEST_CASE("defect: no repetition of a stop's word runs a drive that was switched off and on meanwhile")
{
    for (stop_by const how : ways) {
        taken_over it{{.response_timeout = milliseconds(1'000), .retries = 2}};
        it.poll(milliseconds(1'000), milliseconds(200));
        it.drive().power_cycle(it.now());
        it.is_off = true;
        stop rest{it.drive_at, how, milliseconds(8'000)};
        it.pass(rest, milliseconds(900));
        it.is_off = false;
        it.finish(rest);
        CHECK(it.fastest == 0);
        CHECK(rest.succeeded());
    }
}

TEST_CASE("defect: a stop of a motor that nobody has looked at for a while looks first, then sends its word")
{
    test::later_drives::for_each([]<typename Device>() {
        for (auto const& [how, word] : {std::pair{stop_by::ramp, 7}, std::pair{stop_by::quick_stop, 2}}) {
            hall<Device> it;
            start go{it.drive_at, 30_Hz};
            it.finish(go);
            REQUIRE(go.succeeded());
            it.idle(milliseconds(3'000));
            it.requests_of_unit.clear();
            stop rest{it.drive_at, how};
            it.finish(rest);
            CHECK(rest.succeeded());
            CHECK_FALSE(rest.reason().is_other_stop);
            REQUIRE(it.requests_of_unit.size() > 1);
            CHECK(it.requests_of_unit[0].function == 3);
            CHECK(it.requests_of_unit[0].address == 8401);
            CHECK(it.requests_of_unit[1].function == 6);
            CHECK(it.requests_of_unit[1].word == word);
        }
    });
}

TEST_CASE("defect: a stop of a motor that was looked at within half a second sends its word before all else")
{
    test::later_drives::for_each([]<typename Device>() {
        for (auto const& [how, word] : {std::pair{stop_by::ramp, 7}, std::pair{stop_by::quick_stop, 2}}) {
            hall<Device> it;
            start go{it.drive_at, 30_Hz};
            it.finish(go);
            it.poll(milliseconds(5'000), milliseconds(400));
            stop rest{it.drive_at, how};
            it.finish(rest);
            CHECK(rest.succeeded());
            CHECK_FALSE(rest.reason().is_other_stop);
            REQUIRE_FALSE(it.requests_of_unit.empty());
            CHECK(it.requests_of_unit[0].function == 6);
            CHECK(it.requests_of_unit[0].word == word);
        }
    });
}

TEST_CASE("defect: a stop whose look is not answered lets the motor coast after a tenth of a second")
{
    hall<atv320::device> it{{.response_timeout = milliseconds(1'000), .retries = 2}};
    start go{it.drive_at, 30_Hz};
    it.finish(go);
    it.idle(milliseconds(3'000));
    it.requests_of_unit.clear();
    it.is_off = true;
    stop rest{it.drive_at};
    instant const begin = it.now();
    while (it.requests_of_unit.size() < 2) {
        it.pass(rest, milliseconds(1));
    }
    CHECK(it.now() - begin < milliseconds(130)); // with the time of the frames
    CHECK(it.requests_of_unit[1].function == 6);
    CHECK(it.requests_of_unit[1].word == 0);
    it.is_off = false;
    it.finish(rest);
    CHECK(rest.succeeded());
    CHECK(rest.reason().is_other_stop);
}

TEST_CASE("defect: the stop of a cycle that is slower than half a second is the one ordered, behind a look")
{
    hall<atv320::device> it;
    cyclic<atv320::device> loop{it.drive_at, {.period = milliseconds(800)}};
    it.pass(loop, milliseconds(5'000));
    REQUIRE(loop.run(900_rpm));
    it.pass(loop, milliseconds(8'000));
    REQUIRE(loop.control().is_running());
    it.requests_of_unit.clear();
    loop.stop();
    it.pass(loop, milliseconds(300));
    REQUIRE(it.requests_of_unit.size() > 1);
    CHECK(it.requests_of_unit[0].address == 8401);
    CHECK(it.requests_of_unit[1].function == 6);
    CHECK(it.requests_of_unit[1].word == 7);
    it.pass(loop, milliseconds(5'000));
    CHECK_FALSE(cia402::has_power(it.drive().state_machine().state()));
}

TEST_CASE("defect: a cycle writes nothing to a drive whose power cycle a tolerated miss has covered")
{
    constexpr std::uint16_t outputs = atv320::device::scanner.output_addresses;
    for (duration const off : {milliseconds(150), milliseconds(400), milliseconds(900)}) {
        hall<atv320::device> it{{.response_timeout = milliseconds(500), .retries = 0}};
        // Saved is another program's map: the first word would be ACC, the second the control word.
        it.set(outputs, atv320::acc.address);
        it.set(outputs + 1, atv320::cmd.address);
        it.save();
        it.set(outputs, atv320::cmd.address);
        it.set(outputs + 1, atv320::lfrd.address);
        cyclic<atv320::device> loop{it.drive_at};
        it.pass(loop, milliseconds(3'000));
        REQUIRE(loop.run(900_rpm));
        it.pass(loop, milliseconds(4'000));
        REQUIRE(loop.control().is_running());
        it.drive().power_cycle(it.now());
        int const acceleration = it.drive().word("ACC");
        it.is_off = true;
        it.pass(loop, off);
        it.is_off = false;
        it.pass(loop, milliseconds(5'000));
        CHECK(it.drive().word("ACC") == acceleration);
        CHECK_FALSE(loop.control().is_ordered());
        CHECK_FALSE(cia402::has_power(it.drive().state_machine().state()));
    }
}

TEST_CASE("defect: a cycle whose drive kept its power goes on behind a tolerated miss, with two reads")
{
    hall<atv320::device> it;
    cyclic<atv320::device> loop{it.drive_at};
    it.pass(loop, milliseconds(3'000));
    REQUIRE(loop.run(900_rpm));
    it.pass(loop, milliseconds(4'000));
    std::uint16_t const word = it.drive().word("CMD");
    it.is_off = true;
    it.pass(loop, milliseconds(120)); // one exchange
    it.requests_of_unit.clear();
    it.is_off = false;
    it.pass(loop, milliseconds(1'000));
    CHECK(loop.control().is_running());
    CHECK(loop.control().is_ordered());
    CHECK_FALSE(loop.link_lost());
    CHECK(it.drive().word("CMD") == word);
    REQUIRE(it.requests_of_unit.size() >= 2);
    CHECK(it.requests_of_unit[0].address == atv320::eta.address);
    CHECK(it.requests_of_unit[1].address == atv320::lft.address);
    for (auto const& each : it.requests_of_unit) {
        CHECK(each.address != atv320::chcf.address); // not checked anew
    }
}
