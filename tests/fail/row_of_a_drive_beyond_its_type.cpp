// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A row of a drive with a limit that a word does not hold: where it is named, and by `drive_check`.
// EXPECT: this_row_has_a_limit_that_its_type_does_not_hold<52001>
// CASES: 2
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

inline constexpr parameter rows[]{
    {"LFR", 52001, rw, in<signed_decihertz>, -4000, REFUSED == 0 ? 4000 : 40'000, {}, "Reference", &setpoint}};
inline constexpr parameter_group groups[]{{"rows", rows}};
inline constexpr parameter_map parameters{groups};

struct full_device : atv99::device {
    using registers = row_table<full_device, table<>, parameters>;
};

} // namespace own

#if REFUSED == 2
static_assert(has_rows_with_roles<own::full_device>);
#else
inline auto const asked =
    read<rtuwire::parameter_called<own::full_device, "LFR">>(rtuwire::station<own::full_device>{rtuwire::unit_id{40}});
#endif
