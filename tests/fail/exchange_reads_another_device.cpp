// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An exchange that is to read a register of another drive, be it the first one or a later one.
// EXPECT: this device has no such register
// CASES: 2
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};

inline constexpr reg<count16> before{.code = "BEFORE", .address = atv12::nm1.address - 1};
inline constexpr reg<count16> instead{.code = "INSTEAD", .address = atv12::nm2.address};

void act()
{
#if not defined(REFUSED)
    static_cast<void>(exchange<contiguous<atv12::nm1, atv12::nm2>, atv12::nc1>(drive, 6_raw));
#elif REFUSED == 1
    static_cast<void>(exchange<contiguous<before, atv12::nm1>, atv12::nc1>(drive, 6_raw));
#else
    static_cast<void>(exchange<contiguous<atv12::nm1, instead, atv12::nm3>, atv12::nc1>(drive, 6_raw));
#endif
}
