// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One request that is to write registers which do not follow one another.
// EXPECT: one request writes registers that follow one another
// CASES: 3
#include <rtuwire/ask/access.hpp>
#include <rtuwire/wire/functions.hpp>

using namespace rtuwire;

inline constexpr reg<count16> first{.code = "A", .address = 100};
inline constexpr reg<count16> second{.code = "B", .address = 101};
inline constexpr reg<count16> third{.code = "C", .address = 102};
inline constexpr reg<count16> fifth{.code = "E", .address = 104};

struct drive {
    static constexpr literal name{"Drive"};
    using registers = table<first, second, third, fifth>;
    static constexpr unit_range units{1, 247};
    static constexpr device_limits limits{63, 61, 4, 4};
    static constexpr function_set functions{all_functions};
    static constexpr std::array<address_range, 0> readable{};
};
inline constexpr station<drive> one{unit_id{7}};

void act()
{
#if not defined(REFUSED)
    static_cast<void>(write_all<first, second, third>(one, 1_raw, 2_raw, 3_raw));
#elif REFUSED == 1
    static_cast<void>(write_all<first, second, fifth>(one, 1_raw, 2_raw, 3_raw));
#elif REFUSED == 2
    static_cast<void>(write_all<first, fifth>(one, 1_raw, 2_raw));
#else
    static_cast<void>(write_all<third, second>(one, 1_raw, 2_raw));
#endif
}
