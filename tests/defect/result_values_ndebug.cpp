// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The same with NDEBUG, which is about assertions and not about motors.
#ifndef NDEBUG
#define NDEBUG
#endif
#include "defect/result_values.hpp"

static_assert(RTUWIRE_CHECKED == 1);

TEST_CASE("defect: the value of a failed result is not read, NDEBUG or not") { test::values_are_checked(); }
