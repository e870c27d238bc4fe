// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive that would be asked at an address to which whatever hangs on the line answers.
// EXPECT: a drive is asked at 1 to 247, never at a reserved address
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/drives.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

struct own : atv320::device {
#if defined(REFUSED)
    static constexpr unit_range units{1, 248};
#else
    static constexpr unit_range units{1, 200};
#endif
};
static_assert(drive_check<own>::passed);
