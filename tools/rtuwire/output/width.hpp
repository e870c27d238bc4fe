// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How many columns of a terminal a text in UTF-8 takes.
#pragma once

#include <cstddef>
#include <string_view>

namespace tool {

/// One for each character; the texts of this tool have none that takes two.
inline std::size_t width_of(std::string_view text)
{
    std::size_t width = 0;
    for (char const each : text) {
        bool const continues = (static_cast<unsigned char>(each) & 0xC0U) == 0x80U;
        width += continues ? 0U : 1U;
    }
    return width;
}

} // namespace tool
