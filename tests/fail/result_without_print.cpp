// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A result on a stream, where nothing shows it.
// EXPECT: include_rtuwire_print_hpp_or_show_its_value_or_its_error
// CASES: 2
// ALONE
#include <iostream>

#include <rtuwire/client.hpp>

using namespace rtuwire;

extern result<decihertz> const speed;
extern result<void> const done;

void act()
{
#if not defined(REFUSED)
    std::cout << speed.has_value() << done.has_value();
#elif REFUSED == 1
    std::cout << speed;
#else
    std::cout << done;
#endif
}
