// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a device's description says: its functions, its unit addresses, and what can be read across.
#include <rtuwire/table/device.hpp>

#include <array>
#include <cstdint>

#include "support/catch.hpp"

#include <rtuwire/core/units.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/table.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

inline constexpr reg<count16> one{.code = "ONE", .address = 100};
inline constexpr reg<count16> two{.code = "TWO", .address = 104};
inline constexpr reg<count16> highest{.code = "LAST", .address = 65535};

/// Registers at 100, 104 and 65535; 101 and 102, 200 to 209 and 65530 to 65533 can be read all the same.
struct gauge {
    static constexpr literal name{"gauge"};
    static constexpr function_set functions{function_code::read_holding_registers};
    static constexpr device_limits limits{10, 10, 0, 0};
    static constexpr unit_range units{3, 31};
    static constexpr std::array<address_range, 3> readable{{{101, 102}, {200, 209}, {65530, 65533}}};
    using registers = table<one, two, highest>;
};

bool is_there(std::uint32_t address)
{
    return (address >= 100 and address <= 102) or address == 104 or (address >= 200 and address <= 209) or
           (address >= 65530 and address <= 65533) or address == 65535;
}

bool are_there(std::uint32_t first, std::uint32_t last)
{
    for (std::uint32_t address = first; address <= last; ++address) {
        if (not is_there(address)) {
            return false;
        }
    }
    return true;
}

} // namespace

TEST_CASE("addresses can be read across where each is a register's or called readable")
{
    for (std::uint32_t const around : {102U, 203U, 65528U}) {
        for (std::uint32_t first = around - 8; first <= around + 7; ++first) {
            for (std::uint32_t last = first; last <= around + 7; ++last) {
                CAPTURE(first, last);
                REQUIRE(is_readable_across<gauge>(static_cast<std::uint16_t>(first),
                                                  static_cast<std::uint16_t>(last)) == are_there(first, last));
            }
        }
    }
}

TEST_CASE("a device has the functions that it names")
{
    CHECK(implements<gauge>(function_code::read_holding_registers));
    CHECK_FALSE(implements<gauge>(function_code::write_single_register));
    CHECK_FALSE(implements<gauge>(function_code::diagnostics));
}

TEST_CASE("a station has an address of its device's range")
{
    for (std::uint32_t number = 0; number <= 300; ++number) {
        auto const found = station<gauge>::checked(number);
        REQUIRE(found.has_value() == (number >= 3 and number <= 31));
        if (found) {
            REQUIRE(found->unit().byte() == number);
        } else {
            REQUIRE(found.error() == errc::invalid_unit);
        }
    }
    CHECK_FALSE(station<gauge>::checked(0x1'0003));
    CHECK(station<gauge>{unit_id{3}}.unit() == unit_id{3});
    CHECK(station<gauge>{unit_id{31}}.unit() == unit_id{31});
}

namespace {

/// A gauge alone on its line, which has any address.
struct on_its_own : gauge {
    static constexpr unit_range units{0, 255};
};

} // namespace

TEST_CASE("a station has a reserved address where its device's range has it, and never that of everyone")
{
    for (std::uint32_t number = 0; number <= 300; ++number) {
        auto const found = station<on_its_own>::checked(number);
        REQUIRE(found.has_value() == (number >= 1 and number <= 255));
        REQUIRE((not found or found->unit().byte() == number));
    }
    CHECK(station<on_its_own>{unit_id::reserved(248)}.unit() == unit_id::reserved(248));
}

TEST_CASE("a device that says nothing else has the addresses 1 to 247 and a time-out that can be set")
{
    unit_range const all{};
    for (std::uint32_t number = 0; number <= 300; ++number) {
        REQUIRE(all.contains(number) == (number >= 1 and number <= 247));
    }
    CHECK(link_timeout{milliseconds(1'000), milliseconds(2'000)}.is_adjustable);
}
