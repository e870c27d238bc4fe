// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Two registers of a table at one address.
// EXPECT: these_registers_overlap<speed, level>
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};
inline constexpr station<atv28::device> old{unit_id{3}};

inline constexpr reg<count16> speed{.code = "SPD", .address = 7};
inline constexpr reg<count16> level{.code = "TRQ", .address = 7};

void act()
{
#ifdef REFUSED
    static_cast<void>(table<speed, level>::size);
#else
    static_cast<void>(table<speed>::size);
#endif
}
