// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Two choices of one mnemonic: a program that asks for it would get one of them.
// EXPECT: this_row_has_one_choice_twice<50>
#include "meter_facts.hpp"

namespace meter {

#ifdef REFUSED
inline constexpr choice modes[]{{1, "ON", "on"}, {2, "ON", "off"}};
#else
inline constexpr choice modes[]{{1, "ON", "on"}, {2, "OFF", "off"}};
#endif

inline constexpr register_row rows[]{{"M", 50, row_words::rw, modes}};

struct device : meter_facts {
    using amounts = amount_types<count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const tell = write<parameter_called<meter::device, "M">>(station<meter::device>{unit_id{3}}, named<"on">);
