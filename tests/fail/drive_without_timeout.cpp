// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Resets a drive that does not stop by itself when its line goes silent.
// EXPECT: a drive stops by itself where its line goes silent: by layout.safeguards.sll and .tto, or by .fixed_timeout, which longest_silence covers
#include <rtuwire/altivar/device/drive_type.hpp>

#include "../altivar/device/sixth_drive.hpp"

struct pump : atv99::device {
#ifdef REFUSED
    static constexpr rtuwire::altivar::drive_layout layout = [] {
        auto wrong = atv99::device::layout;
        wrong.safeguards.tto = 0;
        return wrong;
    }();
#endif
};

void act()
{
    rtuwire::altivar::reset_fault const reset{rtuwire::station<pump>{rtuwire::unit_id{41}}};
    static_cast<void>(reset);
}
