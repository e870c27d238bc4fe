// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "words/place_value.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "catalog/value_text.hpp"
#include "words/amount_words.hpp"

namespace tool {

namespace {

using wide = exact_amount::wide;

/// All bits of a number of up to four registers.
std::uint64_t bits_of(value_form const& form, std::span<std::uint16_t const> words)
{
    std::string const letters = form.letters();
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        std::uint64_t const byte = (words[i / 2] >> (i % 2 == 0 ? 8U : 0U)) & 0xFFU;
        bits |= byte << (8 * (letters.size() - 1 - static_cast<std::size_t>(letters[i] - 'a')));
    }
    return bits;
}

std::string with_unit(std::string text, std::string const& unit)
{
    return unit.empty() ? std::move(text) : std::move(text) + ' ' + unit;
}

wide power_of_ten(unsigned exponent)
{
    wide power = 1;
    for (; exponent > 0; --exponent) {
        power *= 10;
    }
    return power;
}

std::string digits_of(wide number)
{
    bool const is_negative = number < 0;
    std::string digits;
    for (wide rest = is_negative ? -number : number; rest > 0 or digits.empty(); rest /= 10) {
        digits += static_cast<char>('0' + static_cast<int>(rest % 10));
    }
    std::ranges::reverse(digits);
    return is_negative ? '-' + digits : digits;
}

double number_in(std::string const& text)
{
    double number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

cell whole_number(wide number, std::string const& text)
{
    using limits = std::numeric_limits<std::int64_t>;
    if (number >= (limits::min)() and number <= (limits::max)()) {
        return static_cast<std::int64_t>(number);
    }
    bool const fits = number > 0 and number <= (std::numeric_limits<std::uint64_t>::max)();
    return fits ? cell{static_cast<std::uint64_t>(number)} : cell{number_in(text)};
}

/// So many counts, scaled exactly, with the digits of the scale.
formed_value scaled(wide count, value_form const& form)
{
    unsigned const places = std::max(form.factor.places, form.offset.places);
    wide const last = count * form.factor.digits * power_of_ten(places - form.factor.places) +
                      form.offset.digits * power_of_ten(places - form.offset.places);
    std::string text = digits_of(last);
    if (places == 0) {
        return {whole_number(last, text), with_unit(text, form.unit)};
    }
    std::size_t const sign = last < 0 ? 1 : 0;
    std::size_t const digits = text.size() - sign;
    text.insert(sign, digits <= places ? places + 1 - digits : 0, '0');
    text.insert(text.size() - places, ".");
    return {number_in(text), with_unit(text, form.unit)};
}

long double power_of(short_decimal const& number) { return static_cast<long double>(power_of_ten(number.places)); }

/// A number with the fewest digits that mean it, or with so many.
template <typename Number> std::string shortest(Number value, int digits)
{
    std::array<char, 64> text{};
    auto const end =
        digits == 0 ? std::to_chars(text.data(), text.data() + text.size(), value)
                    : std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

template <typename Number> formed_value floating(Number value, value_form const& form)
{
    if (std::isnan(value)) {
        return {{}, "not a number"};
    }
    if (std::isinf(value)) {
        return {{}, value < 0 ? "below any number" : "above any number"};
    }
    bool const is_scaled = form.factor != short_decimal{1, 0} or form.offset != short_decimal{0, 0};
    auto const amount = static_cast<double>(amount_of(form, static_cast<long double>(value)));
    // The double nearest to an amount is shown by its fewest digits; the error of a float is larger than the last of these.
    constexpr int digits = sizeof(Number) == sizeof(double) ? 0 : std::numeric_limits<Number>::digits10 + 1;
    std::string const text = is_scaled ? shortest(amount, digits) : shortest(value, 0);
    return {number_in(text), with_unit(text, form.unit)};
}

formed_value packed_decimal(std::uint64_t bits, unsigned digits, value_form const& form)
{
    wide number = 0;
    for (unsigned i = digits; i-- > 0;) {
        std::uint64_t const digit = bits >> (4 * i) & 0xFU;
        if (digit > 9) {
            std::uint16_t const halves[]{static_cast<std::uint16_t>(bits >> 16U), static_cast<std::uint16_t>(bits)};
            return {{}, hex_words(std::span{halves}.subspan(digits > 4 ? 0 : 1)) + ", which is no BCD"};
        }
        number = number * 10 + static_cast<int>(digit);
    }
    return scaled(number, form);
}

formed_value text_value(value_form const& form, std::span<std::uint16_t const> words)
{
    bool const is_swapped = form.order == "badc";
    std::string text;
    for (std::uint16_t const word : words) {
        char const high = static_cast<char>(word >> 8U);
        char const low = static_cast<char>(word & 0xFFU);
        text += is_swapped ? low : high;
        text += is_swapped ? high : low;
    }
    text.resize(std::min<std::size_t>(text.size(), form.characters));
    text.resize(std::min(text.find('\0'), text.size()));
    text.resize(text.find_last_not_of(' ') + 1);
    return {text, text};
}

std::string numbers_of_bits(std::uint16_t word)
{
    std::string text;
    for (unsigned bit = 0; bit < 16; ++bit) {
        if ((unsigned{word} >> bit & 1U) != 0) {
            text += (text.empty() ? "" : ", ") + std::to_string(bit);
        }
    }
    return text.empty() ? "none" : text;
}

formed_value bits_value(place const& where, std::uint16_t word)
{
    if (where.is_single_bit() or where.last_bit < 0) {
        bool const is_set = (word >> (where.bit < 0 ? 0 : where.bit) & 1) != 0;
        return {is_set, is_set ? "1" : "0"};
    }
    auto const number = static_cast<std::int64_t>(bits_of(where, std::span{&word, 1}));
    return {number, std::to_string(number)};
}

} // namespace

long double amount_of(value_form const& form, long double count)
{
    return count * static_cast<long double>(form.factor.digits) / power_of(form.factor) +
           static_cast<long double>(form.offset.digits) / power_of(form.offset);
}

long double count_of(value_form const& form, long double amount)
{
    return (amount - static_cast<long double>(form.offset.digits) / power_of(form.offset)) * power_of(form.factor) /
           static_cast<long double>(form.factor.digits);
}

std::uint64_t bits_of(place const& where, std::span<std::uint16_t const> words)
{
    if (where.is_single_bit() or where.bit < 0) {
        return where.is_single_bit() ? words[0] : bits_of(where.form, words);
    }
    unsigned const width = where.last_bit < 0 ? 1U : static_cast<unsigned>(where.last_bit - where.bit + 1);
    return words[0] >> where.bit & ((1U << width) - 1U);
}

std::string hex_words(std::span<std::uint16_t const> words)
{
    std::string text = "0x";
    for (std::uint16_t const word : words) {
        text += hex_word(word).substr(2);
    }
    return text;
}

formed_value value_of(place const& where, std::span<std::uint16_t const> words)
{
    value_form const& form = where.form;
    if (where.is_single_bit() or where.bit >= 0) {
        return bits_value(where, words[0]);
    }
    if (form.type == value_type::text) {
        return text_value(form, words);
    }
    std::uint64_t const bits = bits_of(form, words);
    auto const low = static_cast<std::uint16_t>(bits);
    switch (form.type) {
    case value_type::none:
        return form.unit.empty() and form.factor == short_decimal{1, 0} and form.offset == short_decimal{0, 0}
                   ? formed_value{std::int64_t{low}, std::to_string(low) + " (" + hex_word(low) + ')'}
                   : scaled(low, form);
    case value_type::i16: return scaled(static_cast<std::int16_t>(low), form);
    case value_type::i32: return scaled(static_cast<std::int32_t>(bits), form);
    case value_type::i64: return scaled(static_cast<std::int64_t>(bits), form);
    case value_type::f32: return floating(std::bit_cast<float>(static_cast<std::uint32_t>(bits)), form);
    case value_type::f64: return floating(std::bit_cast<double>(bits), form);
    case value_type::bcd16: return packed_decimal(bits, 4, form);
    case value_type::bcd32: return packed_decimal(bits, 8, form);
    case value_type::bits: return {std::int64_t{low}, hex_word(low) + " (" + numbers_of_bits(low) + ')'};
    case value_type::hex: return {std::int64_t{low}, hex_word(low)};
    case value_type::u16:
    case value_type::u32:
    case value_type::u64:
    case value_type::text: break;
    }
    return scaled(bits, form);
}

} // namespace tool
