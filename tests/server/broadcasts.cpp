// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Every function to every unit at once: writes take effect without a response, nothing else has any effect. And what
// functions 11 and 12 count.
#include <rtuwire/server/server.hpp>

#include "support/proof.hpp"
#include "support/server_on_a_line.hpp"
#include "support/whole_bank.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

template <typename Functions = public_functions>
using whole_unit = test::server_on_a_line<basic_server<serial_diagnostics, Functions>, test::whole_bank>;

/// Asks everyone; returns the bank, or nothing where somebody answered.
template <typename Functions = public_functions, std::size_t Size>
constexpr test::whole_bank after_broadcast(std::array<std::byte, Size> pdu) // a copy: Clang 14 crashes on a view of it
{
    whole_unit<Functions> unit;
    static_cast<void>(unit.bank.words.set(4, 0x0012));
    if (not unit.ask(pdu, 0).empty() or not unit.is_silent()) {
        unit.bank.words = {};
        unit.bank.switched = {};
        unit.bank.files = {};
    }
    return unit.bank;
}

STATIC_CHECK(after_broadcast("05 00 03 FF 00"_hex).switched.get(3));
STATIC_CHECK(after_broadcast("0F 00 03 00 02 01 03"_hex).switched.get(4));
STATIC_CHECK(after_broadcast("15 09 06 00 02 00 07 00 01 12 34"_hex).files[1][7] == 0x1234);
STATIC_CHECK(after_broadcast("16 00 04 00 F2 00 25"_hex).words.get(4) == 0x0017);
STATIC_CHECK(after_broadcast("06 00 04 12 34"_hex).words.get(4) == 0x1234);
STATIC_CHECK(after_broadcast("10 00 04 00 01 02 12 34"_hex).words.get(4) == 0x1234);

// Function 23 writes, but has something to tell: it is not for everyone. Nor has a server what its type does not name.
STATIC_CHECK(after_broadcast("17 00 04 00 01 00 04 00 01 02 12 34"_hex).words.get(4) == 0x0012);
STATIC_CHECK(after_broadcast<register_functions>("16 00 04 00 F2 00 25"_hex).words.get(4) == 0x0012);
STATIC_CHECK(after_broadcast<register_functions>("06 00 04 12 34"_hex).words.get(4) == 0x1234);
STATIC_CHECK(not after_broadcast<register_functions>("05 00 03 FF 00"_hex).switched.get(3));

/// A unit, and what it tells of itself by functions 11 and 12.
struct counted : whole_unit<> {
    unsigned events()
    {
        byte_view const told = ask("0B"_hex);
        bool const is_free = told.size() == 8 and told[1] == std::byte{0x0B} and u16_at(told, 2) == 0;
        return is_free ? u16_at(told, 4) : 0xFFFFU;
    }
    bool is_logged(std::uint16_t events, std::uint16_t messages)
    {
        byte_view const told = ask("0C"_hex);
        return told.size() == 11 and told[2] == std::byte{6} and u16_at(told, 3) == 0 and u16_at(told, 5) == events and
               u16_at(told, 7) == messages;
    }
};

} // namespace

TEST_CASE("the event counter counts what was executed, but not its own requests")
{
    counted unit;
    CHECK(unit.events() == 0);
    CHECK(unit.events() == 0);
    unit.ask("01 00 00 00 01"_hex);
    unit.ask("06 00 00 12 34"_hex);
    CHECK(unit.events() == 2);
    unit.ask("01 00 00 00 00"_hex); // exceptions
    unit.ask("42"_hex);
    CHECK(unit.events() == 2);
    unit.ask("05 00 03 FF 00"_hex, 0);
    CHECK(unit.events() == 3);
    unit.ask("01 00 00 00 01"_hex, 0); // without effect
    unit.ask("01 00 00 00 01"_hex, 2); // to another unit
    CHECK(unit.events() == 3);
    CHECK(unit.is_logged(3, 14)); // all messages
    CHECK(unit.is_logged(4, 15)); // the first one was an event
}

TEST_CASE("clearing the counters clears that of events, and is none")
{
    counted unit;
    unit.ask("01 00 00 00 01"_hex);
    unit.ask("08 00 0A 00 00"_hex);
    CHECK(unit.events() == 0);
    unit.ask("01 00 00 00 01"_hex);
    CHECK(unit.events() == 1);
    unit.ask("08 00 01 00 00"_hex);
    CHECK(unit.events() == 0);
    unit.ask("08 00 04 00 00"_hex); // listens only
    unit.ask("01 00 00 00 01"_hex);
    unit.ask("08 00 01 00 00"_hex);
    CHECK(unit.events() == 0);
}
