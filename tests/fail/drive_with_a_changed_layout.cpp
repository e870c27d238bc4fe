// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Checks a drive whose layout is the changed copy of another one's, which a check would read at that one's registers.
// EXPECT: a layout that was changed has other registers to check: set layout.checked to drive_layout::checked_of(layout)
#include <rtuwire/altivar/device/drive_type.hpp>

#include "../altivar/device/sixth_drive.hpp"

struct pump : atv99::device {
    static constexpr rtuwire::altivar::drive_layout layout = [] {
        auto changed = atv99::device::layout;
        changed.hsp = atv99::hsp.address;
#ifndef REFUSED
        changed.checked = rtuwire::altivar::drive_layout::checked_of(changed);
#endif
        return changed;
    }();
};

void act()
{
    rtuwire::altivar::check_supervision const check{rtuwire::station<pump>{rtuwire::unit_id{41}}};
    static_cast<void>(check);
}
