// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "backup/saved_text.hpp"

#include <algorithm>

namespace tool {

bool is_row_field(std::string_view name) noexcept
{
    constexpr std::string_view names[]{"group", "address", "register", "menu", "raw", "value", "unit", "error", "name"};
    return std::ranges::find(names, name) != std::end(names);
}

} // namespace tool
