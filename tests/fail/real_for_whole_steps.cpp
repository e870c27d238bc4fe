// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A floating point amount for registers that count whole steps.
// EXPECT: this register counts whole steps: rounded_to first
#include <rtuwire/client.hpp>

using namespace rtuwire;

inline constexpr reg<unsigned32<decivolts>> wide{.code = "W", .address = 3};

void act(real<volts> amount)
{
#ifdef REFUSED
    static_cast<void>(setting<wide>::checked(amount));
#else
    auto const rounded = amount.rounded_to<decivolts>();
    static_cast<void>(rounded and setting<wide>::checked(*rounded));
#endif
}
