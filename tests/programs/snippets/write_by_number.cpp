// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: README.md
// BEGINS: auto const written = line.ask(
#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>

using namespace rtuwire;

void snippet(posix_serial& port)
{
    blocking_client line{port, line_timing::host(19'200, character_format::even_8_1)};
    // BLOCK
}
