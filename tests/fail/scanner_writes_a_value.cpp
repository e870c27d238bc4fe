// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One register among those that a scanner writes, which is only read.
// EXPECT: the scanner cannot write a read-only register
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv320::device> drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(configure_scanner<scanner_inputs<atv320::eta>, scanner_outputs<atv320::cmd, atv320::rfr>>{drive});
#else
    static_cast<void>(configure_scanner<scanner_inputs<atv320::eta>, scanner_outputs<atv320::cmd, atv320::lfr>>{drive});
#endif
}
