// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A write in given steps to a device that has no function 06.
// EXPECT: this device does not implement function 06
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

/// An ATV320 that has function 16 alone.
struct writer : atv320::device {
    static constexpr function_set functions{function_code::write_multiple_registers};
};

inline constexpr station<atv320::device> drive{unit_id{7}};
inline constexpr station<writer> deaf{unit_id{3}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write_with_step<deciseconds, atv320::acc>(deaf, 1.3_s));
#else
    static_cast<void>(write_with_step<deciseconds, atv320::acc>(drive, 1.3_s));
    static_cast<void>(deaf);
#endif
}
