// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A scale that no request reads with its register.
// EXPECT: this register with all its words and its scale does not fit one request of this device
#include "meter.hpp"

inline constexpr reg<signed_count16> factor{.code = "LSF", .address = 2};
inline constexpr reg<scaled_by<volts, factor>> near{.code = "NEAR", .address = 3};
inline constexpr reg<scaled_by<volts, factor>> far{.code = "FAR", .address = 9};
struct source : meter::device {
    using registers = table<factor, near, far>;
};
inline constexpr station<source> other{unit_id{4}};

void act()
{
#ifdef REFUSED
    static_cast<void>(read<far>(other));
#else
    static_cast<void>(read<near>(other));
#endif
}
