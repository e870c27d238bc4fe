// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A literal that is no whole number of a register type's steps.
// EXPECT: this_amount_is_not_a_whole_number_of_steps
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

#ifdef REFUSED
deciseconds ramp() { return 1.23_s; }
#else
deciseconds ramp() { return 1.20_s; }
#endif
