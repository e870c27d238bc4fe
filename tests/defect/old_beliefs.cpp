// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What was read or written once, and is not so any more when a word relies on it, or when "done" is said of it.
#include "defect/powered_drive.hpp"
#include "support/catch.hpp"
#include "support/drives.hpp"

#include <cstdint>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/change_reference.hpp>
#include <rtuwire/altivar/procedure/motion/direct_control.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(200), .retries = 2};

/// A drive whose supervision is on, but not in what it has saved.
struct unsaved : test::powered_drive<atv320::device> {
    unsigned cut_at{0}; ///< the request at which it loses its power: that one is not answered
    unsigned count{0};

    explicit unsaved(client_options const& options) : test::powered_drive<atv320::device>{options}
    {
        set(atv320::sll.address, 0);
        save();
        set(atv320::sll.address, 1);
        disturb([this](test::frame_bytes& frame, bool is_request) {
            count += is_request ? 1U : 0U;
            if (is_request and count == cut_at) {
                drive().power_cycle(now());
                frame.clear();
            }
        });
    }
    bool has_power() { return cia402::has_power(drive().state_machine().state()); }
};

/// An order whose program sleeps between its read of the control word and the command to run, while another master writes.
template <typename Device, typename Order> void sleeps_before_the_command(Order go, bool was_running)
{
    test::powered_drive<Device> it;
    if (was_running) {
        start first{it.drive_at, 10_Hz};
        it.finish(first);
        REQUIRE(first.running());
    }
    bool is_read = false;
    it.disturb([&](test::frame_bytes& frame, bool is_request) {
        std::uint8_t const function = to_u8(frame[1]);
        is_read = is_read or (is_request and function == 3 and u16_at(byte_view{frame}, 2) == Device::layout.cmd);
    });
    bool is_asleep = false;
    for (int i = 0; i < 2'000 and not is_asleep; ++i) {
        it.step(
            [&](instant now) {
                if (not is_asleep) {
                    it.link().converse(go, now);
                }
                is_asleep = is_read and go.intent() == effect::enabling and it.request()[1] == std::byte{3} and
                            u16_at(it.request(), 2) == Device::layout.cmd;
            },
            milliseconds(1));
    }
    REQUIRE(is_asleep);
    it.idle(milliseconds(600));
    it.set(Device::layout.cmd, 6);
    it.finish(go);
    CHECK_FALSE(go.running());
    it.idle(milliseconds(1'000));
    CHECK_FALSE(cia402::has_power(it.drive().state_machine().state()));
}

} // namespace

TEST_CASE("defect: no check is whole whose drive has lost its power behind one of its reads")
{
    for (client_options const& options : {test::quick, patient}) {
        for (unsigned at = 1; at < 14; ++at) {
            INFO("at request " << at);
            unsaved it{options};
            it.cut_at = at;
            check_supervision check{it.drive_at};
            it.finish(check);
            CHECK((it.count < at or not check.ready()));
        }
    }
}

TEST_CASE("defect: no start runs a drive whose unsaved supervision was lost behind one of its requests")
{
    for (client_options const& options : {test::quick, patient}) {
        unsigned checked = 0;
        for (unsigned at = 2; at < 26; ++at) {
            INFO("at request " << at);
            unsaved it{options};
            it.cut_at = at;
            start go{it.drive_at, 30_Hz};
            it.finish(go);
            if (it.count < at) {
                break;
            }
            CHECK_FALSE(it.has_power());
            CHECK_FALSE(go.running());
            ++checked;
        }
        CHECK(checked > 15);
    }
}

TEST_CASE("defect: no cycle runs a drive whose unsaved supervision was lost behind one of its requests")
{
    for (unsigned at = 2; at < 40; ++at) {
        INFO("at request " << at);
        unsaved it{test::quick};
        it.cut_at = at;
        cyclic<atv320::device> loop{it.drive_at};
        it.pass(loop, milliseconds(1'200));
        static_cast<void>(loop.run(900_rpm));
        it.pass(loop, milliseconds(3'000));
        CHECK_FALSE(it.has_power());
        CHECK_FALSE(loop.control().is_ordered());
    }
}

TEST_CASE("defect: a start that has run does not run once its drive's time-out has passed without a request")
{
    test::all_drives::for_each([]<typename Device>() {
        test::powered_drive<Device> it;
        start go{it.drive_at, 30_Hz};
        it.finish(go);
        REQUIRE(go.running());
        it.idle(milliseconds(5'000));
        CHECK(go.running());
        it.idle(milliseconds(5'500));
        CHECK_FALSE(go.running());
        CHECK_FALSE(cia402::has_power(it.drive().state_machine().state()));
    });
}

TEST_CASE("defect: a start of a running motor whose reference is not answered goes on, or stops the motor")
{
    test::all_drives::for_each([]<typename Device>() {
        for (unsigned const most : {1U, 1'000U}) { // responses that are lost
            INFO(most << " responses");
            test::powered_drive<Device> it;
            start first{it.drive_at, 10_Hz};
            it.finish(first);
            REQUIRE(first.running());
            start go{it.drive_at, 40_Hz};
            bool is_cut = false;
            unsigned lost = 0;
            it.disturb([&](test::frame_bytes& frame, bool is_request) {
                is_cut = is_cut or (is_request and frame.size() == 8 and frame[1] == std::byte{6} and
                                    u16_at(byte_view{frame}, 2) == Device::frequency_reference.address);
                if (is_cut and not is_request and lost < most) {
                    ++lost;
                    frame.clear();
                }
            });
            it.pass(go, milliseconds(6'000));
            CHECK(is_cut);
            CHECK(go.running() == (most == 1));
            CHECK(it.drive().motor().frequency() == (most == 1 ? 40'000 : 0));
        }
    });
}

TEST_CASE("defect: no change of a reference is done where another one was written since")
{
    test::all_drives::for_each([]<typename Device>() {
        unsigned overwritten = 0;
        for (std::uint32_t after_ms = 0; after_ms < 3'000; after_ms += 30) {
            INFO("another reference after " << after_ms << " ms");
            test::powered_drive<Device> it;
            start go{it.drive_at, 20_Hz};
            it.finish(go);
            it.poll(milliseconds(2'000), milliseconds(300));
            change_reference to{it.drive_at, 40_Hz};
            it.pass(to, milliseconds(after_ms));
            if (to.settled()) {
                break;
            }
            single_request other{test::powered_unit, write_single_register{Device::frequency_reference.address, 250}};
            it.run(
                [&](instant now) {
                    it.link().converse(to, now);
                    it.link().converse(other, now);
                },
                [&] { return other.settled(); }, milliseconds(1'000));
            while (not to.settled()) {
                it.pass(to, milliseconds(10));
            }
            bool const is_done = to.succeeded();
            it.idle(milliseconds(4'000));
            if (is_done) {
                CHECK(it.drive().motor().frequency() == 40'000);
            } else {
                ++overwritten;
            }
        }
        CHECK(overwritten > 5);
    });
}

TEST_CASE("defect: the control word is read again where it was read too long before the command to run")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const was_running : {false, true}) {
            sleeps_before_the_command<Device>(start{station<Device>{test::powered_unit}, 30_Hz}, was_running);
        }
    });
    sleeps_before_the_command<atv28::device>(atv28::direct_start{station<atv28::device>{test::powered_unit}, 30_Hz},
                                             false);
}
