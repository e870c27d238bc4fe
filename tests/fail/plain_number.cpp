// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A number without a unit for a register.
// EXPECT: a plain number is no setting: give it a unit (3_s), or name an enumerator or bits
// CASES: 2
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

void act(station<atv12::device> const& drive)
{
#if not defined(REFUSED)
    static_cast<void>(write<atv12::acc>(drive, 3_s));
    static_cast<void>(write<atv12::cmd>(drive, command_word{0x0006}));
#elif REFUSED == 1
    static_cast<void>(write<atv12::acc>(drive, 30));
#else
    static_cast<void>(write<atv12::cmd>(drive, 0x0006));
#endif
}
