// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Values as they are typed for a place, as its registers.
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "output/plain_text.hpp"
#include "words/amount_words.hpp"
#include "words/place_value.hpp"

namespace tool {

namespace {

using wide_number = exact_amount::wide;

constexpr unsigned most_digits = 20;
constexpr unsigned most_places = 9;

/// The counts of an integer type.
struct count_range {
    wide_number lowest;
    wide_number highest;
};

template <typename Integer> constexpr count_range range_of() noexcept
{
    return {(std::numeric_limits<Integer>::min)(), (std::numeric_limits<Integer>::max)()};
}

count_range range_of(value_type type) noexcept
{
    switch (type) {
    case value_type::i16: return range_of<std::int16_t>();
    case value_type::u32: return range_of<std::uint32_t>();
    case value_type::i32: return range_of<std::int32_t>();
    case value_type::u64: return range_of<std::uint64_t>();
    case value_type::i64: return range_of<std::int64_t>();
    case value_type::bcd16: return {0, 9'999};
    case value_type::bcd32: return {0, 99'999'999};
    case value_type::none:
    case value_type::u16:
    case value_type::bits:
    case value_type::hex:
    case value_type::f32:
    case value_type::f64:
    case value_type::text: break;
    }
    return range_of<std::uint16_t>();
}

/// A number as it is typed, and what stands behind it.
struct typed_number {
    wide_number digits{0};
    unsigned places{0};
    std::string_view number{}; ///< as a program reads it
    std::string_view unit{};
    bool is_long{false}; ///< more than `digits` holds
    std::string wrong{};
};

/// The number of digits of an exponent at the front of a text, with what stands before them: "e5", "E-12".
std::size_t size_of_exponent(std::string_view text)
{
    std::size_t size = not text.empty() and (text[0] == 'e' or text[0] == 'E') ? 1 : 0;
    if (size == 0) {
        return 0;
    }
    size += text.size() > 1 and (text[1] == '+' or text[1] == '-') ? 1U : 0U;
    std::size_t const first = size;
    while (size < text.size() and is_digit(text[size])) {
        ++size;
    }
    return size > first ? size : 0;
}

/// "; 0xFF if it is hexadecimal" of what looks like it.
std::string hint_at_hex(std::string_view text)
{
    constexpr std::string_view digits = "0123456789abcdefABCDEF";
    bool const is_hex = not text.empty() and text.size() <= 16 and text.find_first_not_of(digits) == text.npos;
    return is_hex ? "; say 0x" + std::string{text} + " if it is hexadecimal" : std::string{};
}

typed_number number_typed(std::string_view text, bool may_have_exponent)
{
    typed_number typed;
    bool const is_negative = text.starts_with('-');
    std::size_t const begin = is_negative or text.starts_with('+') ? 1 : 0;
    std::size_t end = begin;
    unsigned count = 0;
    bool has_point = false;
    for (; end < text.size() and (is_digit(text[end]) or (text[end] == '.' and not has_point)); ++end) {
        if (text[end] == '.') {
            has_point = true;
        } else if (++count <= most_digits) {
            typed.digits = typed.digits * 10 + (text[end] - '0');
            typed.places += has_point ? 1U : 0U;
        }
    }
    end += may_have_exponent and count > 0 ? size_of_exponent(text.substr(end)) : 0;
    typed.digits *= is_negative ? -1 : 1;
    typed.number = text.substr(begin == 1 and not is_negative ? 1 : 0, end - (begin == 1 and not is_negative ? 1 : 0));
    typed.unit = text.substr(end);
    if (count > 0 and typed.unit.size() > 1 and typed.unit[0] == ',' and is_digit(typed.unit[1])) {
        typed.wrong = decimal_comma_text;
    } else if (count == 0) {
        typed.wrong = "it takes a number: 25, 0x0019, #25 for a count without its scale" + hint_at_hex(text);
    }
    typed.is_long = count > most_digits or typed.places > most_places;
    typed.unit.remove_prefix(std::min(typed.unit.find_first_not_of(' '), typed.unit.size()));
    return typed;
}

/// What is wrong with a unit behind a number; empty where nothing is.
std::string why_not_unit(std::string_view typed, std::string const& unit)
{
    if (typed.empty() or typed == unit) {
        return {};
    }
    return unit.empty() ? "no unit of it was said, so '" + std::string{typed} +
                              "' is none: leave it out, or say the scale, "
                              "as in 40:0.1V=230.1V"
                        : "it is in " + unit + ", not in " + std::string{typed};
}

words_typed words_of_bits(value_form const& form, std::uint64_t bits)
{
    std::string const letters = form.letters();
    words_typed typed{.words = std::vector<std::uint16_t>(letters.size() / 2)};
    for (std::size_t i = 0; i < letters.size(); ++i) {
        std::uint64_t const byte =
            bits >> (8 * (letters.size() - 1 - static_cast<std::size_t>(letters[i] - 'a'))) & 0xFFU;
        std::uint16_t& word = typed.words[i / 2];
        word = static_cast<std::uint16_t>(word | byte << (i % 2 == 0 ? 8U : 0U));
    }
    return typed;
}

std::uint64_t packed(std::uint64_t number)
{
    std::uint64_t bits = 0;
    for (unsigned i = 0; number > 0; ++i, number /= 10) {
        bits |= (number % 10) << (4 * i);
    }
    return bits;
}

words_typed words_of_count(value_form const& form, wide_number count)
{
    auto const bits = static_cast<std::uint64_t>(count);
    bool const is_packed = form.type == value_type::bcd16 or form.type == value_type::bcd32;
    words_typed typed = words_of_bits(form, is_packed ? packed(bits) : bits);
    bool const is_as_it_comes = not is_packed and (form.order.empty() or form.order == "abcd");
    typed.count = is_as_it_comes ? std::optional{static_cast<std::int64_t>(count)} : std::nullopt;
    return typed;
}

std::string text_of_count(place where, wide_number count)
{
    where.form.type = where.form.type == value_type::none ? value_type::u16 : where.form.type;
    return value_of(where, words_of_count(where.form, count).words).text;
}

words_typed refuse_count(place const& where, bool is_below)
{
    count_range const range = range_of(where.form.type);
    bool const may_have_sign = is_below and where.form.type == value_type::none;
    return {.wrong =
                "it takes " + text_of_count(where, range.lowest) + " to " + text_of_count(where, range.highest) +
                (may_have_sign ? "; of a number that may be below 0 say the type: " + text_of(where) + ":i16" : "")};
}

words_typed words_of_raw(place const& where, std::string_view text)
{
    std::int64_t negative = 0;
    std::uint64_t positive = 0;
    bool const is_negative = text.starts_with('-');
    auto const [end, why] = is_negative ? std::from_chars(text.data(), text.data() + text.size(), negative)
                                        : std::from_chars(text.data(), text.data() + text.size(), positive);
    if (why != std::errc{} or end != text.data() + text.size()) {
        return {.wrong = "behind # stands a whole number, the count in the registers"};
    }
    wide_number const count = is_negative ? wide_number{negative} : wide_number{positive};
    count_range const range = range_of(where.form.type);
    bool const is_below = count < range.lowest;
    return is_below or count > range.highest ? refuse_count(where, is_below) : words_of_count(where.form, count);
}

/// Of the bytes in the order of a number: where they come in another one, those of a response may be meant.
words_typed words_of_hex(place const& where, std::string_view digits)
{
    value_form const& form = where.form;
    bool const is_swapped = not form.order.empty() and form.order != "abcd" and form.type != value_type::hex and
                            form.type != value_type::bits;
    if (is_swapped) {
        return {.wrong = "its bytes come as " + form.order + ", so 0x may mean two numbers: say it in decimal"};
    }
    std::size_t const most = std::size_t{4} * where.form.registers();
    std::uint64_t bits = 0;
    auto const [end, why] = std::from_chars(digits.data(), digits.data() + digits.size(), bits, 16);
    if (digits.empty() or digits.size() > most or why != std::errc{} or end != digits.data() + digits.size()) {
        return {.wrong = "behind 0x stand at most " + std::to_string(most) + " hexadecimal digits"};
    }
    words_typed typed = words_of_bits(where.form, bits);
    bool const is_number = not std::holds_alternative<std::monostate>(value_of(where, typed.words).value);
    return is_number ? typed : words_typed{.wrong = "these registers are no number of its type"};
}

wide_number power(unsigned exponent)
{
    wide_number result = 1;
    for (; exponent > 0; --exponent) {
        result *= 10;
    }
    return result;
}

words_typed words_of_amount(place const& where, typed_number const& typed)
{
    value_form const& form = where.form;
    if (typed.is_long) {
        return {.wrong = "more than 20 digits, or more than 9 behind the point"};
    }
    wide_number const above = (typed.digits * power(form.offset.places) - form.offset.digits * power(typed.places)) *
                              power(form.factor.places);
    wide_number const below = power(typed.places + form.offset.places) * form.factor.digits;
    wide_number const count = above / below - (above % below < 0 ? 1 : 0);
    bool const is_between = above % below != 0;
    count_range const range = range_of(form.type);
    if (count < range.lowest or count + (is_between ? 1 : 0) > range.highest) {
        return refuse_count(where, count < range.lowest);
    }
    if (is_between) {
        return {{},
                "no whole number of its steps: say " + text_of_count(where, count) + " or " +
                    text_of_count(where, count + 1)};
    }
    return words_of_count(form, count);
}

/// The digits of a number without zeros around them, and the power of ten of the first: "0.0120" is "12" and -2.
struct plain_digits {
    bool is_negative{false};
    std::string digits{};
    int power{0};

    friend bool operator==(plain_digits const&, plain_digits const&) = default;
};

/// Of a number as `number_typed` takes it, or as a program prints it.
plain_digits digits_of(std::string_view number)
{
    plain_digits found{.is_negative = number.starts_with('-')};
    number.remove_prefix(found.is_negative ? 1 : 0);
    std::size_t const end = std::min(number.find_first_of("eE"), number.size());
    std::size_t const point = std::min(number.find('.'), end);
    std::string_view exponent = number.substr(std::min(end + 1, number.size()));
    exponent.remove_prefix(exponent.starts_with('+') ? 1 : 0);
    if (std::from_chars(exponent.data(), exponent.data() + exponent.size(), found.power).ec ==
        std::errc::result_out_of_range) {
        constexpr int beyond_all = 1'000'000;
        found.power = exponent.starts_with('-') ? -beyond_all : beyond_all;
    }
    found.power += static_cast<int>(point) - 1;
    found.digits = std::string{number.substr(0, point)};
    found.digits += point < end ? number.substr(point + 1, end - point - 1) : std::string_view{};
    std::size_t const zeros = std::min(found.digits.find_first_not_of('0'), found.digits.size());
    found.power -= static_cast<int>(zeros);
    found.digits.erase(0, zeros);
    found.digits.erase(found.digits.find_last_not_of('0') + 1);
    return found.digits.empty() ? plain_digits{} : found;
}

/// Whether a number, printed with as many digits as were typed, is what was typed.
bool is_as_typed(double held, std::string_view typed)
{
    plain_digits const wanted = digits_of(typed);
    int const most = static_cast<int>(wanted.digits.size()) - 1;
    std::string text(std::size_t{64} + wanted.digits.size(), ' ');
    auto const end =
        std::to_chars(text.data(), text.data() + text.size(), held, std::chars_format::scientific, std::max(most, 0));
    plain_digits const printed = digits_of({text.data(), static_cast<std::size_t>(end.ptr - text.data())});
    return wanted == printed and (not wanted.digits.empty() or held == 0);
}

template <typename Number> words_typed words_of_float(place const& where, std::string_view number)
{
    value_form const& form = where.form;
    long double amount = 0;
    auto const read = std::from_chars(number.data(), number.data() + number.size(), amount);
    long double const scaled = count_of(form, amount);
    bool const is_beyond =
        read.ec != std::errc{} and not digits_of(number).digits.empty() and digits_of(number).power > 0;
    // The greatest number, written with few digits, may be above it.
    constexpr auto greatest = static_cast<long double>((std::numeric_limits<Number>::max)());
    constexpr long double half_a_step = sizeof(Number) == 4 ? 0x1p103L : 0.0L;
    if (is_beyond or not(std::abs(scaled) < greatest + half_a_step or std::abs(scaled) <= greatest)) {
        return {.wrong = "more than its type holds"};
    }
    auto const held = static_cast<Number>(std::clamp(scaled, -greatest, greatest));
    auto const shown = static_cast<double>(amount_of(form, static_cast<long double>(held)));
    words_typed typed;
    if constexpr (sizeof(Number) == 4) {
        typed = words_of_bits(form, std::bit_cast<std::uint32_t>(held));
    } else {
        typed = words_of_bits(form, std::bit_cast<std::uint64_t>(held));
    }
    return is_as_typed(shown, number) ? typed
                                      : words_typed{.wrong = "its type has no such number: the nearest is " +
                                                             value_of(where, typed.words).text};
}

words_typed words_of_text(value_form const& form, std::string_view text)
{
    bool const is_plain = plain_text(text) == text;
    if (not is_plain or text.size() > form.characters) {
        return {{},
                "it takes a text of at most " + std::to_string(form.characters) +
                    " bytes in UTF-8, without control characters"};
    }
    std::string padded{text};
    padded.resize(std::size_t{2} * form.registers());
    words_typed typed;
    for (std::size_t i = 0; i < padded.size(); i += 2) {
        std::size_t const first = form.order == "badc" ? i + 1 : i;
        std::size_t const second = form.order == "badc" ? i : i + 1;
        typed.words.push_back(static_cast<std::uint16_t>(static_cast<unsigned char>(padded[first]) << 8U |
                                                         static_cast<unsigned char>(padded[second])));
    }
    return typed;
}

/// On or off: 1 or 0.
std::optional<std::uint16_t> state_in(std::string_view text)
{
    bool const is_on = is_same_word(text, "on") or text == "1";
    bool const is_off = is_same_word(text, "off") or text == "0";
    return is_on or is_off ? std::optional{is_on ? std::uint16_t{1} : std::uint16_t{0}} : std::nullopt;
}

words_typed words_of_coil(std::string_view text)
{
    auto const state = state_in(text);
    return state ? words_typed{.words = {*state}} : words_typed{.wrong = "a coil is on or off"};
}

/// Bits of a register, where they stand in it.
words_typed words_of_some_bits(place const& where, std::string_view text)
{
    bool const is_one = where.last_bit < 0;
    unsigned const most = unsigned{where.mask()} >> static_cast<unsigned>(where.bit);
    auto number = is_one ? state_in(text) : std::nullopt;
    if (not is_one) {
        bool const is_hex = text.starts_with("0x") or text.starts_with("0X");
        std::string_view const digits = text.substr(is_hex ? 2 : text.starts_with('#') ? 1 : 0);
        std::uint16_t typed = 0;
        auto const [end, why] = std::from_chars(digits.data(), digits.data() + digits.size(), typed, is_hex ? 16 : 10);
        bool const is_whole = not digits.empty() and why == std::errc{} and end == digits.data() + digits.size();
        number = is_whole and typed <= most ? std::optional{typed} : std::nullopt;
    }
    if (not number) {
        return {.wrong = is_one ? "a bit is on or off" : "these bits are one number from 0 to " + std::to_string(most)};
    }
    return {.words = {static_cast<std::uint16_t>(*number << static_cast<unsigned>(where.bit))}};
}

} // namespace

words_typed words_for(place const& where, std::string_view text)
{
    if (where.is_single_bit()) {
        return words_of_coil(text);
    }
    if (where.bit >= 0) {
        return words_of_some_bits(where, text);
    }
    value_type const type = where.form.type;
    if (type == value_type::text) {
        return words_of_text(where.form, text);
    }
    bool const is_float = type == value_type::f32 or type == value_type::f64;
    if (text.starts_with("0x") or text.starts_with("0X")) {
        return words_of_hex(where, text.substr(2));
    }
    if (text.starts_with('#')) {
        return is_float
                   ? words_typed{.wrong = "a number with a point has no count: say the number, or 0x and its registers"}
                   : words_of_raw(where, text.substr(1));
    }
    typed_number typed = number_typed(text, is_float);
    if (typed.wrong.empty()) {
        typed.wrong = why_not_unit(typed.unit, where.form.unit);
        typed.wrong += typed.wrong.empty() ? std::string{} : hint_at_hex(text);
    }
    if (not typed.wrong.empty()) {
        return {.wrong = typed.wrong};
    }
    if (not is_float) {
        return words_of_amount(where, typed);
    }
    return type == value_type::f32 ? words_of_float<float>(where, typed.number)
                                   : words_of_float<double>(where, typed.number);
}

} // namespace tool
