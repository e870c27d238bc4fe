// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value that the choices of a row do not list, by its name.
// EXPECT: this register has no value of this name
#include <rtuwire/client.hpp>
#include <rtuwire/rows.hpp>

using namespace rtuwire;

namespace meter {

inline constexpr choice tariffs[]{{1, "DAY"}, {4, "NIGHT"}};

inline constexpr register_row rows[]{
    {"E", 40, row_words::input, in<unsigned32<watt_hours>>},
    {"T", 50, row_words::rw, tariffs, {}, {}, 1},
};

struct device {
    static constexpr literal name{"meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
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
