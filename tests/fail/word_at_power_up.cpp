// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The word that a control register shows at power-up, and that is not to be sent.
// EXPECT: value_is_never_written_to_this_register
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv28::device> drive{unit_id{3}};

void act()
{
#ifdef REFUSED
    static_cast<void>(write<atv28::cmd>(drive, atv28::command_word{0x00F0}));
#else
    static_cast<void>(write<atv28::cmd>(drive, atv28::command_word{0x0080}));
#endif
}
