// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Wrapping time: every test stands across the wrap of the counter.
#include <rtuwire/core/time.hpp>

#include "support/proof.hpp"

using namespace rtuwire;

namespace {

// Five seconds before the counter wraps.
constexpr instant late{0xFFFF'FFFFU - 5'000'000U};

STATIC_CHECK((late + milliseconds(10'000)).microseconds < late.microseconds);
STATIC_CHECK(late + milliseconds(10'000) - late == milliseconds(10'000));
STATIC_CHECK(late + milliseconds(10'000) - milliseconds(10'000) == late);
STATIC_CHECK(reached(late, late));
STATIC_CHECK(reached(late + milliseconds(10'000), late + milliseconds(9'999)));
STATIC_CHECK(not reached(late, late + milliseconds(10'000)));
STATIC_CHECK(not reached(late, late + microseconds(1)));
STATIC_CHECK(reached(late + milliseconds(35 * 60'000), late));
STATIC_CHECK(milliseconds(3) == microseconds(3'000) and milliseconds(2) < milliseconds(3));
STATIC_CHECK(milliseconds(2) + microseconds(5) == microseconds(2'005));
STATIC_CHECK(microseconds(7) * 3 == microseconds(21));

STATIC_CHECK(earlier(late, late + milliseconds(10'000)) == deadline{late});
STATIC_CHECK(earlier(late + milliseconds(10'000), late) == deadline{late});
STATIC_CHECK(earlier({}, late) == deadline{late} and earlier(late, {}) == deadline{late});
STATIC_CHECK(not earlier({}, {}).has_value());

} // namespace
