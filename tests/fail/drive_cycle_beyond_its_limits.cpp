// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Describes a drive whose cycle moves more than its function 23 takes.
// EXPECT: a cycle moves its words by function 23 or 16, which the drive has and whose limits they keep
#include <rtuwire/drives.hpp>

#include "../altivar/device/sixth_drive.hpp"

struct pump : atv99::device {
#ifdef REFUSED
    static constexpr rtuwire::device_limits limits{11, 9, 2, 2};
#endif
};

static_assert(rtuwire::altivar::drive_check<pump>::passed);
