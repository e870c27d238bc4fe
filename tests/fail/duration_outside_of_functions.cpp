// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A time that is no duration, given to a variable outside of functions that is no constant.
// EXPECT: a_duration_is_
// CASES: 3
// ALONE
#include <rtuwire/client.hpp>

using namespace rtuwire;

#if not defined(REFUSED)
client_options options{.response_timeout = 3_s};
duration pause{0.5_s};
#elif REFUSED == 1
client_options options{.response_timeout = 99'999_s};
#elif REFUSED == 2
client_options options{.response_timeout = -3_s};
#else
duration pause{99'999_s};
#endif
