// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A simulated drive says who it is in the bytes that its manual prints, or what a program tells it to say.
#include <rtuwire/sim/drive/unit.hpp>

#include "support/catch.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr auto request = "02 2B 0E 01 00 34 77"_hex;

template <typename Device> byte_view response_of(sim::unit<Device>& unit)
{
    instant now{0};
    unit.advance(now);
    now = now + milliseconds(20);
    unit.advance(now);
    unit.receive(request, now);
    unit.advance(now);
    now = now + milliseconds(20);
    unit.advance(now);
    return unit.poll_transmit();
}

constexpr device_object objects[] = {{vendor_name, "nobody"}, {product_code, "x"}};

} // namespace

TEST_CASE("an ATV310 identifies itself as its manual prints it")
{
    // With the length of the reference put right (0C), and the CRC made from that.
    constexpr auto printed =
        "02 2B 0E 01 02 00 00 03 00 12 53 63 68 6E 65 69 64 65 72 20 45 6C 65 63 74 72 69 63 01 0C 41 54 56 33 31 30 48 30 33 37 4E 34 02 04 30 32 30 31 B0 38"_hex;
    sim::unit<atv310::device> unit{unit_id{2}, timing, instant{0}};
    byte_view const said = response_of(unit);
    REQUIRE(said.size() == 50);
    CHECK(byte_view{printed}.size() == 50);
    for (std::size_t i = 0; i < said.size(); ++i) {
        CHECK(said[i] == byte_view{printed}[i]);
    }
}

TEST_CASE("a program can let a simulated drive say another vendor")
{

    static constexpr server_profile other = sim::line_profile_with<atv310::device>(identity_of<objects>);
    sim::unit<atv310::device> unit{unit_id{2}, timing, instant{0}, other};
    byte_view const said = response_of(unit);
    REQUIRE(said.size() > 16);
    CHECK(to_u8(said[9]) == 6);
    CHECK(to_u8(said[10]) == 'n');
}

TEST_CASE("an ATV28 does not know function 43")
{
    sim::unit<atv28::device> unit{unit_id{2}, timing, instant{0}};
    byte_view const said = response_of(unit);
    REQUIRE(said.size() == 5);
    CHECK(to_u8(said[1]) == 0xAB);
    CHECK(to_u8(said[2]) == 0x01);
}
