// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A device without the register of its scale.
// EXPECT: this device lacks the register that holds the scale
#include "meter.hpp"

struct source : meter::device {
    using registers = table<meter::phase>;
};
inline constexpr station<source> other{unit_id{4}};

void act()
{
#ifdef REFUSED
    static_cast<void>(read<meter::phase>(other));
#else
    static_cast<void>(read<meter::phase>(unit));
#endif
}
