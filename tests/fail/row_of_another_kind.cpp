// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A coil as a row that holds a word.
// EXPECT: this_row_holds_what_its_kind_cannot<50>
#include "meter_facts.hpp"

namespace meter {

inline constexpr register_row rows[]{
    {"E", 40, row_words::input, in<unsigned32<watt_hours>>},
#ifdef REFUSED
    {"P", 50, row_words::coil_rw, in<count16>},
#else
    {"P", 50, row_words::coil_rw, in<bool>},
#endif
};

struct device : meter_facts {
    using amounts = amount_types<unsigned32<watt_hours>, count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const energy = read<parameter_called<meter::device, "E">>(station<meter::device>{unit_id{3}});
