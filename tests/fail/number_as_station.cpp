// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A station at a plain number, which is no unit yet.
// EXPECT: a plain number is no unit: station<...>{unit_id{7}}, or station<...>::checked(n) at run time
// ALONE
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;

#ifdef REFUSED
inline constexpr station<altivar::atv320::device> drive{7};
#else
inline constexpr station<altivar::atv320::device> drive{unit_id{7}};
#endif
