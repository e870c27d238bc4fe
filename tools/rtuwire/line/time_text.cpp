// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/time_text.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "../support/platform.hpp"

namespace tool {

std::uint64_t unix_now()
{
    using namespace std::chrono;
    return static_cast<std::uint64_t>(duration_cast<microseconds>(system_clock::now().time_since_epoch()).count());
}

namespace {

/// With so many digits of a part of a second.
std::string text_of_local(std::uint64_t unix_microseconds, int digits, unsigned part)
{
    auto const seconds = static_cast<std::time_t>(unix_microseconds / 1'000'000);
    long offset = 0;
    std::tm const local = local_time(seconds, offset);
    char date[32] = "";
    std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%S", &local);
    long const minutes = std::labs(offset) / 60;
    char fraction[16] = "";
    if (digits > 0) {
        std::snprintf(fraction, sizeof fraction, ".%0*u", digits, part);
    }
    char zone[48];
    std::snprintf(zone, sizeof zone, "%c%02ld%02ld", offset < 0 ? '-' : '+', minutes / 60, minutes % 60);
    return std::string{date} + fraction + zone;
}

} // namespace

std::string time_text(std::uint64_t unix_microseconds)
{
    return text_of_local(unix_microseconds, 3, static_cast<unsigned>(unix_microseconds / 1'000 % 1'000));
}

std::string second_text(std::uint64_t unix_microseconds) { return text_of_local(unix_microseconds, 0, 0); }

std::string exact_time_text(std::uint64_t unix_microseconds)
{
    return text_of_local(unix_microseconds, 6, static_cast<unsigned>(unix_microseconds % 1'000'000));
}

} // namespace tool
