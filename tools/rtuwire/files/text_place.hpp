// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Where something stands in a text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tool {

/// Where a text stands; line 0 is the file as a whole.
struct text_place {
    std::size_t line{0};
    std::size_t column{0}; ///< in bytes, the first is 1

    friend bool operator==(text_place const&, text_place const&) = default;
};

/// Tells the places of bytes of a text, fast where each is behind the one before.
class place_counter {
public:
    explicit place_counter(std::string_view text) noexcept : text_{text} {}

    [[nodiscard]] text_place of(std::size_t byte) noexcept;

private:
    std::string_view text_;
    std::size_t at_{0};
    text_place place_{1, 1};
};

/// "meter.yaml:12:5: ", and without a place "meter.yaml: ".
[[nodiscard]] std::string told_place(std::string const& file, text_place where);

} // namespace tool
