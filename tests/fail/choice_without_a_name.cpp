// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A choice without a mnemonic, asked for by an empty name.
// EXPECT: a value without a name is asked for by its number
#include "meter_facts.hpp"

namespace meter {

inline constexpr choice modes[]{{1, {}, "on"}, {2, {}, "off"}};

#ifdef REFUSED
inline constexpr auto const& wanted = named<"">;
#else
inline constexpr auto const& wanted = named<"on">;
#endif

inline constexpr register_row rows[]{{"M", 50, row_words::rw, modes}};

struct device : meter_facts {
    using amounts = amount_types<count16>;
    using registers = row_table<device, table<>, rows>;
};

} // namespace meter

inline auto const tell = write<parameter_called<meter::device, "M">>(station<meter::device>{unit_id{3}}, meter::wanted);
