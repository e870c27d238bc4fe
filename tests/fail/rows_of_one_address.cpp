// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Two rows of a device of one's own have one address.
// EXPECT: two_rows_have_this_address<40>
#include "meter_facts.hpp"

namespace meter {

inline constexpr register_row rows[]{
    {"E", 40, row_words::input, in<unsigned32<watt_hours>>},
#ifdef REFUSED
    {"P", 40, row_words::input, in<count16>},
#else
    {"P", 40, row_words::ro, in<count16>},
#endif
};

struct device : meter_facts {
    using amounts = amount_types<unsigned32<watt_hours>, count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const energy = read<parameter_called<meter::device, "E">>(station<meter::device>{unit_id{3}});
