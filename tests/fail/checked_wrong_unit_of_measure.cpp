// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A value known only at run time that measures something else than its register.
// EXPECT: this value measures something else than the register
// CASES: 2
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};

void act(deciamperes measured, deciseconds wished)
{
    static_cast<void>(measured);
    static_cast<void>(wished);
#if not defined(REFUSED)
    static_cast<void>(write<atv12::acc>(drive, checked(wished)));
#elif REFUSED == 1
    static_cast<void>(write<atv12::acc>(drive, checked(measured)));
#else
    static_cast<void>(setting<atv12::acc>::checked(command_word{15}));
#endif
}
