// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A scanner that somebody changes beside a cycle: no word reaches a register that it is not meant for, and no word is
// taken for a status that is none.
#include "support/catch.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>
#include <vector>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using state = cia402::state;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr std::uint16_t nma1 = 12'701, nca1 = 12'721, acc_address = 9'001;

/// A bus, a drive, and a cycle of it.
template <typename Device> struct bench : test::simulated_bus<bus<3>, Device> {
    static constexpr station<Device> drive{unit_id{3}};
    cyclic<Device> loop{drive, {.period = milliseconds(100)}};

    bench() : test::simulated_bus<bus<3>, Device>{bus<3>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
        pass(milliseconds(1'000));
    }
    detail::simulated_drive<Device>& far() { return this->unit(0).drive(); }
    void pass(duration length)
    {
        this->run([&](instant now) { this->link().converse(0, loop, now); }, [] { return false; }, length);
    }
    /// Another master writes, past this bus.
    void write(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        REQUIRE(far().check_write(address, value) == errc::none);
        static_cast<void>(far().write(address, value));
    }
};

} // namespace

TEST_CASE("motion law: S23 a cycle beside a scanner's configuration writes nothing where it did not look")
{
    bench<atv320::device> it;
    REQUIRE_FALSE(it.loop.link_lost());
    std::uint16_t const acc = it.far().word("ACC");
    // CMD and the reference have other places from now on.
    using other = configure_scanner<scanner_inputs<atv320::lft, atv320::eta>,
                                    scanner_outputs<atv320::lfrd, atv320::acc, atv320::cmd>>;
    other change{it.drive};
    bool is_clean = true;
    it.run(
        [&](instant now) {
            it.link().converse(0, it.loop, now);
            it.link().converse(1, change, now);
            it.loop.run(1'500_rpm); // whenever it may
            std::uint16_t const command = it.far().word("CMD");
            bool const is_command = command == 0 or command == 6 or command == 7 or command == 15;
            is_clean = is_clean and it.far().word("ACC") == acc and is_command;
        },
        [&] { return change.settled(); }, milliseconds(10'000));
    it.pass(milliseconds(5'000));
    CHECK(is_clean);
    CHECK(it.far().word("ACC") == acc);
    CHECK(it.loop.control().reason().kind == outcome_kind::misconfigured);
    CHECK_FALSE(it.loop.run(1'500_rpm));
    CHECK_FALSE(cia402::has_power(it.far().state_machine().state()));
}

TEST_CASE("motion law: S23 a scanner whose first word is no status any more orders nothing")
{
    // What another master may have put there: LFRD reads 0, ACC and HSP have the bits of no state.
    for (std::uint16_t const shown : {std::uint16_t{8'602}, acc_address, std::uint16_t{3'104}}) {
        INFO(shown);
        bench<atv12::device> it;
        REQUIRE(it.loop.run(1'500_rpm)); // at the same moment
        it.write(nma1, shown);
        bool had_power = false;
        for (unsigned moment = 0; moment < 500; ++moment) {
            it.pass(milliseconds(10));
            had_power = had_power or cia402::has_power(it.far().state_machine().state());
        }
        CHECK_FALSE(had_power);
        CHECK_FALSE(it.loop.control().is_ordered());
        CHECK_FALSE(it.loop.run(1'500_rpm));
        CHECK(it.loop.control().reason().kind == outcome_kind::misconfigured);
        CHECK(it.loop.link_lost());
        // It is put right, and looked at anew.
        it.write(nma1, 3'201);
        it.pass(milliseconds(2'000));
        CHECK_FALSE(it.loop.link_lost());
        CHECK(it.loop.run(1'500_rpm));
        it.pass(milliseconds(2'000));
        CHECK(it.far().state_machine().state() == state::operation_enabled);
    }
}

TEST_CASE("motion law: S23 a command that went elsewhere enables nothing")
{
    // Another master moved only the first output: nothing that the cycle reads shows it.
    bench<atv320::device> it;
    it.write(nca1, acc_address);
    REQUIRE(it.loop.run(1'500_rpm));
    bool had_power = false;
    for (unsigned moment = 0; moment < 500; ++moment) {
        it.pass(milliseconds(10));
        had_power = had_power or cia402::has_power(it.far().state_machine().state());
    }
    CHECK_FALSE(had_power);
    CHECK_FALSE(it.loop.control().is_ordered());
}
