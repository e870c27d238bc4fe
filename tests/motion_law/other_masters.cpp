// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive that somebody else commands, that loses its power, or that shares its address with another one.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/one_in.hpp"
#include "support/simulated_bus.hpp"

#include <vector>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

template <typename Device> struct cycling : test::simulated_bus<drive_client<2>, Device> {
    using base = test::simulated_bus<drive_client<2>, Device>;
    cyclic<Device> loop{*station<Device>::checked(3), {.period = milliseconds(50)}};

    cycling() : base{drive_client<2>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
    }
    void pass(duration length)
    {
        this->base::run([&](instant at) { this->link().converse(loop, at); }, [] { return false; }, length);
    }
    detail::simulated_drive<Device>& far() { return this->base::drive(0); }
    state now_in() { return far().state_machine().state(); }
    bool order()
    {
        if constexpr (cycle_layout<Device>::has_scanner) {
            return loop.run(1'200_rpm);
        } else {
            return loop.run(40_Hz);
        }
    }
    /// As another master writes it, on a line of its own.
    void write_as_another(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        REQUIRE(far().check_write(address, value) == errc::none);
        REQUIRE(far().write(address, value) == errc::none);
    }
};

} // namespace

TEST_CASE("motion law: S21 a cycle reports another master's reference and command, and gives up its order")
{
    test::all_drives::for_each([]<typename Device>() {
        for (bool const is_reference : {true, false}) {
            INFO("the reference: " << is_reference);
            unsigned reported = 0;
            constexpr unsigned tries = 8;
            for (unsigned i = 0; i < tries; ++i) {
                cycling<Device> it;
                it.pass(milliseconds(600));
                REQUIRE(it.order());
                it.pass(milliseconds(5'000));
                REQUIRE(it.loop.control().is_running());
                // Another one writes in every pass of its own, faster than this cycle.
                for (unsigned moment = 0; moment < 400; ++moment) {
                    if (it.now_in() == state::operation_enabled) {
                        is_reference ? it.write_as_another(Device::frequency_reference.address, 100)
                                     : it.write_as_another(Device::layout.cmd, 0x080F);
                    }
                    it.pass(milliseconds(7 + i % 3));
                }
                reported += it.loop.control().reason().kind == outcome_kind::overwritten ? 1U : 0U;
                CHECK_FALSE(it.loop.control().is_ordered());
            }
            CHECK(reported == tries);
        }
    });
}

TEST_CASE("motion law: S22 a drive that loses its power at any moment of a climb does not run afterwards")
{
    test::all_drives::for_each([]<typename Device>() {
        unsigned before_running = 0;
        for (std::uint32_t after_ms = 0; after_ms < 400; after_ms += 3 * test::one_in(7)) {
            for (std::uint32_t const off_ms : {0U, 20U, 120U, 700U}) {
                INFO("after " << after_ms << " ms for " << off_ms << " ms");
                cycling<Device> it;
                it.pass(milliseconds(1'000));
                REQUIRE(it.order());
                it.pass(milliseconds(after_ms));
                bool const ran = it.now_in() == state::operation_enabled;
                bool const was_asked_to_run = it.now_in() == state::switched_on;
                it.far().power_cycle(it.now());
                it.cut(0, true);
                it.pass(milliseconds(off_ms));
                it.cut(0, false);
                it.pass(milliseconds(6'000));
                before_running += ran ? 0U : 1U;
                // Where the power came back before the drive had been told anything but "shut down", the order may still
                // stand: each word since was read back.
                bool const may_stand = not ran and not was_asked_to_run and off_ms <= 120;
                CHECK((it.now_in() != state::operation_enabled or may_stand));
                CHECK((it.now_in() != state::operation_enabled or it.loop.control().is_ordered()));
            }
        }
        CHECK(before_running > 10 / test::one_in(7));
    });
}

TEST_CASE("motion law: S30 a halted drive whose link is lost and comes back stays where it is, and only an order "
          "clears the halt")
{
    cycling<atv320::device> it;
    it.pass(milliseconds(600));
    REQUIRE(it.order());
    it.pass(milliseconds(4'000));
    it.loop.stop(stop_by::halt);
    it.pass(milliseconds(8'000));
    REQUIRE(it.far().motor().is_at_rest());
    REQUIRE(it.now_in() == state::operation_enabled);
    for (std::uint32_t const off_ms : {300U, 3'000U, 40'000U}) {
        INFO("for " << off_ms << " ms");
        it.cut(0, true);
        it.pass(milliseconds(off_ms));
        it.cut(0, false);
        it.pass(milliseconds(45'000));
        CHECK(it.far().motor().is_at_rest());
        CHECK(it.far().motor().frequency() == 0);
    }
}

TEST_CASE("motion law: S35 of two drives at one address one stops: the stop does not say that both do")
{
    // Both answer at once, and collide; what arrives is damaged, so that nothing is confirmed.
    test::simulated_bus<drive_client<2>, atv320::device> it{drive_client<2>{test::bus_timing, patient}};
    it.add(unit_id{3});
    it.idle(milliseconds(20));
    start go{station<atv320::device>{unit_id{3}}, 40_Hz};
    REQUIRE(it.run(go));
    it.disturb([](auto& frame, bool is_request) {
        if (not is_request and frame.size() > 2) {
            frame[2] ^= std::byte{0x5A};
        }
    });
    stop rest{station<atv320::device>{unit_id{3}}, stop_by::ramp, milliseconds(5'000)};
    it.run(rest, milliseconds(60'000));
    REQUIRE(rest.settled());
    CHECK_FALSE(rest.succeeded());
    CHECK((rest.reason().kind == outcome_kind::silent or rest.reason().kind == outcome_kind::unconfirmed));
    CHECK(it.drive(0).state_machine().state() != state::operation_enabled); // the word itself arrived
}
