// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value that the choices of a row do not list, by its name.
// EXPECT: this register has no value of this name
#include "meter_facts.hpp"

namespace meter {

inline constexpr choice tariffs[]{{1, "DAY"}, {4, "NIGHT"}};

inline constexpr register_row rows[]{
    {"E", 40, row_words::input, in<unsigned32<watt_hours>>},
    {"T", 50, row_words::rw, tariffs, {}, {}, 1},
};

struct device : meter_facts {
    using amounts = amount_types<unsigned32<watt_hours>, count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

constexpr station<meter::device> unit{unit_id{3}};
#ifdef REFUSED
inline auto const tariff = write<parameter_called<meter::device, "T">>(unit, named<"NOON">);
#else
inline auto const tariff = write<parameter_called<meter::device, "T">>(unit, named<"NIGHT">);
#endif
