// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Every word of every register of every drive as text, read back by a reader of its own: from the names of the units
// and the places behind the point, as a person would.
#include <rtuwire/table/register_text.hpp>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "support/drives.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

STATIC_CHECK(text_of(compact::fault_code::slf1) == "SLF1: Modbus interrupted");
STATIC_CHECK(text_of(atv320::fault_code::ocf) == "OCF: overcurrent");
STATIC_CHECK(text_of(atv28::fault_code::nof) == "nOF: no fault");
STATIC_CHECK(text_of(atv320::product_state::sms) == "SMS"); // its meaning is not known
STATIC_CHECK(text_of(compact::channel_mode::sep) == "SEP");
STATIC_CHECK(text_of(static_cast<compact::fault_code>(999)) == "#999");
STATIC_CHECK(text_of(status_word{0x0237}) == "0x0237" and text_of(command_word{0}) == "0x0000");
constexpr setting<atv12::acc> ramp = 1.3_s;
STATIC_CHECK(text_of(ramp) == "1.3 s");

/// How a unit is written, and how many places its steps have behind the point.
struct form {
    std::string_view unit;
    std::size_t places;
    std::int64_t step; ///< in the last of these places
};
form form_of(hertz) { return {" Hz", 0, 1}; }
form form_of(decihertz) { return {" Hz", 1, 1}; }
form form_of(signed_decihertz) { return {" Hz", 1, 1}; }
form form_of(hectohertz) { return {" Hz", 0, 100}; }
form form_of(rpm) { return {" rpm", 0, 1}; }
form form_of(signed_rpm) { return {" rpm", 0, 1}; }
form form_of(deciamperes) { return {" A", 1, 1}; }
form form_of(centiamperes) { return {" A", 2, 1}; }
form form_of(microamperes) { return {" A", 6, 1}; }
form form_of(tenth_milliamperes) { return {" A", 4, 1}; }
form form_of(volts) { return {" V", 0, 1}; }
form form_of(decivolts) { return {" V", 1, 1}; }
form form_of(millivolts) { return {" V", 3, 1}; }
form form_of(percent) { return {" %", 0, 1}; }
form form_of(signed_percent) { return {" %", 0, 1}; }
form form_of(tenth_percent) { return {" %", 1, 1}; }
form form_of(signed_tenth_percent) { return {" %", 1, 1}; }
form form_of(seconds) { return {" s", 0, 1}; }
form form_of(deciseconds) { return {" s", 1, 1}; }
form form_of(centiseconds) { return {" s", 2, 1}; }
form form_of(units::milliseconds) { return {" s", 3, 1}; }
form form_of(hours) { return {" h", 0, 1}; }
form form_of(centihours) { return {" h", 2, 1}; }
form form_of(newton_metres) { return {" Nm", 0, 1}; }
form form_of(watts) { return {" W", 0, 1}; }
form form_of(hectowatts) { return {" W", 0, 100}; }
form form_of(celsius) { return {" °C", 0, 1}; }
form form_of(centi_per_second) { return {" 1/s", 2, 1}; }
form form_of(count16) { return {"", 0, 1}; }
form form_of(signed_count16) { return {"", 0, 1}; }
form form_of(count16_tenths) { return {"", 1, 1}; }
form form_of(count16_hundredths) { return {"", 2, 1}; }

/// The number that a text spells, in its last place: one sign, digits, and a point with `places` digits behind it.
std::optional<std::int64_t> number_in(std::string_view text, std::size_t places)
{
    bool const is_negative = not text.empty() and text.front() == '-';
    text.remove_prefix(is_negative ? 1 : 0);
    std::size_t const point = text.find('.');
    bool const has_point = point != std::string_view::npos;
    if (has_point != (places > 0) or (has_point and text.size() - point - 1 != places)) {
        return std::nullopt;
    }
    std::size_t const whole = has_point ? point : text.size();
    bool const is_padded = whole == 0 or (whole > 1 and text.front() == '0');
    std::int64_t number = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i != point and (text[i] < '0' or text[i] > '9')) {
            return std::nullopt;
        }
        number = i == point ? number : number * 10 + (text[i] - '0');
    }
    if (is_padded or (is_negative and number == 0)) {
        return std::nullopt;
    }
    return is_negative ? -number : number;
}

/// The word that an amount's text stands for.
template <register_quantity T> std::optional<std::uint32_t> word_in(std::string_view text)
{
    form const is = form_of(T{});
    if (not text.ends_with(is.unit)) {
        return std::nullopt;
    }
    text.remove_suffix(is.unit.size());
    auto const number = number_in(text, is.places);
    if (not number or *number % is.step != 0) {
        return std::nullopt;
    }
    return static_cast<std::uint16_t>(*number / is.step);
}

/// That of a word of bits.
template <bit_field T> std::optional<std::uint32_t> word_in(std::string_view text)
{
    std::string const digits{text};
    return text.size() == 6 and text.starts_with("0x")
               ? std::optional{static_cast<std::uint32_t>(std::strtoul(digits.c_str(), nullptr, 16))}
               : std::nullopt;
}

/// That of an enumerator: by its mnemonic, which is unique, or its number.
template <register_enumeration T> std::optional<std::uint32_t> word_in(std::string_view text)
{
    static std::map<std::string_view, std::uint16_t> const words = [] {
        std::map<std::string_view, std::uint16_t> found;
        for (named_value const& each : enumerators<T>) {
            found.emplace(std::string_view{each.name}, each.value);
        }
        REQUIRE(found.size() == enumerators<T>.size());
        return found;
    }();
    std::size_t const colon = text.find(": ");
    auto const known = words.find(text.substr(0, colon));
    if (known != words.end()) {
        return known->second;
    }
    auto const number = text.starts_with('#') ? number_in(text.substr(1), 0) : std::nullopt;
    return number ? std::optional{static_cast<std::uint32_t>(*number)} : std::nullopt;
}

/// How many words of a type of register come back as another.
template <register_value T> std::size_t mistakes()
{
    static std::size_t const counted = [] {
        std::size_t count = 0;
        for (std::uint32_t word = 0; word <= 0xFFFF; ++word) {
            auto const text = text_of(from_word<T>(static_cast<std::uint16_t>(word)));
            count += word_in<T>(text) == word ? 0U : 1U;
        }
        return count;
    }();
    return counted;
}

} // namespace

TEST_CASE("each word of each register comes back from its text, with each drive")
{
    test::all_drives::for_each([]<typename Device>() {
        Device::registers::for_each([]<auto const & R>() {
            std::string const code{R.code};
            INFO(code);
            CHECK(mistakes<value_of<R>>() == 0);
        });
    });
}

TEMPLATE_TEST_CASE("each amount of a type that no drive has comes back from its text", "", hertz, centiamperes,
                   centiseconds, units::milliseconds, newton_metres, watts, hectowatts, celsius, signed_count16)
{
    CHECK(mistakes<TestType>() == 0);
}
