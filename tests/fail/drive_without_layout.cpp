// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Starts a device that says nothing of a drive's words.
// EXPECT: a drive says where its words are: `static constexpr drive_layout layout`
#include <rtuwire/altivar/device/drive_type.hpp>

#include "../altivar/device/sixth_drive.hpp"

using namespace rtuwire::literals;

struct pump : atv99::device {
#ifdef REFUSED
    static void layout();
#endif
};

void act()
{
    rtuwire::altivar::start const run{rtuwire::station<pump>{rtuwire::unit_id{41}}, 20_Hz};
    static_cast<void>(run);
}
