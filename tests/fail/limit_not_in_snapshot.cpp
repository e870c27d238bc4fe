// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value checked against a snapshot that lacks the register its limit hangs on.
// EXPECT: the limits of this register hang on a register that is not in the plan
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};
inline constexpr station<atv28::device> old{unit_id{3}};

using limits = read_plan<atv28::device, atv28::lsp, atv28::hsp>;

void act()
{
#ifdef REFUSED
    static_cast<void>(limits::snapshot{}.checked<atv28::hsp>(decihertz{400}));
#else
    static_cast<void>(limits::snapshot{}.checked<atv28::sp2>(decihertz{400}));
#endif
}
