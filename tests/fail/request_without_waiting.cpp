// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request given to a client that waits for nothing, as if it returned the response.
// EXPECT: this client waits for no response: name a single_request{unit, request} and give it to `converse` in each pass
// ALONE
#include <rtuwire/client.hpp>

using namespace rtuwire;

void act(host_client& client)
{
#ifdef REFUSED
    auto const found = client.ask(unit_id{7}, read_holding_registers{.start = 0, .count = 1});
    static_cast<void>(found.has_value());
#else
    single_request ask{unit_id{7}, read_holding_registers{.start = 0, .count = 1}};
    client.converse(ask, instant{0});
#endif
}
