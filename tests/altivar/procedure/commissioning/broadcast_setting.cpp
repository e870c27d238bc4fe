// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One setting for all drives of a line: what each of them takes, and what nobody may send to all.
#include "support/catch.hpp"
#include "support/proof.hpp"
#include "support/simulated_bus.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/broadcast_setting.hpp>
#include <rtuwire/altivar/procedure/motion/start.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

// What runs, redirects, readdresses or reassigns is not for all; ramps, limits and time-outs are.
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::cmd>() and not is_for_everyone<atv12::device, atv12::cmdd>());
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::lfr>() and
             not is_for_everyone<atv320::device, atv320::lfrd>());
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::pisp>() and not is_for_everyone<atv28::device, atv28::rpi>());
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::cmi>() and not is_for_everyone<atv28::device, atv28::cmi>());
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::chcf>() and
             not is_for_everyone<atv320::device, atv320::cd1>());
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::cd2>() and not is_for_everyone<atv320::device, atv320::fr2>());
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::fr1>() and not is_for_everyone<atv320::device, atv320::flo>());
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::add>() and not is_for_everyone<atv320::device, atv320::tbr>());
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::tfo>() and not is_for_everyone<atv28::device, atv28::bdr>());
STATIC_CHECK(not is_for_everyone<atv28::device, atv28::tcc>() and not is_for_everyone<atv28::device, atv28::li4>());
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::nc1>() and
             not is_for_everyone<atv320::device, atv320::nca8>());
STATIC_CHECK(not is_for_everyone<atv320::device, atv320::nma1>() and
             not is_for_everyone<atv320::device, atv320::nc8>());
STATIC_CHECK(is_for_everyone<atv12::device, atv12::acc>() and is_for_everyone<atv320::device, atv320::hsp>());
STATIC_CHECK(is_for_everyone<atv320::device, atv320::tto>() and is_for_everyone<atv28::device, atv28::dec>());

constexpr client_options patient{.response_timeout = milliseconds(100), .retries = 1};
constexpr losing_control_and_address knowingly{};

template <typename Device> struct line : test::simulated_bus<drive_client<4>, Device> {
    line() : test::simulated_bus<drive_client<4>, Device>{drive_client<4>{test::bus_timing, patient}}
    {
        this->add(unit_id{3});
        this->add(unit_id{4});
        this->idle(milliseconds(20));
    }
    void send_broadcast(auto request)
    {
        REQUIRE(this->run(request));
        CHECK(request.outcome());
        this->idle(milliseconds(2'500));
    }
    bool both(literal code, std::uint16_t word)
    {
        return this->drive(0).word(code) == word and this->drive(1).word(code) == word;
    }
};

} // namespace

TEST_CASE("a setting reaches all drives of the line")
{
    line<atv12::device> it;
    it.send_broadcast(broadcast_setting<atv12::device, atv12::acc>(1.3_s));
    CHECK(it.both("ACC", 13));
    line<atv28::device> old;
    old.send_broadcast(broadcast_setting<atv28::device, atv28::acc>(2.5_s));
    CHECK(old.both("ACC", 25));
    line<atv320::device> later;
    constexpr auto const& acc = restepped<deciseconds, atv320::acc>;
    later.send_broadcast(broadcast_setting<atv320::device, acc>(1.3_s));
    CHECK(later.both("ACC", 13));
}

TEST_CASE("a configuration reaches those that stand, and nobody says which")
{
    line<atv12::device> it;
    start go{station<atv12::device>{unit_id{3}}, 20_Hz};
    REQUIRE(it.run(go));
    it.send_broadcast(broadcast_setting<atv12::device, atv12::tto>(5_s));
    CHECK(it.drive(0).word("TTO") == 100);
    CHECK(it.drive(1).word("TTO") == 50);
}

TEST_CASE("an extended command goes to all, one with orders only where that is said")
{
    line<atv28::device> it;
    it.send_broadcast(broadcast_extended_command<atv28::device, 0x0010>());
    CHECK(it.both("CMI", 0x0010));
    it.send_broadcast(broadcast_setting<atv28::device, atv28::acc>(2.5_s));
    it.send_broadcast(broadcast_extended_command<atv28::device, 0x0002>(knowingly));
    CHECK(it.drive(0).eeprom_writes() == 1);
    CHECK(it.drive(1).eeprom_writes() == 1);
    it.send_broadcast(broadcast_extended_command<atv28::device, 0x0001>(knowingly));
    CHECK(it.both("ACC", 30));
    it.send_broadcast(broadcast_extended_command<atv28::device, 0x0004>(knowingly));
    CHECK(it.both("ACC", 25));
}

TEST_CASE("a drive that runs does not execute an order to all")
{
    line<atv320::device> it;
    start go{station<atv320::device>{unit_id{3}}, 20_Hz};
    REQUIRE(it.run(go));
    it.send_broadcast(broadcast_extended_command<atv320::device, 0x0001>(knowingly));
    CHECK(it.drive(0).word("FR1") == 164);
    CHECK(it.drive(1).word("FR1") == 1);
}
