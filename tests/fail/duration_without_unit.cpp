// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A bare number where a time is meant: 200 microseconds for whoever meant milliseconds.
// EXPECT: duration
#include <rtuwire/client/needs.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr client_options options{.response_timeout = 200};
#else
constexpr client_options options{.response_timeout = milliseconds(200)};
#endif
static_assert(options.retries == 2);
