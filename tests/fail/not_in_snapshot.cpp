// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A snapshot asked for a register that is not in its plan.
// EXPECT: this register is not in the plan of this snapshot
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};
inline constexpr station<atv28::device> old{unit_id{3}};

using monitor = read_plan<atv12::device, atv12::eta, atv12::rfr>;

void act()
{
#ifdef REFUSED
    static_cast<void>(monitor::snapshot{}.get<atv12::lcr>());
#else
    static_cast<void>(monitor::snapshot{}.get<atv12::rfr>());
#endif
}
