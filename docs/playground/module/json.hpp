// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Text in JSON, written member by member: what the module tells the page. Texts are UTF-8. The caller closes what it opens.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace playground {

class json_text {
public:
    /// Opens an object or a list; without a key inside of a list, or as the whole text.
    void open_object(std::string_view key = {}) { open(key, '{'); }
    void open_list(std::string_view key = {}) { open(key, '['); }
    void close_object() { text_ += '}'; }
    void close_list() { text_ += ']'; }

    void put(std::string_view key, std::string_view value);
    void put(std::string_view key, char const* value) { put(key, std::string_view{value}); }
    void put(std::string_view key, std::string const& value) { put(key, std::string_view{value}); }
    void put(std::string_view key, bool value) { put_bare(key, value ? "true" : "false"); }
    template <std::integral Number>
        requires(not std::same_as<Number, bool>)
    void put(std::string_view key, Number value) { put_number(key, static_cast<std::int64_t>(value)); }

    /// A text that is JSON already, such as a number with its digits.
    void put_literal(std::string_view key, std::string_view literal) { put_bare(key, literal); }

    [[nodiscard]] std::string const& text() const { return text_; }

private:
    void open(std::string_view key, char bracket);
    void put_bare(std::string_view key, std::string_view text);
    void put_number(std::string_view key, std::int64_t value);
    void begin(std::string_view key);
    void quote(std::string_view value);

    std::string text_{};
};

} // namespace playground
