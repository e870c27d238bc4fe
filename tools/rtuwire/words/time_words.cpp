// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/time_words.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

#include "words/amount_words.hpp"

namespace tool {

std::optional<double> seconds_typed(std::string_view text)
{
    typed_amount const typed = read_amount(text, "length of time");
    if (typed.fault != amount_fault::none) {
        return std::nullopt;
    }
    double const seconds = static_cast<double>(typed.amount.numerator) / static_cast<double>(typed.amount.denominator);
    return seconds >= 0 and seconds <= longest_time ? std::optional{seconds} : std::nullopt;
}

std::optional<double> time_limit_typed(std::string_view text)
{
    auto const seconds = seconds_typed(text);
    return seconds and *seconds > 0 ? seconds : std::nullopt;
}

std::string seconds_text(std::chrono::microseconds time)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g s", static_cast<double>(time.count()) / 1e6);
    return text.data();
}

std::string ms_text(std::chrono::microseconds time)
{
    auto const tenths = (std::abs(time.count()) + 50) / 100;
    bool const is_before = time.count() < 0 and tenths > 0;
    return (is_before ? "-" : "") + std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10) + " ms";
}

} // namespace tool
