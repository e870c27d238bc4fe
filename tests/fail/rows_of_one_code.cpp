// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Two rows of a device of one's own have one mnemonic.
// EXPECT: two_rows_have_the_code_of_this_one<50>
#include "meter_facts.hpp"

namespace meter {

inline constexpr register_row rows[]{
    {"E", 40, row_words::input, in<unsigned32<watt_hours>>},
#ifdef REFUSED
    {"E", 50, row_words::rw, in<count16>},
#else
    {"P", 50, row_words::rw, in<count16>},
#endif
};

struct device : meter_facts {
    using amounts = amount_types<unsigned32<watt_hours>, count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const energy = read<parameter_called<meter::device, "E">>(station<meter::device>{unit_id{3}});
