// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request to a plain number, which is no unit yet.
// EXPECT: a request goes to a unit, unit_id{7}, or to all of them, broadcast: not to a plain number
// ALONE
#include <rtuwire/client.hpp>

using namespace rtuwire;

#ifdef REFUSED
single_request ask{7, read_holding_registers{.start = 0, .count = 1}};
#else
single_request ask{unit_id{7}, read_holding_registers{.start = 0, .count = 1}};
#endif
