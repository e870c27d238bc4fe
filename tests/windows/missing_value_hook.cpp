// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Where a program that runs a motor stops it: this one says so, and ends with a status of its own.
#include <cstdio>
#include <cstdlib>

#include <rtuwire/core/result.hpp>
#include <rtuwire/wire/errc.hpp>

void rtuwire::on_missing_value(rtuwire::errc why) noexcept
{
    std::puts(why == rtuwire::errc::timed_out ? "stopped" : "another error");
    std::fflush(stdout);
    std::_Exit(7);
}
