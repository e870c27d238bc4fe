// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "backup/drive_restore.hpp"

namespace tool {

restore_function restore_for(std::string_view drive) noexcept
{
    constexpr std::pair<std::string_view, restore_function> all[]{{"atv12", restore_atv12},
                                                                  {"atv310", restore_atv310},
                                                                  {"atv310_2026", restore_atv310_2026},
                                                                  {"atv320", restore_atv320}};
    for (auto const& [name, function] : all) {
        if (name == drive) {
            return function;
        }
    }
    return nullptr;
}

} // namespace tool
