// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive whose row of the command word, its reference or its reaction to a lost link does not say what it is: a restore
// would write it like a setting, or, SLL as the place on another bus, by an option that says nothing of it.
// EXPECT: a row at a register that commands the drive, tells its state or safeguards it lacks the role of that
// CASES: 4
#include <rtuwire/altivar/own_parameters.hpp>

#include "../altivar/device/sixth_drive.hpp"

#ifndef REFUSED
#define REFUSED 0
#endif

using namespace rtuwire::altivar;

namespace own {

using namespace atv99;
using namespace roles;

inline constexpr row_access rw{rtuwire::access::read_write, rtuwire::provenance::documented};

inline constexpr parameter named[]{
    REFUSED == 1 ? parameter{"CMD", 52000, rw, in<rtuwire::count16>} : row_of(cmd, commands),
    REFUSED == 2 ? parameter{"LFR", 52001, rw, in<rtuwire::signed_decihertz>} : row_of(lfr, setpoint),
    REFUSED == 3   ? parameter{"SLL", 1022, rw, in<rtuwire::count16>}
    : REFUSED == 4 ? row_of(sll, other_bus)
                   : row_of(sll, link_loss)};

// clang-format off
inline constexpr parameter others[]{
    row_of(lfrd, setpoint), row_of(cmi, recalls), row_of(rfrd), row_of(eta), row_of(eti), row_of(rfr), row_of(lft),
    row_of(tto, timeout), row_of(fr1, references),
    row_of(in1, ordinary), row_of(in2, ordinary), row_of(in3, ordinary),
    row_of(out1, cyclic_words), row_of(out2, cyclic_words), row_of(out3, cyclic_words),
    row_of(iw1), row_of(iw2), row_of(iw3), row_of(ow1, passed_on), row_of(ow2, passed_on), row_of(ow3, passed_on),
};
// clang-format on

inline constexpr parameter_group groups[]{{"named", named}, {"others", others}};
inline constexpr parameter_map parameters{groups};

struct full_device : atv99::device {
    using registers = row_table<full_device, atv99::device::registers, parameters>;
};

} // namespace own

static_assert(drive_check<own::full_device>::passed);
