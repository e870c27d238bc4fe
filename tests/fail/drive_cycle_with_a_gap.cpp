// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Describes a drive whose cycle, without a scanner, reads what does not stand together.
// EXPECT: a cycle without a scanner reads addresses that follow one another, and writes two: the control word and a reference
#include <rtuwire/drives.hpp>

#include "../altivar/device/sixth_drive.hpp"

struct pump : atv99::plain_device {
#ifdef REFUSED
    static constexpr rtuwire::altivar::cycle_registers cycle{.by = rtuwire::function_code::write_multiple_registers,
                                                             .reads = {atv99::eta.address, atv99::rfr.address},
                                                             .writes = {atv99::cmd.address, atv99::lfr.address},
                                                             .speed = atv99::rfr.address};
#endif
};

static_assert(rtuwire::altivar::drive_check<pump>::passed);
