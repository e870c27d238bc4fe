// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Describes a drive whose cycle writes no control word.
// EXPECT: a cycle writes the control word, layout.cmd, and one of the references
#include <rtuwire/drives.hpp>

#include "../altivar/device/sixth_drive.hpp"

struct pump : atv99::plain_device {
#ifdef REFUSED
    static constexpr rtuwire::altivar::cycle_registers cycle{.by = rtuwire::function_code::write_multiple_registers,
                                                             .reads = {atv99::rfrd.address, atv99::eta.address},
                                                             .writes = {atv99::lfr.address},
                                                             .speed = atv99::rfrd.address};
#endif
};

static_assert(rtuwire::altivar::drive_check<pump>::passed);
