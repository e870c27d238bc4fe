// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A choice without a mnemonic, asked for by an empty name.
// EXPECT: a value without a name is asked for by its number
#include <rtuwire/client.hpp>
#include <rtuwire/rows.hpp>

using namespace rtuwire;

namespace meter {

inline constexpr choice modes[]{{1, {}, "on"}, {2, {}, "off"}};

#ifdef REFUSED
inline constexpr auto const& wanted = named<"">;
#else
inline constexpr auto const& wanted = named<"on">;
#endif

inline constexpr register_row rows[]{{"M", 50, row_words::rw, modes}};

struct device {
    static constexpr literal name{"meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using amounts = amount_types<count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const tell = write<parameter_called<meter::device, "M">>(station<meter::device>{unit_id{3}}, meter::wanted);
