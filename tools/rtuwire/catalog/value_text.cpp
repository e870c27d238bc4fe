// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/value_text.hpp"

#include <algorithm>

namespace tool {

namespace {

/// The step that a display calls "001", "01" or "1": behind a leading zero stands the point.
std::optional<step_size> displayed_step(std::string_view digits)
{
    step_size step{0, 1};
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (digits[i] < '0' or digits[i] > '9' or i > 6) {
            return std::nullopt;
        }
        step.numerator = step.numerator * 10 + (digits[i] - '0');
        step.denominator *= i > 0 and digits[0] == '0' ? 10 : 1;
    }
    return step.numerator > 0 ? std::optional{step} : std::nullopt;
}

std::string enumerator_text(register_entry const& entry, std::uint16_t word)
{
    rtuwire::choice const* const choice = entry.choice_of(word);
    std::string text{choice == nullptr ? std::string_view{} : std::string_view{choice->mnemonic}};
    std::string_view const meaning =
        choice == nullptr or not entry.has_meanings ? std::string_view{} : std::string_view{choice->meaning};
    if (text.empty() and meaning.empty()) {
        return "#" + std::to_string(word);
    }
    text += text.empty() or meaning.empty() ? "" : ": ";
    return text.append(meaning);
}

} // namespace

std::optional<step_size> step_of(register_entry const& entry, drive_catalog const& drive,
                                 std::optional<std::uint16_t> setting)
{
    if (entry.steps_set_by.empty()) {
        return entry.step;
    }
    register_entry const* const by = drive.by_code(entry.steps_set_by);
    rtuwire::choice const* const chosen = by != nullptr and setting ? by->choice_of(*setting) : nullptr;
    return chosen != nullptr ? displayed_step(chosen->mnemonic) : std::nullopt;
}

std::string number_text(std::int64_t count, step_size step)
{
    // So many digits behind the point that the step is a whole number of the last.
    std::size_t decimals = 0;
    std::int64_t factor = step.numerator;
    for (; factor % step.denominator != 0 and decimals < 9; ++decimals) {
        factor *= 10;
    }
    std::int64_t const last = count * (factor / step.denominator);
    std::string digits = std::to_string(last < 0 ? -last : last);
    if (decimals > 0) {
        digits.insert(0, digits.size() <= decimals ? decimals + 1 - digits.size() : 0, '0');
        digits.insert(digits.size() - decimals, ".");
    }
    return last < 0 ? "-" + digits : digits;
}

std::string amount_text(std::int64_t count, step_size step, std::string_view unit)
{
    std::string text = number_text(count, step);
    return unit.empty() ? text : text.append(" ").append(unit);
}

std::string hex_word(std::uint16_t word)
{
    constexpr char digits[] = "0123456789ABCDEF";
    std::string text = "0x";
    for (unsigned shift = 16; shift > 0; shift -= 4) {
        text += digits[(unsigned{word} >> (shift - 4)) & 0xFU];
    }
    return text;
}

std::string text_of(register_entry const& entry, std::uint16_t word, step_size step)
{
    switch (entry.kind) {
    case register_kind::bits: return hex_word(word);
    case register_kind::enumeration: return enumerator_text(entry, word);
    case register_kind::number:
    case register_kind::signed_number: return amount_text(entry.count_of(word), step, entry.unit);
    }
    return {};
}

std::string text_of(register_entry const& entry, std::uint16_t word) { return text_of(entry, word, entry.step); }

std::string bits_text(register_entry const& entry, std::uint16_t word)
{
    std::string text;
    for (std::size_t bit = 0; bit < 16; ++bit) {
        if (((unsigned{word} >> bit) & 1U) != 0) {
            std::string name = entry.bits[bit].empty() ? "bit " + std::to_string(bit) : std::string{entry.bits[bit]};
            std::replace(name.begin(), name.end(), '_', ' ');
            text += (text.empty() ? "" : ", ") + name;
        }
    }
    return text.empty() ? "none" : text;
}

std::string full_text(register_entry const& entry, std::uint16_t word, step_size step)
{
    std::string const text = text_of(entry, word, step);
    return entry.kind == register_kind::bits ? text + " (" + bits_text(entry, word) + ")" : text;
}

std::string full_text(register_entry const& entry, std::uint16_t word) { return full_text(entry, word, entry.step); }

register_value value_of(register_entry const& entry, std::uint16_t word, std::optional<step_size> step)
{
    if (not step) {
        return {{},
                {},
                std::to_string(entry.count_of(word)) + " steps of a size that " + std::string{entry.steps_set_by} +
                    " sets"};
    }
    std::string const text = full_text(entry, word, *step);
    if (not entry.is_amount()) {
        bool const is_bits = entry.kind == register_kind::bits;
        return {is_bits ? cell{std::int64_t{word}} : cell{text_of(entry, word)}, {}, text};
    }
    double const amount = static_cast<double>(entry.count_of(word)) * static_cast<double>(step->numerator) /
                          static_cast<double>(step->denominator);
    return {amount, std::string{entry.unit}, text};
}

std::string full_text_in(register_entry const& entry, std::uint16_t word, drive_catalog const& drive,
                         std::optional<std::uint16_t> setting)
{
    auto const step = step_of(entry, drive, setting);
    return step ? full_text(entry, word, *step) : std::to_string(word) + " steps";
}

} // namespace tool
