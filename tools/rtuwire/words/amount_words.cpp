// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/amount_words.hpp"

#include <limits>

#include "words/words.hpp"

namespace tool {

namespace {

/// A unit as it is typed, and how much of the catalog's unit it is.
struct typed_unit {
    std::string_view unit;
    std::string_view text;
    std::int64_t numerator{1};
    std::int64_t denominator{1};
    bool is_shown{true}; ///< in the list for people
};

// The first of each unit is the unit itself.
constexpr typed_unit units[]{
    {"Hz", "Hz"},
    {"Hz", "kHz", 1'000},
    {"Hz", "mHz", 1, 1'000},
    {"rpm", "rpm"},
    {"rpm", "1/min", 1, 1, false},
    {"rpm", "/min", 1, 1, false},
    {"rpm", "min-1", 1, 1, false},
    {"A", "A"},
    {"A", "mA", 1, 1'000},
    {"A", "uA", 1, 1'000'000},
    {"A", "µA", 1, 1'000'000, false},
    {"V", "V"},
    {"V", "mV", 1, 1'000},
    {"V", "kV", 1'000},
    {"%", "%"},
    {"s", "s"},
    {"s", "ms", 1, 1'000},
    {"s", "us", 1, 1'000'000, false},
    {"s", "µs", 1, 1'000'000, false},
    {"s", "min", 60},
    {"h", "h"},
    {"h", "min", 1, 60},
    {"Nm", "Nm"},
    {"W", "W"},
    {"W", "kW", 1'000},
    {"kWh", "kWh"},
    {"kWh", "Wh", 1, 1'000},
    {"kWh", "MWh", 1'000},
    {"°C", "°C"},
    {"°C", "C", 1, 1, false},
    {"°C", "degC", 1, 1, false},
    {"Ohm", "Ohm"},
    {"Ohm", "mOhm", 1, 1'000},
    {"H", "H"},
    {"H", "mH", 1, 1'000},
    {"m", "m"},
    {"m", "cm", 1, 100},
    {"m/s", "m/s"},
    {"m/s", "cm/s", 1, 100},
    {"V/rpm", "V/rpm"},
    {"V/rpm", "mV/rpm", 1, 1'000},
    {"1/s", "1/s"},
    {"1/s", "/s", 1, 1, false},
    {"length of time", "s"},
    {"length of time", "ms", 1, 1'000},
    {"length of time", "min", 60},
    {"length of time", "h", 3'600},
};

typed_unit const* unit_typed(std::string_view unit, std::string_view text) noexcept
{
    for (typed_unit const& each : units) {
        if (each.unit == unit and (text.empty() or is_same_word(each.text, text))) {
            return &each;
        }
    }
    return nullptr;
}

/// Takes a sign, digits and a point from the front of a text.
typed_amount take_number(std::string_view& text) noexcept
{
    bool const is_negative = text.starts_with('-');
    text.remove_prefix(is_negative or text.starts_with('+') ? 1 : 0);
    typed_amount read;
    std::size_t digits = 0;
    bool has_point = false;
    for (; not text.empty() and (is_digit(text[0]) or (text[0] == '.' and not has_point)); text.remove_prefix(1)) {
        if (text[0] == '.') {
            has_point = true;
        } else if (++digits <= 15) {
            read.amount.numerator = read.amount.numerator * 10 + (text[0] - '0');
            read.amount.denominator *= has_point ? 10 : 1;
        }
    }
    read.amount.numerator *= is_negative ? -1 : 1;
    read.fault = digits == 0   ? amount_fault::not_a_number
                 : digits > 15 ? amount_fault::too_many_digits
                               : amount_fault::none;
    if (digits > 0 and text.size() > 1 and text[0] == ',' and is_digit(text[1])) {
        read.fault = amount_fault::decimal_comma;
    }
    return read;
}

/// Limited to what 64 bits hold, which is beyond any register.
std::int64_t narrowed(exact_amount::wide number) noexcept
{
    using limits = std::numeric_limits<std::int64_t>;
    return number > (limits::max)()   ? (limits::max)()
           : number < (limits::min)() ? (limits::min)()
                                      : static_cast<std::int64_t>(number);
}

} // namespace

std::int64_t exact_amount::counts_below(step_size step) const noexcept
{
    wide const above = numerator * step.denominator;
    wide const below = denominator * step.numerator;
    wide const whole = above / below;
    return narrowed(above % below < 0 ? whole - 1 : whole);
}

std::int64_t exact_amount::counts_above(step_size step) const noexcept
{
    wide const above = numerator * step.denominator;
    wide const below = denominator * step.numerator;
    wide const whole = above / below;
    return narrowed(above % below > 0 ? whole + 1 : whole);
}

typed_amount read_amount(std::string_view text, std::string_view unit)
{
    typed_amount read = take_number(text);
    if (read.fault != amount_fault::none) {
        return read;
    }
    while (text.starts_with(' ')) {
        text.remove_prefix(1);
    }
    read.unit = text;
    if (text.empty()) {
        return read;
    }
    typed_unit const* const typed = unit_typed(unit, text);
    if (typed == nullptr) {
        read.fault = amount_fault::wrong_unit;
        return read;
    }
    read.amount.numerator *= typed->numerator;
    read.amount.denominator *= typed->denominator;
    return read;
}

std::string units_for(std::string_view unit)
{
    std::string list;
    for (typed_unit const& each : units) {
        if (each.unit == unit and each.is_shown) {
            list += (list.empty() ? "" : ", ") + std::string{each.text};
        }
    }
    return list;
}

} // namespace tool
