// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Keeps a drive running that does not say what its cycle moves.
// EXPECT: a drive says what its cycle moves: `static constexpr cycle_registers cycle`
#include <rtuwire/altivar/device/drive_type.hpp>

#include "../altivar/device/sixth_drive.hpp"

struct pump : atv99::device {
#ifdef REFUSED
    static void cycle();
#endif
};

void act()
{
    rtuwire::altivar::cyclic<pump> const run{rtuwire::station<pump>{rtuwire::unit_id{41}}};
    static_cast<void>(run);
}
