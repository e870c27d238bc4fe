// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One register among those that a scanner reads, which another drive's table names.
// EXPECT: this device has no such register
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv320::device> drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(configure_scanner<scanner_inputs<atv320::eta, atv28::rfr>, scanner_outputs<atv320::cmd>>{drive});
#else
    static_cast<void>(configure_scanner<scanner_inputs<atv320::eta, atv320::rfr>, scanner_outputs<atv320::cmd>>{drive});
#endif
}
