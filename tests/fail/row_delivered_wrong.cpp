// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A row that is delivered with a value that its list of choices does not have, or its type does not hold.
// EXPECT: this_row_is_delivered_with_a_value_that_it_does_not_take<50>
// CASES: 4
#include <rtuwire/client.hpp>
#include <rtuwire/rows.hpp>

#ifndef REFUSED
#define REFUSED 0
#endif

using namespace rtuwire;

namespace meter {

inline constexpr choice tariffs[]{{1, "DAY"}, {4, "NIGHT"}};

inline constexpr register_row rows[]
{
    {"E", 40, row_words::input, in<unsigned32<watt_hours>>},
#if REFUSED == 1
        {"P", 50, row_words::rw, tariffs, {}, {}, 2},
#elif REFUSED == 2
        {"P", 50, row_words::rw, in<count16>, {}, {}, 70'000},
#elif REFUSED == 3
        {"P", 50, row_words::rw, in<unsigned32<watt_hours>>, {}, {}, -1},
#elif REFUSED == 4
        {"P", 50, row_words::coil_rw, in<bool>, {}, {}, 7},
#else
        {"P", 50, row_words::rw, tariffs, {}, {}, 1},
#endif
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

inline auto const energy = read<parameter_called<meter::device, "E">>(station<meter::device>{unit_id{3}});
