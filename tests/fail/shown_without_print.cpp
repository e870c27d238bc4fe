// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An amount, a real number or an error on a stream, where nothing shows them.
// EXPECT: include_rtuwire_print_hpp_to_show_this
// CASES: 4
// ALONE
#include <iostream>
#include <sstream>

#include <rtuwire/client.hpp>

using namespace rtuwire;

extern real<volts> const measured;

void act()
{
#if not defined(REFUSED)
    std::cout << measured.count();
#elif REFUSED == 1
    std::cout << 3_Hz;
#elif REFUSED == 2
    std::cout << errc::timed_out;
#elif REFUSED == 3
    std::cout << measured;
#else
    std::ostringstream{} << 3_Hz;
#endif
}
