// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Checks a drive whose time-out is at an address that its table does not have.
// EXPECT: an address in layout.safeguards is in no register of the drive's table; 0 says that the drive has none
#include <rtuwire/altivar/device/drive_type.hpp>

#include "../altivar/device/sixth_drive.hpp"

struct pump : atv99::device {
#ifdef REFUSED
    static constexpr rtuwire::altivar::drive_layout layout = [] {
        auto wrong = atv99::device::layout;
        wrong.safeguards.tto = 6005;
        return wrong;
    }();
#endif
};

void act()
{
    rtuwire::altivar::check_supervision const check{rtuwire::station<pump>{rtuwire::unit_id{41}}};
    static_cast<void>(check);
}
