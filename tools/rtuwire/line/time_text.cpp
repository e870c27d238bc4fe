// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/time_text.hpp"

#include <chrono>
#include <cstdio>
#include <ctime>

namespace tool {

std::uint64_t unix_now()
{
    using namespace std::chrono;
    return static_cast<std::uint64_t>(duration_cast<microseconds>(system_clock::now().time_since_epoch()).count());
}

namespace {

/// With a part of a second: so many digits of it.
std::string local_time(std::uint64_t unix_microseconds, int digits, unsigned part)
{
    auto const seconds = static_cast<std::time_t>(unix_microseconds / 1'000'000);
    std::tm local{};
    ::localtime_r(&seconds, &local);
    char date[32] = "";
    char zone[8] = "";
    std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%S", &local);
    std::strftime(zone, sizeof zone, "%z", &local);
    char text[64];
    std::snprintf(text, sizeof text, "%s.%0*u%s", date, digits, part, zone);
    return text;
}

} // namespace

std::string time_text(std::uint64_t unix_microseconds)
{
    return local_time(unix_microseconds, 3, static_cast<unsigned>(unix_microseconds / 1'000 % 1'000));
}

std::string exact_time_text(std::uint64_t unix_microseconds)
{
    return local_time(unix_microseconds, 6, static_cast<unsigned>(unix_microseconds % 1'000'000));
}

} // namespace tool
