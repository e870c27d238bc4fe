// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A recall of saved settings, of a drive that has no such order.
// EXPECT: this device cannot recall its saved settings over the line
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/recall_from_eeprom.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

void act()
{
#ifdef REFUSED
    static_cast<void>(recall_from_eeprom{station<atv320::device>{unit_id{7}}});
#else
    static_cast<void>(recall_from_eeprom{station<atv28::device>{unit_id{7}}});
#endif
}
