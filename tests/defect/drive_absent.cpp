// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive that was without power while nobody looked: what was read of it before counts no longer. An ATV320 comes back in its
// saved I/O profile, in which the words of most stops are RUN.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>
#include <vector>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr unit_id unit{3};
constexpr client_options quick{.response_timeout = milliseconds(100), .retries = 0};
constexpr stop_by ways[]{stop_by::ramp, stop_by::quick_stop, stop_by::halt, stop_by::freewheel};

/// A client and a drive of which all requests are kept.
template <typename Device> struct hall : test::simulated_bus<drive_client<4>, Device> {
    static constexpr station<Device> drive_at{unit};

    struct written {
        std::uint8_t function;
        std::uint16_t address;
        std::uint16_t word;
    };
    std::vector<written> requests_of_unit{};
    bool is_off{false};
    int fastest{0};

    explicit hall(client_options const& options = quick)
        : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, options}}
    {
        this->add(unit);
        this->idle(milliseconds(20));
        this->disturb([this](test::frame_bytes& frame, bool is_request) {
            if (is_request and frame.size() == 8) {
                requests_of_unit.push_back({to_u8(frame[1]), u16_at(byte_view{frame}, 2), u16_at(byte_view{frame}, 4)});
            }
            if (is_off) {
                frame.clear();
            }
        });
    }

    void set(std::uint16_t address, std::uint16_t word)
    {
        register_block<1> const one{word};
        REQUIRE(this->drive().write(address, one) == errc::none);
    }
    void save()
    {
        set(Device::layout.cmi, 2);
        this->idle(milliseconds(500));
        set(Device::layout.cmi, 0);
    }

    template <typename Conversation> void pass(Conversation& whom, duration length)
    {
        instant const end = this->now() + length;
        while (not reached(this->now(), end)) {
            this->step(
                [&](instant now) {
                    if (not whom.settled()) {
                        this->link().converse(whom, now);
                    }
                },
                milliseconds(5));
            int const now = this->drive().motor().frequency();
            fastest = fastest < now ? now : fastest;
        }
    }
    template <typename Conversation> void finish(Conversation& whom)
    {
        for (int i = 0; i < 4'000 and not whom.settled(); ++i) {
            pass(whom, milliseconds(10));
        }
        REQUIRE(whom.settled());
    }

    /// Reads the status once, and keeps it from then on for some time.
    void poll(duration length, duration every)
    {
        instant const end = this->now() + length;
        while (not reached(this->now(), end)) {
            single_request look{unit, read_holding_registers{Device::layout.eta, 1}};
            REQUIRE(this->run(look));
            this->idle(every);
        }
        requests_of_unit.clear();
    }
};

/// A drive that was saved in its I/O profile, with a reference of 30 Hz at its terminals; this client has taken it over, and
/// has read that. Nothing of that is saved.
struct taken_over : hall<atv320::device> {
    explicit taken_over(client_options const& options = quick) : hall<atv320::device>{options}
    {
        set(atv320::chcf.address, 3);
        set(atv320::cd1.address, 10);
        set(atv320::fr1.address, 1);
        save();
        drive().set_analog_reference(30'000);
        set_channel take{drive_at, channel_settings<atv320::device>::by_modbus()};
        finish(take);
        REQUIRE(take.succeeded());
        check_supervision check{drive_at};
        finish(check);
        REQUIRE(check.ready());
        requests_of_unit.clear();
        fastest = 0;
    }
};

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
