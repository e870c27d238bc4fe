// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Each error has its number, a kind and a name, and no other number has.
#include <rtuwire/wire/errc.hpp>

#include <string>

#include "support/errors.hpp"
#include "support/proof.hpp"

#include <rtuwire/wire/errc_name.hpp>

using namespace rtuwire;
using test::all_errors;

namespace {

/// The entry of a number in the list; null where no error has it.
constexpr test::known_error const* entry_of(std::uint32_t number)
{
    for (auto const& each : all_errors) {
        if (each.number == number) {
            return &each;
        }
    }
    return nullptr;
}

constexpr bool has_a_kind_by_its_number()
{
    for (std::uint32_t number = 0; number <= 0xFF; ++number) {
        auto const* const entry = entry_of(number);
        error_category const other = number < 0x80 ? error_category::exception : error_category::unknown;
        if (category_of(static_cast<errc>(number)) != (entry == nullptr ? other : entry->category)) {
            return false;
        }
    }
    return true;
}
PROOF("an error has the kind that the list gives; an unlisted exception is one, any other number is unknown",
      has_a_kind_by_its_number)

constexpr bool exceptions_are_one_kind()
{
    for (std::uint32_t number = 0; number <= 0xFF; ++number) {
        auto const error = static_cast<errc>(number);
        if (is_exception(error) != (category_of(error) == error_category::exception)) {
            return false;
        }
    }
    return true;
}
PROOF("what a server sent, and nothing else, is of the kind of exceptions", exceptions_are_one_kind)

} // namespace

TEST_CASE("each error keeps its number, and has a kind")
{
    for (auto const& each : all_errors) {
        INFO(std::string{name(each.error)});
        CHECK(static_cast<std::uint32_t>(each.error) == each.number);
        CHECK(category_of(each.error) == each.category);
        CHECK(each.category != error_category::unknown);
    }
}

TEST_CASE("the list holds every error that has a name, once, and no other")
{
    for (std::uint32_t number = 0; number <= 0xFF; ++number) {
        std::string const text{name(static_cast<errc>(number))};
        INFO(number << ": " << text);
        CHECK((text != "exception" and text != "unknown error") == (entry_of(number) != nullptr));
    }
    for (auto const& each : all_errors) {
        CHECK(entry_of(each.number) == &each);
    }
}
