// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A number known only at run time, of a type that holds more than the quantity.
// EXPECT: ramp
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

#ifdef REFUSED
deciseconds from_panel(int ramp) { return deciseconds{ramp}; }
#else
auto from_panel(int ramp) { return ramp * 0.1_s; }
#endif
