// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "backup/saved_text.hpp"

#include <algorithm>

namespace tool {

text_place place_counter::of(std::size_t byte) noexcept
{
    if (byte < at_) {
        at_ = 0;
        place_ = {1, 1};
    }
    for (; at_ < std::min(byte, text_.size()); ++at_) {
        place_ = text_[at_] == '\n' ? text_place{place_.line + 1, 1} : text_place{place_.line, place_.column + 1};
    }
    return place_;
}

bool is_row_field(std::string_view name) noexcept
{
    constexpr std::string_view names[]{"group", "address", "register", "menu", "raw", "value", "unit", "error", "name"};
    return std::ranges::find(names, name) != std::end(names);
}

} // namespace tool
