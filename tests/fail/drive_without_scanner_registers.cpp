// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stops a drive that does not say where its scanner is, nor that it has none.
// EXPECT: a drive says where its scanner is, or that it has none: `static constexpr scanner_registers scanner{}`
#include <rtuwire/altivar/device/drive_type.hpp>

#include "../altivar/device/sixth_drive.hpp"

struct pump : atv99::device {
#ifdef REFUSED
    static void scanner();
#endif
};

void act()
{
    rtuwire::altivar::stop const rest{rtuwire::station<pump>{rtuwire::unit_id{41}}};
    static_cast<void>(rest);
}
