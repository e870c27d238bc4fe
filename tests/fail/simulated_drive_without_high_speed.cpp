// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Simulates a drive whose table does not have its highest frequency.
// EXPECT: a simulated drive needs the register HSP, its highest frequency
#include <rtuwire/sim/drive/unit.hpp>

#include "../altivar/device/sixth_drive.hpp"

#include <rtuwire/sim.hpp>

struct pump : atv99::plain_device {
#ifdef REFUSED
    using registers = rtuwire::table<atv99::cmd, atv99::lfr, atv99::lfrd, atv99::cmi, atv99::rfrd, atv99::eta,
                                     atv99::eti, atv99::rfr, atv99::lft, atv99::tto, atv99::sll, atv99::fr1, atv99::acc,
                                     atv99::dec, atv99::nsp, atv99::frs, atv99::add>;
#endif
};

static_assert(sizeof(rtuwire::sim::unit<pump>) > 0);
