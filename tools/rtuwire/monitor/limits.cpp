// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "monitor/limits.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>

#include "exit_status.hpp"

namespace tool {

namespace {

/// A bound and its unit; nothing of an empty text. Refuses what is no number.
std::optional<double> bound_in(std::string_view text, std::string const& word, std::string& unit)
{
    if (text.empty()) {
        return std::nullopt;
    }
    double number = 0;
    auto const [end, why] = std::from_chars(text.data(), text.data() + text.size(), number);
    std::string_view const rest = text.substr(static_cast<std::size_t>(end - text.data()));
    bool const is_unit = rest.find_first_of(".,:=@+- ") == rest.npos;
    if (why != std::errc{} or not std::isfinite(number) or not is_unit) {
        refuse_word("--alarm " + word + ": '" + std::string{text} + "' is no number such as 8.5 or 8.5A");
    }
    if (not rest.empty() and not unit.empty() and unit != rest) {
        refuse_word("--alarm " + word + ": its limits are in " + unit + " and in " + std::string{rest});
    }
    unit = rest.empty() ? unit : std::string{rest};
    return number;
}

std::string text_of(char const* side, double bound, std::string_view unit)
{
    char text[64];
    std::snprintf(text, sizeof text, "%s %g", side, bound);
    return text + (unit.empty() ? std::string{} : ' ' + std::string{unit});
}

} // namespace

value_limit limit_in(std::string const& word)
{
    std::size_t const sign = word.rfind('=');
    std::size_t const dots = sign == word.npos ? word.npos : word.find("..", sign);
    if (dots == word.npos or sign == 0) {
        refuse_word("--alarm " + word + ": it looks like LCR=2..8.5A, or LCR=..8.5A");
    }
    value_limit limit{.word = word.substr(0, sign)};
    limit.lowest = bound_in(std::string_view{word}.substr(sign + 1, dots - sign - 1), word, limit.unit);
    limit.highest = bound_in(std::string_view{word}.substr(dots + 2), word, limit.unit);
    if (not limit.lowest and not limit.highest) {
        refuse_word("--alarm " + word + ": neither a lowest nor a highest value");
    }
    if (limit.lowest and limit.highest and *limit.lowest > *limit.highest) {
        refuse_word("--alarm " + word + ": the lowest value is above the highest");
    }
    return limit;
}

std::string outside_text(value_limit const& limit, double value, std::string_view unit)
{
    if (not limit.unit.empty() and limit.unit != unit) {
        return "its limit is in " + limit.unit + ", and it is " +
               (unit.empty() ? std::string{"without a unit"} : "in " + std::string{unit});
    }
    return not std::isfinite(value)                   ? "no number, which its limit is of"
           : limit.lowest and value < *limit.lowest   ? text_of("below", *limit.lowest, unit)
           : limit.highest and value > *limit.highest ? text_of("above", *limit.highest, unit)
                                                      : std::string{};
}

} // namespace tool
