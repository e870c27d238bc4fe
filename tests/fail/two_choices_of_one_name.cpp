// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A name that two choices of a list have, as their meaning.
// EXPECT: this register has two values of this name
#include "meter_facts.hpp"

namespace meter {

#ifdef REFUSED
inline constexpr choice modes[]{{1, "A", "on"}, {2, "B", "on"}};
#else
inline constexpr choice modes[]{{1, "A", "on"}, {2, "B", "off"}};
#endif

inline constexpr register_row rows[]{{"M", 50, row_words::rw, modes}};

struct device : meter_facts {
    using amounts = amount_types<count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const tell = write<parameter_called<meter::device, "M">>(station<meter::device>{unit_id{3}}, named<"on">);
