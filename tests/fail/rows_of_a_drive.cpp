// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A parameter of one's own, added to a drive of the library at an address that it has already.
// EXPECT: two_rows_have_this_address<9001>
#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr row_access rw{access::read_write, provenance::documented};
inline constexpr parameter more[]{
#ifdef REFUSED
    {"OWN", 9001, rw, in<count16>},
#else
    {"OWN", 9999, rw, in<count16>},
#endif
};
inline constexpr parameter_group groups[]{{"more", more}};
inline constexpr parameter_map more_parameters{groups};

struct own_drive : atv12::device {
    using registers = row_table<own_drive, atv12::device::registers, atv12::parameters, more_parameters>;
};

static_assert(drive_check<own_drive>::passed);
