// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The hook of this program: it leaves the error where the parent of the process looks. Weak, as it is declared: each test that
// looks at it has it, whichever tests stand in its program.
#pragma once

#include <rtuwire/core/result.hpp>

#include "support/death.hpp"

void rtuwire::on_missing_value(rtuwire::errc why) noexcept
{
    auto const byte = static_cast<unsigned char>(why);
    if (::write(test::last_words, &byte, 1) != 1) {
        _exit(1);
    }
}
