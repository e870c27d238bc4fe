// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A name for a bit that no word has.
// EXPECT: this_row_has_a_bit_beyond_15<50>
#include "meter_facts.hpp"

namespace meter {

#ifdef REFUSED
inline constexpr choice modes[]{{1, "ON", "on"}, {16, "OFF", "off"}};
#else
inline constexpr choice modes[]{{1, "ON", "on"}, {15, "OFF", "off"}};
#endif

inline constexpr register_row rows[]{{"M", 50, row_words::rw, bits(modes)}};

struct device : meter_facts {
    using amounts = amount_types<count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const ask = read<parameter_called<meter::device, "M">>(station<meter::device>{unit_id{3}});
