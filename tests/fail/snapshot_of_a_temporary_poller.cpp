// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The snapshot of a poller that is gone.
// EXPECT: deleted
// EXPECT: latest
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/ask/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

using monitor = read_plan<atv12::device, atv12::rfr>;
inline constexpr station<atv12::device> drive{unit_id{7}};

std::int32_t speed()
{
#ifdef REFUSED
    auto const& shown = poller<monitor>{drive}.latest();
#else
    poller<monitor> const panel{drive};
    auto const& shown = panel.latest();
#endif
    return shown.get<atv12::rfr>().count();
}
