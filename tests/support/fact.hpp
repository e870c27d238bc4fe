// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Names the facts of a proof, so that the one which does not hold is told: by the compiler and by the run.
#pragma once

#include <cstdio>

namespace rtuwire::test {

/// Not constexpr: the compiler that meets it shows the call of `is`, with the fact.
inline void this_fact_does_not_hold(char const* fact) { std::fprintf(stderr, "does not hold: %s\n", fact); }

/// One fact of a proof, by name: `is(unit.has(0x1234), "value")`.
constexpr bool is(bool holds, char const* fact)
{
    if (not holds) {
        this_fact_does_not_hold(fact);
    }
    return holds;
}

} // namespace rtuwire::test
