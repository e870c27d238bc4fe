// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "output/passing_text.hpp"

#include <cstddef>
#include <string>

#include "../support/platform.hpp"

namespace tool {

namespace {

std::size_t dropped = 0;

} // namespace

void tell_at_once(std::string_view text)
{
    tell_dropped();
    bool const is_told = dropped == 0 and write_at_once(STDERR_FILENO, text);
    dropped += is_told ? 0 : 1;
}

void tell_dropped()
{
    if (dropped > 0 and write_at_once(STDERR_FILENO, "\nrtuwire: the standard error was blocked: " +
                                                         std::to_string(dropped) + " lines were dropped\n")) {
        dropped = 0;
    }
}

} // namespace tool
