// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value or a reason.
#include <rtuwire/core/result.hpp>

#include <type_traits>

#include "support/death.hpp"
#include "support/proof.hpp"

#include <rtuwire/wire/errc.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

STATIC_CHECK(std::is_trivially_copyable_v<result<int>>);
STATIC_CHECK(std::is_trivially_copyable_v<result<void>>);
STATIC_CHECK(sizeof(result<std::uint16_t>) == 4);

// What a result takes as bytes, against the standard's trait: parts with a copy, a move, an assignment or an end of their own,
// and a part that cannot be assigned.
struct copied {
    copied() = default;
    copied(copied const&) {}
};
struct assigned {
    assigned& operator=(assigned const&) { return *this; }
};
struct ended {
    ~ended() {}
};
struct constant {
    int const value;
};
struct whole {
    int value;
    std::uint8_t bytes[3];
};
template <typename... Values>
constexpr bool
    are_judged_as_by_the_standard = ((copied_as_bytes<Values> == std::is_trivially_copyable_v<Values>)and...);
STATIC_CHECK(
    are_judged_as_by_the_standard<copied, assigned, ended, constant, whole, int, int*, result<int>, result<whole>>);
STATIC_CHECK(copied_as_bytes<whole>and copied_as_bytes<constant> and not copied_as_bytes<assigned>);
STATIC_CHECK(sizeof(result<void>) == 1);

constexpr result<int> half(int number)
{
    if (number % 2 != 0) {
        return errc::malformed;
    }
    return number / 2;
}

STATIC_CHECK(half(8).has_value() and *half(8) == 4 and half(8).error() == errc::none);
STATIC_CHECK(not half(7).has_value() and half(7).error() == errc::malformed);
STATIC_CHECK(half(7) == errc::malformed and not(half(8) == errc::malformed));
STATIC_CHECK(half(8) == 4 and not(half(8) == 5) and not(half(7) == 4));
STATIC_CHECK(half(7).value_or(-1) == -1 and half(8).value_or(-1) == 4);
STATIC_CHECK(half(8).and_then(half) == 2);
STATIC_CHECK(half(6).and_then(half) == errc::malformed);
STATIC_CHECK(half(5).and_then(half) == errc::malformed);

STATIC_CHECK(half(8) == half(8) and half(8) != half(6));
STATIC_CHECK(half(7) == half(5) and half(7) != half(8) and half(8) != half(7));
STATIC_CHECK(half(7) != result<int>{errc::timed_out});

constexpr bool calls_nothing_after_an_error()
{
    unsigned calls = 0;
    auto const count = [&](int number) -> result<int> {
        ++calls;
        return number + 1;
    };
    bool const passed_on = half(7).and_then(count) == errc::malformed and calls == 0;
    return passed_on and half(8).and_then(count) == 5 and calls == 1;
}
PROOF("and_then calls its function for a value only", calls_nothing_after_an_error)

constexpr result<char> letter(int number)
{
    return number == 4 ? result<char>{'d'} : result<char>{errc::illegal_data_value};
}
STATIC_CHECK(half(8).and_then(letter) == 'd');
STATIC_CHECK(half(6).and_then(letter) == errc::illegal_data_value);

struct pair {
    int left, right;
};
STATIC_CHECK(result<pair> {
    pair { 1, 2 }
} -> right == 2);

constexpr result<void> checked(bool good)
{
    if (good) {
        return {};
    }
    return errc::timed_out;
}

STATIC_CHECK(checked(true).has_value() and static_cast<bool>(checked(true)));
STATIC_CHECK(checked(false) == errc::timed_out and not(checked(true) == errc::timed_out));

} // namespace

// This program has no hook.
TEST_CASE("without a hook, reading a value that is not there ends the program all the same")
{
    test::end const end = test::end_of([] {
        int const volatile got = *half(7);
        static_cast<void>(got);
    });
    CHECK(end.is_trap);
    CHECK(end.left == -1);
}
