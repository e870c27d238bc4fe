// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Error codes, unit addresses, functions and limits.
#include <rtuwire/wire/errc_name.hpp>

#include <array>
#include <set>
#include <string>

#include "support/errors.hpp"
#include "support/proof.hpp"

#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/unit_id.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool exceptions_keep_their_number()
{
    for (std::uint32_t code = 0; code <= 0xFF; ++code) {
        errc const error = exception_error(static_cast<std::uint8_t>(code));
        bool const is_listed = code >= 1 and code < 0x80;
        if (is_listed and static_cast<std::uint32_t>(error) != code) {
            return false;
        }
        if (not is_exception(error) or (not is_listed and error != errc::unlisted_exception)) {
            return false;
        }
    }
    for (errc const other : {errc::none, errc::crc_mismatch, errc::device_failed}) {
        if (is_exception(other)) {
            return false;
        }
    }
    return true;
}
PROOF("an exception keeps its number, and none can pass for a local error", exceptions_keep_their_number)

constexpr bool units_are_1_to_247()
{
    for (std::uint32_t number = 0; number <= 300; ++number) {
        auto const unit = unit_id::checked(number);
        bool const is_unit = number >= 1 and number <= 247;
        if (unit.has_value() != is_unit) {
            return false;
        }
        if (is_unit and unit->byte() != number) {
            return false;
        }
        if (not is_unit and unit.error() != errc::invalid_unit) {
            return false;
        }
    }
    return true;
}
PROOF("a unit address is 1 to 247", units_are_1_to_247)

constexpr bool a_head_is_whole()
{
    std::array<std::byte, 4> place{};
    byte_writer out{place};
    write_head(out, function_code::read_holding_registers, 1, 2);
    return not out.ok() and out.written().empty() and place[0] == std::byte{0};
}
PROOF("a head that does not fit is not written", a_head_is_whole)

constexpr bool local_causes_are_no_exceptions()
{
    for (auto const& each : test::all_errors) {
        if (each.number >= 0x80 and is_exception(each.error)) {
            return false;
        }
    }
    return not is_exception(errc::none) and is_exception(static_cast<errc>(0x7F));
}
PROOF("from 80 on an error is a local cause, and no exception", local_causes_are_no_exceptions)

constexpr bool tells_everyone_from_each()
{
    destination const all{broadcast};
    bool ok = all.is_broadcast() and all.byte() == 0;
    for (std::uint32_t number = 1; number <= 247; ++number) {
        destination const one{*unit_id::checked(number)};
        ok = ok and not one.is_broadcast() and one.byte() == number and not(one == all);
    }
    return ok;
}
PROOF("a destination is everyone or one unit", tells_everyone_from_each)
STATIC_CHECK(unit_id{3} < unit_id{4} and unit_id{3} == unit_id{3});

constexpr function_set two{function_code::write_single_register, static_cast<function_code>(127)};
STATIC_CHECK(two.contains(function_code::write_single_register));
STATIC_CHECK(two.contains(static_cast<function_code>(127)));
STATIC_CHECK(not two.contains(function_code::read_holding_registers));
STATIC_CHECK(not function_set{static_cast<function_code>(0x86)}.contains(function_code{6}));
STATIC_CHECK(not function_set{static_cast<function_code>(0)}.contains(function_code{0}));
STATIC_CHECK(not two.contains(static_cast<function_code>(0x86)));

STATIC_CHECK(sizeof(function_set) == 16);

constexpr bool holds_what_it_was_given()
{
    for (std::uint32_t member = 0; member <= 0xFF; ++member) {
        function_set const one{static_cast<function_code>(member)};
        for (std::uint32_t code = 0; code <= 0xFF; ++code) {
            bool const is_member = code == member and code >= 1 and code <= 127;
            if (one.contains(static_cast<function_code>(code)) != is_member) {
                return false;
            }
        }
    }
    return true;
}

// The public function codes of the specification (AP 5.1), as data.
constexpr std::array<unsigned, 19> codes_of_the_specification{1,  2,  3,  4,  5,  6,  7,  8,  11, 12,
                                                              15, 16, 17, 20, 21, 22, 23, 24, 43};

constexpr bool has_every_public_function()
{
    unsigned count = 0;
    for (std::uint32_t code = 0; code <= 0xFF; ++code) {
        count += all_functions.contains(static_cast<function_code>(code)) ? 1U : 0U;
    }
    for (unsigned const code : codes_of_the_specification) {
        count -= all_functions.contains(static_cast<function_code>(code)) ? 1U : 0U;
    }
    return count == 0 and all_functions != function_set{};
}
PROOF("all public functions of the specification are known, and no other", has_every_public_function)

STATIC_CHECK(not unit_id::checked(0xFFFF'FFFF) and not unit_id::checked(256 + 7));
STATIC_CHECK(is_address_range(65535, 0) and not is_address_range(65535, 65535));
STATIC_CHECK(not is_address_range(0, 65537) and is_address_range(65534, 2));
STATIC_CHECK(not is_address_range(1, static_cast<std::size_t>(-1)));

STATIC_CHECK(is_address_range(65535, 1) and not is_address_range(65535, 2));
STATIC_CHECK(is_address_range(0, 65536) and not is_address_range(1, 65536));
STATIC_CHECK(is_address_range(65411, 125) and not is_address_range(65412, 125));
STATIC_CHECK(not is_quantity(0, 125) and is_quantity(1, 125));
STATIC_CHECK(is_quantity(125, 125) and not is_quantity(126, 125));

} // namespace

TEST_CASE("a set of functions holds the one it was given, of 1 to 127") { CHECK(holds_what_it_was_given()); }

TEST_CASE("every error that has a name has its own")
{
    std::set<std::string> names;
    std::size_t named = 0;
    for (unsigned code = 0; code <= 0xFF; ++code) {
        std::string const text{name(static_cast<errc>(code))};
        CHECK_FALSE(text.empty());
        if (text != "exception" and text != "unknown error") {
            ++named;
            names.insert(text);
        }
    }
    CHECK(names.size() == named);
    CHECK(named == test::all_errors.size());
    CHECK(name(static_cast<errc>(0x0C)) == "exception");
    CHECK(name(static_cast<errc>(0xFE)) == "unknown error");
}
