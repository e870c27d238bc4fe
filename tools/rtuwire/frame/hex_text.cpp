// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/hex_text.hpp"

namespace tool {

std::string hex_of(rtuwire::byte_view bytes)
{
    std::string text(bytes.size() * 3, ' ');
    text.resize(rtuwire::to_hex(bytes, text).size());
    return text;
}

} // namespace tool
