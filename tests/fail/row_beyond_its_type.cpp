// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A row with a limit that its type does not hold: it would count as a limit, and the value be cut short to a word.
// EXPECT: this_row_has_a_limit_that_its_type_does_not_hold<50>
// CASES: 8
#include <rtuwire/client.hpp>
#include <rtuwire/rows.hpp>

#ifndef REFUSED
#define REFUSED 0
#endif

using namespace rtuwire;

namespace meter {

using namespace row_words;

// clang-format off
inline constexpr register_row rows[]{
    {"E", 40, input, in<unsigned32<watt_hours>>, 0, 4'294'967'295},
    {"F", 42, rw, in<unsigned64<watt_hours>>, 0, 4'294'967'296},
    {"G", 46, rw, in<signed_count16>, -32'768, 32'767},
#if REFUSED == 1
    {"P", 50, rw, in<count16>, {}, 65'536},
#elif REFUSED == 2
    {"P", 50, rw, in<count16>, -5},
#elif REFUSED == 3
    {"P", 50, rw, in<signed_count16>, {}, 32'768},
#elif REFUSED == 4
    {"P", 50, rw, in<count16>, {}, 4'294'967'296},
#elif REFUSED == 5
    {"P", 50, rw, in<unsigned32<watt_hours>>, -1},
#elif REFUSED == 6
    {"P", 50, rw, in<unsigned64<watt_hours>>, -1},
#elif REFUSED == 7
    {"P", 50, rw, in<float32<volts>>, {}, 16'777'217},
#elif REFUSED == 8
    {"P", 50, coil_rw, in<bool>, {}, 2},
#else
    {"P", 50, rw, in<count16>, 0, 65'535},
    {"V", 52, rw, in<float32<volts>>, -16'777'216, 16'777'216},
    {"K", 50, coil_rw, in<bool>, 0, 1},
#endif
};
// clang-format on

struct device {
    static constexpr literal name{"meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using amounts =
        amount_types<unsigned32<watt_hours>, unsigned64<watt_hours>, float32<volts>, count16, signed_count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const energy = read<parameter_called<meter::device, "E">>(station<meter::device>{unit_id{3}});
