// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A stop against a bad line and a drive that refuses: what counts is whether the motor comes to rest.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/single_request.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using state = cia402::state;
using bytes = std::vector<std::byte>;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr duration half_a_minute = milliseconds(30'000);

/// A client and a drive that runs at 50 Hz.
template <typename Device> struct running : test::simulated_bus<drive_client<4>, Device> {
    static constexpr station<Device> drive{unit_id{3}};

    running() : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
        start go{drive, 50_Hz};
        REQUIRE(this->run(go));
        REQUIRE(go.succeeded());
        this->idle(milliseconds(5'000));
        REQUIRE(far().motor().frequency() == 50'000);
        check_supervision look{drive}; // what its words mean is known now
        REQUIRE(this->run(look));
        REQUIRE(look.ready());
    }

    detail::simulated_drive<Device>& far() { return this->unit(0).drive(); }
    bool has_power() { return cia402::has_power(far().state_machine().state()); }
    bool stands() { return far().state_machine().state() == state::switch_on_disabled; }
};

/// Whether a frame is a request that writes the control word.
template <typename Device> bool writes_control(bytes const& frame)
{
    return frame.size() == 8 and frame[1] == std::byte{6} and u16_at(byte_view{frame}, 2) == Device::layout.cmd;
}

/// A response that becomes an exception, its CRC with it.
void refuse(bytes& frame, std::uint8_t code)
{
    frame = {frame[0], frame[1] | std::byte{0x80}, std::byte{code}};
    std::uint16_t const crc = crc16(frame);
    frame.push_back(to_byte(crc));
    frame.push_back(to_byte(crc >> 8U));
}

} // namespace

TEST_CASE("motion law: S7 two frames lost at the beginning of a stop: the motor stops all the same")
{
    test::all_drives::for_each([]<typename Device>() {
        running<Device> it;
        unsigned lost = 0;
        it.disturb([&](bytes& frame, bool is_request) {
            if (is_request and lost < 2) {
                ++lost;
                frame.clear();
            }
        });
        stop rest{it.drive};
        REQUIRE(it.run(rest));
        CHECK(lost == 2);
        CHECK(rest.succeeded());
        CHECK(it.stands());
    });
}

TEST_CASE("motion law: S7 all answers lost: the stop's word goes again and again, and it says that nobody confirmed it")
{
    test::all_drives::for_each([]<typename Device>() {
        running<Device> it;
        unsigned words = 0;
        it.disturb([&](bytes& frame, bool is_request) {
            words += is_request and writes_control<Device>(frame) ? 1U : 0U;
            if (not is_request) {
                frame.clear();
            }
        });
        stop rest{it.drive, stop_by::ramp, milliseconds(20'000)};
        REQUIRE(it.run(rest));
        CHECK(rest.reason().kind == outcome_kind::silent);
        CHECK(rest.reason().error == errc::timed_out);
        CHECK(words > 10);
        CHECK_FALSE(it.far().motor().frequency() != 0);
    });
}

TEST_CASE("motion law: S8 a drive that answers 04, 05 or 06 for a while is told to stop until it does")
{
    for (std::uint8_t const code : {std::uint8_t{4}, std::uint8_t{5}, std::uint8_t{6}}) {
        test::all_drives::for_each([&]<typename Device>() {
            running<Device> it;
            instant const end = it.now() + milliseconds(600);
            it.disturb([&](bytes& frame, bool is_request) {
                if (not is_request and not reached(it.now(), end)) {
                    refuse(frame, code);
                }
            });
            stop rest{it.drive};
            REQUIRE(it.run(rest));
            CHECK(rest.succeeded());
            CHECK(it.stands());
        });
    }
}

TEST_CASE("motion law: S7 the word leaves before anything is read; only halt looks first")
{
    test::all_drives::for_each([]<typename Device>() {
        for (stop_by const mode : {stop_by::ramp, stop_by::freewheel, stop_by::quick_stop}) {
            running<Device> it;
            bytes first;
            it.disturb([&](bytes& frame, bool) { first = first.empty() ? frame : first; });
            stop rest{it.drive, mode};
            REQUIRE(it.run(rest));
            CHECK(writes_control<Device>(first));
            std::uint16_t const word = u16_at(byte_view{first}, 4);
            CHECK(word == (mode == stop_by::ramp ? 7 : mode == stop_by::freewheel ? 0 : 2)); // CHCF has just been read
            CHECK_FALSE(rest.reason().is_other_stop);
            CHECK(rest.succeeded());
            CHECK(it.stands());
        }
    });
}

TEST_CASE("motion law: S18 after each stop the drive is where no stray word can start it")
{
    test::all_drives::for_each([]<typename Device>() {
        for (stop_by const mode : {stop_by::ramp, stop_by::freewheel, stop_by::quick_stop}) {
            running<Device> it;
            stop rest{it.drive, mode};
            REQUIRE(it.run(rest));
            REQUIRE(rest.succeeded());
            CHECK_FALSE(rest.reason().is_other_stop);
            single_request stray{it.drive.unit(), write_single_register{Device::layout.cmd, 0x000F}};
            REQUIRE(it.run(stray));
            it.idle(milliseconds(1'000));
            CHECK_FALSE(it.has_power());
        }
    });
}

TEST_CASE("motion law: S18 a start that is withdrawn leaves a drive that no stray word can start")
{
    test::all_drives::for_each([]<typename Device>() {
        running<Device> it;
        stop rest{it.drive};
        REQUIRE(it.run(rest));
        start go{it.drive, 50_Hz};
        bool was_local = false;
        while (not go.settled()) {
            it.step([&](instant now) { it.link().converse(go, now); }, milliseconds(5));
            if (not was_local and it.far().state_machine().state() == state::switched_on) {
                was_local = true;
                it.far().press_stop();
            }
        }
        CHECK(was_local);
        CHECK_FALSE(go.succeeded());
        single_request stray{it.drive.unit(), write_single_register{Device::layout.cmd, 0x000F}};
        REQUIRE(it.run(stray));
        it.idle(milliseconds(1'000));
        CHECK_FALSE(it.has_power());
    });
}

TEST_CASE("motion law: S34 a stop that is taken and not obeyed says so")
{
    test::all_drives::for_each([]<typename Device>() {
        running<Device> it;
        it.disturb([&](bytes& frame, bool is_request) {
            // A drive that takes its commands from elsewhere: the word arrives as another register's.
            if (is_request and writes_control<Device>(frame)) {
                frame = {frame[0],     std::byte{6},   to_byte(Device::layout.cmd >> 8U), to_byte(Device::layout.cmd),
                         std::byte{0}, std::byte{0x0F}};
                std::uint16_t const crc = crc16(frame);
                frame.push_back(to_byte(crc));
                frame.push_back(to_byte(crc >> 8U));
            } else if (not is_request and frame[1] == std::byte{6}) {
                frame = {frame[0],     std::byte{6},   to_byte(Device::layout.cmd >> 8U), to_byte(Device::layout.cmd),
                         std::byte{0}, std::byte{0x07}};
                std::uint16_t const crc = crc16(frame);
                frame.push_back(to_byte(crc));
                frame.push_back(to_byte(crc >> 8U));
            }
        });
        stop rest{it.drive, stop_by::ramp, milliseconds(3'000)};
        REQUIRE(it.run(rest));
        CHECK(rest.reason().kind == outcome_kind::state_timeout);
        CHECK(rest.reason().state == state::operation_enabled);
    });
}

TEST_CASE("motion law: L3 a halt of a drive whose profile is not known leaves no bit that may be RUN")
{
    using device = atv320::device;
    constexpr std::uint16_t by_io = 3;
    running<device> it;
    stop first{it.drive};
    REQUIRE(it.run(first));
    for (auto const& [address, word] :
         {std::pair{atv320::chcf.address, by_io}, std::pair{atv320::lfr.address, std::uint16_t{300}},
          std::pair{device::layout.cmd, std::uint16_t{1}}, std::pair{atv320::lfr.address, std::uint16_t{300}}}) {
        single_request told{it.drive.unit(), write_single_register{address, word}};
        REQUIRE(it.run(told));
        REQUIRE(told.outcome());
    }
    it.idle(milliseconds(3'000));
    REQUIRE(it.far().motor().frequency() != 0);

    stop rest{it.drive, stop_by::halt};
    REQUIRE(it.run(rest));
    CHECK(rest.reason().kind == outcome_kind::unconfirmed); // there the status word stays at "switched on"
    CHECK(rest.reason().is_other_stop);
    CHECK(it.far().word("CMD") == 0);
    CHECK_FALSE(it.has_power());
}

TEST_CASE("motion law: L4 a stop that the drive does not have stops by its ramp, at any moment of a start")
{
    test::all_drives::for_each([]<typename Device>() {
        for (auto const way : {stop_by::halt, stop_by::dc_injection}) {
            bool const has_it = way == stop_by::halt ? Device::layout.halt != 0 : Device::layout.dc_injection != 0;
            for (std::uint32_t begins = 0; begins < 600 and not has_it; begins += 20) {
                running<Device> it;
                stop rest{it.drive};
                REQUIRE(it.run(rest));
                start go{it.drive, 30_Hz};
                it.run([&](instant now) { it.link().converse(go, now); }, [] { return false; }, milliseconds(begins));
                stop again{it.drive, way};
                bool const is_over = it.run(
                    [&](instant now) {
                        it.link().converse(again, now);
                        it.link().converse(go, now);
                    },
                    [&] { return again.settled(); }, half_a_minute);
                CHECK((is_over and again.succeeded() and again.reason().is_other_stop));
                CHECK_FALSE((it.has_power() or go.running()));
            }
        }
    });
}

TEST_CASE("motion law: S10 a halt rests in operation, and becomes the ramp where it cannot look")
{
    test::all_drives::for_each([]<typename Device>() {
        running<Device> it;
        unsigned lost = 0;
        it.disturb([&](bytes& frame, bool is_request) {
            if (is_request and frame[1] == std::byte{3} and lost < 4) {
                ++lost;
                frame.clear();
            }
        });
        stop rest{it.drive, stop_by::halt};
        REQUIRE(it.run(rest));
        CHECK(rest.reason().kind == outcome_kind::succeeded);
        CHECK(rest.reason().is_other_stop);
        CHECK_FALSE(it.has_power());
    });
}
