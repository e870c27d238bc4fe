// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The limits that an image holds its registers to: open ones, numbers of both signs, and those that hang on
// other registers.
#include <rtuwire/sim/drive/image.hpp>

#include <array>
#include <cstdint>

#include "support/catch.hpp"

#include <rtuwire/core/units.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/table.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

inline constexpr reg<signed_rpm> trim{.code = "TRIM", .address = 100};
inline constexpr reg<signed_rpm> offset{.code = "OFS", .address = 101, .min = {-100}, .max = {100}};
inline constexpr reg<rpm> at_least{.code = "LEAST", .address = 102, .min = {7}};
inline constexpr reg<rpm> base{.code = "BASE", .address = 103, .min = {0}, .max = {9999}, .factory = 500};
inline constexpr reg<rpm> times{.code = "TIMES", .address = 104, .min = {0}, .max = {99}, .factory = 30};
inline constexpr reg<rpm> share{.code = "SHARE", .address = 105, .min = share_of("BASE", 1, 2), .max = "BASE"};
inline constexpr reg<rpm> product{.code = "PROD", .address = 106, .min = {0}, .max = product_of("BASE", "TIMES", 10)};

struct machine {
    static constexpr literal name{"machine"};
    static constexpr function_set functions{function_code::write_single_register};
    static constexpr device_limits limits{10, 10, 0, 0};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<trim, offset, at_least, base, times, share, product>;
};
using machine_image = detail::image<machine>;

/// Whether a register takes exactly the raw counts from `least` to `most`, among those beside both.
bool is_range_of(machine_image const& held, literal code, std::int32_t least, std::int32_t most)
{
    bool ok = true;
    for (std::int32_t const raw : {least - 1, least, least + 1, most - 1, most, most + 1}) {
        bool const is_taken = held.check(machine_image::at(code), static_cast<std::uint16_t>(raw)) == errc::none;
        ok = ok and is_taken == (raw >= least and raw <= most);
    }
    return ok;
}

} // namespace

TEST_CASE("a register without limits takes every word")
{
    machine_image const held;
    for (std::uint32_t word = 0; word <= 0xFFFF; ++word) {
        REQUIRE(held.check(machine_image::at("TRIM"), static_cast<std::uint16_t>(word)) == errc::none);
    }
}

TEST_CASE("limits that are numbers, of both signs and on one side alone")
{
    machine_image const held;
    CHECK(is_range_of(held, "OFS", -100, 100));
    CHECK(held.check(machine_image::at("LEAST"), 6) == errc::illegal_data_value);
    CHECK(held.check(machine_image::at("LEAST"), 7) == errc::none);
    CHECK(held.check(machine_image::at("LEAST"), 0xFFFF) == errc::none);
}

TEST_CASE("limits that hang on other registers follow them")
{
    machine_image held;
    CHECK(is_range_of(held, "SHARE", 250, 500));
    CHECK(is_range_of(held, "PROD", 0, 1'500));
    held.put(machine_image::at("BASE"), 100);
    CHECK(is_range_of(held, "SHARE", 50, 100));
    CHECK(is_range_of(held, "PROD", 0, 300));
    held.put(machine_image::at("TIMES"), 25);
    CHECK(is_range_of(held, "PROD", 0, 250));
}
