// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the demonstration writes down of a drive, in the order in which it happened.
#include "support/catch.hpp"

#include "../../examples/support/logbook.hpp"

using examples::logbook;
using rtuwire::cia402::state;

namespace {

examples::sample at(double time, state read) { return {time, 0, 0, 0, read, true}; }

} // namespace

TEST_CASE("logbook: a sample that was asked for before a newer state was noted shows the newer one")
{
    logbook seen;
    seen.note(state::ready_to_switch_on, 5.10);
    seen.note(state::switched_on, 5.28);
    seen.add(at(5.29, state::ready_to_switch_on), 5.20);
    CHECK(seen.samples().back().state == state::switched_on);
}

TEST_CASE("logbook: a sample that was asked for later shows what was read")
{
    logbook seen;
    seen.add(at(0.1, state::switch_on_disabled), 0.0);
    CHECK(seen.samples().back().state == state::switch_on_disabled);
    seen.note(state::ready_to_switch_on, 5.10);
    seen.note(state::ready_to_switch_on, 5.30);
    seen.add(at(5.35, state::fault), 5.20);
    CHECK(seen.samples().back().state == state::fault);
}
