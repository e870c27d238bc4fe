// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "json.hpp"

namespace playground {

void json_text::put(std::string_view key, std::string_view value)
{
    begin(key);
    quote(value);
}

void json_text::open(std::string_view key, char bracket)
{
    begin(key);
    text_ += bracket;
}

void json_text::put_bare(std::string_view key, std::string_view text)
{
    begin(key);
    text_ += text;
}

void json_text::put_number(std::string_view key, std::int64_t value) { put_bare(key, std::to_string(value)); }

void json_text::begin(std::string_view key)
{
    bool const is_first = text_.empty() or text_.back() == '{' or text_.back() == '[';
    if (not is_first) {
        text_ += ',';
    }
    if (not key.empty()) {
        quote(key);
        text_ += ':';
    }
}

void json_text::quote(std::string_view value)
{
    constexpr char digits[] = "0123456789abcdef";
    text_ += '"';
    for (char const each : value) {
        auto const byte = static_cast<unsigned char>(each);
        bool const is_plain = byte >= ' ';
        if (not is_plain) {
            text_ += "\\u00";
            text_ += digits[byte >> 4U];
            text_ += digits[byte & 15U];
            continue;
        }
        if (each == '"' or each == '\\') {
            text_ += '\\';
        }
        text_ += each;
    }
    text_ += '"';
}

} // namespace playground
