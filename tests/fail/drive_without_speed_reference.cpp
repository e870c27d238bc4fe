// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Changes the reference of a drive that has no register for a speed.
// EXPECT: a drive has a register for its speed: `static constexpr auto const& speed_reference = lfrd`
#include <rtuwire/altivar/device/drive_type.hpp>

#include "../altivar/device/sixth_drive.hpp"

using namespace rtuwire::literals;

struct pump : atv99::device {
#ifdef REFUSED
    static void speed_reference();
#endif
};

void act()
{
    rtuwire::altivar::change_reference const to{rtuwire::station<pump>{rtuwire::unit_id{41}}, 20_Hz};
    static_cast<void>(to);
}
