// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "files/text_place.hpp"

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

std::string told_place(std::string const& file, text_place where)
{
    return where.line == 0 ? file + ": "
                           : file + ':' + std::to_string(where.line) + ':' + std::to_string(where.column) + ": ";
}

} // namespace tool
