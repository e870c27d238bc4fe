// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/trace.md
// BEGINS: std::array<std::byte, 256> place;
#include <array>

#include <rtuwire/trace.hpp>

using namespace rtuwire;

constinit trace_ring<4096> frames;
void show(traced_frame const& frame);

void read()
{
    // BLOCK
}
