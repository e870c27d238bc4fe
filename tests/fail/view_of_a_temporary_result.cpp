// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A write that would keep a view of words that are gone with the result that held them.
// EXPECT: register_view
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

result<register_block<2>> words() { return register_block{1, 2}; }

std::size_t kept_size()
{
#ifdef REFUSED
    write_multiple_registers<> const kept{100, *words()};
#else
    auto const own = *words();
    write_multiple_registers<> const kept{100, own};
#endif
    return kept.size();
}
