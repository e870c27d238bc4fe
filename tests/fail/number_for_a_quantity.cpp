// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A number without a unit for a quantity.
// EXPECT: time_span
#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;

#ifdef REFUSED
deciseconds ramp = 30;
#else
deciseconds ramp{30};
#endif
