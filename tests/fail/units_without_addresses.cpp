// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server of several units that does not know which bank is whose.
// EXPECT: a server of several units is made of bank_at{unit_id{3}, bank}, or of a std::array of these
#include <rtuwire/server.hpp>

using namespace rtuwire;

constexpr line_timing timing{19'200, character_format::even_8_1};

void act()
{
    word_bank<4> io, meter;
#ifdef REFUSED
    static_cast<void>(server::for_units(timing, io, meter));
#else
    static_cast<void>(server::for_units(timing, bank_at{unit_id{3}, io}, bank_at{unit_id{4}, meter}));
#endif
}
