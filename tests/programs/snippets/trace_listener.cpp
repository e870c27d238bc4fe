// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/trace.md
// BEGINS: line_listener tap
#include <rtuwire/client.hpp>
#include <rtuwire/trace.hpp>

namespace board {
rtuwire::instant now();
}

using namespace rtuwire;

struct receiver {
    byte_view received();
};

void show(traced_frame const& frame, byte_view request, duration response_time);

void snippet(receiver& uart)
{
    // BLOCK
}
