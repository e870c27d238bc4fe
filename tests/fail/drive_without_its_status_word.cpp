// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Watches a drive whose table lacks its status word.
// EXPECT: the status word, layout.eta, is in no register of the drive's table
#include <rtuwire/altivar/device/drive_type.hpp>

#include "../altivar/device/sixth_drive.hpp"

struct pump : atv99::plain_device {
#ifdef REFUSED
    using registers = rtuwire::table<atv99::cmd, atv99::lfr, atv99::lfrd, atv99::cmi, atv99::rfrd, atv99::eti,
                                     atv99::rfr, atv99::lft, atv99::tto, atv99::sll, atv99::fr1>;
#endif
};

void act()
{
    rtuwire::altivar::watch<pump> const seen{rtuwire::station<pump>{rtuwire::unit_id{41}}};
    static_cast<void>(seen);
}
