// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Tests that the compiler evaluates, and that run as well: the compiler refuses undefined behaviour,
// the run is what sanitizers and coverage see. They set RTUWIRE_NO_STATIC_TESTS.
#pragma once

#include "support/catch.hpp"
#include "support/fact.hpp"

namespace rtuwire::test {

/// Runs a proof; through a volatile pointer, or the optimizer would evaluate it at compile time again.
inline bool run(bool (*proof)())
{
    bool (*volatile opaque)() = proof;
    return opaque();
}

} // namespace rtuwire::test

#ifdef RTUWIRE_NO_STATIC_TESTS
#define RTUWIRE_STATIC_PROOF(sentence, function)
#define RTUWIRE_STATIC_FACT(...)                                                                                       \
    TEST_CASE()                                                                                                        \
    {                                                                                                                  \
        CHECK(::rtuwire::test::run([] { return static_cast<bool>(__VA_ARGS__); }));                                    \
    }                                                                                                                  \
    static_assert(true)
#else
#define RTUWIRE_STATIC_PROOF(sentence, function) static_assert(function(), sentence);
#define RTUWIRE_STATIC_FACT(...) static_assert(__VA_ARGS__)
#endif

/// PROOF("sentence", function): `constexpr bool function()` holds when compiled and when run.
#define PROOF(sentence, function)                                                                                      \
    RTUWIRE_STATIC_PROOF(sentence, function)                                                                           \
    TEST_CASE(sentence) { CHECK(::rtuwire::test::run(function)); }

/// STATIC_CHECK(expression); at namespace scope: a fact that fits one line. It runs only where the
/// static half is off.
#define STATIC_CHECK(...) RTUWIRE_STATIC_FACT(__VA_ARGS__)
