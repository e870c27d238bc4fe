// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a program that runs a motor says: like printf, but a blocked or broken output stops nothing.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <string>

#include <rtuwire/frames.hpp>

#include "printer.hpp"

// Windows' own printf has other words for sizes.
#ifdef __MINGW_PRINTF_FORMAT
#define TOOL_PRINTF __MINGW_PRINTF_FORMAT
#else
#define TOOL_PRINTF printf
#endif

namespace tool {

inline printer standard_output{STDOUT_FILENO};
inline printer error_output{STDERR_FILENO};

/// A value, an error or an outcome of the library, as printf takes it.
template <typename Value> std::string words(Value const& value) { return std::string{text_of(value)}; }

/// What printf would make of it.
[[gnu::format(TOOL_PRINTF, 1, 0)]] inline std::string formatted(char const* format, std::va_list values)
{
    char text[512];
    int const size = std::vsnprintf(text, sizeof text, format, values);
    return size < 0 ? std::string{} : std::string{text};
}

/// To standard output.
[[gnu::format(TOOL_PRINTF, 1, 2)]] inline void say(char const* format, ...)
{
    std::va_list values;
    va_start(values, format);
    standard_output.put(formatted(format, values));
    va_end(values);
}

/// To the error output.
[[gnu::format(TOOL_PRINTF, 1, 2)]] inline void complain(char const* format, ...)
{
    std::va_list values;
    va_start(values, format);
    error_output.put(formatted(format, values));
    va_end(values);
}

/// Says how much nobody got, where it can, and gives the output a moment. The status to end with: `status`,
/// or 1 in place of 0 where standard output could not be written.
inline int end_of_output(char const* program, int status)
{
    constexpr std::chrono::milliseconds time_limit{2'000};
    bool const flows = standard_output.finish(time_limit);
    int const failure = standard_output.failure();
    std::size_t const missing = standard_output.missing();
    if (failure != 0) {
        complain("%s: standard output: %s\n", program, std::strerror(failure));
    } else if (missing > 0 and flows) {
        say("%zu lines were dropped: the output was blocked\n", missing);
        standard_output.finish(time_limit);
    } else if (missing > 0) {
        complain("%s: %zu lines were dropped: the output is blocked\n", program, missing);
    }
    error_output.finish(time_limit);
    return status == 0 and failure != 0 ? 1 : status;
}

} // namespace tool
