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

namespace {

template <typename Functions = public_functions>
using whole_unit = test::server_on_a_line<basic_server<serial_diagnostics, Functions>, test::whole_bank>;

/// Asks everyone; returns the bank, or nothing where somebody answered.
template <typename Functions = public_functions> constexpr test::whole_bank after_broadcast(byte_view pdu)
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
    constexpr unsigned events()
    {
        byte_view const told = ask("0B"_hex);
        bool const is_free = told.size() == 8 and told[1] == std::byte{0x0B} and u16_at(told, 2) == 0;
        return is_free ? u16_at(told, 4) : 0xFFFFU;
    }
    constexpr bool is_logged(std::uint16_t events, std::uint16_t messages)
    {
        byte_view const told = ask("0C"_hex);
        return told.size() == 11 and told[2] == std::byte{6} and u16_at(told, 3) == 0 and u16_at(told, 5) == events and
               u16_at(told, 7) == messages;
    }
};

constexpr bool counts_what_is_executed()
{
    counted unit;
    using test::is;
    bool const is_none = is(unit.events() == 0, "at first") and is(unit.events() == 0, "its own request");
    unit.ask("01 00 00 00 01"_hex);
    unit.ask("06 00 00 12 34"_hex);
    bool const are_two = is(unit.events() == 2, "two requests");
    unit.ask("01 00 00 00 00"_hex);
    unit.ask("42"_hex);
    bool const still_two = is(unit.events() == 2, "exceptions");
    unit.ask("05 00 03 FF 00"_hex, 0);
    bool const are_three = is(unit.events() == 3, "a write to everyone");
    unit.ask("01 00 00 00 01"_hex, 0);
    unit.ask("01 00 00 00 01"_hex, 2);
    return is_none and are_two and still_two and are_three and is(unit.events() == 3, "what has no effect") and
           is(unit.is_logged(3, 14), "the log counts all messages") and is(unit.is_logged(4, 15), "and is an event");
}
PROOF("the event counter counts what was executed, but not its own requests", counts_what_is_executed)

constexpr bool is_cleared()
{
    using test::is;
    counted unit;
    unit.ask("01 00 00 00 01"_hex);
    unit.ask("08 00 0A 00 00"_hex);
    bool const by_clear = is(unit.events() == 0, "08/0A");
    unit.ask("01 00 00 00 01"_hex);
    bool const counts_again = is(unit.events() == 1, "the next request");
    unit.ask("08 00 01 00 00"_hex);
    bool const by_restart = is(unit.events() == 0, "08/01");
    unit.ask("08 00 04 00 00"_hex);
    unit.ask("01 00 00 00 01"_hex);
    unit.ask("08 00 01 00 00"_hex);
    return by_clear and counts_again and by_restart and is(unit.events() == 0, "08/01 after listening only");
}
PROOF("clearing the counters clears that of events, and is none", is_cleared)

} // namespace
