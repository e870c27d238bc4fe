// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A sink whose `take` may throw, in the middle of a client, a bus or a server.
// CASES: 4
// EXPECT: a sink of frames has a function take(traced_frame const&) that is noexcept
#include <rtuwire/client.hpp>
#include <rtuwire/server.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

struct sink {
#ifdef REFUSED
    void take(traced_frame const&) {}
#else
    void take(traced_frame const&) noexcept {}
#endif
};

inline constexpr line_timing timing{19'200, character_format::even_8_1};

#if not defined(REFUSED) or REFUSED == 1
client::traced_by<sink> link{timing};
#endif
#if not defined(REFUSED) or REFUSED == 2
bus<2>::traced_by<sink> line{timing};
#endif
#if not defined(REFUSED) or REFUSED == 3
server::traced_by<sink> node{unit_id{7}, timing};
#endif
#if not defined(REFUSED) or REFUSED == 4
basic_client<traced_needs<usual_needs, sink>> other{timing};
#endif
