// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "messages/utc_time.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>

#include "words/words.hpp"

namespace tool::gateway {

namespace {

/// Takes a text apart from its front.
class time_reader {
public:
    explicit time_reader(std::string_view text) noexcept : rest_{text} {}

    bool is_right() const { return is_right_; }
    bool is_at_end() const { return rest_.empty(); }
    bool is_at(char wanted) const { return not rest_.empty() and rest_.front() == wanted; }

    void skip(char wanted)
    {
        is_right_ = is_right_ and is_at(wanted);
        rest_.remove_prefix(is_right_ ? 1 : 0);
    }

    /// A number of so many digits, within limits.
    int number(std::size_t digits, int lowest, int highest)
    {
        is_right_ = is_right_ and rest_.size() >= digits and std::ranges::all_of(rest_.substr(0, digits), is_digit);
        int value = 0;
        for (std::size_t i = 0; is_right_ and i < digits; ++i) {
            value = value * 10 + (rest_[i] - '0');
        }
        is_right_ = is_right_ and value >= lowest and value <= highest;
        rest_.remove_prefix(is_right_ ? digits : 0);
        return value;
    }

    /// The microseconds of a fraction: as many digits as there are, at least one.
    std::int64_t fraction()
    {
        std::int64_t value = 0;
        std::size_t digits = 0;
        for (; digits < rest_.size() and is_digit(rest_[digits]); ++digits) {
            value = digits < 6 ? value * 10 + (rest_[digits] - '0') : value;
        }
        for (std::size_t i = digits; i < 6; ++i) {
            value *= 10;
        }
        is_right_ = is_right_ and digits > 0;
        rest_.remove_prefix(digits);
        return value;
    }

    /// The seconds that a zone is ahead of UTC.
    int zone()
    {
        if (is_at('Z')) {
            skip('Z');
            return 0;
        }
        int const sign = is_at('-') ? -1 : 1;
        skip(sign < 0 ? '-' : '+');
        int const hours = number(2, 0, 23);
        if (is_at(':')) {
            skip(':');
        }
        return sign * (hours * 3'600 + number(2, 0, 59) * 60);
    }

private:
    std::string_view rest_;
    bool is_right_{true};
};

} // namespace

std::string utc_text(std::uint64_t unix_microseconds)
{
    using namespace std::chrono;
    sys_time<milliseconds> const time{milliseconds{unix_microseconds / 1'000}};
    auto const day = floor<days>(time);
    year_month_day const date{day};
    hh_mm_ss const clock{time - day};
    char text[64];
    std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                  static_cast<int>(clock.seconds().count()), static_cast<int>(clock.subseconds().count()));
    return text;
}

std::optional<std::uint64_t> time_in(std::string_view text)
{
    using namespace std::chrono;
    time_reader from{text};
    year const in_year{from.number(4, 1970, 9'999)};
    from.skip('-');
    month const in_month{static_cast<unsigned>(from.number(2, 1, 12))};
    from.skip('-');
    year_month_day const date{in_year, in_month, day{static_cast<unsigned>(from.number(2, 1, 31))}};
    from.skip('T');
    int const in_day = from.number(2, 0, 23) * 3'600;
    from.skip(':');
    int const in_hour = from.number(2, 0, 59) * 60;
    from.skip(':');
    int const in_minute = from.number(2, 0, 59);
    std::int64_t part = 0;
    if (from.is_at('.')) {
        from.skip('.');
        part = from.fraction();
    }
    int const ahead = from.zone();
    if (not from.is_right() or not from.is_at_end() or not date.ok()) {
        return std::nullopt;
    }
    auto const whole = sys_days{date}.time_since_epoch() + seconds{in_day + in_hour + in_minute - ahead};
    std::int64_t const time = duration_cast<microseconds>(whole).count() + part;
    return time < 0 ? std::nullopt : std::optional{static_cast<std::uint64_t>(time)};
}

} // namespace tool::gateway
