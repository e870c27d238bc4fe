// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads of values that are not there, for two files: NDEBUG must make no difference.
#pragma once

#include <cstdint>

#include "support/death.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/result.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/unit_id.hpp>

using namespace rtuwire;

namespace rtuwire::test {

/// Uses a value, so that the compiler has to have it.
template <typename T> void consume(T const& value)
{
    T const volatile used = value;
    static_cast<void>(used);
}

struct pair_of_words {
    std::uint16_t first;
    std::uint16_t second;
};

/// A number that the compiler does not know.
inline std::uint32_t told(std::uint32_t number)
{
    std::uint32_t const volatile place = number;
    return place;
}

/// Every way to read a value: one that is there is read, one that is not ends the program behind its hook.
static void values_are_checked()
{
    auto const unit = [](std::uint32_t number) { consume((*unit_id::checked(told(number))).byte()); };
    CHECK(end_of([&] { unit(247); }).is_return);
    end const refused = end_of([&] { unit(248); });
    CHECK(refused.is_trap);
    CHECK(refused.left == static_cast<int>(errc::invalid_unit));
    CHECK(refused.said == "rtuwire: the program ends: it read a value that is not there (errc 0x81, see "
                          "rtuwire/wire/errc.hpp): look at has_value() or size() first\n");

    auto const pair = [](errc error) {
        return told(0) + static_cast<std::uint32_t>(error) == 0 ? result<pair_of_words>{pair_of_words{1, 2}}
                                                                : result<pair_of_words>{error};
    };
    CHECK(end_of([&] { consume(pair(errc::none)->second); }).is_return);
    CHECK(end_of([&] { consume((*pair(errc::none)).first); }).is_return);
    end const transition_rule = end_of([&] { consume(pair(errc::timed_out)->second); });
    CHECK(transition_rule.is_trap);
    CHECK(transition_rule.left == static_cast<int>(errc::timed_out));
    end const star = end_of([&] { consume((*pair(errc::busy)).first); });
    CHECK(star.is_trap);
    CHECK(star.left == static_cast<int>(errc::busy));

    // A failure says why.
    CHECK(end_of([&] { consume(result<int>{static_cast<errc>(told(0))}.has_value()); }).is_trap);

    // What asks first is no misuse.
    CHECK(end_of([&] { consume(pair(errc::timed_out).value_or({3, 4}).first); }).is_return);
    CHECK(end_of([&] { consume(unit_id::checked(told(248)) == errc::invalid_unit); }).is_return);
}

} // namespace rtuwire::test
