// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "output/plain_text.hpp"

#include <cstddef>
#include <cstdio>

namespace tool {

namespace {

/// How many bytes the character at the front of a text has in UTF-8; 0 where it is none.
std::size_t size_of_character(std::string_view text)
{
    auto const byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    unsigned const lead = byte(0);
    std::size_t const size = lead < 0x80 ? 1 : lead >= 0xC2 and lead < 0xE0 ? 2 : (lead & 0xF0U) == 0xE0 ? 3 : 4;
    if (size > text.size() or (size == 4 and (lead < 0xF0 or lead > 0xF4))) {
        return 0;
    }
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) {
            return 0;
        }
    }
    // Written longer than needed, a half of a pair, behind the last character.
    bool const is_wrong = size > 2 and ((lead == 0xE0 and byte(1) < 0xA0) or (lead == 0xED and byte(1) > 0x9F) or
                                        (lead == 0xF0 and byte(1) < 0x90) or (lead == 0xF4 and byte(1) > 0x8F));
    return is_wrong ? 0 : size;
}

/// C0, DEL, C1, and what turns the direction of the text around it.
bool acts_on_a_terminal(std::string_view character)
{
    auto const lead = static_cast<unsigned char>(character[0]);
    if (character.size() == 1) {
        return lead < 0x20 or lead == 0x7F;
    }
    auto const last = static_cast<unsigned char>(character.back());
    bool const is_c1 = character.size() == 2 and lead == 0xC2 and last < 0xA0;
    bool const is_direction =
        character.size() == 3 and ((character.starts_with("\xE2\x80") and last >= 0xA8 and last <= 0xAE) or
                                   (character.starts_with("\xE2\x81") and last >= 0xA6 and last <= 0xA9));
    return is_c1 or is_direction;
}

std::string hex_of(unsigned number, unsigned digits)
{
    std::string text;
    for (unsigned i = digits; i-- > 0;) {
        text += "0123456789ABCDEF"[(number >> (4 * i)) & 0xFU];
    }
    return text;
}

/// The number of a character of at most three bytes.
unsigned number_of(std::string_view character)
{
    unsigned number = 0;
    for (char const each : character) {
        number = (number << 6U) | (static_cast<unsigned char>(each) & 0x3FU);
    }
    return character.size() == 1 ? static_cast<unsigned char>(character[0]) : number & 0xFFFFU;
}

/// Copies a text, but for what `replaced` returns another text for: a character, and whether it is one.
template <typename Replaced> std::string copy_of(std::string_view text, Replaced replaced)
{
    std::string plain;
    while (not text.empty()) {
        std::size_t const size = size_of_character(text);
        std::string_view const character = text.substr(0, size == 0 ? 1 : size);
        plain += size == 0 or acts_on_a_terminal(character) ? replaced(character) : std::string{character};
        text.remove_prefix(character.size());
    }
    return plain;
}

} // namespace

std::string plain_text(std::string_view text)
{
    return copy_of(text, [](std::string_view character) {
        std::string bytes;
        for (char const each : character) {
            bytes += "\\x" + hex_of(static_cast<unsigned char>(each), 2);
        }
        return bytes;
    });
}

std::string plain_json(std::string_view text)
{
    return copy_of(text, [](std::string_view character) { return "\\u" + hex_of(number_of(character), 4); });
}

void tell_error(std::string_view text) { std::fprintf(stderr, "rtuwire: %s\n", plain_text(text).c_str()); }

} // namespace tool
