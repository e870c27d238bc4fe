// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Factory settings over the line: what they take away, and what the conversation claims.
#include "support/catch.hpp"
#include "support/drives.hpp"
#include "support/simulated_bus.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};

template <typename Device> struct pair : test::simulated_bus<drive_client<4>, Device> {
    static constexpr station<Device> drive{unit_id{7}};

    pair() : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, patient}}
    {
        this->add(unit_id{7});
        this->idle(milliseconds(20));
    }
    detail::simulated_drive<Device>& far() { return this->test::simulated_bus<drive_client<4>, Device>::drive(0); }
    outcome_kind end_of(auto conversation)
    {
        CHECK(this->run(conversation));
        return conversation.reason().kind;
    }
    void tell(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        REQUIRE(far().check_write(address, value) == errc::none);
        static_cast<void>(far().write(address, value));
    }
};

constexpr losing_control_and_address knowingly{};
constexpr terminal_options unseen{.accept_unseen_inputs = true};

template <typename Device> void is_delivered_again()
{
    pair<Device> it;
    it.tell(Device::registers::template contains<atv28::acc> ? 252 : 9001, 99);
    REQUIRE(it.far().word("ACC") == 99);
    if (Device::layout.safeguards.inputs == 0) {
        CHECK(it.end_of(restore_factory_settings{it.drive, knowingly}) == outcome_kind::unknown_register);
        REQUIRE(it.far().word("ACC") == 99);
    }
    CHECK(it.end_of(restore_factory_settings{it.drive, knowingly, unseen}) == outcome_kind::executed_unconfirmed);
    CHECK(it.far().word("ACC") == 30);
    CHECK(it.far().eeprom_writes() == 0);
}

} // namespace

TEST_CASE("factory settings are executed, and never said to be confirmed")
{
    test::all_drives::for_each([]<typename Device>() { is_delivered_again<Device>(); });
}

TEST_CASE("a later drive has no address afterwards, and terminals in command")
{
    pair<atv320::device> it;
    CHECK(it.end_of(restore_factory_settings{it.drive, knowingly}) == outcome_kind::executed_unconfirmed);
    CHECK(it.far().word("ADD") == 0);
    CHECK(it.far().word("FR1") == 1);
    CHECK(it.end_of(start{it.drive, 20_Hz}) == outcome_kind::silent);
}

TEST_CASE("factory settings are not ordered of a drive that runs, nor where nobody answers")
{
    pair<atv320::device> it;
    CHECK(it.end_of(start{it.drive, 20_Hz}) == outcome_kind::succeeded);
    CHECK(it.end_of(restore_factory_settings{it.drive, knowingly}) == outcome_kind::refused_while_running);
    CHECK(it.far().word("FR1") == 164);
    it.cut(0, true);
    CHECK(it.end_of(restore_factory_settings{it.drive, knowingly}) == outcome_kind::silent);
}

TEST_CASE("what else stands in CMI stays as it was")
{
    pair<atv28::device> it;
    it.tell(252, 99);
    it.tell(402, 0x4010);
    CHECK(it.end_of(restore_factory_settings{it.drive, knowingly}) == outcome_kind::executed_unconfirmed);
    CHECK(it.far().word("CMI") == 0x4010);
    CHECK(it.far().word("ACC") == 30);
}

TEST_CASE("motion law: S29 factory settings, which give the command to the terminals, wait for "
          "open run inputs")
{
    for (bool const is_three_wire : {false, true}) {
        {
            // What a bare write does.
            pair<atv320::device> it;
            it.tell(11101, is_three_wire ? 1 : 0);
            it.far().set_input(1, true);
            it.tell(8504, 0x0001);
            it.idle(milliseconds(100));
            REQUIRE(cia402::has_power(it.far().state_machine().state()));
        }
        pair<atv320::device> it;
        it.tell(11101, is_three_wire ? 1 : 0);
        it.far().set_input(1, true);
        it.idle(milliseconds(20));
        CHECK(it.end_of(restore_factory_settings{it.drive, knowingly}) == outcome_kind::run_input_closed);
        CHECK(it.far().word("FR1") == 164);
        it.idle(milliseconds(100));
        CHECK_FALSE(cia402::has_power(it.far().state_machine().state()));
    }
}

TEST_CASE("factory settings are taken by a drive in fault: they may be the remedy")
{
    pair<atv28::device> it;
    it.tell(252, 99);
    it.far().inject_fault(2);
    it.idle(milliseconds(100));
    CHECK(it.end_of(restore_factory_settings{it.drive, knowingly}) == outcome_kind::executed_unconfirmed);
    CHECK(it.far().word("ACC") == 30);
}
