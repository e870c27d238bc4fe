// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Banks in an array that is gone when they are served.
// EXPECT: an array that ends with its expression cannot be served: give it a name first
#include <rtuwire/server.hpp>

using namespace rtuwire;

constexpr line_timing timing{19'200, character_format::even_8_1};

void act()
{
    word_bank<4> io, meter;
#ifdef REFUSED
    static_cast<void>(server::for_units(timing, std::array{bank_at{unit_id{3}, io}, bank_at{unit_id{4}, meter}}));
#else
    std::array const boards{bank_at{unit_id{3}, io}, bank_at{unit_id{4}, meter}};
    static_cast<void>(server::for_units(timing, boards));
#endif
}
