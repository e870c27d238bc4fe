// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What every board's file lives through: its own program against a device, a write, and its line as that of a server, for
// hours. The test of a board defines what its stand-in declares, includes the board's file, and says in a struct how that is
// opened, run, and gone through once.
#pragma once

#include <rtuwire/client.hpp>
#include <rtuwire/server.hpp>

#include "far_end.hpp"

namespace stand_in {

template <typename Act> void until(wire::time length, Act act)
{
    line.over_at = line.now() + length;
    try {
        act();
    } catch (time_is_over const&) {
    }
    line.over_at = ~wire::time{0};
    line.fall_silent();
}

/// The program reads; bytes are lost and damaged in each way, and the unit is silent for a while.
template <typename Board> void program_polls(std::uint16_t const& value, rtuwire::errc const& trouble)
{
    check(trouble != rtuwire::errc::none, "no value is shown as good before the first response");
    device unit;
    unit.attach();
    bool is_wrong = false, is_told = false, comes_back = false;
    int values = 0, spoiled = 0;
    wire::time const began = line.now();
    line.on_time = [&] {
        is_wrong = is_wrong or (value != 0 and value != 0x0250);
        bool const is_well = trouble == rtuwire::errc::none and value == 0x0250;
        wire::time const age = line.now() - began;
        values += is_well ? 1 : 0;
        unit.is_silent = age > 4'000'000 and age < 9'000'000;
        is_told = is_told or (unit.is_silent and trouble == rtuwire::errc::timed_out);
        comes_back = comes_back or (age > 55'000'000 and is_well);
        if (unit.requests > unit.bad_request + 4) {
            constexpr arrival kinds[] = {arrival::overrun, arrival::parity, arrival::framing, arrival::noise};
            unit.bad_request = unit.requests + 1;
            unit.loses_a_byte = spoiled % 5 == 4;
            unit.bad_at = static_cast<std::size_t>(spoiled) % 7;
            unit.how = kinds[spoiled++ % 4];
        }
    };
    until(60'000'000, Board::run);
    check(not is_wrong, "no value but the register's is ever shown");
    check(values > 100'000, "values are shown");
    check(is_told, "a silent unit is told");
    check(comes_back, "it goes on when the unit is back");
    check(unit.requests > 100 and spoiled > 20, "it asks again and again");
    std::cout << "program: " << unit.requests << " requests, " << spoiled << " of their responses spoiled\n";
}

template <typename Board> void writes()
{
    device unit;
    unit.attach();
    rtuwire::client link{Board::timing};
    rtuwire::single_request order{rtuwire::unit_id{7}, rtuwire::write_single_register{.address = 9001, .value = 30}};
    until(3'000'000, [&] {
        while (not order.settled()) {
            Board::pass(link, [&] { link.converse(order, rtuwire::instant{line.now_32()}); });
        }
    });
    check(order.settled() and order.outcome() and unit.written == 30, "a register is written");
}

template <typename Board> void serves_for_hours()
{
    constexpr wire::time hour = 3'600'000'000;
    master asker;
    rtuwire::server node{rtuwire::unit_id{7}, Board::timing};
    rtuwire::word_bank<4> bank{3200};
    static_cast<void>(bank.set(3201, 0x0250));
    asker.attach();
    until(2 * hour, [&] {
        for (;;) {
            Board::pass(node, [&] { node.serve(bank, rtuwire::instant{line.now_32()}); });
        }
    });
    check(asker.asked > 28'000 and asker.spoiled > 9'000, "the master asked for two hours");
    check(asker.deaf == 0, "a request that nothing disturbed is answered");
    check(asker.answered_spoiled == 0, "one with a damaged byte is not");
    std::cout << "server: " << asker.asked << " asked, " << asker.spoiled << " of them spoiled; answered "
              << asker.answered << ", not heard " << asker.deaf << '\n';
}

/// All of it; the result is the program's.
template <typename Board> int live(std::uint16_t const& value, rtuwire::errc const& trouble)
{
    Board::open();
    program_polls<Board>(value, trouble);
    writes<Board>();
    serves_for_hours<Board>();
    check(line.sent_undriven == 0, "the driver is on while a character leaves");
    check(line.let_go_early == 0, "and until its last stop bit has left");
    check(line.held_long == 0, "and no longer");
    check(line.collisions == 0, "it is off when the other end speaks");
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace stand_in
