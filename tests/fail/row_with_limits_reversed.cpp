// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A row whose least value is above its most.
// EXPECT: this_row_has_its_limits_reversed<50>
#include "meter_facts.hpp"

namespace meter {

inline constexpr register_row rows[]{
    {"E", 40, row_words::input, in<unsigned32<watt_hours>>},
#ifdef REFUSED
    {"P", 50, row_words::rw, in<count16>, 9, 1},
#else
    {"P", 50, row_words::rw, in<count16>, 1, 9},
#endif
};

struct device : meter_facts {
    using amounts = amount_types<unsigned32<watt_hours>, count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const energy = read<parameter_called<meter::device, "E">>(station<meter::device>{unit_id{3}});
