// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A count known only when running, in parentheses, of a type with numbers that do not fit.
// EXPECT: constant expression
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/table/setting.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

result<setting<atv320::lfr>> wanted(int tenths_of_hertz)
{
#ifdef REFUSED
    return setting<atv320::lfr>::checked(signed_decihertz(tenths_of_hertz));
#else
    using amount = quantity<frequency, int, std::deci>;
    return setting<atv320::lfr>::checked(truncated_to<signed_decihertz>(amount{tenths_of_hertz}));
#endif
}
