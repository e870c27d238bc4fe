// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A write at address 0 whose response somebody waits for: it is a broadcast, which every unit may obey and none confirms.
// EXPECT: what may be broadcast is one at address 0, which nobody answers: send it to broadcast
#include <rtuwire/client.hpp>

using namespace rtuwire;

#ifdef REFUSED
single_request const ask{only_unit, write_single_register{100, 1}};
#else
single_request const ask{broadcast, write_single_register{100, 1}};
#endif
