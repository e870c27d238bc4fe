// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A cycle by function 23 on a client of short frames.
// EXPECT: this client has no room for the longest frames of the conversation: give its client_needs a larger longest_frame
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/cyclic/cyclic.hpp>
#include <rtuwire/client/client.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv320::device> drive{unit_id{3}};
#ifdef REFUSED
inline constexpr client_needs<> needed{.longest_frame = 16, .motors = 1};
#else
inline constexpr client_needs<> needed{.longest_frame = 64, .motors = 1};
#endif

void act(basic_client<needed>& link, instant now)
{
    cyclic cycle{drive};
    link.converse(cycle, now);
}
