// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A ramp time whose steps another register sets.
// EXPECT: another register sets this register's steps: name them with write_with_step
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};
inline constexpr station<atv28::device> old{unit_id{3}};

inline constexpr station<atv320::device> new_drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv320::acc>(new_drive, 1.3_s));
#else
    static_cast<void>(write_with_step<deciseconds, atv320::acc>(new_drive, 1.3_s));
#endif
}
