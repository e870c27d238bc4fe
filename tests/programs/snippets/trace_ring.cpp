// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/trace.md
// BEGINS: constinit trace_ring<4096> frames;
// REST FROM: link.trace_to(frames);
#include <rtuwire/client.hpp>
#include <rtuwire/trace.hpp>

using namespace rtuwire;

constexpr line_timing timing{19'200, character_format::even_8_1};

// BLOCK

void begin()
{
    // REST
}
