// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A row of two words at the last address.
// EXPECT: this_row_ends_behind_address_65535<65535>
#include "meter_facts.hpp"

namespace meter {

inline constexpr register_row rows[]{
    {"E", 40, row_words::input, in<unsigned32<watt_hours>>},
#ifdef REFUSED
    {"P", 65535, row_words::input, in<unsigned32<watt_hours>>},
#else
    {"P", 65535, row_words::input, in<count16>},
#endif
};

struct device : meter_facts {
    using amounts = amount_types<unsigned32<watt_hours>, count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const energy = read<parameter_called<meter::device, "E">>(station<meter::device>{unit_id{3}});
