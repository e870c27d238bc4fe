// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A plan over registers of two devices.
// EXPECT: a plan reads registers of one device only
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
    static_cast<void>(read_plan<atv12::device, atv12::eta, atv28::rfr>::request_count);
#else
    static_cast<void>(read_plan<atv12::device, atv12::eta, atv12::rfr>::request_count);
#endif
}
