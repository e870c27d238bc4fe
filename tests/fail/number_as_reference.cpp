// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A plain number where a drive wants a speed or a frequency.
// EXPECT: a plain number is no reference: give it a unit, 50_Hz or 1500_rpm
// CASES: 3
// ALONE
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/drives.hpp>

using namespace rtuwire;

inline constexpr station<altivar::atv320::device> drive{unit_id{7}};

void act()
{
#if not defined(REFUSED)
    altivar::start go{drive, 50_Hz};
#elif REFUSED == 1
    altivar::start go{drive, 50};
#elif REFUSED == 2
    altivar::start go{drive, 49.5};
#else
    altivar::change_reference go{drive, 50};
#endif
    static_cast<void>(go.settled());
}
