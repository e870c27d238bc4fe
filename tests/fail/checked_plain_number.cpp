// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A number without a unit, known only at run time, for a register.
// EXPECT: a plain number is no setting: give it a unit (n * 0.1_s), or name an enumerator or bits
// CASES: 2
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};

void act(int ramp)
{
#if not defined(REFUSED)
    static_cast<void>(write<atv12::acc>(drive, checked(ramp * 0.1_s)));
#elif REFUSED == 1
    static_cast<void>(write<atv12::acc>(drive, checked(ramp)));
#else
    static_cast<void>(setting<atv12::acc>::checked(ramp));
#endif
}
