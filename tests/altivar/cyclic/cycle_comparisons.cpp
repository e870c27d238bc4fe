// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// When a cycle reads back its control word and its reference: before each command to run, and at each tenth exchange
// while the motor runs.
#include <rtuwire/altivar/cyclic/cyclic.hpp>

#include "altivar/cyclic/cycle_by_hand.hpp"
#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;

namespace {

using cycle = cycle_by_hand<atv12::device>;

/// How many times it says the order, up to its next other request, which it has asked then.
constexpr unsigned orders_of(cycle& it)
{
    unsigned count = 0;
    while (count < 30 and it.asks() and it.exchanges(0x000F, 1'500)) {
        it.hear({running, 1'500, 0, 0});
        ++count;
    }
    return count;
}

constexpr bool reads_back_every_tenth_time()
{
    cycle it;
    bool ok = it.runs(); // one exchange with the command to run
    ok = ok and orders_of(it) == 9 and it.reads(8401);
    it.hear({1});
    ok = ok and orders_of(it) == 10 and it.reads(cmd_address);
    it.hear({0x000F});
    ok = ok and orders_of(it) == 10 and it.reads(lfrd_address);
    it.hear({1'500});
    ok = ok and orders_of(it) == 10 and it.reads(8401);
    it.hear({2});
    return ok and orders_of(it) == 10 and it.reads(cmd_address);
}
PROOF("while the motor runs CHCF, command and reference are read back in turn, at each tenth exchange",
      reads_back_every_tenth_time)

constexpr bool reads_back_what_it_took_over()
{
    cycle it;
    bool ok = it.begins(running) and it.loop.run(1'500_rpm);
    ok = ok and orders_of(it) == 10 and it.reads(8401);
    it.hear({1});
    return ok and orders_of(it) == 10 and it.reads(cmd_address);
}
PROOF("so it is where the motor was found running: ten exchanges, then CHCF first", reads_back_what_it_took_over)

constexpr bool reads_nothing_back_without_need()
{
    cycle it;
    bool ok = it.begins();
    for (unsigned i = 0; i < 25; ++i) {
        ok = ok and it.asks() and it.exchanges(0x0000, 0);
        it.hear({switch_on_disabled, 0, 0, 0});
    }
    ok = ok and it.loop.run(1'500_rpm);
    return ok and it.asks() and it.exchanges(0x0006, 1'500);
}
PROOF("without an order nothing is read back, however long; nor before the first word upward",
      reads_nothing_back_without_need)

constexpr bool reads_back_before_the_first_command()
{
    cycle it;
    bool ok = it.begins(ready) and it.loop.run(1'500_rpm);
    ok = ok and it.asks() and it.exchanges(0x0007, 1'500);
    it.hear({switched_on, 0, 0, 0});
    return ok and it.asks() and it.reads(cmd_address);
}
PROOF("the very first command to run goes behind a look at the control word", reads_back_before_the_first_command)

/// Whether an order finds out that another master started the motor, which stood for so many exchanges.
bool finds_another_master(unsigned exchanges)
{
    cycle it;
    bool ok = it.begins();
    for (unsigned i = 1; i < exchanges; ++i) {
        ok = ok and it.exchange();
    }
    ok = ok and it.exchange(running, 900) and it.loop.run(1'500_rpm);
    ok = ok and it.asks() and it.reads(8401);
    it.hear({1});
    ok = ok and orders_of(it) == 10 and it.reads(cmd_address);
    it.hear({0x0007});
    return ok and it.loop.control().reason().kind == outcome_kind::overwritten;
}

} // namespace

TEST_CASE("an order finds out that another master started the motor, however long that stood")
{
    for (unsigned const exchanges : {10U, 11U, 255U, 256U, 257U, 300U}) {
        INFO(exchanges);
        CHECK(finds_another_master(exchanges));
    }
}
