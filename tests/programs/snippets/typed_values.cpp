// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: README.md
// BEGINS: constexpr station<altivar::atv12::device> drive
#include <iostream>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/print.hpp>

using namespace rtuwire;

int snippet(posix_serial& port, int ramp)
{
    blocking_client line{port, line_timing::host(19'200, character_format::even_8_1)};
    // BLOCK
    return 0;
}
