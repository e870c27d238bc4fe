// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Factory settings, ordered by somebody who does not say that he knows what they take away.
// EXPECT: factory settings may take the line's control and the drive's address away
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/restore_factory_settings.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv320::device> drive{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(restore_factory_settings{drive});
#else
    static_cast<void>(restore_factory_settings{drive, losing_control_and_address{}});
#endif
}
