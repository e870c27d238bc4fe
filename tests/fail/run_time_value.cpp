// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A run-time value where the compiler must know it.
// EXPECT: measured
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};
inline constexpr station<atv28::device> old{unit_id{3}};

extern deciseconds measured;

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv12::acc>(drive, measured));
#else
    static_cast<void>(setting<atv12::acc>::checked(measured));
#endif
}
