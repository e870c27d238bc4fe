// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// When a description of a drive is complete: its time-out, and each register of its scanner. What is said of one that is
// not stands in tests/fail.
#include <rtuwire/altivar/device/drive_type.hpp>

#include "support/proof.hpp"

#include <array>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

/// In a function: Clang 14 makes no layout in a lambda that stands in a class.
constexpr drive_layout layout_of(safeguard_layout const& safeguards, duration longest)
{
    drive_layout made{};
    made.safeguards = safeguards;
    made.longest_silence = longest;
    return made;
}

/// A drive of which only its safeguards are asked: two registers, and a time-out that is fixed, in milliseconds.
template <std::uint16_t Sll, std::uint16_t Tto, std::uint32_t Fixed, std::uint32_t Longest> struct guarded {
    static constexpr drive_layout layout =
        layout_of({.sll = Sll, .tto = Tto, .fixed_timeout = milliseconds(Fixed)}, milliseconds(Longest));
};
template <std::uint16_t Sll, std::uint16_t Tto, std::uint32_t Fixed = 0, std::uint32_t Longest = 7'000>
constexpr bool is_guarded = detail::has_timeout<guarded<Sll, Tto, Fixed, Longest>>();

// Both registers are needed, at any address.
STATIC_CHECK(is_guarded<7010, 6005>and is_guarded<1, 1>and is_guarded<1, 6005>and is_guarded<7010, 1>);
STATIC_CHECK(not is_guarded<0, 0> and not is_guarded<0, 6005> and not is_guarded<7010, 0>);
STATIC_CHECK(not is_guarded<0, 1> and not is_guarded<1, 0>);

// Or a time that is fixed and no longer than the longest silence.
STATIC_CHECK(is_guarded<0, 0, 7'000>and is_guarded<0, 0, 1> and not is_guarded<0, 0, 7'001>);
STATIC_CHECK(is_guarded<7010, 0, 7'000>and is_guarded<0, 6005, 7'000>and is_guarded<7010, 6005, 7'001>);

/// Has the registers 10 and 11, 20 and 21, 30 and 31, 40 and 41 but for one, and none beside.
template <std::uint16_t Missing> struct some_registers {
    static constexpr bool has_address(std::uint16_t address)
    {
        bool const is_in_a_row = address >= 10 and address < 50 and address % 10 < 2;
        return is_in_a_row and address != Missing;
    }
};
template <std::uint16_t Missing> struct scanning {
    using registers = some_registers<Missing>;
    static constexpr scanner_registers scanner{10, 20, 30, 40, 2};
};
STATIC_CHECK(detail::has_every_scanner_register<scanning<0>>());
STATIC_CHECK(not detail::has_every_scanner_register<scanning<10>>() and
             not detail::has_every_scanner_register<scanning<11>>());
STATIC_CHECK(not detail::has_every_scanner_register<scanning<20>>() and
             not detail::has_every_scanner_register<scanning<21>>());
STATIC_CHECK(not detail::has_every_scanner_register<scanning<30>>() and
             not detail::has_every_scanner_register<scanning<31>>());
STATIC_CHECK(not detail::has_every_scanner_register<scanning<40>>() and
             not detail::has_every_scanner_register<scanning<41>>());

/// Without a scanner no register is asked for.
struct unscanned {
    using registers = some_registers<0>;
    static constexpr scanner_registers scanner{};
};
STATIC_CHECK(detail::has_every_scanner_register<unscanned>());

} // namespace
