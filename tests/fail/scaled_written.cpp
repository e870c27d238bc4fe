// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register is written whose scale another one holds.
// EXPECT: another register sets this register's steps: name them with write_with_step
#include "meter.hpp"

inline constexpr reg<signed_count16> factor{.code = "LSF", .address = 2};
inline constexpr reg<scaled_by<volts, factor>> limit{.code = "LIM", .address = 1};
struct source : meter::device {
    using registers = table<factor, limit>;
};
inline constexpr station<source> other{unit_id{4}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<limit>(other, 230_V));
#else
    static_cast<void>(write_with_step<volts, limit>(other, 230_V));
#endif
}
