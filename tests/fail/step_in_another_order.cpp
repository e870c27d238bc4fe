// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A step with the high word first for a register with the low word first.
// EXPECT: a step has the word order of its register
#include <rtuwire/client.hpp>

using namespace rtuwire;

namespace meter {
inline constexpr reg<signed_count16> scale{.code = "SF", .address = 3};
inline constexpr reg<scaled_by<quantity<power, std::uint32_t>, scale, word_order::low_first>> limit{.code = "P",
                                                                                                    .address = 4};

struct device {
    static constexpr literal name{"meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<scale, limit>;
};
} // namespace meter

inline constexpr station<meter::device> unit{unit_id{3}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write_with_step<unsigned32<watts>, meter::limit>(unit, 70_W));
#else
    static_cast<void>(write_with_step<unsigned32<watts, word_order::low_first>, meter::limit>(unit, 70_W));
#endif
}
