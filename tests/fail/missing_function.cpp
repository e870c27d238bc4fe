// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An exchange with a drive that has no function 23.
// EXPECT: this device does not implement function 23
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};
inline constexpr station<atv28::device> old{unit_id{3}};

void act()
{
#ifdef REFUSED
    static_cast<void>(exchange<contiguous<atv28::eta>, atv28::lfr>(old, 50_Hz));
#else
    static_cast<void>(exchange<contiguous<atv12::nm1>, atv12::nc1>(drive, 6_raw));
#endif
}
