// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A frequency for a register that holds bits.
// EXPECT: this value measures something else than the register
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/ask/access.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

void command()
{
    constexpr station<atv12::device> drive{unit_id{1}};
#ifdef REFUSED
    static_cast<void>(write<atv12::cmd>(drive, 50_Hz));
#else
    static_cast<void>(write<atv12::cmd>(drive, command_word{0x0006}));
#endif
}
