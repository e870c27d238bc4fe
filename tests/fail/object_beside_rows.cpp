// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An object that has the mnemonic of a row, where only the object is used.
// EXPECT: two_rows_have_the_code_of_this_one<50>
#include "meter_facts.hpp"

namespace meter {

#ifdef REFUSED
inline constexpr reg<count16> object{.code = "M", .address = 51};
#else
inline constexpr reg<count16> object{.code = "O", .address = 51};
#endif

inline constexpr register_row rows[]{{"M", 50, row_words::rw, in<count16>}};

struct device : meter_facts {
    using amounts = amount_types<count16>;
    using registers = row_table<device, table<object>, rows>;
};

} // namespace meter

inline auto const tell = write<meter::object>(station<meter::device>{unit_id{3}}, 5_raw);
